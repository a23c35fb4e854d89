//! How far a solve has come: what is proved, what is found, and the gap.

use crate::words::grouped;
use giveway_model::{Cost, Objective, tr};

use crate::{Size, Solving, words};

/// The cost that is worked on: what is proved of it and what is found.
#[derive(Clone, Debug, PartialEq)]
pub struct Gauge {
    /// The cost.
    pub cost: Cost,
    /// No plan has less; `None` where nothing is proved.
    pub at_least: Option<u32>,
    /// The best plan so far has this.
    pub best: Option<u32>,
    /// Both in a sentence.
    pub sentence: String,
}

/// How far a run has come: of the costs that it minimises in turn, the last one
/// that it knows a bound of.
pub fn gauge(run: &Solving) -> Gauge {
    let costs = objective(run).costs();
    let known = |cost: &&Cost| run.bounds.contains_key(cost);
    let reached = costs.iter().rev().find(known).or(costs.first());
    let cost = reached.copied().unwrap_or(Cost::Makespan);
    let at_least = run.bounds.get(&cost).copied().filter(|&n| n > 0);
    let best = run.best.map(|costs| costs.get(cost));
    Gauge {
        cost,
        at_least,
        best,
        sentence: settled(run, cost) + &sentence(at_least, best),
    }
}

impl Gauge {
    /// The end of a bar on which bound and best plan stand well within.
    ///
    /// ```
    /// use giveway_model::Cost;
    /// use giveway_page::timeline::Gauge;
    /// let gauge = Gauge { cost: Cost::Makespan, at_least: Some(17), best: Some(20), sentence: String::new() };
    /// assert_eq!(gauge.scale(), 24);
    /// ```
    pub fn scale(&self) -> u32 {
        let most = self.best.or(self.at_least).unwrap_or(0).max(8);
        let wanted = most + most.div_ceil(8);
        let unit = 10u32.pow(wanted.ilog10().saturating_sub(1));
        wanted.div_ceil(4 * unit) * 4 * unit
    }
}

fn objective(run: &Solving) -> &Objective {
    let asked = run.request.objective.as_ref();
    asked.unwrap_or(&run.request.scene.objective)
}

/// The costs before the one that is worked on: `With makespan 18: `.
fn settled(run: &Solving, cost: Cost) -> String {
    let before = objective(run).costs().iter();
    let values: Vec<String> = before
        .take_while(|&&before| before != cost)
        .filter_map(|&before| Some(words::value(before, run.best?.get(before))))
        .collect();
    if values.is_empty() {
        return String::new();
    }
    let values: Vec<&str> = values.iter().map(String::as_str).collect();
    tr!(
        "With {costs}: ",
        costs = values.join(tr!("between costs" => " and "))
    )
}

fn sentence(at_least: Option<u32>, best: Option<u32>) -> String {
    match (at_least, best) {
        (Some(least), Some(best)) if least >= best => {
            tr!(
                "Below {least} there is no plan, and a plan of {best} exists.",
                least,
                best
            )
        }
        (Some(least), Some(best)) => tr!(
            "Below {least} there is no plan. A plan of {best} exists. The answer lies between.",
            least,
            best
        ),
        (Some(least), None) => {
            tr!("Below {least} there is no plan. None is found yet.", least)
        }
        (None, Some(best)) => tr!("A plan of {best} exists. No bound is proved yet.", best),
        (None, None) => tr!("No plan is found and no bound is proved yet.").to_owned(),
    }
}

/// The size of a formula and the work on it: `900 variables, 3000 clauses`.
pub fn work_done(size: Size) -> String {
    let Size {
        variables,
        clauses,
        conflicts,
    } = size;
    let mut parts = Vec::new();
    let (all, these) = (grouped(variables), grouped(clauses));
    if variables > 0 {
        parts.push(tr!("{all} variable" | "{all} variables" % variables, all));
    }
    if clauses > 0 {
        parts.push(tr!("{all} clause" | "{all} clauses" % clauses, all = these));
    }
    if conflicts > 0 {
        let all = grouped(conflicts);
        parts.push(tr!("{all} conflict" | "{all} conflicts" % conflicts, all));
    }
    parts.join(", ")
}

#[cfg(test)]
mod tests {
    use giveway_model::{Costs, Plan};
    use giveway_solve::Progress;

    use super::*;
    use crate::{Action, SolveAction, State, WorkerAction, reduce, sample};

    fn after(events: &[Progress]) -> Gauge {
        let mut state = reduce(
            &State::new(sample::draft()),
            Action::Solve(SolveAction::Solve),
        );
        for event in events {
            let event = event.clone();
            state = reduce(
                &state,
                Action::Worker(WorkerAction::Progress { job: 1, event }),
            );
        }
        gauge(state.work.solving().unwrap())
    }

    const fn bound(cost: Cost, at_least: u32) -> Progress {
        Progress::Bound { cost, at_least }
    }

    fn plan() -> Progress {
        Progress::Plan {
            costs: Costs {
                makespan: 20,
                sum_of_costs: 37,
                charges: 3,
                moves: 30,
                waits: 0,
                penalty: 0,
            },
            plan: Plan::default(),
        }
    }

    #[test]
    fn nothing_known() {
        let gauge = after(&[]);
        assert_eq!(
            (gauge.cost, gauge.at_least, gauge.best),
            (Cost::Makespan, None, None)
        );
        assert_eq!(
            gauge.sentence,
            "No plan is found and no bound is proved yet."
        );
    }

    #[test]
    fn a_bound_then_a_plan() {
        let makespan = bound(Cost::Makespan, 17);
        let gauge = after(std::slice::from_ref(&makespan));
        assert_eq!(
            gauge.sentence,
            "Below 17 there is no plan. None is found yet."
        );
        let gauge = after(&[makespan, plan()]);
        assert_eq!(
            gauge.sentence,
            "Below 17 there is no plan. A plan of 20 exists. The answer lies between."
        );
    }

    #[test]
    fn the_next_cost_says_what_is_settled() {
        let gauge = after(&[
            bound(Cost::Makespan, 20),
            plan(),
            bound(Cost::SumOfCosts, 37),
        ]);
        assert_eq!(gauge.cost, Cost::SumOfCosts);
        assert_eq!(
            gauge.sentence,
            "With makespan 20: Below 37 there is no plan, and a plan of 37 exists."
        );
    }

    #[test]
    fn the_scale_has_room_beyond_the_best() {
        for best in [0, 1, 7, 18, 99, 100, 12345] {
            let gauge = Gauge {
                cost: Cost::Moves,
                at_least: None,
                best: Some(best),
                sentence: String::new(),
            };
            assert!(gauge.scale() > best + best / 10, "{best}");
            assert!(gauge.scale() <= 2 * best.max(8), "{best}");
        }
    }

    #[test]
    fn sizes() {
        let size = Size {
            variables: 900,
            clauses: 1_234_567,
            conflicts: 1,
        };
        assert_eq!(
            work_done(size),
            "900 variables, 1\u{202f}234\u{202f}567 clauses, 1 conflict"
        );
        assert_eq!(work_done(Size::default()), "");
    }
}
