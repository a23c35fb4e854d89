//! The tools: what the pointer and the keys do on the board.

use giveway_model::tr;
use giveway_page::{Action, BoardAction, Tool};
use web_sys::HtmlElement;
use yew::prelude::*;

use crate::icon;

/// Which tool is picked.
#[derive(Clone, PartialEq, Properties)]
pub struct ToolsProps {
    /// The tool.
    pub tool: Tool,
    /// Those that may be used.
    #[prop_or_else(|| Tool::ALL.to_vec())]
    pub live: Vec<Tool>,
    /// Takes actions.
    pub send: Callback<Action>,
}

/// The toolbar. One of its buttons is in the order of the page, and arrows go
/// from button to button.
#[component]
pub fn Tools(props: &ToolsProps) -> Html {
    let buttons = use_memo((), |()| Tool::ALL.map(|_| NodeRef::default()));
    // The button that Tab goes to.
    let current = use_state(|| None::<usize>);
    let pressed = Tool::ALL.iter().position(|&tool| tool == props.tool);
    let reached = current.or(pressed).unwrap_or(0);
    let onkeydown = {
        let (buttons, current) = (buttons.clone(), current.clone());
        Callback::from(move |event: KeyboardEvent| {
            let has_modifier = event.ctrl_key() || event.alt_key() || event.meta_key();
            let Some(next) = next(&event.key(), reached).filter(|_| !has_modifier) else {
                return;
            };
            event.prevent_default();
            event.stop_propagation();
            current.set(Some(next));
            if let Some(button) = buttons[next].cast::<HtmlElement>() {
                // Without focus the next key just goes on from here.
                let _ = button.focus();
            }
        })
    };
    // Left by the keyboard, it is entered at the pressed tool again.
    let onfocusout = {
        let current = current.clone();
        Callback::from(move |_: FocusEvent| current.set(None))
    };
    let onfocusin = {
        let buttons = buttons.clone();
        Callback::from(move |event: FocusEvent| {
            let target = event.target();
            let is_it = |button: &NodeRef| {
                let button = button.cast::<HtmlElement>();
                button.map(web_sys::EventTarget::from) == target
            };
            current.set(buttons.iter().position(is_it));
        })
    };
    let button = |(index, tool): (usize, Tool)| {
        let onclick = props
            .send
            .reform(move |_| Action::Board(BoardAction::PickTool(tool)));
        let is_live = props.live.contains(&tool);
        let title = if is_live {
            format!("{} ({})", tool.name(), tool.key())
        } else {
            tr!("{tool}: this step does without it", tool = tool.name())
        };
        html! {
            <>
                if matches!(tool, Tool::Obstacle | Tool::Zone | Tool::Agent) {
                    <i class="sep"></i>
                }
                <button class="tool" ref={buttons[index].clone()} {onclick}
                    aria-pressed={(tool == props.tool).to_string()}
                    aria-label={tool.name()} aria-keyshortcuts={tool.key().to_string()}
                    aria-disabled={(!is_live).then_some("true")} {title}
                    tabindex={if index == reached { "0" } else { "-1" }}>
                    { icon::show(tool.icon()) }
                </button>
            </>
        }
    };
    html! {
        <div class="tools" role="toolbar" aria-label={tr!("Tools")} {onkeydown} {onfocusin} {onfocusout}>
            { for Tool::ALL.into_iter().enumerate().map(button) }
            if props.tool != Tool::Select {
                // For a finger, which no tip follows; the button has the same name.
                <span class="tool-name" aria-hidden="true">{ props.tool.name() }</span>
            }
        </div>
    }
}

/// The button that a key goes to, around the ends; a column and a row alike.
fn next(key: &str, from: usize) -> Option<usize> {
    let count = Tool::ALL.len();
    match key {
        "ArrowDown" | "ArrowRight" => Some((from + 1) % count),
        "ArrowUp" | "ArrowLeft" => Some((from + count - 1) % count),
        "Home" => Some(0),
        "End" => Some(count - 1),
        _ => None,
    }
}
