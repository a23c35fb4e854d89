//! What can be tried where no method has a plan.

use giveway_model::tr;
use giveway_solve::Status;

use crate::State;
use crate::changing::entries::entries;
use crate::changing::{Choice, Tried, WIDEST};

/// What can be tried where no method has a plan.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Fix {
    /// Takes a listed change back, by its index: what it is, in words.
    TakeBack(usize, String),
    /// Tries other methods.
    Try(Choice, String),
    /// Searches for so many seconds.
    Longer(u32),
}

/// What can be tried, the likeliest first; nothing where a method has a plan, or
/// nothing is compared.
pub fn fixes(state: &State) -> Vec<Fix> {
    let Some(comparing) = state.document.mode.comparing() else {
        return Vec::new();
    };
    let (changing, tried) = (&comparing.changing, &comparing.tried);
    if tried.iter().any(|tried| tried.answer.is_some()) {
        return Vec::new();
    }
    let mut fixes = Vec::new();
    let choice = state.settings.methods;
    let is_open = |tried: &Tried| tried.told.result.status != Status::Impossible;
    if tried.iter().any(is_open) {
        fixes.push(Fix::Longer(state.settings.seconds.saturating_mul(4)));
    }
    if !choice.replan {
        let all = Choice {
            replan: true,
            ..choice
        };
        fixes.push(Fix::Try(
            all,
            tr!("Let everyone plan freely (Everything new)").to_owned(),
        ));
        if choice.tunnel && choice.width < WIDEST {
            let width = choice.width + 1;
            let wider = Choice { width, ..choice };
            fixes.push(Fix::Try(
                wider,
                tr!("Allow {n} cell away from the old paths"
                    | "Allow {n} cells away from the old paths" % width),
            ));
        }
    }
    let listed = entries(changing.about.plan(), &changing.list, changing.at).into_iter();
    let listed = listed.filter_map(|entry| Some((*entry.changes.first()?, entry.text())));
    fixes.extend(listed.map(|(index, text)| Fix::TakeBack(index, text)));
    fixes
}
