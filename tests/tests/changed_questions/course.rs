//! A plan around which the world changes once, at random.

use giveway_model::change::{Change, Changes, What};
use giveway_model::check::{check, check_changes};
use giveway_model::{Costs, Instance, Objective, Plan, Question, Scene, Version};
use giveway_solve::change::{ChangeRequest, Method};
use giveway_solve::explain::{ExplainAnswer, ExplainRequest};
use giveway_solve::{Limits, Refusal, Request, Response, SilentHost, SolveRequest, serve};
use giveway_tests::loiter::loiter;
use giveway_tests::oracle::{self, Leniency};
use giveway_tests::{random, upheaval};

fn limits() -> Limits {
    Limits {
        conflicts: Some(20_000),
        ..Limits::default()
    }
}

/// A plan before the changes, the changes of one time, and a plan with them;
/// `None` for the last where there is no way to go on.
pub(super) struct Course {
    pub(super) instance: Instance,
    pub(super) before: Plan,
    pub(super) changes: Changes,
    pub(super) at: u32,
    pub(super) after: Option<Plan>,
}

/// The course of a number; `None` where its changes contradict the world.
pub(super) fn course(seed: u64, number: u64) -> Option<Course> {
    let instance = random::small(seed, number);
    if !(1..=2).contains(&instance.agents().len()) {
        return None;
    }
    let request = Request::Solve(SolveRequest {
        scene: instance.to_scene(),
        limits: limits(),
        ..SolveRequest::default()
    });
    let Response::Solved(solved) = serve(&request, &SilentHost) else {
        panic!("{number}");
    };
    let mut before = solved.plan?;
    if number % 5 == 4 {
        before = loiter(&instance, &before, seed, number);
    }
    let longest = before.paths.values().map(Vec::len).max().unwrap_or(1);
    // In two of four something breaks down.
    let changing = if number % 4 < 2 {
        upheaval::changes
    } else {
        upheaval::breakdowns
    };
    let changes = Changes {
        giveway: Version,
        changes: changing(&instance, longest as u32 - 1, seed, number),
    };
    // Another order of costs makes a plan that is not the best.
    let objective: Objective = ["makespan,sum-of-costs", "makespan,moves", "makespan,waits"]
        [number as usize % 3]
        .parse()
        .unwrap();
    let request = Request::Change(ChangeRequest {
        scene: instance.to_scene(),
        plan: before.clone(),
        changes: changes.clone(),
        since: None,
        methods: vec![Method::Revise, Method::Replan],
        objective: Some(objective),
        within: None,
        limits: limits(),
    });
    let answer = match serve(&request, &SilentHost) {
        Response::Changed(answer) => *answer,
        Response::Refused(Refusal::Changes { .. }) => return None,
        other => panic!("{other:?}"),
    };
    Some(Course {
        at: answer.at?,
        after: answer.adopted().and_then(|it| it.result.plan.clone()),
        instance,
        before,
        changes,
    })
}

impl Course {
    pub(super) fn ask(&self, plan: &Plan, question: &Question) -> Result<ExplainAnswer, Refusal> {
        let request = Request::Explain(ExplainRequest {
            scene: self.instance.to_scene(),
            plan: Some(plan.clone()),
            changes: Some(self.changes.clone()),
            at: None,
            question: question.clone(),
            objective: None,
            within: None,
            proved: None,
            known: None,
            layers: Vec::new(),
            limits: limits(),
        });
        match serve(&request, &SilentHost) {
            Response::Explained(answer) => Ok(*answer),
            Response::Refused(refusal) => Err(refusal),
            other => panic!("{other:?}"),
        }
    }

    pub(super) fn told(&self) -> String {
        let json = |value: &dyn Fn() -> serde_json::Result<String>| value().unwrap();
        format!(
            "{}\n{}\n{}\n{:?}",
            json(&|| serde_json::to_string(&self.instance.to_scene())),
            json(&|| serde_json::to_string(&self.changes)),
            json(&|| serde_json::to_string(&self.before)),
            self.after
        )
    }

    pub(super) fn costs(&self, plan: &Plan) -> Costs {
        let report = check_changes(&self.instance, &self.changes, plan).unwrap();
        assert_eq!(report.violations, [], "{}", self.told());
        report.costs.unwrap()
    }

    /// The plan with one more wait of all agents on their way at the time of the
    /// change; `None` where that is no plan.
    pub(super) fn delayed(&self, plan: &Plan) -> Option<Plan> {
        let mut plan = plan.clone();
        for (name, path) in &mut plan.paths {
            let now = self
                .at
                .checked_sub(plan.from.get(name).copied().unwrap_or(0))?
                as usize;
            if path.len() > now + 1 {
                let here = path[now]?;
                path.insert(now, Some(here));
                if let Some(charges) = plan.charges.get_mut(name) {
                    let later = charges.iter_mut().filter(|time| **time >= self.at);
                    later.for_each(|time| *time += 1);
                }
            }
        }
        let report = check_changes(&self.instance, &self.changes, &plan).ok()?;
        report.is_valid().then_some(plan)
    }

    /// What every answer must keep to.
    pub(super) fn check(&self, plan: &Plan, answer: &ExplainAnswer) {
        let before = self.costs(plan);
        let since = answer.since.unwrap();
        assert!(since >= self.at, "{}", self.told());
        let Some(other) = &answer.alternative else {
            return;
        };
        let costs = self.costs(other);
        assert_eq!(answer.costs, Some(costs), "{}", self.told());
        for (&cost, &delta) in &answer.deltas {
            let more = i64::from(costs.get(cost)) - i64::from(before.get(cost));
            assert_eq!(delta, more, "{cost:?} {}", self.told());
        }
        // What is past is as it was.
        for (name, path) in &plan.paths {
            let from = plan.from.get(name).copied().unwrap_or(0);
            let at = |path: &[Option<giveway_model::Cell>], time: u32| {
                let index = time.checked_sub(from)? as usize;
                path.get(index).or(path.last()).copied().flatten()
            };
            for time in from..since {
                assert_eq!(
                    at(path, time),
                    at(other.path(name), time),
                    "{}",
                    self.told()
                );
            }
        }
    }

    /// The rest as an instance of its own, with who is broken down for how long, and who
    /// is half way along a slow move; `None` where there is an agent that was there before
    /// and has arrived.
    pub(super) fn rest(&self, plan: &Plan) -> Option<(Instance, Plan, Leniency)> {
        let at = self.at as usize;
        let scene = self.instance.to_scene();
        let mut agents = scene.agents.clone();
        let mut with = Leniency::default();
        for change in &self.changes.changes {
            match &change.what {
                What::AddAgent { agent } => agents.push(agent.clone()),
                What::RemoveAgent { agent } | What::StopAgent { agent } => {
                    agents.retain(|other| other.name != *agent);
                }
                What::SetGoal { agent, cell } => {
                    agents.iter_mut().find(|a| a.name == *agent)?.goal = Some(*cell);
                }
                What::DelayAgent { agent, steps } if *steps > 0 => {
                    let held = with.held.entry(agent.clone()).or_default();
                    *held = (*held).max(*steps);
                }
                What::AddWaypoint { .. } | What::SetBattery { .. } => return None,
                _ => {}
            }
        }
        let mut rest = Plan::default();
        // Who is in transit begins the same, and is broken down from the end of its move.
        for agent in &mut agents {
            let name = agent.name.clone();
            if plan.from.contains_key(&name) {
                rest.paths.insert(name.clone(), plan.path(&name).to_vec());
                let charges = plan.charges(&name).iter();
                let charges: Vec<u32> = charges.map(|time| time - self.at).collect();
                rest.charges.insert(name, charges);
                continue;
            }
            let path = plan.path(&name);
            // Whoever had arrived has slept, and used no battery.
            if path.len() <= at + 1 || self.before.path(&name).len() <= at {
                return None;
            }
            agent.start = path[at].or(path[at + 1])?;
            if path[at].is_none() {
                with.transit.insert(name.clone(), path[at - 1]?);
                if let Some(held) = with.held.get_mut(&name) {
                    *held += 1;
                }
            }
            if Some(agent.start) == agent.goal && at > 0 {
                return None;
            }
            agent
                .waypoints
                .retain(|cell| !path[..=at].contains(&Some(*cell)));
            if let Some(battery) = &mut agent.battery {
                for time in 0..self.at {
                    battery.initial = if plan.charges(&name).contains(&time) {
                        battery.capacity
                    } else {
                        battery.initial - 1
                    };
                }
            }
            rest.paths.insert(name.clone(), path[at..].to_vec());
            let charges = plan.charges(&name).iter();
            let charges: Vec<u32> = charges
                .filter_map(|time| time.checked_sub(self.at))
                .collect();
            if !charges.is_empty() {
                rest.charges.insert(name, charges);
            }
        }
        rest.charges.retain(|_, charges| !charges.is_empty());
        let changed: Vec<Change> = self.changes.changes.clone();
        let scene = Scene {
            map: oracle::standing(
                &oracle::map_after(&scene.map, &changed),
                &self.before,
                &changed,
            ),
            agents,
            ..scene
        };
        let mut instance = Instance::new(scene).ok()?;
        for (name, cell) in &with.transit {
            instance.start_state_mut(name).transit_from = Some(*cell);
        }
        check(&instance, &rest)
            .is_valid()
            .then_some((instance, rest, with))
    }
}

impl Course {
    /// How many steps of a long wait that is asked about lie before the change.
    pub(super) fn waited(&self, plan: &Plan, question: &Question) -> u32 {
        let Question::Wait {
            agent,
            at,
            from: None,
            at_least: Some(2..),
            ..
        } = question
        else {
            return 0;
        };
        let path = plan.path(agent);
        let now = self.at as usize;
        let Some(Some(here)) = path.get(now).filter(|_| !plan.from.contains_key(agent)) else {
            return 0;
        };
        let steps = path[..now].iter().rev();
        let steps = steps.take_while(|&&entry| entry == Some(*here)).count();
        if at.is_none_or(|at| at == *here) {
            steps as u32
        } else {
            0
        }
    }
}
