//! Faults of a draft in the words of the form.

use giveway_model::{Scene, tr};

use super::{Draft, Field, FormFault, Input, Looked, Wrong, field_of, form, head};
use crate::lesson::read::{Flaw, MAX_TIME};

/// What is wrong, as a sentence beside the field; beside the board or the task, where
/// the fault has no field.
pub fn sentence(wrong: &Wrong, field: Option<&Field>) -> String {
    let said = match wrong {
        Wrong::Missing => match field.map(|field| &field.input) {
            Some(Input::One(_) | Input::Many(_)) => tr!("Choose something here."),
            Some(Input::Line | Input::Area | Input::Number | Input::Switch) | None => {
                tr!("Write something here.")
            }
        },
        Wrong::NotNumber => tr!("Write a whole number here."),
        Wrong::NotCell => tr!("Write one cell here, such as (3, 1)."),
        Wrong::NotCells => tr!("Write cells here, such as (3, 1), (4, 1)."),
        Wrong::NotQuestion(why) => return tr!("This is not a question: {why}.", why),
        Wrong::NotChanges(_) => {
            tr!("These are not changes. Save them on the page, and paste the whole file here.")
        }
        Wrong::NotChoice => tr!("This choice does not exist. Choose again."),
        Wrong::Markup(error) => {
            return tr!(
                "Character {at}: found {found}, expected {expected}.",
                at = error.at,
                found = error.found,
                expected = error.expected
            );
        }
        Wrong::Flaw(flaw) => return self::flaw(flaw),
    };
    said.to_owned()
}

fn flaw(flaw: &Flaw) -> String {
    let said = match flaw {
        Flaw::TooMany {
            things,
            count,
            most,
        } => {
            let things = things.words();
            return tr!(
                "There are {count} {things} here; at most {most} are allowed.",
                count,
                things,
                most
            );
        }
        Flaw::OutOfRange { least, most, .. } => {
            return tr!("Write a number from {least} to {most} here.", least, most);
        }
        Flaw::LinkedRobot(name) | Flaw::UnknownRobot(name) => {
            return tr!("The board of this step has no robot {name}.", name);
        }
        Flaw::LinkedCell(cell) | Flaw::UnknownCell(cell) => {
            return tr!("The map of this step has no cell {cell}.", cell);
        }
        Flaw::UnknownRule(number) => {
            return tr!(
                "The board of this step has no rule {number} that is on.",
                number = u64::from(*number) + 1
            );
        }
        Flaw::LinkedTerm(term) => return tr!("The glossary has no term \"{term}\".", term),
        Flaw::LinkedTime(time) => {
            return tr!(
                "Time {time} is too late: the last one is {most}.",
                time,
                most = MAX_TIME
            );
        }
        Flaw::BadScene(fault) => {
            return tr!(
                "This board has a fault: found {found}, expected {expected}. Change it on the page, then take it again.",
                found = fault.found,
                expected = fault.expected
            );
        }
        Flaw::Twice(what) => return tr!("Another answer has {what} already.", what),
        Flaw::OtherKind(value) => {
            return tr!("{value} does not answer what the task asks for.", value);
        }
        Flaw::NotOptimised(cost) => {
            return tr!(
                "The scene does not minimise this cost ({cost}). Choose another one.",
                cost
            );
        }
        Flaw::NoTitle => tr!("Write a title here."),
        Flaw::ControlCharacter => {
            tr!("This line holds an invisible control character. Type the line again.")
        }
        Flaw::NoWords | Flaw::NoParagraphs => tr!("Write a sentence here."),
        Flaw::NoSteps => tr!("Add a step."),
        Flaw::NoScene => {
            tr!("The first step needs a board. Press \"Take the board as it is now\".")
        }
        Flaw::TwoPlans => tr!("Choose one plan only."),
        Flaw::NoPlan => {
            tr!(
                "This task is about a plan. Solve the scene on the page or open a plan there, then press \"Take the board as it is now\"."
            )
        }
        Flaw::LegalPlan => tr!("This plan breaks no rule. Take a plan with conflicts."),
        Flaw::NoHints => tr!("Write at least one hint."),
        Flaw::NoReason => tr!("Write here why it is so."),
        Flaw::NoTask => tr!("Choose what there is to do, or remove the hints and the reason."),
        Flaw::NoTools => tr!("Choose at least one tool: without one, nothing can be edited."),
        Flaw::NoRobots => tr!("Choose at least one robot."),
        Flaw::OneAnswer => {
            tr!("Add a second answer, or remove this one: then the learner types the value.")
        }
        Flaw::FewAnswers(_) => tr!("Add a second answer."),
        Flaw::NoRightAnswer => tr!("Mark the right answer."),
        Flaw::NoFront(_) => tr!("Choose two or three different costs."),
        Flaw::SameCosts => tr!("Choose two different costs."),
        Flaw::NoMethods => tr!("Choose at least one method."),
        Flaw::NoAim => {
            tr!("Choose a cost to be reached, or say how many robots must keep their path.")
        }
    };
    said.to_owned()
}

/// A line in the list of all that is still to do.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ToDo {
    /// The step, from 0; none for the lesson as a whole.
    pub step: Option<usize>,
    /// The name of the field, where the fault has one.
    pub field: Option<String>,
    /// The step, the label of the field, and what is wrong.
    pub text: String,
}

impl Looked {
    /// All that is still to do: of the lesson first, then step by step.
    pub fn to_do(&self, draft: &Draft) -> Vec<ToDo> {
        let mut faults: Vec<&FormFault> = self.faults().iter().collect();
        faults.sort_by_key(|fault| fault.place.step);
        let mut all: Vec<ToDo> = Vec::new();
        for fault in faults {
            let line = line(draft, fault);
            if !all.contains(&line) {
                all.push(line);
            }
        }
        all
    }
}

fn line(draft: &Draft, fault: &FormFault) -> ToDo {
    let step = fault.place.step;
    let fields = match step.and_then(|at| Some((at, draft.steps().get(at)?))) {
        Some((at, step)) => {
            let scene: Option<&Scene> = draft.scene(at);
            form(step, scene)
        }
        None => head(),
    };
    let field = field_of(&fields, &fault.place);
    let what = sentence(&fault.wrong, field);
    let text = match (step, field) {
        (Some(step), Some(field)) => tr!(
            "Step {number}, {field}: {what}",
            number = step + 1,
            field = field.label,
            what
        ),
        (Some(step), None) => tr!("Step {number}: {what}", number = step + 1, what),
        (None, Some(field)) => tr!("{field}: {what}", field = field.label, what),
        (None, None) => what,
    };
    ToDo {
        step,
        field: field.map(|field| field.name.clone()),
        text,
    }
}
