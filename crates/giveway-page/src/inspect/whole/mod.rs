//! The scene and its plan as a whole.

mod costs;
#[cfg(test)]
mod tests;
mod words;

use giveway_model::tr;
use giveway_model::words::decimal;
use giveway_solve::{Status, words::reach_of_bounds};

use crate::timeline::work_done;
use crate::words::values;
use crate::{Answer, Draft, Size, State, changing, planners};

pub use costs::CostFacts;

use costs::costs;
pub(crate) use words::claim;
use words::contents;

/// What the inspector tells where nothing is selected.
#[derive(Clone, Debug, PartialEq)]
pub struct Whole {
    /// The name of the scene.
    pub title: String,
    /// What the scene contains: `2 robots, 2 chargers, 6 slow cells, 6 obstacles`.
    pub contents: String,
    /// What is claimed of the plan, and why nothing more; none before a solve.
    pub claims: Vec<String>,
    /// The costs, those of the objective first; empty where nothing is known.
    pub costs: Vec<CostFacts>,
    /// The size of the work.
    pub work: Option<String>,
}

/// What there is to tell of the scene and its plan.
pub fn whole(state: &State) -> Whole {
    let scene = state.document.draft.scene();
    let mut whole = Whole {
        title: if scene.name.is_empty() {
            tr!("Untitled").to_owned()
        } else {
            scene.name.clone()
        },
        contents: contents(
            state.world(),
            |agent| state.is_there(agent),
            changing::broken_down_for_good(state).len(),
        ),
        claims: Vec::new(),
        costs: Vec::new(),
        work: None,
    };
    if let Some(run) = state.work.solving() {
        let asked = run.request.objective.as_ref();
        let objective = asked.unwrap_or(&run.request.scene.objective);
        // Of the plan that plays, as what stands beside it is about that.
        let playing = state.playing_costs();
        whole.costs = costs(objective.costs(), |cost| {
            (
                playing.map(|costs| costs.get(cost)),
                run.bounds.get(&cost).copied(),
            )
        });
        if let Some((best, _)) = run.best.zip(state.playing_before_best()) {
            let costs = values(objective, &best);
            whole.claims.push(tr!(
                "A better plan is found: {costs}. It plays once this one is at its end.",
                costs
            ));
        }
        whole.work = Some(work_done(run.size)).filter(|text| !text.is_empty());
    } else if let Some(answer) = &state.document.answer {
        tell(&mut whole, answer);
        bound(&mut whole, answer, planners::least(&state.document));
        if state.document.own_front().is_some() {
            // What is claimed is claimed of the front, and said with it.
            whole.claims.clear();
        }
        if state.document.is_stale() {
            // What was proved was proved of another scene.
            for cost in &mut whole.costs {
                cost.at_least = None;
            }
            whole.claims = vec![tr!("This is of the scene before the last edit.").to_owned()];
            whole
                .claims
                .extend(without_path(&state.document.draft, answer));
            whole.work = None;
        }
    }
    whole
}

/// The robots that a plan of the scene before has no path for here: they are not in the timeline.
fn without_path(draft: &Draft, answer: &Answer) -> Option<String> {
    answer.plan()?;
    let agents = draft.agents().iter().enumerate();
    let agents = agents.filter(|(index, _)| answer.agent(draft, *index).is_none());
    let mut names: Vec<String> = agents.map(|(_, agent)| agent.name.clone()).collect();
    if names.len() > NAMES {
        names.truncate(NAMES);
        names.push("\u{2026}".to_owned());
    }
    let robots = names.join(", ");
    (!names.is_empty()).then(|| tr!("Without a path that fits: {robots}.", robots))
}

/// How many robots are named that a plan has no path for.
const NAMES: usize = 12;

/// What is proved of the first cost of all plans of the scene stands beside each plan of it.
fn bound(whole: &mut Whole, answer: &Answer, least: Option<u32>) {
    let first = answer.request.scene.objective.costs().first();
    let facts = whole
        .costs
        .iter_mut()
        .find(|facts| Some(&facts.cost) == first);
    if let (Some(facts), Some(least)) = (facts, least) {
        facts.at_least = Some(facts.at_least.map_or(least, |own| own.max(least)));
    }
}

fn tell(whole: &mut Whole, answer: &Answer) {
    let solved = &answer.solved;
    let asked = answer.request.objective.as_ref();
    let objective = asked.unwrap_or(&answer.request.scene.objective);
    whole.claims.extend(claim(answer));
    whole
        .claims
        .extend(solved.reason.as_ref().map(giveway_solve::words::reason));
    whole.claims.extend(reach_of_bounds(solved));
    whole.costs = costs(objective.costs(), |cost| {
        (
            solved.costs.map(|costs| costs.get(cost)),
            solved.bounds.get(&cost).copied(),
        )
    });
    let size = Size {
        variables: solved.stats.variables,
        clauses: solved.stats.clauses,
        conflicts: solved.stats.conflicts,
    };
    let mut work = work_done(size);
    if let Some(planner) = answer.by {
        planner.title().clone_into(&mut work);
    } else if work.is_empty() {
        // Of a search that was stopped the work is not known, nor of a plan from
        // elsewhere.
        if !matches!(solved.status, Status::Optimal | Status::Impossible) {
            return;
        }
        tr!("Proved without SAT").clone_into(&mut work);
    }
    let seconds = match solved.stats.cpu_seconds {
        little if little < 0.05 => tr!("less than 0.1 s").to_owned(),
        seconds => format!("{} s", decimal(seconds, 1)),
    };
    whole.work = Some(format!("{work}, {seconds}"));
}
