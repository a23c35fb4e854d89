//! Random questions about random plans of random small instances: the same seed
//! and number give the same question for ever.

use giveway_model::question::fits;
use giveway_model::{Cell, Cost, Instance, Objective, Plan, Question};
use rand::seq::{IndexedRandom, SliceRandom};
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;

use crate::oracle::{self, Contrast, Verdict};
use crate::random;

/// Kinds of questions that have a contrast.
const KINDS: usize = 18;
/// How often a question is drawn before the plan is given up.
const DRAWS: usize = 60;

/// A question that fits a valid plan.
#[derive(Clone, Debug)]
pub struct Case {
    /// The instance, with the objective in which costs compare.
    pub instance: Instance,
    /// The plan, which need not be optimal.
    pub plan: Plan,
    /// The question.
    pub question: Question,
}

/// The case of a number; `None` where the instance has no plan, or is too large
/// for the oracle, whose plans these are.
pub fn random(seed: u64, number: u64) -> Option<Case> {
    of(random::small(seed, number), seed, number)
}

/// The case of a number about an instance.
pub fn of(instance: Instance, seed: u64, number: u64) -> Option<Case> {
    let mut random = ChaCha8Rng::seed_from_u64(seed ^ 0x51);
    random.set_stream(number);
    let plan = plan(&instance, &mut random)?;
    let question = question(&instance, &plan, &mut random)?;
    let (instance, plan) = if random.random_bool(0.4) {
        // A plan that is worse: the best with what some question asks for.
        let contrast = Contrast {
            question: &question,
            plan: &plan,
        };
        let worse = best(&instance, Some(contrast)).unwrap_or(plan);
        (instance, worse)
    } else {
        (instance, plan)
    };
    let question = self::question(&instance, &plan, &mut random)?;
    Some(Case {
        instance,
        plan,
        question,
    })
}

/// A random question that fits a valid plan of any instance.
pub fn about(instance: &Instance, plan: &Plan, seed: u64, number: u64) -> Option<Question> {
    let mut random = ChaCha8Rng::seed_from_u64(seed ^ 0x51);
    random.set_stream(number);
    question(instance, plan, &mut random)
}

/// The best plan in the objective of the instance, or in another one.
fn plan(instance: &Instance, random: &mut ChaCha8Rng) -> Option<Plan> {
    if random.random_bool(0.6) {
        return best(instance, None);
    }
    let mut costs = Cost::USUAL.to_vec();
    costs.shuffle(random);
    let other = Objective::new(costs).unwrap();
    best(&instance.clone().with_objective(other), None)
}

fn best(instance: &Instance, contrast: Option<Contrast>) -> Option<Plan> {
    let asked = oracle::Question {
        instance,
        within: None,
        cap: 100_000,
    };
    let verdict = match contrast {
        Some(contrast) => asked.best_with(contrast),
        None => asked.best(),
    };
    match verdict {
        Verdict::Best(point) => Some(point.plan),
        Verdict::Impossible | Verdict::Capped => None,
    }
}

/// A question that fits a plan, of a kind drawn first: rare ones come as often
/// as any.
fn question(instance: &Instance, plan: &Plan, random: &mut ChaCha8Rng) -> Option<Question> {
    for _ in 0..DRAWS {
        let kind = random.random_range(0..KINDS);
        for _ in 0..DRAWS {
            let drawn = Draw {
                instance,
                plan,
                random,
            }
            .question(kind);
            if let Some(question) = drawn
                && fits(&question, instance, plan).is_ok()
            {
                assert!(draws(kind, &question), "{kind}: {question:?}");
                return Some(question);
            }
        }
    }
    None
}

/// Whether a number draws questions of this kind: a new kind needs a number of its own, in
/// [`Draw::question`], too.
fn draws(kind: usize, question: &Question) -> bool {
    match question {
        Question::Wait { .. } => kind <= 1,
        Question::Charge { .. } => kind == 2,
        Question::NoCharge { .. } => kind == 3,
        Question::Visit { .. } => kind == 4,
        Question::NoVisit { .. } => kind == 5,
        Question::Move { .. } => kind == 6,
        Question::NoMove { .. } => kind == 7,
        Question::Slow { .. } => kind == 8,
        Question::Order { .. } => kind == 9,
        Question::Arrival { .. } => kind == 10,
        Question::Length { .. } => kind == 11,
        Question::Makespan => kind == 12,
        Question::SumOfCosts => kind == 13,
        Question::Charges { .. } => kind == 14,
        Question::Moves { .. } => kind == 15,
        Question::Waits { .. } => kind == 16,
        Question::Yield { .. } => kind == 17,
        // They have no contrast, or one that the oracle of rules knows.
        Question::Penalty | Question::Rule { .. } | Question::Unsolvable | Question::Plan => false,
    }
}

/// The parts of a question, drawn.
struct Draw<'a> {
    instance: &'a Instance,
    plan: &'a Plan,
    random: &'a mut ChaCha8Rng,
}

impl Draw<'_> {
    fn agent(&mut self) -> Option<String> {
        let agent = self.instance.agents().choose(self.random)?;
        Some(agent.name.clone())
    }

    /// A cell, mostly of the agent's path, and its time there.
    fn stop(&mut self, agent: &str) -> Option<(Cell, u32)> {
        let path = self.plan.path(agent);
        let time = self.random.random_range(0..path.len());
        if let Some(cell) = path[time]
            && self.random.random_bool(0.7)
        {
            return Some((cell, time as u32));
        }
        let grid = self.instance.grid();
        let cells: Vec<Cell> = grid.cells().map(|(cell, _)| cell).collect();
        Some((*cells.choose(self.random)?, time as u32))
    }

    fn maybe<T>(&mut self, value: T) -> Option<T> {
        self.random.random_bool(0.5).then_some(value)
    }

    fn question(&mut self, kind: usize) -> Option<Question> {
        let agent = self.agent()?;
        let (cell, time) = self.stop(&agent)?;
        let (other, _) = self.stop(&agent)?;
        let [little, some, steps, many] = [2, 3, 3, 8].map(|n| self.random.random_range(0..n));
        let next = self.plan.path(&agent)[time as usize..]
            .iter()
            .flatten()
            .find(|&&next| next != cell)
            .copied()
            .filter(|_| self.random.random_bool(0.6))
            .unwrap_or(other);
        Some(match kind {
            0 | 1 => Question::Wait {
                at: self.maybe(cell),
                from: self.maybe(time.saturating_sub(little)),
                to: self.maybe(time + 1 + some),
                at_least: self.maybe(1 + steps),
                agent,
            },
            2 => Question::Charge {
                at: self.maybe(cell),
                time: self.maybe(time),
                agent,
            },
            3 => Question::NoCharge { agent, at: cell },
            4 => Question::Visit {
                agent,
                at: cell,
                time: self.maybe(time + little),
            },
            5 => Question::NoVisit {
                agent: self.maybe(agent),
                at: cell,
            },
            6 => Question::Move {
                agent,
                from_cell: cell,
                to_cell: next,
                time: self.maybe(time),
            },
            7 => Question::NoMove {
                agent,
                from_cell: cell,
                to_cell: next,
                time: self.maybe(time),
            },
            8 => {
                let edge = self.maybe((cell, next));
                Question::Slow {
                    agent,
                    from_cell: edge.map(|edge| edge.0),
                    to_cell: edge.map(|edge| edge.1),
                }
            }
            9 => Question::Order {
                agent,
                first: cell,
                second: other,
            },
            10 => Question::Arrival { agent },
            11 => Question::Length {
                agent,
                fewer_than: self.maybe(many),
            },
            12 => Question::Makespan,
            13 => Question::SumOfCosts,
            14 => Question::Charges {
                agent: self.maybe(agent),
            },
            15 => Question::Moves {
                agent: self.maybe(agent),
            },
            16 => Question::Waits {
                agent: self.maybe(agent),
            },
            17 => Question::Yield {
                agent,
                to: self.agent()?,
                at: cell,
            },
            _ => unreachable!("there are {KINDS} kinds"),
        })
    }
}
