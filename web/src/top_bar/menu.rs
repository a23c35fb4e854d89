//! The menus of the top bar: what opens them, and what stands in them.

use giveway_model::tr;
use giveway_page::intake::protocol::PictureKind;
use giveway_page::ledger::LedgerAction;
use giveway_page::{Action, FileAction, IntakeAction, Save, files};
use yew::prelude::*;

use crate::dialog::Panel;
use crate::{Shown, copy, icon, theme};

/// A button that opens and closes a menu.
pub(super) fn toggle(
    panel: &Panel,
    own: Panel,
    class: &'static str,
    icon: &'static str,
    name: &'static str,
    show: &Callback<Panel>,
) -> Html {
    let open = *panel == own;
    let press = show.reform(move |_: MouseEvent| if open { Panel::Nothing } else { own.clone() });
    html! {
        <button {class} title={name} aria-expanded={open.to_string()} onclick={press}>
            { icon::show(icon) }<span class={(icon == "more").then_some("vh")}>{ name }</span>
        </button>
    }
}

pub(super) fn item(icon: &'static str, name: &str, press: Callback<MouseEvent>) -> Html {
    html! { <button onclick={press}>{ icon::show(icon) }{ name.to_owned() }</button> }
}

pub(super) fn save_items(state: &Shown, send: &Callback<Action>, show: &Callback<Panel>) -> Html {
    let press = |save: fn(&Shown, Callback<Action>)| {
        let (state, send, show) = (state.clone(), send.clone(), show.clone());
        Callback::from(move |_: MouseEvent| {
            show.emit(Panel::Nothing);
            save(&state, send.clone());
        })
    };
    let answer = state.document.fresh_answer();
    let has_changes = answer.is_some_and(|answer| answer.course.is_some());
    let has_plan = answer.and_then(|answer| answer.plan()).is_some() || state.audit().is_some();
    let has_report = answer.is_some_and(|answer| answer.plan().is_some());
    let report = {
        let (send, show) = (send.clone(), show.clone());
        Callback::from(move |_: MouseEvent| {
            send.emit(Action::Ledger(LedgerAction::AddUp));
            show.emit(Panel::Report);
        })
    };
    let scene = press(|state, _| crate::files::save(&files::scene_file(state)));
    let plan = press(|state, _| save_if(files::plan_file(state)));
    let has_robots = !state.document.draft.agents().is_empty();
    let robots = press(|state, _| crate::files::save_robots(state));
    let changes = press(|state, _| save_if(files::changes_file(state)));
    let has_trace = answer.is_some_and(|answer| answer.solved.trace.is_some());
    let trace = press(|state, _| save_if(files::trace_file(state)));
    let freedom = {
        let (send, show) = (send.clone(), show.clone());
        Callback::from(move |_: MouseEvent| {
            show.emit(Panel::Nothing);
            send.emit(Action::Intake(IntakeAction::Save(Save::Freedom)));
        })
    };
    let svg = press(|state, send| crate::files::save_picture(state, false, send));
    let png = press(|state, send| crate::files::save_picture(state, true, send));
    let moving = |kind: PictureKind| {
        let (state, send, show) = (state.clone(), send.clone(), show.clone());
        Callback::from(move |_: MouseEvent| {
            show.emit(Panel::Nothing);
            let save = Save::Picture(kind, theme::drawn(state.view.theme));
            send.emit(Action::Intake(IntakeAction::Save(save)));
        })
    };
    let other = show.reform(|_: MouseEvent| Panel::SaveAs);
    let others = if state.audit().is_some() {
        tr!("Report, other formats")
    } else {
        tr!("Other formats")
    };
    html! {
        <>
            { item("save", tr!("Save scene"), scene) }
            if has_plan { { item("save", tr!("Save plan"), plan) } }
            if has_report { { item("file", tr!("Report of the plan"), report) } }
            if has_robots { { item("save", tr!("Save robots (CSV)"), robots) } }
            if has_changes { { item("save", tr!("Save changes"), changes) } }
            if has_trace { { item("save", tr!("Save how it was proved"), trace) } }
            if state.is_laid_over() { { item("save", tr!("Save what must be so"), freedom) } }
            { item("save", others, other) }
            { item("save", tr!("Save picture (SVG)"), svg) }
            { item("save", tr!("Save picture (PNG)"), png) }
            if state.can_be_drawn() {
                { item("save", tr!("Save moving picture (SVG)"), moving(PictureKind::Svg)) }
                { item("save", tr!("Save moving picture (GIF)"), moving(PictureKind::Gif)) }
            }
        </>
    }
}

/// Copies the scene, and says that it did for as long as the menu is open.
pub(super) fn copy_item(
    state: &Shown,
    is_copied: &UseStateHandle<bool>,
    send: &Callback<Action>,
) -> Html {
    let press = {
        let (state, is_copied, send) = (state.clone(), is_copied.clone(), send.clone());
        Callback::from(move |_: MouseEvent| {
            let (is_copied, send) = (is_copied.clone(), send.clone());
            let text = files::scene_file(&state).text;
            copy::text(tr!("scene"), &text, move |done| match done {
                Ok(()) => is_copied.set(true),
                Err(notice) => send.emit(Action::File(FileAction::Tell(notice))),
            });
        })
    };
    let (icon, name) = if **is_copied {
        ("check", tr!("Scene copied"))
    } else {
        ("copy", tr!("Copy scene"))
    };
    html! {
        <>
            { item(icon, name, press) }
            <span class="vh" aria-live="polite">{ is_copied.then_some(name) }</span>
        </>
    }
}

fn save_if(saved: Option<files::Saved>) {
    if let Some(saved) = saved {
        crate::files::save(&saved);
    }
}
