//! The dock of a search by hand: who splits, take back, begin again; the tabs of a phone.

use giveway_model::tr;
use giveway_page::inside::{HandAction, InsideAction, by_hand};
use giveway_page::keys::key_name;
use giveway_page::{Action, State, Tab, ViewAction};
use web_sys::HtmlElement;
use yew::prelude::*;

use crate::icon;

fn act(action: HandAction) -> Action {
    Action::Inside(InsideAction::Hand(action))
}

/// A person splits, or the planner.
#[inline(never)]
pub(super) fn who(state: &State, send: &Callback<Action>) -> Html {
    let is_on = state.inside.by_hand.is_on;
    if is_on && !state.can_show_planners_tree() {
        return html! {};
    }
    let button = |name: &'static str, on: bool| {
        html! {
            <button type="button" aria-pressed={(on == is_on).to_string()} onclick={send.reform(move |_| act(HandAction::Show(on)))}>{ name }</button>
        }
    };
    html! {
        <div class="seg byh" role="group" aria-label={tr!("Who splits")}>
            { button(tr!("who splits" => "By hand"), true) }
            { button(tr!("who splits" => "Planner"), false) }
        </div>
    }
}

/// The buttons of a person who splits, and how many nodes there are.
#[inline(never)]
pub(super) fn keys(state: &State, send: &Callback<Action>) -> Html {
    let clock = by_hand::dock(state);
    let has_splits = by_hand::has_splits(state);
    let button = |icon: &'static str, title: String, name: &'static str, action: HandAction| {
        html! {
            <button type="button" class="btn ghost round" {title} disabled={!has_splits} onclick={send.reform(move |_| act(action))}>
                { icon::show(icon) }<span class="vh">{ name }</span>
            </button>
        }
    };
    let back = tr!("Take back the last split");
    let restart = tr!("Begin again");
    let search = send.reform(|_| act(HandAction::Read(false)));
    html! {
        <>
            <div class="keys">
                { button("undo", format!("{back} ({})", key_name("Ctrl+Z")), back, HandAction::TakeBack) }
                { button("start", restart.to_owned(), restart, HandAction::Restart) }
            </div>
            if let Some((nodes, of)) = clock {
                <p class="clock"><b>{ nodes }</b><span>{ format!(" {of}") }</span></p>
            }
            if state.lesson().is_some() && !state.covers_lesson() {
                <button type="button" class="btn outline to-hand" onclick={search}>{ icon::show("tree") }<span>{ tr!("Search by hand") }</span></button>
            }
        </>
    }
}

#[derive(Clone, PartialEq, Properties)]
pub(super) struct TabsProps {
    /// What is shown, of those below.
    at: usize,
    /// The name of each, the place that it shows, and what shows it.
    tabs: Vec<(&'static str, &'static str, Action)>,
    send: Callback<Action>,
}

impl TabsProps {
    pub(super) fn of(state: &State, send: &Callback<Action>) -> Self {
        let is_tree = state.view.tab == Tab::Timeline;
        let is_in_lesson = state.lesson().is_some();
        let mut tabs = Vec::new();
        if is_in_lesson {
            tabs.push((tr!("Lesson"), "course", act(HandAction::Read(true))));
        }
        tabs.push((
            tr!("who splits" => "By hand"),
            "inspector",
            act(HandAction::Read(false)),
        ));
        let tree = Action::View(ViewAction::ShowTab(Tab::Timeline));
        tabs.push((tr!("a tab" => "Tree"), "lanes", tree));
        let last = tabs.len() - 1;
        let at = if is_tree {
            last
        } else if is_in_lesson && !state.covers_lesson() {
            0
        } else {
            last - 1
        };
        Self {
            at,
            tabs,
            send: send.clone(),
        }
    }
}

/// Fetches the style sheet; while one works on the page, it is there already.
fn dress() {
    let document = gloo::utils::document();
    let find = |place| document.query_selector(place).ok().flatten();
    let meta = find("meta[name=giveway-hand-style]");
    let path = meta.as_ref().and_then(|meta| meta.get_attribute("content"));
    let (Some(meta), Some(path), Some(head)) = (meta, path, find("head")) else {
        return;
    };
    if let Ok(link) = document.create_element("link") {
        // Neither fails for a name and an element such as these.
        let _ = link.set_attribute("rel", "stylesheet");
        let _ = link.set_attribute("href", &path);
        let _ = head.append_child(&link);
        meta.remove();
    }
}

/// The tabs of a phone.
#[component]
pub(super) fn HandTabs(props: &TabsProps) -> Html {
    let TabsProps { at, tabs, send } = props;
    use_effect_with((), |()| dress());
    let list = use_node_ref();
    let onkeydown = {
        let (list, props) = (list.clone(), props.clone());
        move |event: KeyboardEvent| {
            let (at, count) = (props.at, props.tabs.len());
            let to = match event.key().as_str() {
                "ArrowRight" => (at + 1) % count,
                "ArrowLeft" => (at + count - 1) % count,
                _ => return,
            };
            event.prevent_default();
            event.stop_propagation();
            props.send.emit(props.tabs[to].2.clone());
            let list = list.cast::<HtmlElement>();
            let button = list.and_then(|list| list.children().item(to as u32));
            if let Some(Ok(button)) = button.map(wasm_bindgen::JsCast::dyn_into::<HtmlElement>) {
                let _ = button.focus();
            }
        }
    };
    let one = |(place, (name, of, action)): (usize, &(&'static str, &'static str, Action))| {
        let is_shown = place == *at;
        let action = action.clone();
        html! {
            <button type="button" role="tab" aria-selected={is_shown.to_string()} aria-controls={*of} tabindex={if is_shown { "0" } else { "-1" }}
                onclick={send.reform(move |_| action.clone())}>{ *name }</button>
        }
    };
    html! {
        <div class="tabs" role="tablist" aria-label={tr!("Below the board")} ref={list} {onkeydown}>
            { for tabs.iter().enumerate().map(one) }
        </div>
    }
}
