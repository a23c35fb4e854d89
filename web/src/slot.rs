//! What the page says by itself: in the row under the board, on a phone a sheet from
//! below. What it says is decided in [`giveway_page::slot`].

use giveway_model::tr;
use giveway_page::slot::{Button, Kind, Message, Press, Weight, message};
use giveway_page::{Action, Draft, SlotAction, State, files};
use yew::prelude::*;

use crate::board::Small;
use crate::board::SmallProps;
use crate::part::part;
use crate::turning::{Turning, TurningProps, turning};
use crate::{icon, keep};

/// What is said now, if anything is.
pub(crate) fn said(state: &State) -> Option<Message> {
    message(state)
}

/// The place of what is said. It is there before anything is: some readers hear it
/// only so.
pub(crate) fn show(state: &State, said: Option<&Message>, send: &Callback<Action>) -> Html {
    let of = |is_alert: bool| {
        let said = said.filter(|said| (said.kind == Kind::Alert) == is_alert);
        said.map(|said| card(state, said, send))
    };
    html! {
        <>
            <div class="slot-place" role="status">{ of(false) }</div>
            <div class="slot-place" role="alert">{ of(true) }</div>
        </>
    }
}

fn card(state: &State, said: &Message, send: &Callback<Action>) -> Html {
    let is_alert = said.kind == Kind::Alert;
    let is_welcome = said.kind == Kind::Welcome;
    let close = said.close.clone().map(|action| {
        let press = send.reform(move |_: MouseEvent| action.clone());
        let content =
            html! { <>{ icon::show("cancel") }<span class="vh">{ tr!("Close") }</span></> };
        part::<Turning>(TurningProps {
            meaning: said.title.into(),
            class: classes!("btn", "ghost", "round", "slot-close"),
            title: Some(tr!("Close").into()),
            label: None,
            is_off: false,
            is_toggle: false,
            content,
            onclick: press,
        })
    });
    html! {
        <section class={if is_welcome { "slot welcome" } else { "slot" }} aria-label={said.title}>
            if let Some(name) = said.kind.icon() {
                <span class={classes!("slot-icon", is_alert.then_some("warn"))}>{ icon::show(name) }</span>
            }
            <div class="slot-words"><h2>{ said.title }</h2><p>{ said.text.clone() }</p></div>
            if let Some([here, there]) = &said.boards {
                <div class="slot-boards">
                    { small(here, tr!("Here")) }
                    { small(there, tr!("Other tab")) }
                </div>
            }
            <div class="slot-acts">{ for said.buttons.iter().map(|it| button(state, said, it, send)) }</div>
            { close }
        </section>
    }
}

fn small(draft: &std::rc::Rc<Draft>, name: &'static str) -> Html {
    html! {
        <figure>{ part::<Small>(SmallProps { draft: draft.clone() }) }<figcaption>{ name }</figcaption></figure>
    }
}

fn button(state: &State, said: &Message, button: &Button, send: &Callback<Action>) -> Html {
    let class = match button.weight {
        Weight::Filled => "primary",
        Weight::Outlined => "outline",
        Weight::Quiet => "ghost",
    };
    let press: Callback<MouseEvent> = match &button.press {
        Press::Act(action) => {
            let action = action.clone();
            send.reform(move |_| (*action).clone())
        }
        Press::Learn(what) => {
            let what = *what;
            send.reform(move |_| {
                keep::learn(what);
                Action::Slot(SlotAction::Close)
            })
        }
        Press::Download => send.reform(|_| {
            keep::download_lost();
            keep::settle_lost();
            Action::Slot(SlotAction::Settle)
        }),
        Press::StartAfresh => send.reform(|_| {
            keep::settle_lost();
            Action::Slot(SlotAction::Settle)
        }),
        Press::Save => {
            let saved = files::kept_file(state);
            send.reform(move |_| {
                crate::files::save(&saved);
                Action::Slot(SlotAction::Close)
            })
        }
    };
    let content = html! {
        <>
            { button.icon.map(icon::show) }<span>{ button.name }</span>
            if let Some(remark) = button.remark { <small>{ remark }</small> }
        </>
    };
    turning(
        class,
        format!("{}: {}", said.title, button.name),
        content,
        press,
    )
}
