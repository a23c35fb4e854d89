//! A request for delays, from the scene to the answer.

use std::cmp::Reverse;
use std::rc::Rc;

use giveway_model::{
    Costs, Instance, Plan, Version,
    check::{check, check_history},
    sorting::sort_by_key,
};

use super::{
    DelaysAnswer, DelaysRequest,
    heat::heat,
    ledger::ledger,
    places::places,
    proof::{Proving, prove},
    running::{RunningPlan, part},
    words,
};
use crate::{
    Host, Progress, Reason, Refusal, SolveAnswer, Status, Stop,
    budget::Budget,
    explain::{
        changed::{ChangedWorld, counting},
        engine::solved,
    },
    problem::{Problem, ProblemError},
    walk::Walk,
};

/// Serves a request for delays; tells the host of the ledger before the proof.
///
/// # Errors
/// When the scene, the plan or the changes are wrong, or there is no plan.
pub(crate) fn serve(request: &DelaysRequest, host: &dyn Host) -> Result<DelaysAnswer, Refusal> {
    let scene = request.scene.clone();
    let mut instance = Instance::new(scene).map_err(|faults| Refusal::Scene { faults })?;
    if let Some(objective) = &request.objective {
        instance = instance.with_objective(objective.clone());
    }
    let in_force = instance.in_force(instance.objective().clone());
    let instance = instance.with_objective(in_force);
    let budget = Rc::new(Budget::new(host, request.limits));
    let serving = Serving {
        request,
        budget: &budget,
        host,
    };
    let Some(changes) = counting(request.changes.as_ref(), request.at) else {
        return serving.without_changes(&instance);
    };
    let world = ChangedWorld::new(&instance, &changes, request.plan.as_ref())?;
    let report = check_history(&world.after, &world.plan);
    if !report.is_valid() {
        let violations = report.violations;
        return Err(Refusal::Plan { violations });
    }
    let snapshot = world.snapshot(&instance);
    let in_force = snapshot.instance.in_force(instance.objective().clone());
    let rest = snapshot.instance.clone().with_objective(in_force);
    let plan = trimmed(&rest, snapshot.rest());
    let running = RunningPlan {
        instance: &rest,
        plan: &plan,
        snapshot: Some(&snapshot),
    };
    Ok(serving.answered(&running, None))
}

/// A plan that ends for each agent at its arrival.
fn trimmed(instance: &Instance, mut plan: Plan) -> Plan {
    plan.cut_trailing_goals(instance);
    plan
}

/// A request that is served.
struct Serving<'a, 'h> {
    request: &'a DelaysRequest,
    budget: &'a Rc<Budget<'h>>,
    host: &'h dyn Host,
}

impl Serving<'_, '_> {
    /// The answer in one world.
    fn without_changes(&self, instance: &Instance) -> Result<DelaysAnswer, Refusal> {
        let running = |plan| RunningPlan {
            instance,
            plan,
            snapshot: None,
        };
        if let Some(plan) = &self.request.plan {
            let violations = check(instance, plan).violations;
            if !violations.is_empty() {
                return Err(Refusal::Plan { violations });
            }
            let plan = trimmed(instance, plan.clone());
            return Ok(self.answered(&running(&plan), None));
        }
        let solved = solved(instance, self.request.within, self.budget)?;
        let known = solved.answer;
        let Some(plan) = known.plan.clone() else {
            let mut answer = empty(instance);
            answer.reason.clone_from(&known.reason);
            return Ok(self.finished(answer));
        };
        let mut answer = self.answered(&running(&plan), Some(&known));
        answer.plan = Some(plan);
        Ok(answer)
    }

    /// The answer about a plan; `known` is what its search proved, where it was found here.
    fn answered(&self, running: &RunningPlan, known: Option<&SolveAnswer>) -> DelaysAnswer {
        let mut answer = empty(running.instance);
        answer.since = running.snapshot.map(|snapshot| snapshot.at);
        let Some(costs) = running.costs() else {
            answer.reason = Some(Stop::Contradiction.into());
            return self.finished(answer);
        };
        answer.costs = Some(running.whole_costs(costs));
        let (problem, walks) = match self.enter(running, &mut answer) {
            Ok(entered) => entered,
            Err(reason) => {
                answer.reason = Some(reason);
                return self.finished(answer);
            }
        };
        if self.request.ledger_only || answer.delay == 0 {
            return self.finished(answer);
        }
        if let Some(known) = known {
            answer.prove_by(known);
            if known.status == Status::Optimal && answer.proof.is_some() {
                return self.finished(answer);
            }
        }
        let told = DelaysAnswer {
            proof: None,
            pending: true,
            ..answer.clone()
        };
        let told = Box::new(self.finished(told));
        self.host.progress(&Progress::Delays { answer: told });
        if answer.proof.is_none() {
            let proving = Proving {
                running,
                problem: &problem,
                walks: &walks,
                costs,
                within: self.request.within,
            };
            let own = part(self.budget);
            answer.proof = Some(prove(&proving, &own));
            self.budget.absorb(&own);
        }
        self.finished(answer)
    }

    /// Enters the ledger into the answer.
    fn enter(
        &self,
        running: &RunningPlan,
        answer: &mut DelaysAnswer,
    ) -> Result<(Problem, Vec<Walk>), Reason> {
        let (problem, walks) = posed(running, self.budget)?;
        let ledger = ledger(running, &problem, &walks, self.budget)?;
        let mut rows = ledger.rows;
        answer.delay = rows
            .iter()
            .map(|row| row.delay)
            .fold(0, u32::saturating_add);
        let sum = answer.costs.map_or(0, |costs: Costs| costs.sum_of_costs);
        answer.alone = sum.saturating_sub(answer.delay);
        answer.lost = heat(&rows);
        answer.places = places(&answer.lost, &rows);
        sort_by_key(&mut rows, |row| Reverse(row.delay));
        answer.agents = rows;
        answer.because = ledger.totals;
        answer.calm = ledger.calm.map(|calm| match running.snapshot {
            Some(snapshot) => snapshot.whole(&calm),
            None => calm,
        });
        Ok((problem, walks))
    }

    /// The answer with its words and the work so far.
    fn finished(&self, mut answer: DelaysAnswer) -> DelaysAnswer {
        answer.words = words::all(&answer);
        answer.stats = self.budget.stats();
        answer
    }
}

/// The problem of a plan, and its walks.
fn posed(running: &RunningPlan, budget: &Budget) -> Result<(Problem, Vec<Walk>), Reason> {
    let problem = match Problem::new(running.instance, budget) {
        Ok(problem) => problem,
        Err(ProblemError::TooManyWaypoints(agent)) => {
            let agent = running.names().get(agent).cloned().unwrap_or_default();
            return Err(Reason::ManyWaypoints { agent });
        }
        // There is a plan.
        Err(ProblemError::Alone(..)) => return Err(Stop::Contradiction.into()),
        Err(ProblemError::Stopped(stop)) => return Err(stop.into()),
    };
    let walks = running.walks(&problem).ok_or(Stop::Contradiction)?;
    Ok((problem, walks))
}

/// The answer about which nothing is known.
fn empty(instance: &Instance) -> DelaysAnswer {
    DelaysAnswer {
        giveway: Version,
        objective: instance.objective().clone(),
        since: None,
        costs: None,
        alone: 0,
        delay: 0,
        agents: Vec::new(),
        because: Vec::new(),
        lost: Vec::new(),
        places: Vec::new(),
        proof: None,
        plan: None,
        calm: None,
        reason: None,
        pending: false,
        words: String::new(),
        stats: crate::Stats::default(),
    }
}
