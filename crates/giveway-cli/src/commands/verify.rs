//! `giveway verify`: checks exported certificates again.

use std::collections::{BTreeMap, BTreeSet};
use std::fs::{self, File};
use std::io::{self, Read};
use std::path::Path;

use giveway_model::{Fault, Version};
use giveway_proof::bundle::{Manifest, archive};
use giveway_proof::{Budget, Bundle, Certified, Report, verify};
use serde::Serialize;

use crate::{
    args::{Common, Verify},
    exit::Exit,
    failure::Failure,
    output::{self, Said, text},
};

/// The bytes of the manifest, and of any other file, beyond which a folder is no
/// certificate: what is exported is far smaller.
const MOST_MANIFEST: u64 = 4 << 20;
const MOST: u64 = 512 << 20;

/// What came of checking several certificates.
#[derive(Serialize)]
struct Reports {
    giveway: Version,
    /// By their names.
    certificates: BTreeMap<String, Report>,
}

pub(crate) fn run(args: &Verify, common: &Common) -> Result<Exit, Failure> {
    let reports = read(&args.certificate)?.into_iter();
    let reports = reports.map(|(name, bundle)| (name, verify(&bundle, &Budget::default())));
    let reports = Reports {
        giveway: Version,
        certificates: reports.collect(),
    };
    let is = |test: fn(&Report) -> bool| reports.certificates.values().any(test);
    let exit = if is(|report| report.certified == Certified::NotCertified && !report.stopped) {
        Exit::Wrong
    } else if is(|report| report.certified == Certified::NotCertified) {
        Exit::Unknown
    } else {
        Exit::Answered
    };
    match reports.certificates.first_key_value() {
        Some((_, report)) if reports.certificates.len() == 1 => {
            output::answer(common.format, &Said::default(), report, |_| {
                text::verify(report)
            })?;
        }
        _ => output::answer(common.format, &Said::default(), &reports, |_| {
            text::verify_all(&reports.certificates)
        })?,
    }
    Ok(exit)
}

/// The certificates of an archive, of a folder of folders, or the one of a folder.
fn read(path: &Path) -> Result<archive::Bundles, Failure> {
    let failure = |error: &io::Error| {
        let fault = Fault::at("", error.to_string(), "a certificate");
        Failure::input(path.to_string_lossy(), fault)
    };
    if fs::metadata(path)
        .map_err(|error| failure(&error))?
        .is_file()
    {
        let bytes = bounded(path, MOST).map_err(|error| failure(&error))?;
        return archive::unpack(&bytes)
            .map_err(|fault| Failure::input(path.to_string_lossy(), fault));
    }
    let mut bundles = archive::Bundles::new();
    if !path.join(MANIFEST).exists() {
        for entry in fs::read_dir(path).map_err(|error| failure(&error))? {
            let entry = entry.map_err(|error| failure(&error))?;
            if entry.path().join(MANIFEST).is_file() {
                let name = entry.file_name().to_string_lossy().into_owned();
                bundles.insert(name, read_folder(&entry.path())?);
            }
        }
    }
    if bundles.is_empty() {
        bundles.insert(String::new(), read_folder(path)?);
    }
    Ok(bundles)
}

/// The manifest, and the files that it names: no others are read. Whatever else
/// lies in the folder has no bytes, and is refused as something that does not
/// belong there.
fn read_folder(folder: &Path) -> Result<Bundle, Failure> {
    let failure = |path: &Path, error: &io::Error| {
        let fault = Fault::at("", error.to_string(), "the folder of a certificate");
        Failure::input(path.to_string_lossy(), fault)
    };
    let mut names = BTreeSet::new();
    for entry in fs::read_dir(folder).map_err(|error| failure(folder, &error))? {
        let entry = entry.map_err(|error| failure(folder, &error))?;
        names.insert(entry.file_name().to_string_lossy().into_owned());
    }
    let mut bundle = Bundle::new();
    let mut expected = BTreeSet::new();
    if names.contains(MANIFEST) {
        let path = folder.join(MANIFEST);
        let bytes = bounded(&path, MOST_MANIFEST).map_err(|error| failure(&path, &error))?;
        let manifest: Option<Manifest> = serde_json::from_slice(&bytes).ok();
        expected = manifest.and_then(|m| m.expected()).unwrap_or_default();
        bundle.insert(MANIFEST.to_owned(), bytes);
    }
    names.remove(MANIFEST);
    for name in names {
        let path = folder.join(&name);
        let bytes = if expected.contains(&name) {
            bounded(&path, MOST).map_err(|error| failure(&path, &error))?
        } else {
            Vec::new()
        };
        bundle.insert(name, bytes);
    }
    Ok(bundle)
}

const MANIFEST: &str = "manifest.json";

/// The bytes of a regular file that is not too large: no link, no pipe, no device.
fn bounded(path: &Path, most: u64) -> io::Result<Vec<u8>> {
    if !fs::symlink_metadata(path)?.is_file() {
        return Err(io::Error::other("something other than a regular file"));
    }
    let mut bytes = Vec::new();
    File::open(path)?.take(most + 1).read_to_end(&mut bytes)?;
    if bytes.len() as u64 > most {
        return Err(io::Error::other("a file that is too large"));
    }
    Ok(bytes)
}
