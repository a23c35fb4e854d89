//! Questions about a plan around which the world has changed, against joint
//! states, exhausted: from the change on for the best way to go on, and over the
//! rest as an instance of its own for what a question contrasts it with.
//!
//! `GIVEWAY_RANDOM_CHANGES` sets how many (60 by default), `GIVEWAY_RANDOM_SEED`
//! the seed.
#![allow(
    clippy::unwrap_used,
    clippy::print_stdout,
    clippy::panic,
    reason = "a test that cannot go on ends with a panic"
)]

use std::collections::BTreeMap;

use giveway_model::change::{Change, Changes, What};
use giveway_model::check::{check, check_changes};
use giveway_model::{Cost, Costs, Instance, Objective, Plan, Question, Scene, Version};
use giveway_solve::change::{ChangeRequest, Method};
use giveway_solve::explain::{ExplainAnswer, ExplainRequest, Fact, FactKind, Verdict};
use giveway_solve::{Limits, Refusal, Request, Response, SilentHost, SolveRequest, serve};
use giveway_tests::oracle::{self, Changed, Contrast, Held, Known, Leniency};
use giveway_tests::{environment, facts, questions, random, upheaval};

/// Joint states that the oracle may look at.
const CAP: usize = 30_000;

fn limits() -> Limits {
    Limits {
        conflicts: Some(20_000),
        ..Limits::default()
    }
}

/// A plan before the changes, the changes of one time, and a plan with them;
/// `None` for the last where there is no way to go on.
struct Course {
    instance: Instance,
    before: Plan,
    changes: Changes,
    at: u32,
    after: Option<Plan>,
}

/// The course of a number; `None` where its changes contradict the world.
fn course(seed: u64, number: u64) -> Option<Course> {
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
    let before = solved.plan?;
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
    fn ask(&self, plan: &Plan, question: &Question) -> Result<ExplainAnswer, Refusal> {
        let request = Request::Explain(ExplainRequest {
            scene: self.instance.to_scene(),
            plan: Some(plan.clone()),
            changes: Some(self.changes.clone()),
            at: None,
            question: question.clone(),
            objective: None,
            within: None,
            limits: limits(),
        });
        match serve(&request, &SilentHost) {
            Response::Explained(answer) => Ok(*answer),
            Response::Refused(refusal) => Err(refusal),
            other => panic!("{other:?}"),
        }
    }

    fn told(&self) -> String {
        let json = |value: &dyn Fn() -> serde_json::Result<String>| value().unwrap();
        format!(
            "{}\n{}\n{}\n{:?}",
            json(&|| serde_json::to_string(&self.instance.to_scene())),
            json(&|| serde_json::to_string(&self.changes)),
            json(&|| serde_json::to_string(&self.before)),
            self.after
        )
    }

    fn costs(&self, plan: &Plan) -> Costs {
        let report = check_changes(&self.instance, &self.changes, plan).unwrap();
        assert_eq!(report.violations, [], "{}", self.told());
        report.costs.unwrap()
    }

    /// The plan with one more wait of all agents on their way at the time of the
    /// change; `None` where that is no plan.
    fn delayed(&self, plan: &Plan) -> Option<Plan> {
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
    fn check(&self, plan: &Plan, answer: &ExplainAnswer) {
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

    /// The rest as an instance of its own, and who is broken down for how long;
    /// `None` where there is an agent that no instance can have, or one that was
    /// there before and has arrived.
    fn rest(&self, plan: &Plan) -> Option<(Instance, Plan, Leniency)> {
        let at = self.at as usize;
        let scene = self.instance.to_scene();
        let mut agents = scene.agents.clone();
        let mut with = Leniency::default();
        for change in &self.changes.changes {
            match &change.what {
                What::AddAgent { agent } => agents.push(agent.clone()),
                What::RemoveAgent { agent } => agents.retain(|other| other.name != *agent),
                What::SetGoal { agent, cell } => {
                    agents.iter_mut().find(|a| a.name == *agent)?.goal = *cell;
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
            agent.start = path[at]?;
            if agent.start == agent.goal && at > 0 {
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
            map: oracle::map_after(&scene.map, &changed),
            agents,
            ..scene
        };
        let instance = Instance::new(scene).ok()?;
        check(&instance, &rest)
            .is_valid()
            .then_some((instance, rest, with))
    }
}

fn limit() -> (u64, u64) {
    let seed = environment::number("GIVEWAY_RANDOM_SEED", 1);
    (seed, environment::number("GIVEWAY_RANDOM_CHANGES", 60))
}

/// Whether a plan is the best, or how much better one is; that there is none.
#[test]
fn the_best_way_to_go_on() {
    let (seed, count) = limit();
    let mut seen: BTreeMap<String, u64> = BTreeMap::new();
    let mut compared = 0;
    for number in 0.. {
        if compared >= count {
            break;
        }
        assert!(number < 100 * count, "too few of them can be compared");
        let Some(course) = course(seed, number) else {
            continue;
        };
        let list = &course.changes.changes;
        let costs = course.instance.objective().costs();
        let world = Changed::new(&course.instance, costs, &course.before, course.at, list);
        let Some(mut world) = world else { continue };
        let known = world.best(Held::Nothing, &[], CAP);
        if known == Known::Capped {
            continue;
        }
        let Some(plan) = &course.after else {
            let refused = match (course.ask(&course.before, &Question::Unsolvable), &known) {
                (Ok(answer), Known::None) => {
                    assert_eq!(answer.verdict, Verdict::Necessary, "{}", course.told());
                    assert_eq!(answer.since, Some(course.at));
                    for repair in &answer.repairs {
                        assert!(!repair.plan.paths.is_empty());
                    }
                    "none"
                }
                (Ok(answer), _) => panic!("{answer:?} {}", course.told()),
                (Err(_), _) => "none, refused",
            };
            *seen.entry(refused.to_owned()).or_default() += 1;
            compared += 1;
            continue;
        };
        // Every other plan is worse than it need be.
        let worse = course.delayed(plan).filter(|_| number % 2 == 1);
        let plan = worse.as_ref().unwrap_or(plan);
        let asked = course.ask(plan, &Question::Plan);
        let answer = match asked {
            Ok(answer) => answer,
            Err(refusal) => {
                let sentence = refusal.sentences().join(" ");
                let kind: String = sentence.chars().filter(|c| !c.is_ascii_digit()).collect();
                *seen.entry(kind).or_default() += 1;
                continue;
            }
        };
        compared += 1;
        course.check(plan, &answer);
        let Known::Best(best) = known else {
            panic!("{known:?} {}", course.told());
        };
        let own = course.costs(plan).vector(course.instance.objective());
        let best = &best[..costs.len()];
        if answer.since == Some(course.at) {
            let found = answer.costs.unwrap().vector(course.instance.objective());
            assert_eq!(found, best, "{} {answer:?}", course.told());
            assert_eq!(answer.optimal, Some(own == best), "{}", course.told());
            *seen.entry(format!("optimal {}", own == best)).or_default() += 1;
            let rests = |path: &Vec<_>| path.len() <= course.at as usize;
            let rested = course.instance.stays() && plan.paths.values().any(rests);
            *seen.entry("with one at rest".to_owned()).or_default() += u64::from(rested);
        } else if answer.optimal == Some(false) {
            let found = answer.costs.unwrap().vector(course.instance.objective());
            assert!(*best <= *found && found < own, "{}", course.told());
            *seen.entry("later".to_owned()).or_default() += 1;
        }
    }
    println!("{seen:?}");
    let at_least = |kind: &str, few: u64| {
        let found = seen.get(kind).copied().unwrap_or(0);
        assert!(found * 60 >= few * count, "{kind}: {found} of {count}");
    };
    at_least("optimal true", 10);
    at_least("optimal false", 5);
    at_least("with one at rest", 5);
    at_least("none", 1);
}

/// Questions about one agent and its way, against the rest by itself.
#[test]
fn what_a_question_contrasts_the_rest_with() {
    let (seed, count) = limit();
    let mut compared = 0;
    let mut kinds: BTreeMap<&str, u64> = BTreeMap::new();
    let mut verdicts: BTreeMap<Verdict, u64> = BTreeMap::new();
    let mut broken_down: BTreeMap<&str, u64> = BTreeMap::new();
    for number in 0.. {
        if compared >= count {
            break;
        }
        assert!(number < 400 * count, "too few of them can be compared");
        let Some(course) = course(seed ^ 0xc0, number) else {
            continue;
        };
        let Some(plan) = &course.after else { continue };
        let Some((instance, rest, with)) = course.rest(plan) else {
            continue;
        };
        let Some(relative) = questions::about(&instance, &rest, seed, number) else {
            continue;
        };
        let question = later(&relative, course.at);
        let contrast = Contrast {
            question: &relative,
            plan: &rest,
        };
        let answer = match course.ask(plan, &question) {
            Ok(answer) => answer,
            Err(refusal) => panic!("{refusal:?} {question:?} {}", course.told()),
        };
        course.check(plan, &answer);
        assert_eq!(answer.since, Some(course.at));
        assert_eq!(answer.question, question);
        let asked = oracle::Question {
            instance: &instance,
            within: answer.within.map(|within| within - course.at),
            cap: CAP,
        };
        let objective = instance.objective();
        let costs = giveway_model::check::costs(&instance, &rest).unwrap();
        let before = costs.vector(objective);
        let (expected, deltas) = match asked.best_with_less(contrast, &with) {
            oracle::Verdict::Capped => continue,
            oracle::Verdict::Impossible => (Verdict::Necessary, BTreeMap::new()),
            oracle::Verdict::Best(point) => {
                let verdict = match point.vector.cmp(&before) {
                    std::cmp::Ordering::Less => Verdict::Improvable,
                    std::cmp::Ordering::Equal => Verdict::Needless,
                    std::cmp::Ordering::Greater => Verdict::Costly,
                };
                let values = point.vector.iter().zip(&before);
                let more = values.map(|(&a, &b)| i64::from(a) - i64::from(b));
                let costs = objective.costs().iter().copied();
                (verdict, costs.zip(more).collect::<BTreeMap<Cost, i64>>())
            }
        };
        let about = || format!("{question:?} {answer:?} {}", course.told());
        assert_eq!(answer.verdict, expected, "{}", about());
        assert_eq!(answer.deltas, deltas, "{}", about());
        let most = (expected == Verdict::Costly).then_some(&before);
        let claim = Claim {
            course: &course,
            instance: &instance,
            contrast,
            with: &with,
            most,
        };
        claim.check(&answer, &mut broken_down);
        if !with.held.is_empty() {
            let asked = question
                .agent()
                .is_some_and(|it| with.held.contains_key(it));
            let key = if asked {
                "its own breakdown"
            } else {
                "a breakdown"
            };
            *broken_down.entry(key).or_default() += 1;
        }
        compared += 1;
        *kinds.entry(question.kind()).or_default() += 1;
        *verdicts.entry(answer.verdict).or_default() += 1;
    }
    println!("{kinds:?} {verdicts:?} {broken_down:?}");
    assert!(
        kinds.len() >= 8 && verdicts.len() >= 3,
        "{kinds:?} {verdicts:?}"
    );
    let seen = |key: &str| broken_down.get(key).copied().unwrap_or(0);
    for key in ["a breakdown", "its own breakdown", "a breakdown as a fact"] {
        assert!(seen(key) * 60 >= 2 * count, "{key}: {broken_down:?}");
    }
}

/// What a set of facts claims of the rest.
struct Claim<'a> {
    course: &'a Course,
    instance: &'a Instance,
    contrast: Contrast<'a>,
    /// Who is broken down.
    with: &'a Leniency,
    /// The most that a plan may cost, where only dearer ones exist.
    most: Option<&'a Vec<u32>>,
}

impl Claim<'_> {
    /// Whether there is a plan as asked for with only these facts; `None` where
    /// the oracle cannot tell.
    fn has_plan(&self, facts: &[Fact], within: Option<u32>) -> Option<bool> {
        let question = self.contrast.question;
        let (scene, mut leniency) = facts::only(self.instance, question, facts);
        if scene.agents.is_empty() {
            return None;
        }
        let breakdowns = facts.iter().filter(|it| it.kind == FactKind::Breakdown);
        for name in breakdowns.flat_map(|fact| &fact.agents) {
            let held = self.with.held.get(name).copied();
            assert!(held.is_some(), "{name} {}", self.course.told());
            leniency.held.extend(held.map(|held| (name.clone(), held)));
        }
        let asked = oracle::Question {
            instance: &Instance::new(scene).ok()?,
            within,
            cap: CAP,
        };
        match asked.best_with_less(self.contrast, &leniency) {
            oracle::Verdict::Capped => None,
            oracle::Verdict::Impossible => Some(false),
            oracle::Verdict::Best(point) => {
                Some(self.most.is_none_or(|most| point.vector <= *most))
            }
        }
    }

    /// The facts rule a plan out, and where they are minimal, without any one of
    /// them there is one.
    fn check(&self, answer: &ExplainAnswer, seen: &mut BTreeMap<&'static str, u64>) {
        let Some(core) = answer.core.as_ref().filter(|_| !self.with.held.is_empty()) else {
            return;
        };
        let about = || format!("{answer:?} {}", self.course.told());
        let within = core.within.map(|within| within - self.course.at);
        let all = self.has_plan(&core.facts, within);
        assert_ne!(all, Some(true), "{}", about());
        let needed = core.facts.iter().filter(|_| core.minimal && all.is_some());
        for fact in needed {
            let others: Vec<Fact> = core
                .facts
                .iter()
                .filter(|it| *it != fact)
                .cloned()
                .collect();
            assert_ne!(
                self.has_plan(&others, None),
                Some(false),
                "{} {}",
                fact.text,
                about()
            );
            if fact.kind == FactKind::Breakdown {
                assert_eq!(fact.time, Some(self.course.at), "{}", about());
                *seen.entry("a breakdown as a fact").or_default() += 1;
            }
        }
    }
}

/// A question with all times later.
fn later(question: &Question, by: u32) -> Question {
    let mut question = question.clone();
    match &mut question {
        Question::Wait { from, to, .. } => {
            for time in [from, to].into_iter().flatten() {
                *time += by;
            }
        }
        Question::Charge { time, .. }
        | Question::Visit { time, .. }
        | Question::Move { time, .. }
        | Question::NoMove { time, .. } => {
            if let Some(time) = time {
                *time += by;
            }
        }
        _ => {}
    }
    question
}
