//! The proofs of answers, kept for questions about their plans.

use std::collections::VecDeque;

use giveway_model::{Objective, Plan, Scene};

use super::Response;
use crate::{ProvedBest, Request, SolveRequest, Status};

/// What was proved of the last plans that a program had from [`serve`](super::serve). A question
/// about one of them need not prove it again.
///
/// ```
/// use giveway_solve::{Proofs, Request, SilentHost, SolveRequest, serve};
///
/// let mut proofs = Proofs::default();
/// let request = Request::Solve(SolveRequest::default());
/// let response = serve(&proofs.completed(request.clone()), &SilentHost);
/// proofs.keep(request, &response); // a refusal is nothing to keep
/// assert_eq!(proofs, Proofs::default());
/// ```
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Proofs(VecDeque<Kept>);

/// A plan, what asked for it, and the proof that none is better.
#[derive(Clone, Debug, PartialEq)]
struct Kept {
    scene: Scene,
    objective: Option<Objective>,
    within: Option<u32>,
    plan: Plan,
    proved: ProvedBest,
}

impl Proofs {
    /// How many plans.
    const MOST: usize = 8;

    /// The empty memory; may be a constant.
    pub const fn new() -> Self {
        Self(VecDeque::new())
    }

    /// The request with what was proved of the plan that it is about, where its scene, objective
    /// and horizon are those of the proof and nothing changed on the way.
    pub fn completed(&self, mut request: Request) -> Request {
        match &mut request {
            Request::Explain(asked) if asked.proved.is_none() && asked.changes.is_none() => {
                let key = (&asked.scene, &asked.objective, asked.within);
                asked.proved = self.of(asked.plan.as_ref(), key);
            }
            Request::Freedom(asked) if asked.proved.is_none() => {
                let key = (&asked.scene, &asked.objective, asked.within);
                asked.proved = self.of(asked.plan.as_ref(), key);
            }
            Request::Explain(_)
            | Request::Freedom(_)
            | Request::Solve(_)
            | Request::Check(_)
            | Request::Certify(_)
            | Request::Export(_)
            | Request::Change(_)
            | Request::Audit(_)
            | Request::Plan(_)
            | Request::Together(_)
            | Request::Price(_)
            | Request::Delays(_)
            | Request::Order(_)
            | Request::Sizing(_) => {}
        }
        request
    }

    /// What was proved of a plan in a scene, for an objective, within a horizon.
    fn of(
        &self,
        plan: Option<&Plan>,
        (scene, objective, within): (&Scene, &Option<Objective>, Option<u32>),
    ) -> Option<ProvedBest> {
        let plan = plan?;
        let kept = self.0.iter().find(|kept| {
            kept.plan == *plan
                && kept.within == within
                && kept.objective == *objective
                && kept.scene == *scene
        })?;
        Some(kept.proved.clone())
    }

    /// Keeps what a response proves of its own plan; the oldest proof goes where there are too many.
    pub fn keep(&mut self, request: Request, response: &Response) {
        if let (Request::Solve(solve), Response::Solved(answer)) = (request, response)
            && answer.status == Status::Optimal
            && let Some(plan) = &answer.plan
        {
            let SolveRequest {
                scene,
                objective,
                within,
                ..
            } = solve;
            self.0.truncate(Self::MOST - 1);
            self.0.push_front(Kept {
                scene,
                objective,
                within,
                plan: plan.clone(),
                proved: ProvedBest::by_search(answer),
            });
        }
    }
}

#[cfg(test)]
mod tests {
    use giveway_model::{Agent, Cell, Cost, Question, change::Changes};

    use super::*;
    use crate::{SilentHost, explain::ExplainRequest, freedom::FreedomRequest, serve};

    /// A robot that has to go round a shelf.
    fn solve() -> SolveRequest {
        let scene = Scene {
            map: vec!["...".to_owned(), ".#.".to_owned(), "...".to_owned()],
            agents: vec![Agent {
                name: "A1".to_owned(),
                start: Cell::new(0, 1),
                goal: Some(Cell::new(2, 1)),
                waypoints: Vec::new(),
                battery: None,
                heading: None,
            }],
            ..Scene::default()
        };
        SolveRequest {
            scene,
            trace: true,
            ..SolveRequest::default()
        }
    }

    fn about(solve: &SolveRequest, plan: Plan) -> ExplainRequest {
        ExplainRequest {
            scene: solve.scene.clone(),
            plan: Some(plan),
            question: Question::Makespan,
            changes: None,
            at: None,
            objective: solve.objective.clone(),
            within: solve.within,
            proved: None,
            known: None,
            layers: Vec::new(),
            limits: crate::Limits::default(),
        }
    }

    #[test]
    fn a_question_about_a_kept_plan_has_its_proof_and_no_other_has() {
        let mut proofs = Proofs::new();
        let solve = solve();
        let response = serve(&Request::Solve(solve.clone()), &SilentHost);
        let Response::Solved(answer) = &response else {
            panic!("{response:?}");
        };
        let plan = answer.plan.clone().unwrap();
        proofs.keep(Request::Solve(solve.clone()), &response);
        let proved = |explain: ExplainRequest| match proofs.completed(Request::Explain(explain)) {
            Request::Explain(explain) => explain.proved,
            other => panic!("{other:?}"),
        };
        let asked = || about(&solve, plan.clone());
        assert_eq!(proved(asked()), Some(ProvedBest::by_search(answer)));

        let mut other = asked();
        other.scene.map[2] = "..~".to_owned();
        assert_eq!(proved(other), None, "another scene");
        let objective = Some(Objective::new(vec![Cost::Waits]).unwrap());
        let other = ExplainRequest {
            objective,
            ..asked()
        };
        assert_eq!(proved(other), None, "another objective");
        let other = ExplainRequest {
            within: Some(9),
            ..asked()
        };
        assert_eq!(proved(other), None, "another horizon");
        let other = ExplainRequest {
            changes: Some(Changes::default()),
            ..asked()
        };
        assert_eq!(proved(other), None, "a world that changed");
        let mut other = asked();
        other.plan = None;
        assert_eq!(proved(other), None, "a plan that is yet to be found");
    }

    #[test]
    fn what_all_best_plans_share_is_asked_without_a_second_proof() {
        let mut proofs = Proofs::new();
        let solve = solve();
        let response = serve(&Request::Solve(solve.clone()), &SilentHost);
        let Response::Solved(answer) = &response else {
            panic!("{response:?}");
        };
        proofs.keep(Request::Solve(solve.clone()), &response);
        let ask = |proofs: &Proofs| {
            let request = proofs.completed(Request::Freedom(FreedomRequest {
                scene: solve.scene.clone(),
                plan: answer.plan.clone(),
                ..FreedomRequest::default()
            }));
            match serve(&request, &SilentHost) {
                Response::Freedom(answer) => answer,
                other => panic!("{other:?}"),
            }
        };
        let (handed_on, again) = (ask(&proofs), ask(&Proofs::new()));
        assert_eq!(handed_on.reach, again.reach);
        assert_eq!(handed_on.plans, again.plans);
        assert_eq!(handed_on.backbone, again.backbone);
        assert!(handed_on.stats.work < again.stats.work);
    }

    #[test]
    fn a_plan_that_is_not_proved_best_is_not_kept() {
        let mut proofs = Proofs::new();
        let request = Request::Solve(solve());
        let mut response = serve(&request, &SilentHost);
        if let Response::Solved(answer) = &mut response {
            answer.status = Status::Feasible;
        }
        proofs.keep(request, &response);
        assert_eq!(proofs, Proofs::new());
    }

    #[test]
    fn the_oldest_proof_goes() {
        let mut proofs = Proofs::new();
        for within in 4..4 + 2 * Proofs::MOST as u32 {
            let request = Request::Solve(SolveRequest {
                within: Some(within),
                ..solve()
            });
            let response = serve(&request, &SilentHost);
            proofs.keep(request, &response);
        }
        assert_eq!(proofs.0.len(), Proofs::MOST);
        let newest = proofs.0.front().and_then(|kept| kept.within);
        assert_eq!(newest, Some(3 + 2 * Proofs::MOST as u32));
    }
}
