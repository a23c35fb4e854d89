//! The menu beside `Solve`: planners of the textbook, each with what it promises.

use giveway_model::tr;
use giveway_page::{Action, SolveAction, State, planners};
use giveway_solve::plan::Planner;
use web_sys::HtmlElement;
use yew::prelude::*;

use crate::dialog::Panel;
use crate::icon;

/// The button with its menu; nothing where something else is done with the plan.
pub(super) fn show(
    state: &State,
    toggle: &NodeRef,
    panel: &Panel,
    send: &Callback<Action>,
    show: &Callback<Panel>,
) -> Html {
    if !state.can_plan() {
        return Html::default();
    }
    let open = *panel == Panel::Planners;
    let press = show.reform(move |_: MouseEvent| {
        if open {
            Panel::Nothing
        } else {
            Panel::Planners
        }
    });
    let item = |action: SolveAction, title: &'static str, promise: &'static str| {
        let (send, show, toggle) = (send.clone(), show.clone(), toggle.clone());
        let press = move |_: MouseEvent| {
            // The menu goes, and the focus with it.
            if let Some(toggle) = toggle.cast::<HtmlElement>() {
                let _ = toggle.focus();
            }
            show.emit(Panel::Nothing);
            send.emit(Action::Solve(action.clone()));
        };
        html! { <button onclick={press}><span>{ title }<small>{ promise }</small></span></button> }
    };
    let planner = |planner: Planner| {
        item(
            SolveAction::Plan(planner),
            planner.title(),
            planners::promise(planner),
        )
    };
    html! {
        <>
            <button ref={toggle} class="btn outline by" title={tr!("Planners")} aria-expanded={open.to_string()} onclick={press}>
                { icon::show("down") }<span class="vh">{ tr!("Planners") }</span>
            </button>
            if open {
                <div class="menu">
                    { item(SolveAction::Solve, planners::BEST.text(), planners::BEST_PROMISE.text()) }
                    <hr />
                    { for Planner::ALL.into_iter().map(planner) }
                </div>
            }
        </>
    }
}
