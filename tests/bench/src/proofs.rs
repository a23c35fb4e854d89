//! Certificates: how large they are, and how long it takes to make and to check
//! them.

use std::error::Error;
use std::fmt::Write as _;
use std::fs;
use std::path::{Path, PathBuf};

use giveway_proof::bundle::{Entry, Manifest};

use crate::rows;
use crate::run::Command;

/// The graded instances that are certified.
const GRADED: [&str; 17] = [
    "A01", "A02", "A03", "A04", "A05", "A06", "A07", "A08", "B01", "B02", "B03", "B04", "B05",
    "B06", "B07", "B08", "B13",
];
/// The worked examples.
const EXAMPLES: [&str; 4] = ["warehouse", "scenario-1", "scenario-6", "dynamic-3x3"];

/// Wall seconds for making one; what is not certified by then says so.
const LIMIT: &str = "60";

const HEAD: &str = "\
| instance | there is no plan | variables | clauses | formula MB | proof MB | to make, CPU s | to check, CPU s |
| --- | --- | ---: | ---: | ---: | ---: | ---: | ---: |
";

/// The table of all of them.
///
/// # Errors
/// Where the command fails, or refuses what it wrote.
pub(crate) fn table(command: &Command) -> Result<String, Box<dyn Error>> {
    let mut text = HEAD.to_owned();
    for name in EXAMPLES {
        let file = rows::data(&format!("seed/{name}.json"));
        row(command, &mut text, name, &file)?;
    }
    for name in GRADED {
        let (stem, file) = rows::graded_file(name)?;
        row(command, &mut text, &stem, &file)?;
    }
    Ok(text)
}

/// Makes and checks one certificate; a line for each of its claims.
fn row(
    command: &Command,
    text: &mut String,
    name: &str,
    file: &Path,
) -> Result<(), Box<dyn Error>> {
    let folder = tempfile::tempdir()?;
    let place = folder.path().to_string_lossy().into_owned();
    let file = file.to_string_lossy();
    let made = command.seconds(&[
        "solve",
        &file,
        "--quiet",
        "--proof",
        &place,
        "--time-limit",
        LIMIT,
    ])?;
    let checked = command.seconds(&["verify", &place, "--quiet"])?;
    let manifest = fs::read_to_string(folder.path().join("manifest.json"))?;
    let manifest: Manifest = serde_json::from_str(&manifest)?;
    // The times are those of all claims of an instance together.
    let (mut made, mut checked) = (format!("{made:.2}"), format!("{checked:.2}"));
    for entry in &manifest.claims {
        let claim = entry.claim().sentence();
        let claim = claim.trim_start_matches("There is no plan").trim();
        let rest = match entry {
            Entry::Proof {
                name,
                variables,
                clauses,
                ..
            } => {
                let size = |ending: &str| -> Result<f64, std::io::Error> {
                    let path: PathBuf = folder.path().join(format!("{name}.{ending}"));
                    Ok(fs::metadata(path)?.len() as f64 / 1e6)
                };
                let (cnf, drat) = (size("cnf")?, size("drat")?);
                format!("{variables} | {clauses} | {cnf:.2} | {drat:.2}")
            }
            Entry::Lemmas { lemmas, .. } => {
                let variables: usize = lemmas.iter().map(|lemma| lemma.variables).sum();
                let clauses: usize = lemmas.iter().map(|lemma| lemma.clauses).sum();
                let most = lemmas.iter().map(|lemma| lemma.lemma.by.len()).max();
                let size = |ending: &str| -> Result<f64, std::io::Error> {
                    let mut size = 0;
                    for lemma in lemmas {
                        size +=
                            fs::metadata(folder.path().join(format!("{}.{ending}", lemma.name)))?
                                .len();
                    }
                    Ok(size as f64 / 1e6)
                };
                let (cnf, drat) = (size("cnf")?, size("drat")?);
                format!(
                    "{} lemmas of at most {} robots: {variables} | {clauses} | {cnf:.2} | {drat:.2}",
                    lemmas.len(),
                    most.unwrap_or_default(),
                )
            }
            Entry::Search { .. } => "by search | - | - | -".to_owned(),
            Entry::None { why, .. } => format!("{} | - | - | -", why.sentence()),
        };
        let _ = writeln!(text, "| {name} | {claim} | {rest} | {made} | {checked} |");
        eprintln!("{name} {claim} {rest} {made} {checked}");
        (made, checked) = ("\"".to_owned(), "\"".to_owned());
    }
    Ok(())
}
