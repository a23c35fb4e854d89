//! Zip archives without compression, as PKWARE's APPNOTE.TXT (6.3) has them.
//!
//! A library that compresses would weigh more than everything else that certificates
//! need here; whoever sends an archive over a network compresses it on the way.

use std::collections::BTreeMap;

use giveway_model::Fault;
use giveway_proof::Bundle;

/// The first of January 1980, the earliest day: the same files make the same bytes.
const DAY: u16 = 0x21;
/// The version that is needed to unpack.
const VERSION: u16 = 20;
/// Names are UTF-8.
const UTF8: u16 = 1 << 11;

/// Packs certificates, each into a folder of its name.
///
/// # Errors
/// Where there is too much for the format.
pub(super) fn pack(bundles: &BTreeMap<String, Bundle>) -> Result<Vec<u8>, Fault> {
    let (mut bytes, mut directory, mut count) = (Vec::new(), Vec::new(), 0_u16);
    for (folder, files) in bundles {
        for (file, content) in files {
            let name = format!("{folder}/{file}");
            let entry = entry(&name, content).ok_or_else(too_much)?;
            let offset = u32::try_from(bytes.len()).map_err(|_| too_much())?;
            bytes.extend(b"PK\x03\x04");
            bytes.extend(&entry);
            bytes.extend(name.as_bytes());
            bytes.extend(content);
            directory.extend(b"PK\x01\x02");
            directory.extend(VERSION.to_le_bytes()); // who made it: nobody in particular
            directory.extend(&entry);
            directory.extend([0; 10]); // no comment, one disk, no attributes
            directory.extend(offset.to_le_bytes());
            directory.extend(name.as_bytes());
            count = count.checked_add(1).ok_or_else(too_much)?;
        }
    }
    let start = u32::try_from(bytes.len()).map_err(|_| too_much())?;
    let length = u32::try_from(directory.len()).map_err(|_| too_much())?;
    bytes.extend(directory);
    bytes.extend(b"PK\x05\x06\0\0\0\0");
    bytes.extend([count, count].map(u16::to_le_bytes).as_flattened());
    bytes.extend([length, start].map(u32::to_le_bytes).as_flattened());
    bytes.extend([0; 2]);
    Ok(bytes)
}

fn too_much() -> Fault {
    Fault::at("certificates", "too much", "what fits into a zip archive")
}

/// What is said of a file before its content and in the directory.
fn entry(name: &str, content: &[u8]) -> Option<Vec<u8>> {
    let size = u32::try_from(content.len()).ok()?.to_le_bytes();
    let mut entry = Vec::new();
    let stored = 0;
    for short in [VERSION, UTF8, stored, 0, DAY] {
        entry.extend(short.to_le_bytes());
    }
    entry.extend(checksum(content).to_le_bytes());
    entry.extend(size);
    entry.extend(size);
    entry.extend(u16::try_from(name.len()).ok()?.to_le_bytes());
    entry.extend([0; 2]); // no extra field
    Some(entry)
}

/// CRC-32 with the polynomial of zip, 4 bits at a time.
fn checksum(bytes: &[u8]) -> u32 {
    let table: [u32; 16] = std::array::from_fn(|index| {
        (0..4).fold(index as u32, |crc, _| {
            (crc >> 1) ^ (0xedb8_8320 & 0_u32.wrapping_sub(crc & 1))
        })
    });
    let step = |crc: u32| (crc >> 4) ^ table[(crc & 15) as usize];
    !bytes
        .iter()
        .fold(!0, |crc, &byte| step(step(crc ^ u32::from(byte))))
}
