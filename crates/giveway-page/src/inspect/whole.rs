//! The scene and its plan as a whole.

use giveway_model::{Cost, Ground};
use giveway_solve::{Status, words::reach_of_bounds};

use crate::timeline::work_done;
use crate::words::{count, title};
use crate::{Answer, Draft, Size, State};

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

/// A cost of the plan.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct CostFacts {
    /// The cost.
    pub cost: Cost,
    /// Its name.
    pub title: &'static str,
    /// What the plan has; `None` without a plan.
    pub value: Option<u32>,
    /// The proved lower bound.
    pub at_least: Option<u32>,
    /// Whether it is one of those to be minimised.
    pub is_minimised: bool,
}

impl CostFacts {
    /// Whether it is proved that no plan has less.
    pub fn is_proved(&self) -> bool {
        self.value.is_some() && self.value == self.at_least
    }
}

/// What there is to tell of the scene and its plan.
pub fn whole(state: &State) -> Whole {
    let scene = state.document.draft.scene();
    let mut whole = Whole {
        title: if scene.name.is_empty() {
            "Scene without a name".to_owned()
        } else {
            scene.name.clone()
        },
        contents: contents(state.world(), |agent| state.is_there(agent)),
        claims: Vec::new(),
        costs: Vec::new(),
        work: None,
    };
    if let Some(run) = state.work.solving() {
        let asked = run.request.objective.as_ref();
        let objective = asked.unwrap_or(&run.request.scene.objective);
        whole.costs = costs(objective.costs(), |cost| {
            (
                run.best.map(|costs| costs.get(cost)),
                run.bounds.get(&cost).copied(),
            )
        });
        whole.work = Some(work_done(run.size)).filter(|text| !text.is_empty());
    } else if let Some(answer) = &state.document.answer {
        tell(&mut whole, answer);
        if state.document.own_front().is_some() {
            // What is claimed is claimed of the front, and said with it.
            whole.claims.clear();
        }
        if state.document.is_stale() {
            // What was proved was proved of another scene.
            for cost in &mut whole.costs {
                cost.at_least = None;
            }
            whole.claims = vec!["This is of the scene before the last edit.".to_owned()];
            whole.work = None;
        }
    }
    whole
}

fn tell(whole: &mut Whole, answer: &Answer) {
    let solved = &answer.solved;
    let asked = answer.request.objective.as_ref();
    let objective = asked.unwrap_or(&answer.request.scene.objective);
    whole.claims.push(claim(answer));
    whole.claims.extend(solved.reason.clone());
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
    if work.is_empty() {
        "Proved without SAT".clone_into(&mut work);
    }
    let seconds = match solved.stats.cpu_seconds {
        little if little < 0.05 => "less than 0.1 s".to_owned(),
        seconds => format!("{seconds:.1} s"),
    };
    whole.work = Some(format!("{work}, {seconds}"));
}

fn costs(objective: &[Cost], known: impl Fn(Cost) -> (Option<u32>, Option<u32>)) -> Vec<CostFacts> {
    let others = Cost::ALL
        .into_iter()
        .filter(|cost| !objective.contains(cost));
    let all = objective.iter().copied().chain(others);
    let facts = all.map(|cost| {
        let (value, at_least) = known(cost);
        CostFacts {
            cost,
            title: title(cost),
            value,
            at_least,
            is_minimised: objective.contains(&cost),
        }
    });
    facts
        .filter(|facts| facts.value.is_some() || facts.at_least.is_some())
        .collect()
}

/// What is claimed, and how far it reaches.
fn claim(answer: &Answer) -> String {
    let solved = &answer.solved;
    if let (Some(course), Status::Optimal) = (&answer.course, solved.status) {
        let at = answer.changed_last().unwrap_or(0);
        let step = course.steps.last().and_then(|step| step.method);
        let way = step.map_or_else(String::new, |method| {
            format!(" by {}", crate::words::change::method_in_words(method))
        });
        return format!("No way to go on from time {at}{way} is better.");
    }
    giveway_solve::words::claim(solved)
}

/// What a scene contains.
fn contents(draft: &Draft, is_there: impl Fn(usize) -> bool) -> String {
    let grid = draft.grid();
    let grounds = |is: fn(Ground) -> bool| {
        let rows = (0..grid.height()).map(|y| grid.row(y));
        rows.flatten().filter(|&&ground| is(ground)).count()
    };
    let agents = (0..draft.agents().len()).filter(|&agent| is_there(agent));
    let mut parts = vec![count(agents.count(), "robot")];
    for (n, thing) in [
        (grounds(Ground::is_charger), "charger"),
        (grounds(Ground::is_slow), "slow cell"),
        (grounds(|ground| ground == Ground::Obstacle), "obstacle"),
    ] {
        if n > 0 {
            parts.push(count(n, thing));
        }
    }
    parts.join(", ")
}

#[cfg(test)]
mod tests {
    use crate::{BoardAction, SolveAction};
    use giveway_solve::Progress;

    use super::*;
    use crate::{Action, reduce, sample};

    #[test]
    fn a_proved_plan() {
        let whole = whole(&sample::solved());
        assert_eq!(whole.title, "warehouse");
        assert_eq!(
            whole.contents,
            "2 robots, 2 chargers, 6 slow cells, 6 obstacles"
        );
        assert_eq!(
            whole.claims,
            ["No plan is better, no matter how many steps you allow."]
        );
        let proved: Vec<_> = whole.costs.iter().map(CostFacts::is_proved).collect();
        assert_eq!(proved, [true, true, true, false, false]);
        assert_eq!(whole.costs[1].title, "Sum of costs");
        assert_eq!(
            whole.work.as_deref(),
            Some("Proved without SAT, less than 0.1 s")
        );
    }

    #[test]
    fn a_solve_under_way() {
        let state = reduce(
            &State::new(sample::draft()),
            Action::Solve(SolveAction::Solve),
        );
        assert_eq!(whole(&state).costs, []);
        let event = Progress::Bound {
            cost: Cost::Makespan,
            at_least: 17,
        };
        let state = reduce(
            &state,
            Action::Solve(SolveAction::Progress { job: 1, event }),
        );
        let costs = whole(&state).costs;
        assert_eq!(costs.len(), 1);
        assert_eq!((costs[0].value, costs[0].at_least), (None, Some(17)));
        assert!(!costs[0].is_proved());
    }

    #[test]
    fn a_stale_plan_is_called_one() {
        let state = sample::solved();
        let state = reduce(
            &state,
            Action::Board(BoardAction::PickTool(crate::Tool::Obstacle)),
        );
        let state = reduce(
            &state,
            Action::Board(BoardAction::Press(giveway_model::Cell::new(8, 1))),
        );
        let state = reduce(
            &state,
            Action::Board(BoardAction::Press(giveway_model::Cell::new(4, 2))),
        );
        let state = reduce(&state, Action::Board(BoardAction::Release));
        assert!(state.document.is_stale());
        assert!(whole(&state).claims[0].contains("before the last edit"));
    }
}
