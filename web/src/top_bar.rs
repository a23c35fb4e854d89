//! The top bar: the scene's name and size, and what is done to it as a whole.

use giveway_page::{Action, FileAction, ViewAction, files, words};
use web_sys::{Event, HtmlInputElement};
use yew::prelude::*;

use crate::dialog::{Panel, use_dismiss};
use crate::theme::system_is_dark;
use crate::{Shown, copy, icon, keep, paste};

/// The state, what is open, and where changes of both go.
#[derive(Clone, PartialEq, Properties)]
pub(crate) struct TopBarProps {
    /// The state.
    pub(crate) state: Shown,
    /// What is open.
    pub(crate) panel: Panel,
    /// Takes actions.
    pub(crate) send: Callback<Action>,
    /// Opens and closes.
    pub(crate) show: Callback<Panel>,
}

/// The top bar.
#[component]
pub(crate) fn TopBar(props: &TopBarProps) -> Html {
    let TopBarProps {
        state,
        panel,
        send,
        show,
    } = props;
    let acts = use_node_ref();
    let picker = use_node_ref();
    let menu_open = matches!(panel, Panel::Menu | Panel::Open | Panel::Save);
    use_dismiss(&acts, menu_open, &show.reform(|()| Panel::Nothing));
    let is_copied = use_state_eq(|| false);
    {
        let is_copied = is_copied.clone();
        use_effect_with(menu_open, move |_| is_copied.set(false));
    }
    let pick = {
        let (picker, show) = (picker.clone(), show.clone());
        Callback::from(move |_: MouseEvent| {
            show.emit(Panel::Nothing);
            if let Some(input) = picker.cast::<HtmlInputElement>() {
                input.click();
            }
        })
    };
    let picked = {
        let (state, send, show) = (state.clone(), send.clone(), show.clone());
        Callback::from(move |event: Event| {
            let input: HtmlInputElement = event.target_unchecked_into();
            crate::files::open(&state, input.files(), send.clone(), show.clone());
            // So that the same file can be opened again.
            input.set_value("");
        })
    };
    let paste = {
        let (state, send, show) = (state.clone(), send.clone(), show.clone());
        Callback::from(move |_: MouseEvent| {
            show.emit(Panel::Nothing);
            paste::ask(&state, send.clone(), show.clone());
        })
    };
    let scene = state.document.draft.scene();
    let grid = state.document.draft.grid();
    let name = match scene.name.as_str() {
        "" => "Untitled",
        name => name,
    };
    let agents = words::count(scene.agents.len(), "robot");
    let examples = show.reform(|_: MouseEvent| Panel::Examples);
    let fresh = show.reform(|_: MouseEvent| Panel::New);
    let scenes = show.reform(|_: MouseEvent| Panel::Scenes);
    let share = {
        let state = state.clone();
        show.reform(move |_: MouseEvent| Panel::Share(keep::address(&state).into()))
    };
    let help = show.reform(|_: MouseEvent| Panel::Help);
    let theme = press_theme(state, send);
    let theme_title = format!("Theme: {}", state.view.theme.name());
    let undo = send.reform(|_| Action::Undo);
    let redo = send.reform(|_| Action::Redo);
    html! {
        <header class="bar">
            <span class="brand">
                <svg viewBox="0 0 24 24" aria-hidden="true">
                    <path d="M3.6 5.2h16.8L12 19.6Z" />
                </svg>
                <b>{ "Giveway" }</b>
            </span>
            <h1 class="scene">
                <button title="Scenes in this browser" aria-haspopup="dialog" onclick={scenes.clone()}>
                    <span>{ name.to_owned() }</span>{ icon::show("down") }
                </button>
                <small>{ format!("{} \u{d7} {}, {agents}", grid.width(), grid.height()) }</small>
            </h1>
            <span class="grow"></span>
            <div class="acts" ref={acts}>
                <button class="btn ghost wide" title="Examples" onclick={examples.clone()}>
                    { icon::show("examples") }<span>{ "Examples" }</span>
                </button>
                <button class="btn ghost wide" title="New scene" onclick={fresh.clone()}>
                    { icon::show("plus") }<span>{ "New" }</span>
                </button>
                <span class="hold">
                    { toggle(panel, Panel::Open, "btn ghost wide", "open", "Open", show) }
                    if *panel == Panel::Open {
                        <div class="menu">
                            { item("open", "Choose a file", pick.clone()) }
                            { item("copy", "Paste", paste.clone()) }
                        </div>
                    }
                </span>
                <input ref={picker} type="file" hidden=true multiple=true onchange={picked}
                    accept=".json,.map,.scen,.giveway,application/json" />
                <span class="hold">
                    { toggle(panel, Panel::Save, "btn ghost wide", "save", "Save", show) }
                    if *panel == Panel::Save {
                        <div class="menu">
                            { save_items(state, send, show) }
                            { copy_item(state, &is_copied, send) }
                        </div>
                    }
                </span>
                <button class="btn ghost wide" title="Share a link" onclick={share.clone()}>
                    { icon::show("share") }<span>{ "Share" }</span>
                </button>
                <i class="sep"></i>
                <button class="btn ghost ph" title="Undo (Ctrl Z)" onclick={undo}
                    disabled={!state.history.can_undo()}>
                    { icon::show("undo") }<span class="vh">{ "Undo" }</span>
                </button>
                <button class="btn ghost ph" title="Redo (Ctrl Shift Z)" onclick={redo}
                    disabled={!state.history.can_redo()}>
                    { icon::show("redo") }<span class="vh">{ "Redo" }</span>
                </button>
                <i class="sep"></i>
                <button class="btn ghost" title={theme_title.clone()} onclick={theme.clone()}>
                    { icon::show("theme") }<span class="vh">{ "Theme" }</span>
                </button>
                <button class="btn ghost" title="Help (?)" onclick={help.clone()}>
                    { icon::show("help") }<span class="vh">{ "Help" }</span>
                </button>
                { toggle(panel, Panel::Menu, "btn ghost only-ph", "more", "More", show) }
                if *panel == Panel::Menu {
                    <div class="menu">
                        { item("examples", "Examples", examples) }
                        { item("plus", "New scene", fresh) }
                        { item("open", "Open", pick) }
                        { item("copy", "Paste", paste) }
                        { save_items(state, send, show) }
                        { copy_item(state, &is_copied, send) }
                        { item("share", "Share", share) }
                        <hr />
                        { item("settings", "Settings", show.reform(|_| Panel::Settings)) }
                        { item("theme", &theme_title, theme) }
                        { item("help", "Help", help) }
                    </div>
                }
            </div>
        </header>
    }
}

/// A button that opens and closes a menu.
fn toggle(
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
            { icon::show(icon) }<span class={(name == "More").then_some("vh")}>{ name }</span>
        </button>
    }
}

fn item(icon: &'static str, name: &str, press: Callback<MouseEvent>) -> Html {
    html! { <button onclick={press}>{ icon::show(icon) }{ name.to_owned() }</button> }
}

fn save_items(state: &Shown, send: &Callback<Action>, show: &Callback<Panel>) -> Html {
    let press = |save: fn(&Shown, Callback<Action>)| {
        let (state, send, show) = (state.clone(), send.clone(), show.clone());
        Callback::from(move |_: MouseEvent| {
            show.emit(Panel::Nothing);
            save(&state, send.clone());
        })
    };
    let answer = state.document.fresh_answer();
    let has_changes = answer.is_some_and(|answer| answer.course.is_some());
    let has_plan = answer.and_then(|answer| answer.plan()).is_some();
    let scene = press(|state, _| crate::files::save(&files::scene_file(state)));
    let plan = press(|state, _| save_if(files::plan_file(state)));
    let changes = press(|state, _| save_if(files::changes_file(state)));
    let svg = press(|state, send| crate::files::save_picture(state, false, send));
    let png = press(|state, send| crate::files::save_picture(state, true, send));
    html! {
        <>
            { item("save", "Save scene", scene) }
            if has_plan { { item("save", "Save plan", plan) } }
            if has_changes { { item("save", "Save changes", changes) } }
            { item("save", "Save picture (SVG)", svg) }
            { item("save", "Save picture (PNG)", png) }
        </>
    }
}

/// Copies the scene, and says that it did for as long as the menu is open.
fn copy_item(state: &Shown, is_copied: &UseStateHandle<bool>, send: &Callback<Action>) -> Html {
    let press = {
        let (state, is_copied, send) = (state.clone(), is_copied.clone(), send.clone());
        Callback::from(move |_: MouseEvent| {
            let (is_copied, send) = (is_copied.clone(), send.clone());
            let text = files::scene_file(&state).text;
            copy::text("scene", &text, move |done| match done {
                Ok(()) => is_copied.set(true),
                Err(notice) => send.emit(Action::File(FileAction::Refuse(notice))),
            });
        })
    };
    let (icon, name) = if **is_copied {
        ("check", "Scene copied")
    } else {
        ("copy", "Copy scene")
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

fn press_theme(state: &Shown, send: &Callback<Action>) -> Callback<MouseEvent> {
    let theme = state.view.theme;
    send.reform(move |_| Action::View(ViewAction::SetTheme(theme.next(system_is_dark()))))
}
