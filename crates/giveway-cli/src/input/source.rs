//! One input as text: a file or standard input.

use std::fs::File;
use std::io::{self, Read};
use std::path::{Path, PathBuf};

use giveway_model::{Fault, format::decode};

use crate::failure::Failure;

/// More bytes than any instance within the limits takes.
const MAX_BYTES: u64 = 256 << 20;

/// A text, and where it came from.
#[derive(Clone, Debug)]
pub(crate) struct Source {
    /// Where it came from; `None` is standard input.
    pub(crate) path: Option<PathBuf>,
    /// The name in messages.
    pub(crate) name: String,
    /// The text, without the mark of its encoding.
    pub(crate) text: String,
    /// What a person should know of how its bytes were read.
    pub(crate) note: Option<String>,
}

/// Whether the argument stands for standard input.
pub(crate) fn is_standard_input(path: &Path) -> bool {
    path.as_os_str() == "-"
}

impl Source {
    /// Reads a file, or standard input for `-`.
    ///
    /// # Errors
    /// When it cannot be read, is too large, or is no text.
    pub(crate) fn read(path: &Path) -> Result<Self, Failure> {
        let standard = is_standard_input(path);
        let name = if standard {
            "standard input".to_owned()
        } else {
            path.to_string_lossy().into_owned()
        };
        let bytes = if standard {
            read_bytes(io::stdin().lock())
        } else if path.is_dir() {
            Err(Fault::at("", "a folder", "a file"))
        } else {
            File::open(path)
                .map_err(|error| unreadable(&error))
                .and_then(read_bytes)
        };
        let decoded = bytes.and_then(|bytes| {
            let (text, encoding) = decode(&bytes)?;
            Ok((text.into_owned(), encoding))
        });
        match decoded {
            Ok((text, encoding)) => Ok(Self {
                path: (!standard).then(|| path.to_owned()),
                note: encoding.note(&name),
                name,
                text,
            }),
            Err(fault) => Err(Failure::input(name, fault)),
        }
    }

    /// A failure because of one fault of this text.
    pub(crate) fn fault(&self, fault: Fault) -> Failure {
        Failure::input(&self.name, fault)
    }

    /// A failure because of the faults of this text.
    pub(crate) fn faults(&self, faults: Vec<Fault>) -> Failure {
        Failure::Input {
            file: self.name.clone(),
            faults,
        }
    }

    /// The file's name without folder and ending; `None` for standard input.
    pub(crate) fn stem(&self) -> Option<String> {
        let stem = self.path.as_ref()?.file_stem()?;
        Some(stem.to_string_lossy().into_owned())
    }
}

fn read_bytes(from: impl Read) -> Result<Vec<u8>, Fault> {
    let mut bytes = Vec::new();
    from.take(MAX_BYTES + 1)
        .read_to_end(&mut bytes)
        .map_err(|error| unreadable(&error))?;
    if bytes.len() as u64 > MAX_BYTES {
        return Err(Fault::at(
            "",
            format!("more than {} MB", MAX_BYTES >> 20),
            "an instance or a plan, which are smaller",
        ));
    }
    Ok(bytes)
}

fn unreadable(error: &io::Error) -> Fault {
    match error.kind() {
        io::ErrorKind::NotFound => Fault::at("", "no file of this name", "a file"),
        io::ErrorKind::PermissionDenied => {
            Fault::at("", "a file that may not be read", "a readable file")
        }
        _ => Fault::at("", format!("\"{error}\" on reading"), "a readable file"),
    }
}
