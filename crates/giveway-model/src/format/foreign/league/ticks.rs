//! Letters for so many ticks each, in segments:
//! `[(0,14,55,0,0):(C 10,F 20)][(100,14,55,0,0):(W 3)]`.
//!
//! A segment begins with its tick, the row, the column, the heading and the counter
//! of the robot. A move or a turn is done in the tick in which the counter is full;
//! once it has begun, only waits interrupt it.

use super::steps::{Unknown, turning};
use crate::format::foreign::Action;
use crate::format::foreign::limits::Steps;
use crate::{Fault, tr};

/// Why a text is not read.
pub(super) enum Refused {
    Unknown(Unknown),
    TooMany(Fault),
}

impl From<Unknown> for Refused {
    fn from(unknown: Unknown) -> Self {
        Self::Unknown(unknown)
    }
}

/// Reads the actions of a robot, one a tick; `full` is where its counter is full.
pub(super) fn actions(text: &str, full: u32, steps: &mut Steps) -> Result<Vec<Action>, Refused> {
    let mut reader = Reader { text, at: 0 };
    let mut robot = Robot {
        full: full.max(1),
        counter: 0,
        begun: Action::Wait,
        actions: Vec::new(),
    };
    while !reader.is_at_end() {
        reader.expect("[(")?;
        let begin = reader.at;
        if reader.number()? as usize != robot.actions.len() {
            let expected = tr!("{n}, the next tick", n = robot.actions.len());
            return Err(Unknown {
                offset: begin,
                expected,
            }
            .into());
        }
        for _ in 0..4 {
            reader.expect(",")?;
            reader.number()?;
        }
        reader.expect("):(")?;
        while !reader.skip(")]") {
            let action = reader.action()?;
            reader.expect(" ")?;
            let ticks = reader.number()? as usize;
            steps.add(ticks).map_err(Refused::TooMany)?;
            robot.go_on(action, ticks);
            reader.skip(",");
        }
    }
    Ok(robot.actions)
}

struct Robot {
    full: u32,
    counter: u32,
    /// What it is doing while the counter is not 0.
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

struct Reader<'a> {
    text: &'a str,
    at: usize,
}

impl Reader<'_> {
    fn rest(&self) -> &str {
        self.text.get(self.at..).unwrap_or("")
    }

    const fn is_at_end(&self) -> bool {
        self.at >= self.text.len()
    }

    fn unknown(&self, expected: impl Into<String>) -> Unknown {
        Unknown {
            offset: self.at,
            expected: expected.into(),
        }
    }

    fn skip(&mut self, part: &str) -> bool {
        let is_there = self.rest().starts_with(part);
        if is_there {
            self.at += part.len();
        }
        is_there
    }

    fn expect(&mut self, part: &str) -> Result<(), Unknown> {
        if self.skip(part) {
            Ok(())
        } else {
            Err(self.unknown(format!("\"{part}\"")))
        }
    }

    fn number(&mut self) -> Result<u32, Unknown> {
        let digits = self.rest().bytes().take_while(u8::is_ascii_digit).count();
        let number = self.rest().get(..digits).and_then(|it| it.parse().ok());
        let number = number.filter(|&number: &u32| i32::try_from(number).is_ok());
        let number = number
            .ok_or_else(|| self.unknown(tr!("a whole number from 0 to {most}", most = i32::MAX)))?;
        self.at += digits;
        Ok(number)
    }

    fn action(&mut self) -> Result<Action, Unknown> {
        let letter = self.rest().bytes().next().and_then(turning);
        let action = letter.ok_or_else(|| self.unknown(tr!("one of F R C W T, or )]")))?;
        self.at += 1;
        Ok(action)
    }
}
