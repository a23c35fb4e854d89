//! What undo and redo do to a world that changes, in a sentence.

use giveway_model::change::What;
use giveway_model::tr_data;
use giveway_model::words::Sentence;

use crate::Mode;

/// What undo or redo did to the changes of the world; nothing where these are no part of it.
pub(crate) fn travelled(before: &Mode, after: &Mode, is_back: bool) -> Option<Sentence> {
    let (was, is) = match (before.changing(), after.changing()) {
        (Some(was), Some(is)) => (was, is),
        (Some(_), None) if is_back => {
            return Some(tr_data!(
                "The world does not change any more: that was undone."
            ));
        }
        (None, Some(is)) => {
            return Some(tr_data!(
                "The world changes again at time {at}.",
                at = is.at
            ));
        }
        (Some(_) | None, None) => return None,
    };
    let of_one = |more: &[What], fewer: &[What]| {
        let mut rest = more.to_vec();
        for what in fewer {
            if let Some(place) = rest.iter().position(|it| it == what) {
                rest.remove(place);
            }
        }
        let first = rest.first()?;
        Some(first.sentence().0)
    };
    match (of_one(&was.list, &is.list), of_one(&is.list, &was.list)) {
        (Some(what), None) if is_back => Some(tr_data!("Undone: {what}.", what)),
        (Some(what), None) => Some(tr_data!("Taken back again: {what}.", what)),
        (_, Some(what)) => Some(tr_data!("Listed again: {what}.", what)),
        (None, None) if before.comparing().is_some() && after.comparing().is_none() => Some(
            tr_data!("The new plans were put aside. What changes is still listed."),
        ),
        (None, None) => None,
    }
}
