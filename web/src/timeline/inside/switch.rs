//! The tabs beside the transport: lanes or how they were found; and of which method.

use crate::part::part;
use giveway_model::tr;
use giveway_page::inside::{InsideAction, Method};
use giveway_page::order::OrderAction;
use giveway_page::robots::RobotsAction;
use giveway_page::sizing::SizingAction;
use giveway_page::{Action, State};
use gloo::timers::callback::Timeout;
use wasm_bindgen::JsCast;
use web_sys::HtmlElement;
use yew::prelude::*;

#[derive(Clone, PartialEq, Properties)]
struct SwitchProps {
    class: &'static str,
    label: &'static str,
    /// The names of the tabs; where one is short, what it is called aloud.
    names: Vec<(&'static str, Option<&'static str>)>,
    /// Which of them is chosen.
    chosen: usize,
    choose: Callback<usize>,
}

/// Tabs side by side: the arrow keys choose among them.
#[component]
fn Switch(props: &SwitchProps) -> Html {
    let SwitchProps {
        class,
        label,
        names,
        chosen,
        choose,
    } = props;
    let label = *label;
    let onkeydown = {
        let choose = choose.clone();
        let (at, count) = (*chosen, names.len());
        move |event: KeyboardEvent| {
            let to = match event.key().as_str() {
                "ArrowRight" => (at + 1) % count,
                "ArrowLeft" => (at + count - 1) % count,
                "Home" => 0,
                "End" => count - 1,
                _ => return,
            };
            event.prevent_default();
            event.stop_propagation();
            choose.emit(to);
            keep_focus(label);
        }
    };
    let choose = {
        let choose = choose.clone();
        Callback::from(move |index: usize| {
            choose.emit(index);
            keep_focus(label);
        })
    };
    let one = |(index, (name, aloud)): (usize, &(&'static str, Option<&'static str>))| {
        let is_chosen = index == *chosen;
        html! {
            <button type="button" role="tab" aria-selected={is_chosen.to_string()} aria-label={*aloud} title={*aloud}
                tabindex={if is_chosen { "0" } else { "-1" }} onclick={choose.reform(move |_| index)}>{ *name }</button>
        }
    };
    html! {
        <div class={classes!("seg", *class)} role="tablist" aria-label={label} {onkeydown}>
            { for names.iter().enumerate().map(one) }
        </div>
    }
}

/// Leaves the focus on the chosen tab of these, though all around it is drawn anew.
fn keep_focus(label: &'static str) {
    let focus = move || {
        let tab = format!("[role=tablist][aria-label=\"{label}\"] [aria-selected=true]");
        let document = gloo::utils::document();
        if let Ok(Some(tab)) = document.query_selector(&tab)
            && let Ok(tab) = tab.dyn_into::<HtmlElement>()
        {
            let _ = tab.focus();
        }
    };
    Timeout::new(0, focus).forget();
}

/// What stands below the board.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Below {
    Lanes,
    Order,
    Robots,
    Sizing,
    Inside,
}

impl Below {
    /// Its name, and what it is called aloud where that is longer.
    fn name(self) -> (&'static str, Option<&'static str>) {
        match self {
            Self::Lanes => (tr!("Timeline"), None),
            Self::Order => (tr!("Order"), None),
            Self::Robots => (tr!("Robots"), None),
            Self::Sizing => (tr!("How many?"), None),
            Self::Inside => (
                tr!("a tab" => "Proof"),
                Some(tr!("Proof: how it was proved")),
            ),
        }
    }

    /// What is there now.
    fn of(state: &State) -> Self {
        if state.is_inside() {
            Self::Inside
        } else if state.shows_sizing() {
            Self::Sizing
        } else if state.shows_order() {
            Self::Order
        } else if state.shows_robots() {
            Self::Robots
        } else {
            Self::Lanes
        }
    }

    /// Opens it, or leaves it.
    fn show(self, on: bool) -> Option<Action> {
        Some(match self {
            Self::Lanes => return None,
            Self::Order => Action::Order(OrderAction::Show(on)),
            Self::Robots => Action::Robots(RobotsAction::Show(on)),
            Self::Sizing => Action::Sizing(SizingAction::Show(on)),
            Self::Inside => Action::Inside(InsideAction::Show(on)),
        })
    }
}

/// The lanes, the table of the robots, how many there could be, or how they were found.
pub(in crate::timeline) fn places(state: &State, send: &Callback<Action>) -> Html {
    let has_robots = state.can_show_robots();
    let is_solved = state.playing().is_some()
        || state.document.fresh_answer().is_some()
        || state.awaited().is_some();
    let has_inside = state.is_inside() || (is_solved && state.can_look_inside());
    if state.keeps_inside() || (!has_robots && !has_inside) {
        return html! {};
    }
    let mut all = vec![Below::Lanes];
    all.extend(state.can_order().then_some(Below::Order));
    all.extend(has_robots.then_some(Below::Robots));
    all.extend(state.can_size().then_some(Below::Sizing));
    all.extend(has_inside.then_some(Below::Inside));
    let now = Below::of(state);
    let chosen = all.iter().position(|&it| it == now).unwrap_or(0);
    let names = all.iter().map(|it| it.name()).collect();
    let choose = {
        let send = send.clone();
        Callback::from(move |index: usize| {
            let Some(&to) = all.get(index).filter(|&&to| to != now) else {
                return;
            };
            for action in [now.show(false), to.show(true)].into_iter().flatten() {
                send.emit(action);
            }
        })
    };
    html! {
        { part::<Switch>(SwitchProps { class: "dtabs", label: tr!("What stands below the board"), names, chosen, choose }) }
    }
}

/// The methods.
pub(super) fn methods(state: &State, send: &Callback<Action>) -> Html {
    let chosen = Method::ALL
        .iter()
        .position(|method| *method == state.inside.method);
    let choose = send.reform(|index: usize| {
        let method = Method::ALL.get(index).copied().unwrap_or_default();
        Action::Inside(InsideAction::By(method))
    });
    html! {
        { part::<Switch>(SwitchProps { class: "mtabs", label: tr!("Method"), names: Method::ALL.map(|method| (method.title(), None)).to_vec(), chosen: chosen.unwrap_or(0), choose }) }
    }
}
