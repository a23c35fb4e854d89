//! How the text of a link arrived: whole, cut, changed on its way, or without a check.

use super::repair::{lacks_beginning, readings};
use super::seal::{self, Sealed};

/// How a link arrived.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Arrival {
    /// All of it, by its check: the text, without the check.
    Whole(String),
    /// It has no check, as links of earlier versions: the texts that it may have been, the
    /// likeliest first; at least one.
    Unchecked(Vec<String>),
    /// It was cut.
    Cut {
        /// How many characters arrived.
        arrived: usize,
        /// How many there were; `None` where that was cut away, too.
        length: Option<usize>,
    },
    /// Its beginning is missing.
    WithoutBeginning,
    /// It was changed on its way, or cut and then lengthened.
    Changed,
}

/// How a text arrived; what mail programs did to it is undone.
///
/// ```
/// use giveway_model::format::link::{arrival::{Arrival, arrival}, seal};
/// let whole = "giveway=1&map=3.3f&name=x&rules=0.0&costs=0&agents=A.0.0.2.0!9.6".to_owned();
/// let mailed = seal::write(&whole).replace('!', "%21").replace('&', "&amp;") + ")";
/// assert_eq!(arrival(&mailed), Arrival::Whole(whole));
/// assert!(matches!(arrival(&mailed[..40]), Arrival::Cut { .. }));
/// ```
pub fn arrival(text: &str) -> Arrival {
    if let Sealed::Whole(whole) = seal::read(text) {
        return Arrival::Whole(whole);
    }
    let readings = readings(text);
    let (first, mut fault) = (readings.first(), None);
    for reading in &readings {
        match seal::read(reading) {
            Sealed::Whole(whole) => return Arrival::Whole(whole),
            Sealed::Without if !reading.is_empty() && "giveway=1".starts_with(&**reading) => {
                fault.get_or_insert(Arrival::Cut {
                    arrived: reading.len(),
                    length: None,
                });
            }
            Sealed::Without => {}
            // A text that was decoded may be shorter than the one that was sent.
            Sealed::Cut(arrived, length) if length.is_none() || Some(reading) == first => {
                fault.get_or_insert(Arrival::Cut { arrived, length });
            }
            Sealed::Cut(..) | Sealed::Changed => {
                fault.get_or_insert(Arrival::Changed);
            }
        }
    }
    match fault {
        Some(fault) => fault,
        None if lacks_beginning(text) => Arrival::WithoutBeginning,
        None => Arrival::Unchecked(readings),
    }
}
