//! Certificates: how large they are, and how long it takes to make and to check
//! them.

use std::error::Error;
use std::fmt::Write as _;
use std::fs;
use std::path::Path;

use giveway_model::{Cost, words};
use giveway_proof::bundle::{Entry, Manifest};

use crate::rows::{self, Row};
use crate::run::Command;

/// The worked examples.
const EXAMPLES: [&str; 4] = ["warehouse", "scenario-1", "scenario-6", "dynamic-3x3"];

/// Wall seconds for making one; what is not certified by then says so.
const LIMIT: &str = "60";

const HEAD: &str = "\
| instance | no plan has less | MB | to make, CPU s | to check, CPU s |
| --- | --- | ---: | ---: | ---: |
";

/// The table of all of them: the worked examples, and all rows of the other tables.
///
/// # Errors
/// Where the command fails, or refuses what it wrote.
pub(crate) fn table(command: &Command) -> Result<String, Box<dyn Error>> {
    let mut text = HEAD.to_owned();
    for name in EXAMPLES {
        let file = rows::data(&format!("seed/{name}.json"));
        let options = [file.to_string_lossy().into_owned()];
        row(command, &mut text, name, &options)?;
    }
    for group in rows::groups()? {
        for Row {
            name,
            file,
            agents,
            objective,
            ..
        } in &group.rows
        {
            let mut options = vec![file.to_string_lossy().into_owned()];
            options.extend(["--objective".to_owned(), objective.to_string()]);
            if let Some(agents) = agents {
                options.extend(["--agents".to_owned(), agents.to_string()]);
            }
            row(command, &mut text, name, &options)?;
        }
    }
    Ok(text)
}

/// Makes and checks one certificate.
fn row(
    command: &Command,
    text: &mut String,
    name: &str,
    options: &[String],
) -> Result<(), Box<dyn Error>> {
    let folder = tempfile::tempdir()?;
    let place = folder.path().to_string_lossy().into_owned();
    let mut make = vec!["solve", "--quiet", "--proof", &place, "--time-limit", LIMIT];
    make.extend(options.iter().map(String::as_str));
    let made = command.seconds(&make)?;
    let manifest = fs::read_to_string(folder.path().join("manifest.json"))?;
    let manifest: Manifest = serde_json::from_str(&manifest)?;
    // What is not certified is no success, though all that is there holds.
    let is_missing = |entry: &Entry| matches!(entry, Entry::None { .. });
    let status = i32::from(manifest.claims.iter().any(is_missing));
    let checked = command.seconds_with_status(&["verify", &place, "--quiet"], status)?;
    let claims: Vec<String> = manifest.claims.iter().map(shown_by).collect();
    let claims = claims.join("; ");
    let megabytes = size(folder.path())? as f64 / 1e6;
    let _ = writeln!(
        text,
        "| {name} | {claims} | {megabytes:.1} | {made:.2} | {checked:.2} |"
    );
    eprintln!("{name}: {claims}; {megabytes:.1} MB, {made:.2} s and {checked:.2} s");
    Ok(())
}

/// What a claim is about, and what shows it.
fn shown_by(entry: &Entry) -> String {
    // Costs are in the order of objectives, and the last limit is the one that no plan keeps.
    let mut limits = Cost::ALL.iter().rev();
    let about = limits.find(|cost| entry.claim().most.contains_key(cost));
    let about = about.map_or("plans at all", |&cost| words::name(cost));
    let by = match entry {
        Entry::Proof { .. } => "a proof".to_owned(),
        Entry::Lemmas { lemmas, .. } => {
            let most = lemmas.iter().map(|proved| proved.lemma.by.len()).max();
            format!(
                "{} lemmas of at most {} robots",
                lemmas.len(),
                most.unwrap_or_default()
            )
        }
        Entry::Search { .. } => "a search".to_owned(),
        Entry::None { .. } => "**nothing**".to_owned(),
    };
    format!("{about}: {by}")
}

/// The bytes of all files of a folder.
fn size(folder: &Path) -> Result<u64, std::io::Error> {
    let mut bytes = 0;
    for entry in fs::read_dir(folder)? {
        bytes += entry?.metadata()?.len();
    }
    Ok(bytes)
}
