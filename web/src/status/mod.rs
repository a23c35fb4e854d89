//! The status sentence, the button that solves, and its settings.

mod live;
mod planners;

use giveway_model::tr;
use giveway_page::intake::Job;
use giveway_page::lesson::Lesson;
use giveway_page::rules::RuleAction;
use giveway_page::{Action, ChangeAction, Phase, SolveAction, State, words};
use yew::prelude::*;

use crate::dialog::{Panel, use_dismiss};
use crate::part::part;
use crate::status::live::LiveProps;
use crate::turning::{Turning, TurningProps};
use crate::{Shown, icon, inspector, settings};
use live::Live;

/// The state, what is open, and where changes of both go.
#[derive(Clone, PartialEq, Properties)]
pub(crate) struct StatusBarProps {
    /// The state.
    pub(crate) state: Shown,
    /// What is open.
    pub(crate) panel: Panel,
    /// Takes actions.
    pub(crate) send: Callback<Action>,
    /// Opens and closes.
    pub(crate) show: Callback<Panel>,
}

/// The status sentence with its badge; the objective; `Solve` or `Cancel`.
#[component]
pub(crate) fn StatusBar(props: &StatusBarProps) -> Html {
    let StatusBarProps {
        state,
        panel,
        send,
        show,
    } = props;
    let around = use_node_ref();
    let planners = use_node_ref();
    let open = *panel == Panel::Settings;
    let close = show.reform(|()| Panel::Nothing);
    use_dismiss(&around, open || *panel == Panel::Planners, &close);
    let toggle = show.reform(move |_: MouseEvent| {
        if open {
            Panel::Nothing
        } else {
            Panel::Settings
        }
    });
    // A plan that is to be guessed is not told.
    let hides_plan = state.lesson().is_some_and(Lesson::hides_plan);
    let costs = words::objective(&state.document.draft.scene().objective);
    html! {
        <section class="status" aria-label={tr!("Status")}>
            if !hides_plan { { sentence(state) } }
            if state.lesson().is_none() { { own_rules(state, send) } }
            if state.lesson().is_none() {
            <div class="solve" ref={around}>
                <button class="obj" title={tr!("Objective, rules and limits")}
                    aria-label={tr!("Settings: {costs}", costs = objective_words(&costs))}
                    aria-expanded={open.to_string()} onclick={toggle}>
                    { icon::show("settings") }
                    { objective(&costs) }
                </button>
                { solve_button(state, send) }
                { planners::show(state, &planners, panel, send, show) }
                if open {
                    { settings::show(state, send, &close) }
                }
            </div>
            }
        </section>
    }
}

/// How many bytes of the sentence are in large letters.
const LONG: usize = 84;

/// The status sentence with its badge: seen, and read aloud.
pub(crate) fn sentence(state: &State) -> Html {
    let standing = words::standing(state);
    let badge = standing.badge;
    let is_long = standing.beside_badge().len() > LONG;
    html! {
        <>
            <p class="status-line" aria-hidden="true">
                <span class={classes!("badge", badge.class())}>
                    { icon::show(badge.icon()) }{ badge.word() }
                </span>
                // What stands there once the question is answered: the line keeps its height.
                <span class={classes!("say", is_long.then_some("long"))} data-later={words::later(state)}>
                    <span>{ standing.beside_badge().to_owned() }</span>
                </span>
            </p>
            { part::<Live>(LiveProps { standing }) }
        </>
    }
}

/// How many rules of the scene's own are in force: it leads to their list.
fn own_rules(state: &State, send: &Callback<Action>) -> Html {
    let Some(rules) = words::standing(state).rules else {
        return Html::default();
    };
    let send = send.clone();
    let onclick = Callback::from(move |_: MouseEvent| {
        send.emit(Action::Rules(RuleAction::List));
        inspector::show_rules();
    });
    html! {
        <button type="button" class="link status-rules" aria-label={tr!("{rules} in force: show them", rules)} {onclick}>{ rules.clone() }</button>
    }
}

/// The costs in short: there is room for three.
fn objective(costs: &[&'static str]) -> Html {
    let (told, more) = costs.split_at(costs.len().min(3));
    let mut told = told.iter();
    let first = told.next().copied();
    html! {
        <>
            <span>{ first }</span>
            { for told.map(|&cost| html! { <><em>{ tr!(" then ") }</em><span>{ cost }</span></> }) }
            if !more.is_empty() { <em>{ tr!(" and {more} more", more = more.len()) }</em> }
        </>
    }
}

/// The same in words: a name must hold what is seen.
fn objective_words(costs: &[&'static str]) -> String {
    let (told, more) = costs.split_at(costs.len().min(3));
    let told = told.join(tr!(" then "));
    match more.len() {
        0 => told,
        more => tr!("{told} and {more} more", told, more),
    }
}

/// The one next step is dark: to cancel, or to solve where nothing fits the
/// scene.
fn solve_button(state: &Shown, send: &Callback<Action>) -> Html {
    // An answer on its way has its own button, at the foot of the inspector.
    let phase = if state.is_looking() {
        state.resting_phase()
    } else {
        state.phase()
    };
    let is_asked = state.document.mode.asking().is_some();
    let is_drawing = state.intake.job().is_some_and(Job::is_picture);
    let going_on = tr!(
        "Go on from here, for {n} s (Ctrl Enter)",
        n = state.seconds_to_go_on()
    );
    let (class, title, action) = match phase {
        _ if is_drawing => (
            "primary",
            tr!("Cancel (Escape)"),
            Action::Solve(SolveAction::Cancel),
        ),
        // It runs by itself: the next step is at the foot of the inspector.
        Phase::Solving if state.audit().is_some() => (
            "outline",
            tr!("Cancel (Escape)"),
            Action::Solve(SolveAction::Cancel),
        ),
        Phase::Solving | Phase::Asking | Phase::Checking | Phase::Counting | Phase::Adapting => (
            "primary",
            tr!("Cancel (Escape)"),
            Action::Solve(SolveAction::Cancel),
        ),
        Phase::Changing => (
            if is_asked { "outline" } else { "primary" },
            tr!("Find new plans (Ctrl Enter)"),
            Action::Change(ChangeAction::Adapt),
        ),
        Phase::Comparing => (
            "outline",
            tr!("Find new plans again (Ctrl Enter)"),
            Action::Change(ChangeAction::Adapt),
        ),
        Phase::Steering => {
            let class = if is_asked { "outline" } else { "primary" };
            (
                class,
                tr!("Check my plan (Ctrl Enter)"),
                Action::Solve(SolveAction::Solve),
            )
        }
        Phase::Stopped => (
            "outline",
            going_on.as_str(),
            Action::Solve(SolveAction::Solve),
        ),
        // What is being made comes first.
        Phase::Editing if !state.is_making() => (
            "primary",
            tr!("Solve (Ctrl Enter)"),
            Action::Solve(SolveAction::Solve),
        ),
        _ => (
            "outline",
            tr!("Solve (Ctrl Enter)"),
            Action::Solve(SolveAction::Solve),
        ),
    };
    let word = match phase {
        _ if is_drawing => tr!("Cancel"),
        Phase::Solving | Phase::Asking | Phase::Checking | Phase::Counting | Phase::Adapting => {
            tr!("Cancel")
        }
        Phase::Changing => tr!("Find new plans"),
        Phase::Comparing => tr!("Find again"),
        Phase::Steering => tr!("Check my plan"),
        Phase::Stopped => tr!("Go on"),
        _ => tr!("Solve"),
    };
    let press = send.reform(move |_| action.clone());
    let content = html! {
        <>
            if word == tr!("Cancel") { { icon::show("cancel") } }
            <span>{ word }</span>
        </>
    };
    part::<Turning>(TurningProps {
        meaning: word.into(),
        class: classes!("btn", class),
        title: Some(title.to_owned().into()),
        label: None,
        is_off: false,
        is_toggle: false,
        content,
        onclick: press,
    })
}
