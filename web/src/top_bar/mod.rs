//! The top bar: the scene's name and size, and what is done to it as a whole.

mod menu;

use giveway_model::tr;
use giveway_page::find::FindAction;
use giveway_page::inside::{InsideAction, Method};
use giveway_page::present::BEGIN;
use giveway_page::{Action, ViewAction};
use web_sys::{Event, HtmlInputElement};
use yew::prelude::*;

use crate::dialog::{Panel, use_dismiss};
use crate::language::LanguageButton;
use crate::language::LanguageButtonProps;
use crate::lesson::Course;
use crate::part::part;
use crate::theme::system_is_dark;
use crate::{Shown, icon, keep, paste};
use menu::{copy_item, item, save_items, toggle};

/// The state, what is open, and where changes of both go.
#[derive(Clone, PartialEq, Properties)]
pub(crate) struct TopBarProps {
    /// The state.
    pub(crate) state: Shown,
    /// What is open.
    pub(crate) panel: Panel,
    /// Opens the course.
    pub(crate) course: Course,
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
        course,
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
        "" => tr!("Untitled"),
        name => name,
    };
    let agents = tr!("{n} robot" | "{n} robots" % scene.agents.len());
    let learn = {
        let course = course.clone();
        show.reform(move |_: MouseEvent| {
            course.open("");
            Panel::Nothing
        })
    };
    let examples = show.reform(|_: MouseEvent| Panel::Examples);
    let fresh = show.reform(|_: MouseEvent| Panel::New);
    let scenes = show.reform(|_: MouseEvent| Panel::Scenes);
    let share = {
        let state = state.clone();
        show.reform(move |_: MouseEvent| Panel::Share(keep::address(&state).into()))
    };
    let find = {
        let send = send.clone();
        show.reform(move |_: MouseEvent| {
            send.emit(Action::Find(FindAction::Open));
            Panel::Nothing
        })
    };
    let present = {
        let send = send.clone();
        show.reform(move |_: MouseEvent| {
            send.emit(BEGIN);
            Panel::Nothing
        })
    };
    let help = show.reform(|_: MouseEvent| Panel::Help);
    let theme = press_theme(state, send);
    let theme_title = tr!("Theme: {theme}", theme = state.view.theme.name());
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
                <button title={tr!("Scenes in this browser")} aria-haspopup="dialog" onclick={scenes.clone()}>
                    <span>{ name.to_owned() }</span>{ icon::show("down") }
                </button>
                <small>{ format!("{} \u{d7} {}, {agents}", grid.width(), grid.height()) }</small>
            </h1>
            <span class="grow"></span>
            <div class="acts" ref={acts}>
                <button class="btn ghost wide" title={tr!("Course")} onclick={learn.clone()}>
                    { icon::show("course") }<span>{ tr!("Course") }</span>
                </button>
                <button class="btn ghost wide" title={tr!("Examples")} onclick={examples.clone()}>
                    { icon::show("examples") }<span>{ tr!("Examples") }</span>
                </button>
                <button class="btn ghost wide" title={tr!("New scene")} onclick={fresh.clone()}>
                    { icon::show("plus") }<span>{ tr!("New") }</span>
                </button>
                <span class="hold">
                    { toggle(panel, Panel::Open, "btn ghost wide", "open", tr!("Open"), show) }
                    if *panel == Panel::Open {
                        <div class="menu">
                            { item("open", tr!("Choose a file"), pick.clone()) }
                            { item("paste", tr!("Paste"), paste.clone()) }
                            <p class="menu-note">{ tr!("A scene, a plan, a link; a map as JSON, as CSV or drawn with . and #; a table of robots.") }</p>
                        </div>
                    }
                </span>
                <input ref={picker} type="file" hidden=true multiple=true onchange={picked}
                    accept=".json,.map,.scen,.giveway,application/json,image/*,.pgm,.yaml" />
                <span class="hold">
                    { toggle(panel, Panel::Save, "btn ghost wide", "save", tr!("Save"), show) }
                    if *panel == Panel::Save {
                        <div class="menu">
                            { save_items(state, send, show) }
                            { copy_item(state, &is_copied, send) }
                        </div>
                    }
                </span>
                <button class="btn ghost wide" title={tr!("Share a link")} onclick={share.clone()}>
                    { icon::show("share") }<span>{ tr!("Share") }</span>
                </button>
                <button class="btn ghost" title={tr!("The board full screen, before a room (P)")} onclick={present.clone()}>
                    { icon::show("fit") }<span class="vh">{ tr!("Present") }</span>
                </button>
                <i class="sep"></i>
                <button class="btn ghost ph" title={tr!("Undo (Ctrl Z)")} onclick={undo}
                    disabled={!state.history.can_undo()}>
                    { icon::show("undo") }<span class="vh">{ tr!("Undo") }</span>
                </button>
                <button class="btn ghost ph" title={tr!("Redo (Ctrl Shift Z)")} onclick={redo}
                    disabled={!state.history.can_redo()}>
                    { icon::show("redo") }<span class="vh">{ tr!("Redo") }</span>
                </button>
                <i class="sep"></i>
                { part::<LanguageButton>(LanguageButtonProps { send: send.clone() }) }
                <button class="btn ghost" title={theme_title.clone()} onclick={theme.clone()}>
                    { icon::show("theme") }<span class="vh">{ tr!("Theme") }</span>
                </button>
                <button class="btn ghost" title={tr!("Help (?)")} onclick={help.clone()}>
                    { icon::show("help") }<span class="vh">{ tr!("Help") }</span>
                </button>
                { toggle(panel, Panel::Menu, "btn ghost only-ph", "more", tr!("More"), show) }
                if *panel == Panel::Menu {
                    <div class="menu">
                        { item("course", tr!("Course"), learn) }
                        { item("examples", tr!("Examples"), examples) }
                        { item("plus", tr!("New scene"), fresh) }
                        { item("open", tr!("Open"), pick) }
                        { item("paste", tr!("Paste"), paste) }
                        { save_items(state, send, show) }
                        { copy_item(state, &is_copied, send) }
                        { item("share", tr!("Share"), share) }
                        { item("fit", tr!("Present"), present) }
                        <hr />
                        { inside_items(state, send, show) }
                        <span class="only-low">{ item("search", tr!("Find a robot"), find) }</span>
                        { item("settings", tr!("Settings"), show.reform(|_| Panel::Settings)) }
                        { item("theme", &theme_title, theme) }
                        { item("help", tr!("Help"), help) }
                    </div>
                }
            </div>
        </header>
    }
}

/// What a phone shows in the place of the lanes: wider pages have tabs for it.
fn inside_items(state: &Shown, send: &Callback<Action>, show: &Callback<Panel>) -> Html {
    if !state.can_look_inside() {
        return html! {};
    }
    let press = |action: InsideAction| {
        let (send, show) = (send.clone(), show.clone());
        Callback::from(move |_: MouseEvent| {
            show.emit(Panel::Nothing);
            send.emit(Action::Inside(action));
        })
    };
    let icon = |method: Method| match method {
        Method::Proof => "proved",
        Method::Tree => "tree",
        Method::Orders => "agent",
        Method::Pibt => "many",
        Method::Lacam => "search",
    };
    let method = |method: Method| {
        item(
            icon(method),
            method.entry(),
            press(InsideAction::By(method)),
        )
    };
    html! {
        <>
            if state.is_inside() { { item("clock", tr!("Timeline"), press(InsideAction::Show(false))) } }
            { for Method::ALL.into_iter().map(method) }
            <hr />
        </>
    }
}

fn press_theme(state: &Shown, send: &Callback<Action>) -> Callback<MouseEvent> {
    let theme = state.view.theme;
    send.reform(move |_| Action::View(ViewAction::SetTheme(theme.next(system_is_dark()))))
}
