//! The plan of a node, of an order or of a configuration, for the board.

use std::rc::Rc;

use giveway_model::check::Rule;
use giveway_model::{Costs, Path, Plan, Version, check};
use giveway_solve::plan::{NodeFate, ToldConflict, words};
use giveway_solve::{Reach, SolveAnswer, SolveRequest, Stats, Status};

use super::crowd::{LacamRun, PibtRun};
use super::{Method, OrderRun, TreeRun, by_hand, index};
use crate::{Answer, Draft, State};

/// The plan of a node.
pub(crate) fn of_node(draft: &Rc<Draft>, tree: &TreeRun, node: u64) -> Rc<Answer> {
    answer(draft, tree.plan(node))
}

/// When the conflict of a node is: that on which it was split, else the first.
pub(crate) fn conflict_time(answer: &Answer, tree: &TreeRun, node: u64) -> u32 {
    match tree.node(node).map(|node| &node.fate) {
        Some(NodeFate::Split { conflict, .. }) => words::moment(conflict),
        Some(NodeFate::Open) => {
            let (Ok(instance), Some(plan)) = (answer.draft.instance(), answer.plan()) else {
                return 0;
            };
            let report = check::check(instance, plan);
            report.violations.first().map_or(0, |first| first.time)
        }
        _ => 0,
    }
}

/// The robots that are on one cell in the conflict of the chosen node, and when; of its own
/// plan only.
pub(crate) fn on_one_cell(state: &State, answer: &Rc<Answer>) -> Option<(Vec<usize>, u32)> {
    let shown = state.inside_plan()?;
    if !Rc::ptr_eq(shown, answer) || state.inside.method != Method::Tree {
        return None;
    }
    if state.inside.by_hand.is_on {
        return by_hand::together(state, answer);
    }
    let tree = state.looked()?.tree.as_ref()?.as_ref().ok()?;
    match &tree.node(state.inside.node)?.fate {
        NodeFate::Split { conflict, .. } => match conflict {
            ToldConflict::Vertex { agents, time, .. }
            | ToldConflict::Target { agents, time, .. } => {
                let [a, b] = agents;
                Some((vec![index(state, a)?, index(state, b)?], *time))
            }
            ToldConflict::Swap { .. } => None,
        },
        NodeFate::Open => {
            let report = check::check(answer.draft.instance().ok()?, answer.plan()?);
            let first = report.violations.first()?;
            let (Rule::Vertex, [a, b]) = (first.rule, first.agents.as_slice()) else {
                return None;
            };
            Some((vec![index(state, a)?, index(state, b)?], first.time))
        }
        _ => None,
    }
}

/// The plan of an order when so many of its robots have planned.
pub(crate) fn of_order(draft: &Rc<Draft>, run: &OrderRun, robots: usize) -> Rc<Answer> {
    let planned = run.told.planned.iter();
    let planned = planned.map(|planned| (&planned.agent, &planned.path));
    let stuck = run.told.stuck.iter();
    let stuck = stuck.map(|stuck| (&stuck.agent, &run.told.furthest));
    let mut plan = Plan::default();
    for (name, path) in planned.chain(stuck).take(robots) {
        plan.paths.insert(name.clone(), path.clone());
    }
    let arrived: Vec<&String> = run
        .told
        .planned
        .iter()
        .take(robots)
        .map(|own| &own.agent)
        .collect();
    let mut answer = answer(draft, plan);
    let own = Rc::make_mut(&mut answer);
    for (agent, arrival) in draft.agents().iter().zip(&mut own.arrivals) {
        if !arrived.contains(&&agent.name) {
            *arrival = None;
        }
    }
    answer
}

/// The plan of PIBT; where it has none, all robots stay at their starts.
pub(crate) fn of_pibt(draft: &Rc<Draft>, run: &PibtRun) -> Rc<Answer> {
    answer(draft, run.plan.clone().unwrap_or_default())
}

/// The steps that lead to a configuration of `LaCAM`, and how many; `None` where it was not told.
pub(crate) fn of_configuration(
    draft: &Rc<Draft>,
    run: &LacamRun,
    id: u32,
) -> Option<(Rc<Answer>, u32)> {
    let plan = run.plan(id, draft.agents())?;
    let mut answer = answer(draft, plan);
    let own = Rc::make_mut(&mut answer);
    let ends = draft.agents().iter().zip(run.cells(id));
    for ((agent, end), arrival) in ends.zip(&mut own.arrivals) {
        if Some(*end) != agent.goal {
            *arrival = None;
        }
    }
    Some((answer, u32::try_from(run.depth(id)).unwrap_or(u32::MAX)))
}

/// A plan that nothing is claimed of; whoever has no path stays at the start.
fn answer(draft: &Rc<Draft>, mut plan: Plan) -> Rc<Answer> {
    for agent in draft.agents() {
        let path = plan.paths.entry(agent.name.clone()).or_default();
        if path.is_empty() {
            path.push(Some(agent.start));
        }
    }
    let last = |path: &Path| u32::try_from(path.len().saturating_sub(1)).unwrap_or(u32::MAX);
    let makespan = plan.paths.values().map(last).max().unwrap_or(0);
    let solved = SolveAnswer {
        giveway: Version,
        status: Status::Feasible,
        costs: Some(Costs {
            makespan,
            ..Costs::default()
        }),
        bounds: std::collections::BTreeMap::new(),
        reach: Reach::default(),
        ended: None,
        reason: None,
        plan: Some(plan),
        stats: Stats::default(),
        trace: None,
    };
    let request = Rc::new(SolveRequest::default());
    Rc::new(Answer::new(Rc::clone(draft), request, solved))
}
