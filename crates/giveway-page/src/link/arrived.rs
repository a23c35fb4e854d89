//! A link as it arrives from anywhere: checked, repaired, and read; or why it is not opened.

use giveway_model::format::link::arrival::{Arrival, arrival};
use giveway_model::tr;

use super::read::Reader;
use super::{From, Linked};

/// The part that every link has and that stands behind the other parts of a scene.
const LAST: &str = "&agents=";

/// Reads a text that came from anywhere.
///
/// # Errors
/// Why it cannot be opened, in sentences.
pub(super) fn read(text: &str) -> Result<Linked, Vec<String>> {
    let read = |text: &str| Reader::default().read(text, From::Anywhere);
    match arrival(text) {
        Arrival::Whole(text) => read(&text).map_err(|why| vec![why]),
        Arrival::Unchecked(readings) => unchecked(&readings, read),
        Arrival::Cut { arrived, length } => Err(vec![
            match length {
                Some(length) => tr!(
                    "This link was cut: {arrived} of its {length} characters arrived.",
                    arrived,
                    length
                ),
                None => tr!("This link was cut: only its beginning arrived.").to_owned(),
            },
            again(),
        ]),
        Arrival::WithoutBeginning => Err(vec![
            tr!("This link was cut: its beginning is missing.").to_owned(),
            again(),
        ]),
        Arrival::Changed => Err(vec![
            tr!("This link was changed or cut on its way: its check sum does not fit.").to_owned(),
            again(),
        ]),
    }
}

/// A link without a check: the first of its readings that can be opened.
fn unchecked(
    readings: &[String],
    read: impl Fn(&str) -> Result<Linked, String>,
) -> Result<Linked, Vec<String>> {
    let mut why = None;
    for reading in readings {
        match read(reading) {
            Ok(_) if !reading.contains(LAST) => {
                let cut = tr!("This link was cut: its robots are missing.").to_owned();
                return Err(vec![cut, again()]);
            }
            Ok(linked) => {
                return Ok(Linked {
                    is_checked: false,
                    ..linked
                });
            }
            // What is told is about the text that looks most like a link.
            Err(fault) if why.is_none() || reading.starts_with("giveway=") => {
                let is_first = !matches!(why, Some((true, _)));
                if is_first {
                    why = Some((reading.starts_with("giveway="), fault));
                }
            }
            Err(_) => {}
        }
    }
    let (_, fault) = why.unwrap_or_default();
    let doubt = tr!("It may have been cut or changed on its way: it carries no check sum.");
    Err(vec![fault, doubt.to_owned()])
}

fn again() -> String {
    tr!("Copy the whole link, or ask for it again; a file is safer than a long link.").to_owned()
}
