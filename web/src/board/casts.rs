//! Who is on the board by which plan, kept as long as it fits.

use std::rc::Rc;

use giveway_page::board::Cast;
use giveway_page::{Answer, State};
use yew::prelude::*;

use crate::Shown;
use crate::held::use_held;

/// The cast of the plan that is shown, and that of the one beside it; the same
/// ones as long as they fit.
#[hook]
pub(super) fn use_casts(state: &Shown) -> (Rc<Cast>, Option<Rc<Cast>>) {
    let kept = use_held(<[Option<Rc<Cast>>; 2]>::default);
    let [mut this, mut other] = kept.take();
    let casts = (
        renewed(&mut this, state, state.shown()),
        state
            .beside()
            .map(|answer| renewed(&mut other, state, Some(answer))),
    );
    kept.set([this, other]);
    casts
}

pub(super) fn renewed(
    kept: &mut Option<Rc<Cast>>,
    state: &State,
    answer: Option<&Rc<Answer>>,
) -> Rc<Cast> {
    match kept {
        Some(cast) if cast.is_by(state, answer) => Rc::clone(cast),
        _ => Rc::clone(kept.insert(Rc::new(Cast::by(state, answer)))),
    }
}
