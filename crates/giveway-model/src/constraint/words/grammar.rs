//! Which words make a rule of which kind.

use super::read::{Read, Words};
use super::tokens::Token;
use crate::condition::{Times, Visit};
use crate::{Cell, MAX_SIDE, constraint::ConstraintKind};

/// Where there is no word at all; docs/rules.md has the words of each kind.
const EXAMPLES: &str = "a rule such as \"At most 1 robot in 'aisle 3'\" or \"A1 arrives by 12\"";

impl Words<'_> {
    pub(super) fn rule(&mut self) -> Read<ConstraintKind> {
        if self.eat("at most") {
            return self.capacity();
        }
        if self.eat("no robot") {
            return self.nobody();
        }
        if self.eat("none") {
            self.need_of()?;
            return self.nobody();
        }
        if self.eat("one way") {
            return self.lane();
        }
        if self.eat("each cell stays free for") {
            let steps = self.steps()?;
            self.need("behind any")?;
            if !self.eat("robot") {
                self.need_of()?;
            }
            return Ok(ConstraintKind::Gap { steps });
        }
        if self.eat("each step") {
            return self.cost();
        }
        if self.eat("all robots") {
            return self.distance();
        }
        if self.rest.is_empty() {
            return self.fault(EXAMPLES);
        }
        if self.eat("each robot") {
            return self.of_each();
        }
        if self.eat("each") {
            self.need_of()?;
            return self.of_each();
        }
        self.agents = Some(self.names()?);
        self.of_named()
    }

    fn need_of(&mut self) -> Read<()> {
        if self.of()? {
            return Ok(());
        }
        self.fault("\"of\" and names of robots")
    }

    /// Behind `at most`.
    fn capacity(&mut self) -> Read<ConstraintKind> {
        let most = self.number()?;
        if !self.eat("robot") && !self.eat("robots") && !self.of()? {
            return self.fault("\"robots\", or \"of\" and names of robots");
        }
        Ok(ConstraintKind::Capacity {
            most,
            zone: self.in_zone()?,
            times: self.times()?,
        })
    }

    /// Behind `no robot` or `none of ...`.
    fn nobody(&mut self) -> Read<ConstraintKind> {
        if !self.eat("waits") {
            return self.closed();
        }
        let mut most = 0;
        if self.eat("more than") {
            most = self.steps()?;
            self.need("on end")?;
        }
        let zone = self.in_zone()?;
        Ok(ConstraintKind::NoWaiting { zone, most })
    }

    fn closed(&mut self) -> Read<ConstraintKind> {
        Ok(ConstraintKind::Closed {
            zone: self.in_zone()?,
            times: self.times()?,
        })
    }

    /// Behind `one way`.
    fn lane(&mut self) -> Read<ConstraintKind> {
        let mut lane = Vec::new();
        if self.eat("from") {
            let first = self.cell()?;
            let before_last = self.rest;
            self.need("to")?;
            let last = self.cell()?;
            lane = straight(first, last);
            if lane.is_empty() {
                self.rest = before_last;
                return self.fault("the end of a straight lane, or \"along\" and all cells");
            }
        } else {
            self.need("along")?;
            lane.push(self.cell()?);
            while self.mark(',') {
                lane.push(self.cell()?);
            }
        }
        if self.eat("for") && !self.eat("all robots") {
            self.agents = Some(self.names()?);
        }
        Ok(ConstraintKind::OneWay { lane })
    }

    /// Behind `each step`.
    fn cost(&mut self) -> Read<ConstraintKind> {
        if self.eat("after") {
            let by = self.number()?;
            self.need("until")?;
            if self.eat("each robot") {
                // All of them.
            } else if self.eat("each") {
                self.need_of()?;
            } else {
                self.agents = Some(vec![self.name()?]);
            }
            self.need("arrives costs")?;
            let weight = self.number()?;
            return Ok(ConstraintKind::Late { by, weight });
        }
        self.of()?;
        let zone = self.in_zone()?;
        self.need("costs")?;
        let weight = self.number()?;
        Ok(ConstraintKind::Avoid { zone, weight })
    }

    /// Behind the names of robots or `all robots`.
    fn distance(&mut self) -> Read<ConstraintKind> {
        if !self.eat("keep") {
            self.need("keeps")?;
        }
        let distance = self.number()?;
        self.need("apart")?;
        Ok(ConstraintKind::Apart {
            distance,
            times: self.times()?,
        })
    }

    /// Behind the names of robots.
    fn of_named(&mut self) -> Read<ConstraintKind> {
        let has_distance = matches!(
            self.rest.first(),
            Some(Token::Word(word)) if ["keep", "keeps"].contains(&word.as_str())
        );
        if has_distance {
            return self.distance();
        }
        let names = self.agents.as_deref().unwrap_or_default();
        let [agent] = names else {
            return self.fault("\"keep\"; a rule for each of several begins with \"Each of\"");
        };
        let agent = agent.clone();
        if self.eat("goes to") {
            let mut cells = vec![self.cell()?];
            while self.mark(',') {
                self.need("then to")?;
                cells.push(self.cell()?);
            }
            self.agents = None;
            return Ok(ConstraintKind::Sequence { agent, cells });
        }
        if self.eat("never") {
            return self.nobody();
        }
        if self.eat("waits at most") {
            let most = self.steps()?;
            self.need("on end")?;
            let zone = self.in_zone()?;
            return Ok(ConstraintKind::NoWaiting { zone, most });
        }
        self.of_each()
    }

    /// Behind one robot or each of some.
    fn of_each(&mut self) -> Read<ConstraintKind> {
        if self.eat("is at") {
            return self.stop();
        }
        if self.eat("stays") {
            let stay = self.steps()?;
            self.need("at")?;
            return Ok(ConstraintKind::Visit {
                stay,
                cell: self.cell()?,
                times: self.times()?,
            });
        }
        if self.eat("arrives by") {
            let to = Some(self.number()?);
            let from = if self.mark(',') {
                self.need("not before")?;
                Some(self.number()?)
            } else {
                None
            };
            let times = Times { from, to };
            return Ok(ConstraintKind::Arrive { times });
        }
        if self.eat("arrives not before") {
            let from = Some(self.number()?);
            let times = Times { from, to: None };
            return Ok(ConstraintKind::Arrive { times });
        }
        if self.eat("starts from") {
            let from = self.number()?;
            self.need("on")?;
            return Ok(ConstraintKind::Depart { from });
        }
        if self.eat("needs") {
            let quarter = self.steps()?;
            self.need("for each quarter turn")?;
            return Ok(ConstraintKind::Turns { quarter });
        }
        self.fault("what a robot does, such as \"arrives by\", \"is at\" or \"stays\"")
    }

    /// Behind `is at`.
    fn stop(&mut self) -> Read<ConstraintKind> {
        let cell = self.cell()?;
        if self.eat("before") {
            let first = match self.agents.take().as_deref() {
                Some([agent]) => agent.clone(),
                _ => return self.fault("one robot that is somewhere first"),
            };
            let agent = self.name()?;
            self.need("is at")?;
            let second = Visit {
                agent,
                cell: self.cell()?,
            };
            let first = Visit { agent: first, cell };
            return Ok(ConstraintKind::Before { first, second });
        }
        self.need("once")?;
        Ok(ConstraintKind::Visit {
            cell,
            stay: 0,
            times: self.times()?,
        })
    }
}

/// The cells from one to another in a row or a column; none where they stand in neither.
fn straight(first: Cell, last: Cell) -> Vec<Cell> {
    let between = |from: u32, to: u32| -> Vec<u32> {
        // A lane that is longer than any map has a fault in any case.
        let span = |from: u32, to: u32| from..=to.min(from.saturating_add(MAX_SIDE));
        if from <= to {
            span(from, to).collect()
        } else {
            span(to, from).rev().collect()
        }
    };
    if first.y == last.y {
        let row = between(first.x, last.x).into_iter();
        row.map(|x| Cell::new(x, first.y)).collect()
    } else if first.x == last.x {
        let column = between(first.y, last.y).into_iter();
        column.map(|y| Cell::new(first.x, y)).collect()
    } else {
        Vec::new()
    }
}
