//! What a phone shows below the board.

use giveway_model::words::Later;
use giveway_model::{tr, tr_later};
use giveway_page::inside::Method;
use giveway_page::{Action, Tab, ViewAction};
use web_sys::HtmlElement;
use yew::prelude::*;

#[derive(Clone, PartialEq, Properties)]
pub(super) struct TabsProps {
    pub tab: Tab,
    /// Whether a plan of elsewhere is checked.
    pub checks: bool,
    /// Whether a lesson is on the board.
    pub teaches: bool,
    /// What is looked into in the place of the lanes.
    pub inside: Option<Method>,
    /// Whether there is a plan to stand in a table.
    pub has_table: bool,
    pub send: Callback<Action>,
}

const TABS: [(Tab, Later, &str); 3] = [
    (Tab::Inspector, tr_later!("Inspector"), "inspector"),
    (Tab::Timeline, tr_later!("Timeline"), "lanes"),
    (Tab::Plan, tr_later!("Plan"), "plan-table"),
];

/// The tabs; wider pages show all three places at once and no tabs.
#[component]
pub(super) fn Tabs(props: &TabsProps) -> Html {
    let TabsProps {
        tab,
        checks,
        teaches,
        inside,
        has_table,
        send,
    } = props;
    let count = TABS.len() - usize::from(!has_table);
    let list = use_node_ref();
    let onkeydown = {
        let (list, send, tab) = (list.clone(), send.clone(), *tab);
        move |event: KeyboardEvent| {
            let at = TABS
                .iter()
                .position(|&(other, ..)| other == tab)
                .unwrap_or(0);
            let to = match event.key().as_str() {
                "ArrowRight" => (at + 1) % count,
                "ArrowLeft" => (at + count - 1) % count,
                "Home" => 0,
                "End" => count - 1,
                _ => return,
            };
            event.prevent_default();
            event.stop_propagation();
            send.emit(Action::View(ViewAction::ShowTab(TABS[to].0)));
            let list = list.cast::<HtmlElement>();
            let button = list.and_then(|list| list.children().item(to as u32));
            if let Some(button) =
                button.and_then(|button| wasm_bindgen::JsCast::dyn_into::<HtmlElement>(button).ok())
            {
                let _ = button.focus();
            }
        }
    };
    let one = |&(choice, name, place): &(Tab, Later, &'static str)| {
        let is_shown = choice == *tab;
        let name = match (choice, *inside) {
            (Tab::Timeline, Some(_)) => tr!("How it was proved"),
            (Tab::Inspector, _) if *teaches => tr!("Lesson"),
            (Tab::Inspector, Some(Method::Proof | Method::Pibt | Method::Lacam)) => tr!("Step"),
            (Tab::Inspector, Some(Method::Tree)) => tr!("Node"),
            (Tab::Inspector, Some(Method::Orders)) => tr!("Order"),
            (Tab::Inspector, None) if *checks => tr!("Check"),
            _ => name.text(),
        };
        // The text of a lesson has the place of the inspector.
        let place = if choice == Tab::Inspector && *teaches {
            "course"
        } else {
            place
        };
        html! {
            <button type="button" role="tab" aria-selected={is_shown.to_string()} aria-controls={place}
                tabindex={if is_shown { "0" } else { "-1" }}
                onclick={send.reform(move |_| Action::View(ViewAction::ShowTab(choice)))}>{ name }</button>
        }
    };
    html! {
        <div class="tabs" role="tablist" aria-label={tr!("Below the board")} ref={list} {onkeydown}>
            { for TABS.iter().take(count).map(one) }
        </div>
    }
}
