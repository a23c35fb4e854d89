//! What would help, by a solver that says as little as is told to it.

use giveway_model::{Cell, Costs, Instance, Plan};

use super::{contrast::explain, read};
use crate::{
    explain::{
        Edit, Verdict,
        group::{Group, Variant},
        group_mus::{Inquiry, Tried},
        repairs::{EditedPlan, Solver, TriedEdits, Unsolved, repairs},
        whole::WholePlan,
    },
    tests::instance,
};

/// A solver that finds a plan of every edited instance, and maybe proves it
/// best.
struct Finds {
    proves: bool,
    /// Its plan, and what it says that this costs.
    plan: Plan,
    costs: Costs,
    /// Whether a known plan is as asked for.
    accepts: bool,
}

impl Finds {
    fn plans(proves: bool) -> Self {
        Self {
            proves,
            plan: Plan::default(),
            costs: Costs::default(),
            accepts: false,
        }
    }
}

impl Inquiry for Finds {
    fn search(&mut self, _: &Variant) -> Tried {
        Tried::Plan(Plan::default())
    }

    fn search_briefly(&mut self, variant: &Variant) -> Tried {
        self.search(variant)
    }

    fn search_again(&mut self, variant: &Variant) -> Tried {
        self.search(variant)
    }

    fn search_longer(&mut self, variant: &Variant) -> Tried {
        self.search(variant)
    }

    fn accepts(&self, _: &Variant, _: &Plan) -> bool {
        self.accepts
    }

    fn is_over(&self) -> bool {
        false
    }
}

impl Solver for Finds {
    fn best(&mut self, _: &Variant) -> Option<EditedPlan> {
        Some(EditedPlan {
            plan: self.plan.clone(),
            costs: self.costs,
            proved: self.proves,
        })
    }

    fn cheapest(&mut self, variant: &Variant) -> Option<EditedPlan> {
        self.best(variant)
    }

    fn near_to(&mut self, _: &Plan, _: &Variant) -> Option<Plan> {
        None
    }
}

#[test]
fn repairs_whose_plans_may_not_be_the_best_are_not_all_that_is_to_say() {
    let instance = instance("a # A");
    for proves in [true, false] {
        let broken = Unsolved {
            instance: &instance,
            is_large: false,
            within: None,
            objective: instance.objective(),
            plan: None,
            asked: &[],
            arriving: None,
            charging: None,
            reach: crate::search::Proved::Within(20),
            cores: vec![vec![Group::Obstacle(Cell::new(1, 0))]],
            suspects: Vec::new(),
            whole: WholePlan::default(),
        };
        let found = repairs(&broken, TriedEdits::default(), &mut Finds::plans(proves));
        assert_eq!(found.first.len(), 1);
        assert_eq!(found.exhaustive, proves);
    }
}

/// Where no set of facts is known, edits are guessed, and it is not said that these are all.
#[test]
fn without_a_known_set_edits_of_suspects_are_tried() {
    let instance = instance("a # A");
    let broken = Unsolved {
        instance: &instance,
        is_large: false,
        within: None,
        objective: instance.objective(),
        plan: None,
        asked: &[],
        arriving: None,
        charging: None,
        reach: crate::search::Proved::Within(4),
        cores: Vec::new(),
        suspects: vec![Group::Task(0), Group::Battery(0)],
        whole: WholePlan::default(),
    };
    let found = repairs(&broken, TriedEdits::default(), &mut Finds::plans(true));
    let edits: Vec<_> = found.first.iter().flat_map(|it| &it.edits).collect();
    assert_eq!(
        edits,
        [&Edit::LeaveOut {
            agent: "a".to_owned()
        }]
    );
    assert!(!found.exhaustive && found.further == 0);
}

/// Two agents, each of which drives along its row, `a` through an obstacle.
fn two_rows() -> (Instance, Plan) {
    let path = |y| (0..3).map(|x| Some(Cell::new(x, y))).collect::<Vec<_>>();
    let plan = Plan {
        paths: [("a".to_owned(), path(0)), ("b".to_owned(), path(1))].into(),
        ..Plan::default()
    };
    (instance("a # A\nb . B"), plan)
}

/// Where the plan that is found is not proved to be the best, and what is left of the plan that is
/// asked about costs less, it is that.
#[test]
fn what_is_left_of_the_plan_is_no_worse() {
    let (instance, plan) = two_rows();
    let dear = Costs {
        makespan: 9,
        ..Costs::default()
    };
    for (proves, accepts, makespan) in [(false, true, 2), (true, true, 9), (false, false, 9)] {
        let broken = Unsolved {
            instance: &instance,
            is_large: false,
            within: None,
            objective: instance.objective(),
            plan: Some(&plan),
            asked: &[],
            arriving: None,
            charging: None,
            reach: crate::search::Proved::Within(4),
            cores: Vec::new(),
            suspects: vec![Group::Task(0)],
            whole: WholePlan::default(),
        };
        let mut finds = Finds {
            costs: dear,
            accepts,
            ..Finds::plans(proves)
        };
        let found = repairs(&broken, TriedEdits::default(), &mut finds);
        assert_eq!(
            found.first[0].costs.makespan, makespan,
            "{proves} {accepts}"
        );
    }
}

/// Where an agent that skips a waypoint helps, leaving it out helps, at no more than the others cost then.
#[test]
fn who_helps_by_doing_less_helps_by_being_left_out() {
    let (instance, plan) = two_rows();
    let leave_out = Edit::LeaveOut {
        agent: "a".to_owned(),
    };
    for asked in [&[][..], &[0]] {
        let broken = Unsolved {
            instance: &instance,
            is_large: false,
            within: None,
            objective: instance.objective(),
            plan: None,
            asked,
            arriving: None,
            charging: None,
            reach: crate::search::Proved::Within(4),
            cores: vec![vec![Group::Waypoint(0, Cell::new(1, 0))]],
            suspects: Vec::new(),
            whole: WholePlan::default(),
        };
        let mut finds = Finds {
            plan: plan.clone(),
            accepts: true,
            ..Finds::plans(true)
        };
        let found = repairs(&broken, TriedEdits::default(), &mut finds);
        let found = found
            .first
            .iter()
            .find(|it| it.edits == [leave_out.clone()]);
        let costs = found.map(|repair| (repair.costs.makespan, repair.costs.sum_of_costs));
        // Who is asked about stays.
        assert_eq!(costs, asked.is_empty().then_some((2, 2)));
    }
}

/// Without its battery an agent cannot charge, so a battery that is too small is in no set of
/// facts: it is tried, and it is not said that these are all repairs.
#[test]
fn more_battery_helps_an_agent_that_is_to_charge() {
    let scene = r#"{ "giveway": 1, "map": ["....+"], "agents": [{ "name": "A1", "start": [0, 0],
        "goal": [1, 0], "battery": { "capacity": 4, "initial": 2 } }] }"#;
    let plan = r#"{ "giveway": 1, "paths": { "A1": [[0, 0], [1, 0]] } }"#;
    let (instance, plan) = read(scene, plan);
    let answer = explain(&instance, &plan, "no-charge A1 --at 4,0");
    assert_eq!(answer.verdict, Verdict::Necessary);
    let first = answer.repairs.iter().map(|repair| &repair.edits[..]);
    let gives = |edits: &[Edit]| matches!(edits, [Edit::Battery { initial: 4, .. }]);
    assert!(first.into_iter().any(gives), "{:?}", answer.repairs);
    assert!(!answer.exhaustive);
}
