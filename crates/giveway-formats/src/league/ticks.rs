//! Letters for so many ticks each, in segments:
//! `[(0,14,55,0,0):(C 10,F 20)][(100,14,55,0,0):(W 3)]`.
//!
//! A segment begins with its tick, the row, the column, the heading and the counter
//! of the robot. A move or a turn is done in the tick in which the counter is full;
//! once it has begun, only waits interrupt it.

use super::steps::{turning, unexpected};
use crate::Action;
use crate::cursor::Cursor;
use crate::limits::Steps;
use giveway_model::{Fault, tr};

/// Reads the actions of a robot, one a tick; `full` is where its counter is full.
pub(super) fn actions(text: &str, full: u32, steps: &mut Steps) -> Result<Vec<Action>, Fault> {
    let mut reader = Reader {
        text,
        cursor: Cursor::new(text),
    };
    let mut robot = Robot {
        full: full.max(1),
        counter: 0,
        begun: Action::Wait,
        actions: Vec::new(),
    };
    while !reader.cursor.is_at_end() {
        reader.expect("[(")?;
        let begin = reader.cursor.offset();
        if reader.number()? as usize != robot.actions.len() {
            let expected = tr!("{n}, the next tick", n = robot.actions.len());
            return Err(unexpected(text, begin, expected));
        }
        for _ in 0..4 {
            reader.expect(",")?;
            reader.number()?;
        }
        reader.expect("):(")?;
        while !reader.cursor.eat(")]") {
            let action = reader.action()?;
            reader.expect(" ")?;
            let ticks = reader.number()? as usize;
            steps.add(ticks)?;
            robot.go_on(action, ticks);
            reader.cursor.eat(",");
        }
    }
    Ok(robot.actions)
}

struct Robot {
    full: u32,
    counter: u32,
    /// The action under way while the counter is not 0.
    begun: Action,
    actions: Vec<Action>,
}

impl Robot {
    fn go_on(&mut self, action: Action, ticks: usize) {
        self.actions.reserve(ticks);
        for _ in 0..ticks {
            let mut done = Action::Wait;
            if action != Action::Wait {
                if self.counter == 0 {
                    self.begun = action;
                }
                self.counter += 1;
                if self.counter >= self.full {
                    self.counter = 0;
                    done = self.begun;
                }
            }
            self.actions.push(done);
        }
    }
}

/// A text, and how far it is read.
struct Reader<'a> {
    text: &'a str,
    cursor: Cursor<'a>,
}

impl Reader<'_> {
    fn unexpected(&self, expected: impl Into<String>) -> Fault {
        unexpected(self.text, self.cursor.offset(), expected)
    }

    fn expect(&mut self, part: &str) -> Result<(), Fault> {
        let is_there = self.cursor.eat(part);
        let fault = || self.unexpected(format!("\"{part}\""));
        is_there.then_some(()).ok_or_else(fault)
    }

    fn number(&mut self) -> Result<u32, Fault> {
        let digits = self.cursor.digits();
        let number = digits.parse::<i32>().ok().map(i32::unsigned_abs);
        let number = number.ok_or_else(|| {
            self.unexpected(tr!("a whole number from 0 to {most}", most = i32::MAX))
        })?;
        self.cursor.eat(digits);
        Ok(number)
    }

    fn action(&mut self) -> Result<Action, Fault> {
        let letter = self.cursor.peek().and_then(turning);
        let action = letter.ok_or_else(|| self.unexpected(tr!("one of F R C W T, or )]")))?;
        self.cursor.skip(1);
        Ok(action)
    }
}
