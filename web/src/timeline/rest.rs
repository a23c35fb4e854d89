//! The line below the lanes of two plans: the robots that drive the same in both.

use giveway_model::tr;
use giveway_page::beside::same;
use giveway_page::{Action, ComparedLanes, State, ViewAction};
use yew::prelude::*;

/// The line with the button that shows their lanes, too; nothing where there are none.
pub(super) fn show(state: &State, lanes: usize, send: &Callback<Action>) -> Html {
    let Some(same) = same(state) else {
        return Html::default();
    };
    let (is_all, next) = match state.view.lanes {
        ComparedLanes::Differing => (false, ComparedLanes::All),
        ComparedLanes::All => (true, ComparedLanes::Differing),
    };
    let onclick = send.reform(move |_| Action::View(ViewAction::ShowLanes(next)));
    html! {
        <div class="rest" key={lanes}>
            <span>{ tr!("{n} robot drives the same in both" | "{n} robots drive the same in both" % same) }</span>
            <button type="button" class="link" aria-pressed={is_all.to_string()} {onclick}>
                { if is_all { tr!("Show those that differ") } else { tr!("Show all lanes") } }
            </button>
        </div>
    }
}
