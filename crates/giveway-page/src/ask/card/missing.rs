//! What is told in the place of reasons, or of what would help, where a search ended without them.

use giveway_model::tr;
use giveway_solve::explain::{ExplainAnswer, GroupMark, Layer, Part, Verdict};

use super::Card;
use super::coming::layers;
use crate::{Asking, State};

/// A part of an answer that was not found.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Missing {
    /// The heading of the part.
    pub title: &'static str,
    /// Why it is not there: a sentence each.
    pub sentences: Vec<String>,
}

/// The parts that are not there though the search is over, in the order of the card.
pub(super) fn missing(
    state: &State,
    asking: &Asking,
    told: &ExplainAnswer,
    card: &Card,
) -> Vec<Missing> {
    let has = |layer: Layer| layers(asking.question()).contains(&layer);
    if state.is_looking() || !has(Layer::Reason) || told.valid.is_some() {
        return Vec::new();
    }
    let mut missing = Vec::new();
    if card.cores.is_empty()
        && let Some(sentence) = no_reason(told)
    {
        let title = tr!("Because of");
        let sentences = vec![sentence.to_owned()];
        missing.push(Missing { title, sentences });
    }
    let can_help = has(Layer::Help) && asking.can_be_repaired() && card.repairs.is_empty();
    if can_help && matches!(told.verdict, Verdict::Costly | Verdict::Necessary) {
        let title = tr!("What would help");
        let sentence = if has_helping_group(told) {
            tr!("See what is marked as helping above.")
        } else if told.exhaustive {
            tr!("No change of one or two things in the scene helps.")
        } else if told.pending.contains(&Part::Repairs) {
            tr!("The search ended before this was looked for.")
        } else {
            tr!("Nothing was found that helps.")
        };
        let sentences = vec![sentence.to_owned()];
        missing.push(Missing { title, sentences });
    }
    missing
}

/// Whether a group of the reasons has a fact without which there is a plan that costs less.
fn has_helping_group(told: &ExplainAnswer) -> bool {
    let mut groups = told.core.iter().flat_map(|core| &core.groups);
    groups.any(|group| group.mark() == GroupMark::Helps)
}

/// Why there is no reason; `None` where none is needed.
fn no_reason(told: &ExplainAnswer) -> Option<&'static str> {
    match told.verdict {
        Verdict::Needless | Verdict::Improvable => None,
        Verdict::Unknown => Some(tr!(
            "Reasons are looked for once it is known what the best other plan costs."
        )),
        Verdict::Costly | Verdict::Necessary => Some(tr!("No small reason was found yet.")),
    }
}
