//! Certificates as one file: a zip archive with a folder for each of them.

use std::collections::BTreeMap;
use std::io::{Cursor, Read as _, Write as _};

use giveway_model::Fault;
use zip::result::ZipError;
use zip::write::SimpleFileOptions;
use zip::{CompressionMethod, ZipArchive, ZipWriter};

use super::Bundle;

/// Certificates by their names.
pub type Bundles = BTreeMap<String, Bundle>;

/// The most files of an archive, and the most bytes that they have unpacked: what is
/// exported is far smaller.
const FILES: usize = 100_000;
const BYTES: u64 = 512 << 20;

/// Packs certificates, each into a folder of its name. The same certificates make the
/// same bytes.
///
/// # Errors
/// Where a name is too long for the format, or there is too much for it.
///
/// ```
/// use std::collections::BTreeMap;
/// use giveway_proof::bundle::archive::{pack, unpack};
/// let files = BTreeMap::from([("README.md".to_owned(), b"# Certificate".to_vec())]);
/// let bundles = BTreeMap::from([("best".to_owned(), files)]);
/// let bytes = pack(&bundles).unwrap();
/// assert_eq!(unpack(&bytes), Ok(bundles));
/// assert!(unpack(&bytes[1..]).is_err());
/// ```
pub fn pack(bundles: &Bundles) -> Result<Vec<u8>, Fault> {
    let failed =
        |error: ZipError| Fault::at("", error.to_string(), "files that fit into an archive");
    let options = SimpleFileOptions::default().compression_method(CompressionMethod::Deflated);
    let mut archive = ZipWriter::new(Cursor::new(Vec::new()));
    for (folder, files) in bundles {
        for (file, bytes) in files {
            let name = format!("{folder}/{file}");
            archive.start_file(name, options).map_err(failed)?;
            let written = archive.write_all(bytes).map_err(ZipError::Io);
            written.map_err(failed)?;
        }
    }
    archive.finish().map(Cursor::into_inner).map_err(failed)
}

/// Unpacks certificates. Files that lie in no folder are those of a certificate
/// without a name.
///
/// # Errors
/// What is no archive of certificates: the place is the name of a file in it.
pub fn unpack(bytes: &[u8]) -> Result<Bundles, Fault> {
    let expected = "a zip archive of certificates";
    let no_archive = |error: ZipError| Fault::at("", error.to_string(), expected);
    let mut archive = ZipArchive::new(Cursor::new(bytes)).map_err(no_archive)?;
    if archive.len() > FILES {
        let found = format!("{} files", archive.len());
        return Err(Fault::at("", found, format!("at most {FILES} files")));
    }
    let mut left = BYTES;
    let mut bundles = Bundles::new();
    for index in 0..archive.len() {
        let mut file = archive.by_index(index).map_err(no_archive)?;
        if file.is_dir() {
            continue;
        }
        let name = file.name().map_err(no_archive)?.into_owned();
        let fault = |found: String, expected: &str| Fault::at(name.as_str(), found, expected);
        let (folder, own) = name.rsplit_once('/').unwrap_or(("", &name));
        let mut bytes = Vec::new();
        let read = file.by_ref().take(left + 1).read_to_end(&mut bytes);
        let read = read.map_err(|error| fault(error.to_string(), expected))?;
        let Some(rest) = left.checked_sub(read as u64) else {
            let most = format!("at most {} MB in all files", BYTES >> 20);
            return Err(fault("more than that".to_owned(), &most));
        };
        left = rest;
        let bundle = bundles.entry(folder.to_owned()).or_default();
        if bundle.insert(own.to_owned(), bytes).is_some() {
            return Err(fault("a second file of this name".to_owned(), "one"));
        }
    }
    if bundles.is_empty() {
        return Err(Fault::at("", "an archive without files", expected));
    }
    Ok(bundles)
}
