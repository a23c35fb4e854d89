//! The check sum of a lesson, which is the same in all languages.

use std::fmt;
use std::str::FromStr;

use giveway_model::tr;
use serde::{Deserialize, Deserializer, Serialize, Serializer, de};

use crate::lesson::task::{Change, Choice, Choose, Guess, Lead, Order, Paint, Predict, Spot};
use crate::lesson::{Lesson, Step, Task, Text, hash, write_dense};

/// What a lesson is known by: the FNV-1a hash (64 bits) of all that decides what there is
/// to do, without its words. So a lesson in German has the sum of the one in English, and
/// a spelling mistake that is mended changes nothing.
///
/// It tells lessons apart and protects nothing: whoever likes can make another lesson with
/// the same sum. Hand-ins are judged against the lecturer's lesson, never against one that
/// they bring, so that there is nothing to win by it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Sum(u64);

impl Sum {
    /// The sum of a lesson.
    pub fn of(lesson: &Lesson) -> Self {
        Self(hash(&write_dense(&wordless(lesson))))
    }

    /// The sum of what a step asks: of a lesson that ends with it, so that the scene counts
    /// with which it begins. `None` where there is no such step.
    pub fn of_step(lesson: &Lesson, step: usize) -> Option<Self> {
        let scene = lesson.scene(step)?;
        let step = wordless_step(lesson.steps.get(step)?);
        let alone = Step {
            scene: Some(scene.clone()),
            ..step
        };
        // Texts, numbers and lists of them always have a JSON form.
        let written = serde_json::to_string(&alone).unwrap_or_default();
        Some(Self(hash(&written)))
    }
}

impl fmt::Display for Sum {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{:016x}", self.0)
    }
}

impl FromStr for Sum {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let is_hex = |c: char| c.is_ascii_digit() || ('a'..='f').contains(&c);
        let number = u64::from_str_radix(text, 16).ok();
        let number = number.filter(|_| text.len() == 16 && text.chars().all(is_hex));
        number.map(Self).ok_or_else(|| {
            let found: String = text.chars().take(40).collect();
            let expected = tr!("16 digits of 0 to 9 and a to f");
            format!("found {found:?}, expected {expected}")
        })
    }
}

impl Serialize for Sum {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_str(self)
    }
}

impl<'de> Deserialize<'de> for Sum {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let text = std::borrow::Cow::<str>::deserialize(deserializer)?;
        text.parse().map_err(de::Error::custom)
    }
}

/// A lesson without its words. What is added to lessons is missed here, and said to be a
/// word or not.
fn wordless(lesson: &Lesson) -> Lesson {
    let Lesson {
        giveway,
        title: _,
        minutes: _,
        about: _,
        hides_answers: _,
        steps,
    } = lesson;
    Lesson {
        giveway: *giveway,
        title: String::new(),
        minutes: 0,
        about: Text::default(),
        hides_answers: false,
        steps: steps.iter().map(wordless_step).collect(),
    }
}

fn wordless_step(step: &Step) -> Step {
    let Step {
        title: _,
        text: _,
        scene,
        plan,
        solved: _,
        time: _,
        playing: _,
        tools,
        edits,
        cells,
        show: _,
        task,
        hints: _,
        reason: _,
    } = step;
    Step {
        scene: scene.clone(),
        plan: plan.clone(),
        tools: tools.clone(),
        edits: *edits,
        cells: cells.clone(),
        task: task.as_ref().map(wordless_task),
        ..Step::default()
    }
}

fn wordless_task(task: &Task) -> Task {
    let say = Text::default();
    match task {
        Task::Paint(Paint { say: _, until }) => {
            let until = until.clone();
            Task::Paint(Paint { say, until })
        }
        Task::Lead(Lead {
            say: _,
            robots,
            aim,
        }) => {
            let (robots, aim) = (robots.clone(), aim.clone());
            Task::Lead(Lead { say, robots, aim })
        }
        Task::Predict(Predict {
            say: _,
            what,
            answers,
        }) => Task::Predict(Predict {
            say,
            what: what.clone(),
            answers: answers.iter().map(wordless_guess).collect(),
        }),
        Task::Spot(Spot { say: _ }) => Task::Spot(Spot { say }),
        Task::Choose(Choose { say: _, answers }) => {
            let answers = answers.iter().map(wordless_choice).collect();
            Task::Choose(Choose { say, answers })
        }
        Task::Order(Order { say: _, find }) => Task::Order(Order { say, find: *find }),
        Task::Change(Change {
            say: _,
            changes,
            methods,
            cost,
            kept,
        }) => Task::Change(Change {
            say,
            changes: changes.clone(),
            methods: methods.clone(),
            cost: *cost,
            kept: *kept,
        }),
    }
}

fn wordless_guess(guess: &Guess) -> Guess {
    let Guess {
        value,
        text: _,
        reply: _,
    } = guess;
    Guess {
        value: value.clone(),
        text: Text::default(),
        reply: Text::default(),
    }
}

fn wordless_choice(choice: &Choice) -> Choice {
    let Choice {
        text: _,
        right,
        reply: _,
        claim,
    } = choice;
    Choice {
        text: Text::default(),
        right: *right,
        reply: Text::default(),
        claim: claim.clone(),
    }
}
