//! Faults of a lesson in the words of its file: the path of keys, what was found, what
//! was expected.

use giveway_model::{Fault, tr};

use super::{Flaw, LessonFault, MAX_TIME, Place, Things};

impl Place {
    /// The path in the file: `steps[2].task.say`.
    pub fn path(&self) -> String {
        match (self.step, &*self.field) {
            (None, field) => field.to_owned(),
            (Some(step), "") => format!("steps[{step}]"),
            (Some(step), field) => format!("steps[{step}].{field}"),
        }
    }
}

impl LessonFault {
    /// The fault in the words of a file.
    pub fn in_file_words(self) -> Fault {
        let place = self.place.path();
        let (found, expected) = match self.flaw {
            Flaw::BadScene(fault) => return fault.of_part(&place),
            flaw => words(flaw),
        };
        Fault::at(place, found, expected)
    }
}

/// What was found, and what was expected.
fn words(flaw: Flaw) -> (String, String) {
    let (found, expected) = match flaw {
        Flaw::TooMany {
            things,
            count,
            most,
        } => {
            let found = format!("{count} {}", things.words());
            return (found, tr!("at most {most}", most));
        }
        Flaw::OutOfRange {
            number,
            least,
            most,
        } => return (number.to_string(), tr!("{least} to {most}", least, most)),
        Flaw::LinkedRobot(name) => {
            let found = tr!("a link to the robot {name}", name = format!("{name:?}"));
            return (found, tr!("a robot of the scene").to_owned());
        }
        Flaw::LinkedCell(cell) => {
            let found = tr!("a link to the cell {cell}", cell);
            return (found, tr!("a cell of the map").to_owned());
        }
        Flaw::LinkedTerm(term) => {
            let found = tr!("a link to the term \"{term}\"", term);
            return (found, tr!("a term of the glossary").to_owned());
        }
        Flaw::LinkedTime(time) => {
            let found = tr!("a link to time {time}", time);
            return (found, tr!("at most {most}", most = MAX_TIME));
        }
        Flaw::UnknownCell(cell) => {
            let found = tr!("the cell {cell}", cell);
            return (found, tr!("a cell of the map").to_owned());
        }
        Flaw::UnknownRobot(name) => {
            let found = tr!("the robot {name}", name = format!("{name:?}"));
            return (found, tr!("a robot of the scene").to_owned());
        }
        Flaw::UnknownRule(number) => {
            let found = tr!("the rule number {number}, counted from 0", number);
            return (found, tr!("a rule of the scene that is on").to_owned());
        }
        Flaw::OtherKind(value) => {
            let expected = tr!("a value of what is asked for");
            return (format!("{value:?}"), expected.to_owned());
        }
        Flaw::Twice(what) => return (tr!("{what} twice", what), tr!("each once").to_owned()),
        Flaw::FewAnswers(n) => return (tr!("{n} answers", n), tr!("at least two").to_owned()),
        Flaw::NoFront(n) => {
            let expected = tr!("two or three different costs");
            return (tr!("{n} costs", n), expected.to_owned());
        }
        Flaw::NotOptimised(cost) => {
            let expected = tr!("a cost of the scene's objective");
            return (tr!("the cost {cost}", cost), expected.to_owned());
        }
        Flaw::BadScene(fault) => return (fault.found, fault.expected),
        Flaw::NoTitle => (tr!("no words"), tr!("a title")),
        Flaw::ControlCharacter => (tr!("a control character"), tr!("one line of text")),
        Flaw::NoWords => (tr!("no words"), tr!("a sentence")),
        Flaw::NoSteps => (tr!("no steps"), tr!("at least one")),
        Flaw::NoScene => (tr!("no scene"), tr!("a scene in the first step")),
        Flaw::NoParagraphs => (tr!("no paragraphs"), tr!("at least one")),
        Flaw::TwoPlans => (tr!("true beside a plan"), tr!("one of the two")),
        Flaw::NoPlan => (tr!("no plan"), tr!("a plan that the task is about")),
        Flaw::LegalPlan => (tr!("a plan that breaks no rule"), tr!("one with conflicts")),
        Flaw::NoHints => (tr!("no hints"), tr!("at least one")),
        Flaw::NoReason => (
            tr!("a task without \"reason\""),
            tr!("why it is so, once solved"),
        ),
        Flaw::NoTask => (tr!("hints or a reason without a task"), tr!("a task")),
        Flaw::NoTools => (
            tr!("a \"paint\" task without tools"),
            tr!("at least one tool"),
        ),
        Flaw::NoRobots => (tr!("no robots"), tr!("at least one")),
        Flaw::OneAnswer => (tr!("one answer"), tr!("none, or at least two")),
        Flaw::NoRightAnswer => (tr!("no answer with \"right\": true"), tr!("at least one")),
        Flaw::SameCosts => (tr!("a cost twice"), tr!("two different costs")),
        Flaw::NoMethods => (tr!("no methods"), tr!("at least one")),
        Flaw::NoAim => (
            tr!("neither \"cost\" nor \"kept\""),
            tr!("what must be reached"),
        ),
    };
    (found.to_owned(), expected.to_owned())
}

impl Things {
    /// Several of them, after a number.
    pub fn words(self) -> &'static str {
        match self {
            Self::Characters => tr!("counted" => "characters"),
            Self::Steps => tr!("counted" => "steps"),
            Self::Paragraphs => tr!("counted" => "paragraphs"),
            Self::Hints => tr!("counted" => "hints"),
            Self::Tools => tr!("counted" => "tools"),
            Self::Cells => tr!("counted" => "cells"),
            Self::Robots => tr!("counted" => "robots"),
            Self::Rules => tr!("counted" => "rules"),
            Self::Answers => tr!("counted" => "answers"),
            Self::Methods => tr!("counted" => "methods"),
            Self::Lessons => tr!("counted" => "lessons"),
            Self::Terms => tr!("counted" => "terms"),
        }
    }
}
