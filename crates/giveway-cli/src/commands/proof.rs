//! `--proof DIR`: certificates of what was proved.

use std::fs;
use std::io::ErrorKind;
use std::path::Path;

use giveway_model::words::count;
use giveway_model::{Fault, Instance, Plan};
use giveway_proof::{Budget, Solved, bundle::Entry, bundle::Manifest, export};
use giveway_solve::explain::ExplainAnswer;
use giveway_solve::freedom::FreedomAnswer;
use giveway_solve::{Certificate, CertifyRequest, SolveAnswer};

use crate::{
    args::Common,
    clock::Clock,
    failure::Failure,
    output::{
        files::{self, NewFile},
        stream,
    },
};

/// Whether a certificate can be written to a folder: a new or an empty one,
/// since all that lies in it belongs to the certificate.
pub(crate) fn check_folder(folder: &Path) -> Result<(), Failure> {
    let name = || folder.to_string_lossy();
    match fs::read_dir(folder) {
        Ok(mut entries) => match entries.next() {
            None => Ok(()),
            Some(_) => Err(Failure::input(
                name(),
                Fault::at("", "a folder with files in it", "a new or an empty one"),
            )),
        },
        Err(error) if error.kind() == ErrorKind::NotFound => Ok(()),
        Err(error) => Err(Failure::output(name(), error)),
    }
}

/// Who asks for a certificate, and how long it may take.
#[derive(Clone, Copy)]
pub(crate) struct Asker<'a> {
    /// Wall seconds for the whole command.
    pub(crate) time_limit: Option<f64>,
    pub(crate) common: &'a Common,
    pub(crate) clock: Clock,
}

/// Certifies what `solve` answered.
pub(crate) fn write_solved(
    folder: &Path,
    instance: &Instance,
    answer: &SolveAnswer,
    asker: &Asker<'_>,
) -> Result<(), Failure> {
    let request = CertifyRequest::of_solved(instance.to_scene(), None, answer);
    let request = request.with_hints(answer.trace.as_ref());
    write(folder, &request.claims(instance), asker)
}

/// Certifies what `explain` answered about a plan.
pub(crate) fn write_explained(
    folder: &Path,
    instance: &Instance,
    plan: Option<&Plan>,
    answer: &ExplainAnswer,
    asker: &Asker<'_>,
) -> Result<(), Failure> {
    let request = CertifyRequest::of_explained(instance, plan, answer);
    write(folder, &request.claims(instance), asker)
}

/// Certifies what `freedom` answered: a folder for each claim.
pub(crate) fn write_freedom(
    folder: &Path,
    instance: &Instance,
    answer: &FreedomAnswer,
    asker: &Asker<'_>,
) -> Result<(), Failure> {
    let mut claims = Vec::new();
    for Certificate { name, request } in answer.certificates(instance) {
        let scene = Instance::new(request.scene.clone()).map_err(|faults| Failure::Input {
            file: name.clone(),
            faults,
        })?;
        claims.extend(write_bundle(
            &folder.join(name),
            &request.claims(&scene),
            asker,
        )?);
    }
    if claims.is_empty() {
        files::make_folder(folder)?;
    }
    note(folder, "certificates", &claims, asker);
    Ok(())
}

/// Writes a certificate, and tells on standard error what is in it.
fn write(folder: &Path, solved: &Solved<'_>, asker: &Asker<'_>) -> Result<(), Failure> {
    let claims = write_bundle(folder, solved, asker)?;
    note(folder, "a certificate", &claims, asker);
    Ok(())
}

fn note(folder: &Path, what: &str, claims: &[Entry], asker: &Asker<'_>) {
    if !asker.common.quiet {
        let summary = summary(claims);
        stream::note(&format!("{}: {what}, {summary}", folder.to_string_lossy()));
    }
}

/// Writes a certificate; what it claims.
fn write_bundle(
    folder: &Path,
    solved: &Solved<'_>,
    asker: &Asker<'_>,
) -> Result<Vec<Entry>, Failure> {
    let go_on = || {
        let limit = asker.time_limit;
        limit.is_none_or(|limit| asker.clock.wall_seconds() < limit)
    };
    let budget = Budget {
        go_on: &go_on,
        ..Budget::default()
    };
    let bundle = export(solved, &budget);
    let manifest = bundle.get("manifest.json");
    let claims = manifest
        .and_then(|text| serde_json::from_slice::<Manifest>(text).ok())
        .map(|manifest| manifest.claims)
        .unwrap_or_default();
    let mut texts = Vec::new();
    for (name, bytes) in bundle {
        let path = folder.join(&name);
        let text = String::from_utf8(bytes)
            .map_err(|error| Failure::output(name, std::io::Error::other(error)))?;
        texts.push(NewFile { path, text });
    }
    files::make_folder(folder)?;
    files::write_all(&texts)?;
    Ok(claims)
}

/// How many claims rest on what.
fn summary(claims: &[Entry]) -> String {
    let number = |is: fn(&Entry) -> bool| claims.iter().filter(|entry| is(entry)).count() as u64;
    let proofs = number(|entry| matches!(entry, Entry::Proof { .. }));
    let lemmas = number(|entry| matches!(entry, Entry::Lemmas { .. }));
    let searches = number(|entry| matches!(entry, Entry::Search { .. }));
    let nothing = number(|entry| matches!(entry, Entry::None { .. }));
    let mut parts = Vec::new();
    if proofs > 0 {
        parts.push(format!("{} with a proof", count(proofs, "claim")));
    }
    if lemmas > 0 {
        parts.push(format!("{} with lemmas", count(lemmas, "claim")));
    }
    if searches > 0 {
        parts.push(format!("{} with a search", count(searches, "claim")));
    }
    if nothing > 0 {
        parts.push(format!("{} not certified", count(nothing, "claim")));
    }
    if parts.is_empty() {
        parts.push("nothing to prove".to_owned());
    }
    parts.join(", ")
}
