//! What the column says of a step of the proof.

use giveway_model::words::{and, grouped, name, value};
use giveway_model::{Cost, Objective, tr};
use giveway_solve::trace::{AgentLeast, Core, SearchEvent, TraceEvent, words};

use super::closer::{alone, chosen_core, limits, told, view_alone};
use super::means::means;
use super::why::{question, why};
use super::{chosen, chosen_event, rows, trace};
use crate::State;
use crate::inside::column::{Button, Choice, Column, Listed, Tint, Verdict};
use crate::inside::{InsideAction, index};

/// So many robots are listed.
const LISTED: usize = 40;

pub(crate) fn column(state: &State) -> Option<Column> {
    let (at, last) = chosen(state)?;
    let event = chosen_event(state)?;
    let objective = &trace(state)?.objective;
    let title = rows::text(objective, event);
    let mut column = Column {
        over: match alone(state) {
            Some((view, _)) => {
                let names: Vec<String> = limits(&view.core)
                    .into_iter()
                    .map(|own| own.agent)
                    .collect();
                tr!(
                    "{robots} alone: step {at} of {last}",
                    robots = and(&names),
                    at,
                    last
                )
            }
            None => tr!("Step {at} of {last}", at, last),
        },
        verdict: verdict(objective, event, &title),
        title,
        foot: foot(state, event, at, last),
        means: means(&event.event).map(str::to_owned),
        can_export: trace(state).is_some(),
        ..Column::default()
    };
    about(state, event, &mut column);
    closer(state, &mut column);
    Some(column)
}

/// The step as it is read aloud.
pub(crate) fn step_text(state: &State) -> Option<String> {
    let event = chosen_event(state)?;
    let text = rows::text(&trace(state)?.objective, event);
    Some(match bound(&event.event) {
        Some((_, to)) => tr!("{text}: at least {to}", text, to),
        None => text,
    })
}

/// The bounds before and after an event that raises one.
const fn bound(event: &SearchEvent) -> Option<(Option<u32>, u32)> {
    match event {
        SearchEvent::Alone { at_least, .. } | SearchEvent::Counted { at_least, .. } => {
            Some((None, *at_least))
        }
        SearchEvent::Core(core) => Some((Some(core.from), core.to)),
        SearchEvent::Closed { from, to, .. } => Some((Some(*from), *to)),
        _ => None,
    }
}

fn verdict(objective: &Objective, event: &TraceEvent, title: &str) -> Option<Verdict> {
    let tint = match &event.event {
        SearchEvent::Impossible(_) => Tint::Stuck,
        SearchEvent::Plan { .. } => Tint::Fine,
        SearchEvent::Alone { .. }
        | SearchEvent::Core(_)
        | SearchEvent::Closed { .. }
        | SearchEvent::Counted { .. }
        | SearchEvent::Exhausted { .. }
        | SearchEvent::Met { .. } => Tint::Proved,
        _ => Tint::Told,
    };
    let (word, beside) = match (&event.event, bound(&event.event)) {
        (_, Some((from, to))) => {
            let was = from.map_or_else(String::new, |from| tr!("was {from}", from));
            (tr!("At least {to}", to), was)
        }
        (SearchEvent::Plan { .. }, _) => (tr!("A better plan").to_owned(), String::new()),
        (SearchEvent::Met { .. } | SearchEvent::Exhausted { .. }, _) => {
            (tr!("Proved").to_owned(), String::new())
        }
        (SearchEvent::Impossible(_), _) => (tr!("No plan").to_owned(), String::new()),
        _ => return None,
    };
    let text = match &event.event {
        SearchEvent::Core(core) => so(core),
        event => {
            let text = words::sentence(objective, event);
            if text.trim_end_matches('.') == title {
                String::new()
            } else {
                text
            }
        }
    };
    Some(Verdict {
        tint,
        word,
        beside,
        text,
    })
}

/// What follows from a core, and of which plans.
fn so(core: &Core) -> String {
    let no_plan = match core.cost {
        Cost::Makespan | Cost::SumOfCosts => {
            tr!(
                "no plan has a {cost} below {to}",
                cost = name(core.cost),
                to = core.to
            )
        }
        cost => tr!(
            "no plan has fewer than {value}",
            value = value(cost, core.to)
        ),
    };
    match words::scope(&core.scope, core.cost) {
        None => tr!("So {no_plan}.", no_plan),
        Some(plans) => format!("{plans}, {no_plan}."),
    }
}

/// Why the robots of the step cannot, and the way to their own proof.
fn closer(state: &State, column: &mut Column) {
    let Some((core, told)) = chosen_core(state).zip(told(state)) else {
        return;
    };
    column.why = why(core, told);
    let proof = told
        .alone
        .as_ref()
        .and_then(|alone| alone.solved.trace.as_ref());
    if let Some(proof) = proof.filter(|_| view_alone(state).is_some()) {
        let last = super::steps(proof).count().saturating_sub(1);
        let last = u32::try_from(last).unwrap_or(u32::MAX);
        let choice = Choice {
            agent: None,
            text: question(core),
            small: tr!("The proof for these robots alone: {n} step"
                | "The proof for these robots alone: {n} steps" % last),
            action: InsideAction::Alone(true),
        };
        column.choices = Some((tr!("Look closer").to_owned(), vec![choice]));
    }
}

/// Robots, work and remarks.
fn about(state: &State, event: &TraceEvent, column: &mut Column) {
    match &event.event {
        SearchEvent::Alone { cost, agents, .. } => {
            column.table = Some(table(
                state,
                tr!("What each robot needs alone"),
                *cost,
                agents,
            ));
        }
        SearchEvent::Core(core) => {
            let asked = limits(core);
            let is_on_time = asked.iter().all(|limit| limit.at_most == limit.least);
            let own = asked.into_iter().map(|limit| AgentLeast {
                agent: limit.agent,
                least: limit.at_most,
            });
            let own: Vec<AgentLeast> = own.collect();
            let mut table = table(state, tr!("The robots of this step"), core.cost, &own);
            if !is_on_time {
                table.columns[0] = tr!("At most");
            }
            column.table = Some(table);
            if core.took > 0 {
                let took = u32::try_from(core.took).unwrap_or(u32::MAX);
                column.remark = Some(tr!("The solver met {n} conflict on the way to it."
                    | "The solver met {n} conflicts on the way to it." % took));
            }
        }
        SearchEvent::Closed { took, .. } if *took > 0 => {
            column.remark = Some(tr!(
                "The solver met {many} conflicts on the way to it.",
                many = grouped(*took)
            ));
        }
        _ => {}
    }
}

fn table(state: &State, title: &str, cost: Cost, agents: &[AgentLeast]) -> Listed {
    let answer = state.document.fresh_answer().or_else(|| state.so_far());
    let arrival = |name: &str| {
        let answer = answer?;
        let agent = index(state, name)?;
        *answer.arrivals.get(answer.agent(&answer.draft, agent)?)?
    };
    let is_time = matches!(cost, Cost::Makespan | Cost::SumOfCosts);
    let row = |own: &AgentLeast| {
        let best = arrival(&own.agent).filter(|_| is_time);
        let best = best.map_or("\u{2013}".to_owned(), |time| time.to_string());
        (
            index(state, &own.agent),
            own.agent.clone(),
            [own.least.to_string(), best],
        )
    };
    Listed {
        title: title.to_owned(),
        columns: if is_time {
            [tr!("On time"), tr!("In the plan")]
        } else {
            [tr!("Alone"), tr!("In the plan")]
        },
        rows: agents.iter().take(LISTED).map(row).collect(),
    }
}

fn foot(state: &State, event: &TraceEvent, at: usize, last: usize) -> Vec<Button> {
    let next = (at < last).then_some(InsideAction::Next);
    let step = Button::new("", tr!("Next step"), next, true);
    if alone(state).is_some() {
        let back = |is_primary| {
            Button::new(
                "back",
                tr!("All robots again"),
                Some(InsideAction::Alone(false)),
                is_primary,
            )
        };
        return match next {
            Some(_) => vec![back(false), step],
            None => vec![back(true)],
        };
    }
    let before = (at > 0).then_some(InsideAction::Back);
    let can_play = next.is_none()
        && state
            .document
            .fresh_answer()
            .is_some_and(|a| a.plan().is_some());
    let on = match &event.event {
        SearchEvent::Impossible(_) => Button::new(
            "",
            tr!("Why is there no plan?"),
            Some(InsideAction::Reasons),
            true,
        ),
        _ if can_play => Button::new(
            "play",
            tr!("Play the plan"),
            Some(InsideAction::PlayPlan),
            true,
        ),
        _ => step,
    };
    vec![Button::new("back", tr!("Step before"), before, false), on]
}
