//! `giveway verify`: checks an exported certificate again.

use std::fs;
use std::path::Path;

use giveway_model::Fault;
use giveway_proof::{Budget, Bundle, verify};

use crate::{
    args::{Common, Verify},
    exit::Exit,
    failure::Failure,
    output::{self, text},
};

pub(crate) fn run(args: &Verify, common: &Common) -> Result<Exit, Failure> {
    let bundle = read(&args.folder)?;
    let report = verify(&bundle, &Budget::default());
    output::answer(common.format, &report, |_| text::verify(&report))?;
    Ok(match (report.accepted, report.stopped) {
        (true, _) => Exit::Answered,
        (false, false) => Exit::Wrong,
        (false, true) => Exit::Unknown,
    })
}

/// All that lies in the folder. A folder in it has no bytes, and is refused as
/// something that does not belong there.
fn read(folder: &Path) -> Result<Bundle, Failure> {
    let failure = |path: &Path, error: &std::io::Error| {
        let fault = Fault::at("", error.to_string(), "the folder of a certificate");
        Failure::input(path.to_string_lossy(), fault)
    };
    let mut bundle = Bundle::new();
    for entry in fs::read_dir(folder).map_err(|error| failure(folder, &error))? {
        let entry = entry.map_err(|error| failure(folder, &error))?;
        let path = entry.path();
        let bytes = if path.is_dir() {
            Vec::new()
        } else {
            fs::read(&path).map_err(|error| failure(&path, &error))?
        };
        bundle.insert(entry.file_name().to_string_lossy().into_owned(), bytes);
    }
    Ok(bundle)
}
