//! A Pareto front: the plans of which none is better in one cost without being
//! worse in another. Each of them is a plan to show.

use std::collections::BTreeMap;
use std::rc::Rc;

use giveway_model::{Cost, Objective, Version, words::values};
use giveway_solve::{FrontAnswer, SolveAnswer, SolveRequest, Stats, Status};

use crate::{Answer, Draft, words};

/// The numbers of costs that have a front.
const COSTS: std::ops::RangeInclusive<usize> = 2..=3;

/// The front of a draft, as far as it was found.
#[derive(Clone, Debug, PartialEq)]
pub struct Front {
    /// The draft that was solved.
    pub draft: Rc<Draft>,
    /// The plans, in the order of the first cost.
    pub points: Vec<Rc<Answer>>,
    /// What is known of the front as a whole.
    pub status: Status,
    /// The makespan up to which it is whole; `None` for whatever the horizon.
    pub within: Option<u32>,
    costs: Vec<Cost>,
    told: FrontAnswer,
}

/// Where the points are on a plot, whole units from its upper left.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Plot {
    /// The points: the first cost to the right, the second upwards.
    pub points: Vec<(u32, u32)>,
    /// The least and the greatest value of the first cost, as they stand below.
    pub across: [u32; 2],
    /// Those of the second one, as they stand on the left.
    pub up: [u32; 2],
    /// The names of both costs.
    pub titles: [&'static str; 2],
}

impl Plot {
    /// The room for the points, in units: width and height.
    pub const ROOM: (u32, u32) = (260, 120);
}

/// Whether an objective has a front: one of two or three costs has.
pub fn has_front(objective: &Objective) -> bool {
    COSTS.contains(&objective.costs().len())
}

impl Front {
    /// Takes a front in.
    ///
    /// What is proved of a point is that it is on the front, not that no plan has
    /// less of one cost: so each is taken in as a plan without a claim, which is
    /// all that a link or a question may make of it.
    pub(crate) fn new(draft: Rc<Draft>, request: &Rc<SolveRequest>, front: FrontAnswer) -> Self {
        let objective = request.objective.as_ref();
        let objective = objective.unwrap_or(&request.scene.objective);
        let points = front.front.iter().cloned().map(|point| {
            let plan = SolveAnswer {
                status: Status::Feasible,
                bounds: BTreeMap::new(),
                ..point
            };
            Rc::new(Answer::new(Rc::clone(&draft), Rc::clone(request), plan))
        });
        Self {
            points: points.collect(),
            status: front.status,
            within: front.within.filter(|_| !front.complete),
            costs: objective.costs().to_vec(),
            told: front,
            draft,
        }
    }

    /// The answer to show first: the plan with the least of the first cost, or
    /// that there is none.
    pub(crate) fn first(&self, request: &Rc<SolveRequest>) -> Rc<Answer> {
        if let Some(first) = self.points.first() {
            return Rc::clone(first);
        }
        let none = SolveAnswer {
            giveway: Version,
            status: self.status,
            costs: None,
            bounds: BTreeMap::new(),
            within: self.within,
            complete: self.within.is_none() && self.status == Status::Impossible,
            reason: None,
            plan: None,
            stats: Stats::default(),
        };
        Rc::new(Answer::new(
            Rc::clone(&self.draft),
            Rc::clone(request),
            none,
        ))
    }

    /// What was told of it.
    pub(crate) const fn told(&self) -> &FrontAnswer {
        &self.told
    }

    /// Whether it is proved that these are all.
    pub fn is_whole(&self) -> bool {
        self.status == Status::Optimal
    }

    /// The number of a plan among the points, if it is one.
    pub fn place_of(&self, answer: &Rc<Answer>) -> Option<usize> {
        self.points
            .iter()
            .position(|point| Rc::ptr_eq(point, answer))
    }

    /// The costs of a point in words: `makespan 18, sum of costs 35`.
    pub fn name(&self, point: usize) -> String {
        let costs = self.points.get(point).and_then(|point| point.solved.costs);
        costs.map_or_else(String::new, |costs| values(&self.costs, &costs))
    }

    /// What is claimed of it, in a sentence.
    pub fn claim(&self) -> String {
        let plans = words::count(self.points.len(), "plan");
        giveway_solve::words::front(&plans, self.is_whole(), self.within)
    }

    /// The plot of the first two costs.
    pub fn plot(&self) -> Plot {
        let [first, second, ..] = self.costs[..] else {
            return Plot::default();
        };
        let all = || self.points.iter().filter_map(|point| point.solved.costs);
        let span = |cost| {
            let values = || all().map(|costs| costs.get(cost));
            [values().min().unwrap_or(0), values().max().unwrap_or(0)]
        };
        let (across, up) = (span(first), span(second));
        let share = |value: u32, [least, most]: [u32; 2], room: u32| match most - least {
            0 => room / 2,
            span => (value - least) * room / span,
        };
        let (width, height) = Plot::ROOM;
        let place = |costs: giveway_model::Costs| {
            let x = share(costs.get(first), across, width);
            (x, height - share(costs.get(second), up, height))
        };
        Plot {
            points: all().map(place).collect(),
            across,
            up,
            titles: [words::title(first), words::title(second)],
        }
    }
}

#[cfg(test)]
mod tests {
    use crate::{BoardAction, SolveAction, State, ViewAction};
    use giveway_model::Costs;
    use giveway_solve::Response;

    use super::*;
    use crate::sample::{draft, proved, warehouse};
    use crate::{Action, Phase, reduce};

    /// The warehouse's plan as if it cost so much, makespan and sum of costs.
    fn point((makespan, sum_of_costs): (u32, u32)) -> SolveAnswer {
        let answer = warehouse();
        let costs = Costs {
            makespan,
            sum_of_costs,
            ..answer.solved.costs.unwrap()
        };
        let plan = answer.plan().cloned().unwrap();
        proved(&answer.draft.scene().objective, costs, plan)
    }

    fn solved(status: Status, costs: &[(u32, u32)]) -> State {
        let actions = [
            Action::View(ViewAction::SetFront(true)),
            Action::Solve(SolveAction::Solve),
        ];
        let state = actions
            .into_iter()
            .fold(State::new(draft()), |state, action| reduce(&state, action));
        let front = FrontAnswer {
            giveway: Version,
            status,
            complete: status == Status::Optimal || costs.is_empty(),
            within: None,
            front: costs.iter().copied().map(point).collect(),
        };
        let response = Box::new(Response::Front(front));
        reduce(
            &state,
            Action::Solve(SolveAction::Respond { job: 1, response }),
        )
    }

    #[test]
    fn every_point_is_a_plan_to_show() {
        let state = solved(Status::Optimal, &[(18, 35), (20, 34), (22, 32)]);
        let front = state.document.front().unwrap();
        assert_eq!(front.name(1), "makespan 20, sum of costs 34, 3 charges");
        assert_eq!(
            front.place_of(state.document.answer.as_ref().unwrap()),
            Some(0)
        );
        assert_eq!(state.phase(), Phase::Planned);
        let standing = words::standing(&state);
        assert!(
            standing
                .sentence
                .starts_with("On the Pareto front of 3 plans: makespan 18"),
            "{standing:?}"
        );

        let state = reduce(&state, Action::Solve(SolveAction::ShowPoint(2)));
        assert_eq!(state.last_time(), 22);
        assert!(words::standing(&state).sentence.contains("makespan 22"));
        assert_eq!(
            reduce(&state, Action::Solve(SolveAction::ShowPoint(9))),
            state
        );
    }

    #[test]
    fn a_point_claims_nothing_of_its_own() {
        let state = solved(Status::Optimal, &[(18, 35), (20, 34)]);
        let solved = &state.document.answer.as_ref().unwrap().solved;
        assert_eq!((solved.status, solved.bounds.len()), (Status::Feasible, 0));
        let part = self::solved(Status::Feasible, &[(18, 35)]);
        assert_eq!(part.phase(), Phase::Stopped);
        assert!(part.document.front().unwrap().claim().contains("so far"));
        let none = self::solved(Status::Impossible, &[]);
        assert_eq!(none.phase(), Phase::None);
    }

    #[test]
    fn a_plot_goes_from_the_least_to_the_greatest() {
        let state = solved(Status::Optimal, &[(18, 35), (20, 34), (22, 32)]);
        let plot = state.document.front().unwrap().plot();
        assert_eq!(plot.points, [(0, 0), (130, 40), (260, 120)]);
        assert_eq!((plot.across, plot.up), ([18, 22], [32, 35]));
        let one = solved(Status::Optimal, &[(18, 35)]);
        assert_eq!(one.document.front().unwrap().plot().points, [(130, 60)]);
    }

    #[test]
    fn a_front_is_of_its_scene() {
        let state = solved(Status::Optimal, &[(18, 35)]);
        let edited = [
            Action::Board(BoardAction::PickTool(crate::Tool::Charger)),
            Action::Board(BoardAction::Press(giveway_model::Cell::new(1, 0))),
            Action::Board(BoardAction::Release),
        ]
        .into_iter()
        .fold(state.clone(), |state, action| reduce(&state, action));
        assert!(edited.document.front().is_none());
        let back = reduce(&edited, Action::Undo);
        assert!(back.document.front().is_some());
        assert_eq!(
            reduce(&back, Action::View(ViewAction::SetFront(false)))
                .document
                .front(),
            back.document.front()
        );
    }
}
