//! The page as a whole: the state, its reducer, and the places.

use std::rc::Rc;

use giveway_course::lesson::Layer;
use giveway_page::inside::Method;
use giveway_page::present::Presenting;
use giveway_page::{Action, Draft, FileAction, Phase, Tab, Tool};
use yew::prelude::*;

use crate::board::BoardProps;
use crate::dialog::AgentsProps;
use crate::dialog::ExamplesProps;
use crate::dialog::NewSceneProps;
use crate::dialog::ReportProps;
use crate::dialog::SaveAsProps;
use crate::dialog::ScenesProps;
use crate::dialog::ShareProps;
use crate::dialog::{
    Agents, Examples, NewScene, Panel, Report, SaveAs, Scenes, Share, help, report_sheet,
};
use crate::drop::Drop;
use crate::drop::DropProps;
use crate::floor_plan::use_kept_floor_plan;
use crate::foreign::use_foreign_changes;
use crate::inspector::InspectorProps;
use crate::intake::use_intake;
use crate::keep::{self, use_keep};
use crate::keys::use_keys;
use crate::language::use_language;
use crate::lesson::use_course;
use crate::newest::Newest;
use crate::part::{keyed_part, part};
use crate::paste::use_paste;
use crate::present::use_presenting;
use crate::solver::use_solver;
use crate::status::StatusBar;
use crate::status::StatusBarProps;
use crate::theme::{use_colours, use_theme, wants_less_motion};
use crate::timeline::DockProps;
use crate::tools::ToolsProps;
use crate::top_bar::TopBar;
use crate::top_bar::TopBarProps;
use crate::wide::use_wide;
use crate::{
    Board, Clock, Dock, Inspector, Shown, Tools, compare, embed, glyph, notice, opening, present,
    sheet,
};

impl Reducible for Shown {
    type Action = Action;

    fn reduce(self: Rc<Self>, action: Action) -> Rc<Self> {
        Rc::new(self.reduced(action))
    }
}

fn opening() -> Shown {
    Shown::new(keep::opening(|| {
        Draft::new(opening::scene()).unwrap_or_default()
    }))
}

/// Puts the scene that the page opens on onto the board again.
pub(crate) fn example() -> Action {
    Action::File(FileAction::Open(Box::new(opening::scene())))
}

/// The page.
#[component]
pub fn App() -> Html {
    let spoken = use_language();
    let changes = use_foreign_changes();
    // All elements are built anew in another language, and after a foreign change.
    let built = format!("{spoken}{changes}");
    let shown = use_reducer(opening);
    let state: Shown = (*shown).clone();
    let send = use_callback(shown.dispatcher(), |action: Action, shown| {
        shown.dispatch(action);
    });
    let open = use_state_eq(Panel::default);
    let panel: Panel = (*open).clone();
    let course = use_course(&state, &send);
    let shown_by = (open.setter(), course.clone());
    let show = use_callback(shown_by, |panel: Panel, (open, course)| {
        open.set(match panel {
            Panel::Course(what) => {
                course.open(&what);
                Panel::Nothing
            }
            panel => panel,
        });
    });
    let clock = {
        let send = send.clone();
        use_memo((), move |()| {
            Clock::new(send, wants_less_motion()).begun_at(opening::time())
        })
    };
    {
        let clock = clock.clone();
        use_effect_with(
            (state.view.playback, state.last_time()),
            move |&(playback, last)| clock.follow(playback, last),
        );
    }
    use_solver(&state, &send);
    use_intake(&state, &send, &show);
    use_keep(&state, &send);
    use_kept_floor_plan(&state, &send);
    use_theme(state.view.theme);
    use_colours(state.document.colours);
    glyph::set_looks(state.looks());
    let is_embedded = *use_memo((), |()| embed::is_embedded());
    let newest = Newest::new(&shown);
    use_keys(&newest, &send, &show);
    use_paste(&newest, &send, &show, is_embedded);
    use_wide(&send);
    let is_printing = sheet::use_printing();
    // What is printed then is the report alone.
    let is_reported = panel == Panel::Report;
    let is_presented = state.is_presented();
    use_presenting(is_presented, &send);
    if is_embedded {
        return html! {
            <ContextProvider<Clock> key={built} context={(*clock).clone()}>
                <div class="app embed">
                    { embed::show(&state, &send) }
                    { notice::show(state.view.notice.as_ref().filter(|_| !state.view.waiting.refused), &send) }
                </div>
            </ContextProvider<Clock>>
        };
    }
    let is_answering = state.document.mode.asking().is_some()
        || giveway_page::ledger::column(&state).is_some()
        || state.shows_order()
        || state.is_writing_rule();
    // On a phone the board has its place before the first cell is marked, and keeps it.
    let is_marking = state.view.tool.is_of_rules() && state.document.mode.is_editing();
    // For the places that show nothing of a stroke on its way.
    let settled = state.settled();
    let has_dock = state
        .lesson()
        .is_none_or(|lesson| !lesson.hides_plan() && state.playing().is_some())
        || state.is_by_hand();
    let covers_lesson = state.covers_lesson();
    let in_proof = state.is_inside() && state.inside.method == Method::Proof;
    html! {
        <ContextProvider<Clock> key={built} context={(*clock).clone()}>
            <div class={classes!("app", phase_class(&state), is_answering.then_some("answering"), state.is_writing_rule().then_some("writing-rule"), is_marking.then_some("marking"), state.is_inside().then_some("inside"), is_reported.then_some("reported"), in_proof.then_some("in-proof"), covers_lesson.then_some("covers-lesson"), state.is_by_hand().then_some("by-hand"), lesson_class(&state))} data-tab={tab(state.shown_tab())} data-presents={presents(&state)}>
                if is_presented {
                    { present::head(&state, &send) }
                } else {
                    { part::<TopBar>(TopBarProps { state: settled.clone(), panel: panel.clone(), course: course.clone(), send: send.clone(), show: show.clone() }) }
                    { part::<StatusBar>(StatusBarProps { state: settled.clone(), panel: panel.clone(), send: send.clone(), show: show.clone() }) }
                }
                <main class="middle">
                    <div class="stage">
                        if !is_presented {
                            { part::<Tools>(ToolsProps { tool: state.view.tool, live: tools(&state), send: send.clone() }) }
                        }
                        // Another one before a room: its cells are larger.
                        { keyed_part::<Board>(u32::from(is_presented), BoardProps { state: state.clone(), send: send.clone() }) }
                    </div>
                    { compare::show(&settled, &send) }
                </main>
                if is_printing && !is_reported { { sheet::head(&state) } }
                if is_printing && is_reported { <div class="paper-report">{ report_sheet(&state) }</div> }
                if (state.lesson().is_none() || covers_lesson) && !is_presented {
                    { part::<Inspector>(InspectorProps { state: state.clone(), send: send.clone() }) }
                }
                { course.place() }
                if is_printing && !is_reported { { sheet::foot(&state) } }
                if is_presented {
                    { present::foot(&state, has_dock && state.plan().is_some(), &send) }
                } else if has_dock {
                    { part::<Dock>(DockProps { state: settled, send: send.clone() }) }
                }
                { notice::show(state.view.notice.as_ref(), &send) }
                { part::<Drop>(DropProps { newest, send: send.clone(), show: show.clone() }) }
                { dialog(&panel, &state, &send, &show) }
            </div>
        </ContextProvider<Clock>>
    }
}

/// The dialog that is open, if one is.
fn dialog(panel: &Panel, state: &Shown, send: &Callback<Action>, show: &Callback<Panel>) -> Html {
    let send = send.clone();
    let on_close = show.reform(|()| Panel::Nothing);
    match panel {
        Panel::Examples => html! { { part::<Examples>(ExamplesProps { send, on_close }) } },
        Panel::Agents(choice) => {
            html! { { part::<Agents>(AgentsProps { choice: choice.clone(), send, on_close }) } }
        }
        Panel::New => html! { { part::<NewScene>(NewSceneProps { send, on_close }) } },
        Panel::SaveAs => {
            html! { { part::<SaveAs>(SaveAsProps { state: state.clone(), send, on_close }) } }
        }
        Panel::Report => {
            html! { { part::<Report>(ReportProps { state: state.clone(), on_close }) } }
        }
        Panel::Scenes => {
            html! { { part::<Scenes>(ScenesProps { state: state.clone(), send, on_close }) } }
        }
        Panel::Share(link) => {
            let on_lesson = show.reform(|_| Panel::Course("~write".to_owned()));
            html! { { part::<Share>(ShareProps { link: link.clone(), name: state.document.draft.scene().name.clone(), send, on_lesson, on_close }) } }
        }
        Panel::Help => {
            let is_free = state.lesson().is_none() && state.view.presenting == Presenting::Off;
            help(is_free, on_close)
        }
        Panel::Nothing
        | Panel::Course(_)
        | Panel::Menu
        | Panel::Open
        | Panel::Save
        | Panel::Settings
        | Panel::Planners => html! {},
    }
}

/// The phase in the style sheets. While ways to go on are compared their columns have
/// the place of the board; a tool that is picked needs the board, and so does a room from
/// which answers are hidden.
fn phase_class(state: &Shown) -> &'static str {
    match state.phase() {
        Phase::Comparing if state.view.tool != Tool::Select || state.hides_answers() => {
            "st-changing"
        }
        Phase::Editing => "st-editing",
        Phase::Solving => "st-solving",
        Phase::Asking | Phase::Checking | Phase::Counting => "st-asking",
        Phase::Planned | Phase::Found => "st-planned",
        Phase::Changing | Phase::Adapting => "st-changing",
        Phase::Comparing => "st-comparing",
        Phase::Steering => "st-steering",
        Phase::Auditing => "st-auditing",
        Phase::None => "st-none",
        Phase::Stopped => "st-stopped",
    }
}

/// The tools that may be used; all, but for those that a step of a lesson does without.
fn tools(state: &Shown) -> Vec<Tool> {
    let all = Tool::ALL.into_iter();
    let lesson = state.lesson();
    all.filter(|&tool| lesson.is_none_or(|lesson| lesson.allows(tool)))
        .collect()
}

/// What is shown to a room, for the style sheets and the script.
fn presents(state: &Shown) -> Option<&'static str> {
    match state.view.presenting {
        Presenting::Off => None,
        Presenting::Told => Some("told"),
        Presenting::Bare => Some("bare"),
    }
}

/// A lesson in the style sheets: it may do without the lanes.
fn lesson_class(state: &Shown) -> Option<&'static str> {
    let lesson = state.lesson()?;
    Some(if lesson.shows(Layer::Lanes) || state.is_inside() {
        "in-lesson"
    } else {
        "in-lesson no-lanes"
    })
}

/// What a phone shows below the board, in the style sheets.
const fn tab(tab: Tab) -> &'static str {
    match tab {
        Tab::Inspector => "inspector",
        Tab::Timeline => "timeline",
        Tab::Plan => "plan",
    }
}
