//! What the check of a task found, in words.

use giveway_model::tr;
use giveway_model::words::name;

use super::super::{KIND, ToDo};
use super::{Finding, Problem};

/// What is wrong with a task, or not known of it; none where it has passed.
pub fn sentence(finding: &Finding) -> Option<String> {
    let said = match finding {
        Finding::Passed => return None,
        Finding::Unknown(None) => {
            tr!("The solver ran out of time: it is not known whether this task can be solved.")
        }
        Finding::Unknown(Some(reason)) => {
            return Some(tr!(
                "It is not known whether this task can be solved: {reason}",
                reason
            ));
        }
        Finding::Failed(problem) => return Some(self::problem(problem)),
    };
    Some(said.to_owned())
}

fn problem(problem: &Problem) -> String {
    let said = match problem {
        Problem::Refused(reason) => return tr!("The solver refuses this task: {reason}", reason),
        Problem::NotOffered(value) => {
            return tr!(
                "None of these answers is right: the solver has proved {value}.",
                value
            );
        }
        Problem::False(index) => {
            return tr!(
                "Answer {number} is marked right, but what it says is false.",
                number = index + 1
            );
        }
        Problem::True(index) => {
            return tr!(
                "Answer {number} is not marked right, but what it says is true.",
                number = index + 1
            );
        }
        Problem::Dear { cost, best } => {
            return tr!(
                "No plan is this good: the best one has {cost} {best}.",
                cost = name(*cost),
                best
            );
        }
        Problem::SomeOrderWorks(order) => {
            return tr!(
                "Some order gives a plan: {order}.",
                order = order.join(", ")
            );
        }
        Problem::StartSolved => tr!("This task is solved before the learner does anything."),
        Problem::Unsolved => tr!(
            "The solver could not solve this task by itself. Press \"Try it\" and solve it once."
        ),
        Problem::NoPlan => tr!("No plan was found for this board, but the task needs one."),
        Problem::SomePlan => {
            tr!("This board has a plan. The task asks which rule leaves none.")
        }
        Problem::Unclear => tr!("This has no one answer on this board. Ask something else."),
        Problem::Differs => {
            tr!("The best plans differ in this, so there is no right answer. Ask something else.")
        }
        Problem::Right(_) => tr!("Mark exactly one answer as right."),
        Problem::NoConflicts => {
            tr!("No two robots have a conflict in this plan. Take a plan with conflicts.")
        }
        Problem::NoOrder => tr!("No order of the robots does this."),
        Problem::NoMethod => tr!("None of the methods reaches this."),
    };
    said.to_owned()
}

/// The lines for the list of all that is still to do, by what was found step by step.
pub fn to_do(findings: &[Option<Finding>]) -> Vec<ToDo> {
    let steps = findings.iter().enumerate();
    let lines = steps.filter_map(|(step, finding)| {
        let what = sentence(finding.as_ref()?)?;
        Some(ToDo {
            step: Some(step),
            field: Some(KIND.to_owned()),
            text: tr!("Step {number}: {what}", number = step + 1, what),
        })
    });
    lines.collect()
}
