//! Questions about a plan around which the world has changed: in the times of
//! the whole, and refused where they cannot be answered.

mod refusals;
mod times;

use giveway_model::{
    Costs, Instance, Plan, change::Changes, check::check_changes, format::native,
    question::from_words,
};

use super::read;
use crate::{
    Refusal, Request, Response, SilentHost,
    explain::{ExplainAnswer, ExplainRequest},
    serve,
};

pub(super) struct Course {
    pub(super) instance: Instance,
    pub(super) plan: Plan,
    pub(super) changes: Changes,
}

pub(super) fn course(instance: &str, plan: &str, changes: &str) -> Course {
    let (instance, plan) = read(instance, plan);
    let changes = format!(r#"{{ "giveway": 1, "changes": [{changes}] }}"#);
    let changes = native::read_changes(&changes).unwrap();
    Course {
        instance,
        plan,
        changes,
    }
}

/// `a` goes along the middle row from the left; `b` has arrived below at time 1.
/// At time 3 the cell (4, 1) becomes an obstacle; `a` goes around by the top
/// row and waits on the way.
fn around() -> Course {
    course(
        r#"{ "giveway": 1, "map": ["......", "......", "......"], "agents": [
            { "name": "a", "start": [0, 1], "goal": [5, 1] },
            { "name": "b", "start": [4, 1], "goal": [4, 2] }] }"#,
        r#"{ "giveway": 1, "paths": {
            "a": [[0, 1], [1, 1], [2, 1], [3, 1], [3, 1], [3, 0], [4, 0], [5, 0], [5, 1]],
            "b": [[4, 1], [4, 2]] } }"#,
        r#"{ "at": 3, "change": "add-obstacle", "cell": [4, 1] }"#,
    )
}

impl Course {
    pub(super) fn request(&self, words: &str) -> ExplainRequest {
        let words: Vec<&str> = words.split_whitespace().collect();
        ExplainRequest {
            scene: self.instance.to_scene(),
            plan: Some(self.plan.clone()),
            changes: Some(self.changes.clone()),
            at: None,
            question: from_words(&words).unwrap(),
            objective: None,
            within: None,
            proved: None,
            known: None,
            layers: Vec::new(),
            limits: crate::Limits::default(),
        }
    }

    pub(super) fn ask(&self, words: &str) -> ExplainAnswer {
        explained(self.request(words)).unwrap_or_else(|refused| panic!("{words}: {refused:?}"))
    }

    pub(super) fn refused(&self, words: &str) -> String {
        let refusal = explained(self.request(words)).unwrap_err();
        refusal.sentences().join(" ")
    }

    pub(super) fn costs(&self, plan: &Plan) -> Costs {
        let report = check_changes(&self.instance, &self.changes, plan).unwrap();
        assert_eq!(report.violations, []);
        report.costs.unwrap()
    }
}

pub(super) fn explained(request: ExplainRequest) -> Result<ExplainAnswer, Refusal> {
    match serve(&Request::Explain(request), &SilentHost) {
        Response::Explained(answer) => Ok(*answer),
        Response::Refused(refusal) => Err(refusal),
        other => panic!("{other:?}"),
    }
}
