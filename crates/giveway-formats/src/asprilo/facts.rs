//! The facts of a file: the things of the warehouse, and the acts of robots.

use std::collections::{BTreeMap, BTreeSet};

use super::term::{Facts, Kind, Term};
use crate::unknown_keys::UnknownKeys;
use giveway_model::words::Later;
use giveway_model::{Fault, MAX_SIDE, tr, tr_later};

/// A number of a thing, as in `object(robot,7)`.
pub(super) type Id = i32;

/// A node, both numbers from 1.
pub(super) type Node = (u32, u32);

/// An order.
#[derive(Debug, Default)]
pub(super) struct Order {
    pub(super) station: Option<Id>,
    /// Its products in the order of the file, each with how many where that is said.
    pub(super) lines: Vec<(Id, Option<i32>)>,
}

/// The act of a robot in a step.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Doing {
    /// Goes on by so much.
    Move(i32, i32),
    /// Lifts the shelf above it.
    PickUp,
    /// Serves an order with a product; how many, where that is said.
    Deliver(Id, Id, Option<i32>),
    /// Anything else, while it stands still.
    Other,
}

/// All that was read.
#[derive(Debug, Default)]
pub(super) struct Warehouse {
    pub(super) nodes: BTreeSet<Node>,
    /// Each with the byte of its fact.
    pub(super) robots: BTreeMap<Id, (Node, usize)>,
    pub(super) shelves: BTreeMap<Id, Node>,
    pub(super) stations: BTreeMap<Id, Node>,
    pub(super) highways: usize,
    /// The shelves of each product, ascending.
    pub(super) products: BTreeMap<Id, Vec<Id>>,
    pub(super) orders: BTreeMap<Id, Order>,
    /// The act of each robot at each time, with the byte of its fact.
    pub(super) doings: BTreeMap<Id, BTreeMap<i32, (Doing, usize)>>,
    /// Facts that are not looked at, by what they are about.
    pub(super) others: BTreeMap<String, usize>,
}

const AT: Later = tr_later!("a node (X,Y) with numbers from 1");

/// Reads all facts.
pub(super) fn read(text: &str) -> Result<Warehouse, Fault> {
    let mut facts = Facts::new(text);
    let mut warehouse = Warehouse::default();
    while let Some(fact) = facts.next()? {
        match fact.parts() {
            Some(("init", [object, value])) => warehouse.init(&facts, &fact, object, value)?,
            Some(("occurs", [object, action, time])) => {
                warehouse.occurs(&facts, &fact, [object, action, time])?;
            }
            Some((name @ ("init" | "occurs"), _)) => {
                let expected = match name {
                    "init" => "init(object(..),value(..))",
                    _ => "occurs(object(..),action(..),time)",
                };
                return Err(facts.unexpected(fact.offset, expected));
            }
            Some((name, _)) => *warehouse.others.entry(name.to_owned()).or_default() += 1,
            None => {}
        }
    }
    Ok(warehouse)
}

impl Warehouse {
    /// The names of the facts that are not read.
    pub(super) fn unknown(&self) -> UnknownKeys {
        let mut unknown = UnknownKeys::default();
        for about in self.others.keys() {
            unknown.note("", about);
        }
        unknown
    }

    fn init(
        &mut self,
        facts: &Facts<'_>,
        fact: &Term<'_>,
        object: &Term<'_>,
        value: &Term<'_>,
    ) -> Result<(), Fault> {
        let Some(("object", [kind, id])) = object.parts() else {
            return Err(facts.unexpected(object.offset, "object(kind,number)"));
        };
        let Some(("value", [name, what])) = value.parts() else {
            return Err(facts.unexpected(value.offset, "value(name,value)"));
        };
        let kind = kind.parts().map_or("", |(kind, _)| kind);
        let name = name.parts().map_or("", |(name, _)| name);
        let number = |term: &Term<'_>| {
            term.number()
                .ok_or_else(|| facts.unexpected(term.offset, tr!("a number")))
        };
        match (kind, name) {
            ("highway", "at") => self.highways += 1,
            ("node", "at") => {
                self.nodes.insert(node(facts, what)?);
            }
            ("robot", "at") => {
                let (id, at) = (number(id)?, node(facts, what)?);
                self.place_robot(facts, id, at, fact.offset)?;
            }
            ("shelf", "at") => {
                self.shelves.insert(number(id)?, node(facts, what)?);
            }
            ("pickingStation", "at") => {
                self.stations.insert(number(id)?, node(facts, what)?);
            }
            ("product", "on") => {
                let shelf = first_of(facts, what)?.0;
                let shelves = self.products.entry(number(id)?).or_default();
                if let Err(at) = shelves.binary_search(&shelf) {
                    shelves.insert(at, shelf);
                }
            }
            ("order", "line") => {
                let line = first_of(facts, what)?;
                let order = self.orders.entry(number(id)?).or_default();
                if !order.lines.contains(&line) {
                    order.lines.push(line);
                }
            }
            ("order", "pickingStation") => {
                let order = self.orders.entry(number(id)?).or_default();
                order.station = Some(number(what)?);
            }
            _ => {
                let about = format!("{kind} {name}").trim().to_owned();
                *self.others.entry(about).or_default() += 1;
            }
        }
        Ok(())
    }

    fn place_robot(
        &mut self,
        facts: &Facts<'_>,
        id: Id,
        at: Node,
        offset: usize,
    ) -> Result<(), Fault> {
        match self.robots.insert(id, (at, offset)) {
            Some((before, _)) if before != at => {
                let found = tr!("a second place of robot {id}", id);
                Err(facts.fault(offset, found, tr!("one place for each robot")))
            }
            _ => Ok(()),
        }
    }

    fn occurs(
        &mut self,
        facts: &Facts<'_>,
        fact: &Term<'_>,
        [object, action, time]: [&Term<'_>; 3],
    ) -> Result<(), Fault> {
        let robot = match object.parts() {
            Some(("object", [kind, id])) if kind.parts() == Some(("robot", &[])) => id.number(),
            _ => None,
        };
        let robot = robot.ok_or_else(|| facts.unexpected(object.offset, "object(robot,number)"))?;
        let Some(("action", [name, what])) = action.parts() else {
            return Err(facts.unexpected(action.offset, "action(name,(..))"));
        };
        let at = time.number().filter(|&time| time >= 1);
        let at = at.ok_or_else(|| facts.unexpected(time.offset, tr!("a time from 1")))?;
        let doing = match name.parts() {
            Some(("move", [])) => match what.pair() {
                Some((x, y)) if x.unsigned_abs().saturating_add(y.unsigned_abs()) == 1 => {
                    Doing::Move(x, y)
                }
                _ => {
                    let expected = tr!("a move (1,0), (-1,0), (0,1) or (0,-1)");
                    return Err(facts.unexpected(what.offset, expected));
                }
            },
            Some(("pickup", [])) => Doing::PickUp,
            Some(("deliver", [])) => deliver(what),
            Some(_) => Doing::Other,
            None => return Err(facts.unexpected(name.offset, tr!("the name of an action"))),
        };
        let before = self
            .doings
            .entry(robot)
            .or_default()
            .insert(at, (doing, fact.offset));
        match before {
            Some((before, _)) if before != doing => {
                let found = tr!("a second action of robot {robot} at time {at}", robot, at);
                Err(facts.fault(fact.offset, found, tr!("one action a step")))
            }
            _ => Ok(()),
        }
    }
}

/// `(order,product,amount)` or `(order,product)`.
fn deliver(what: &Term<'_>) -> Doing {
    let numbers: Vec<Option<i32>> = match what.parts() {
        Some(("", terms)) => terms.iter().map(Term::number).collect(),
        _ => Vec::new(),
    };
    match *numbers.as_slice() {
        [Some(order), Some(product)] => Doing::Deliver(order, product, None),
        [Some(order), Some(product), Some(amount)] => Doing::Deliver(order, product, Some(amount)),
        _ => Doing::Other,
    }
}

fn node(facts: &Facts<'_>, term: &Term<'_>) -> Result<Node, Fault> {
    let (x, y) = term
        .pair()
        .ok_or_else(|| facts.unexpected(term.offset, AT))?;
    let side = |number: i32| {
        let side = u32::try_from(number).ok().filter(|&side| side >= 1);
        side.ok_or_else(|| facts.unexpected(term.offset, AT))
    };
    let (x, y) = (side(x)?, side(y)?);
    if x > MAX_SIDE || y > MAX_SIDE {
        let found = tr!("the node ({x},{y})", x, y);
        let expected = tr!("a map of at most {most} x {most} nodes", most = MAX_SIDE);
        return Err(facts.fault(term.offset, found, expected));
    }
    Ok((x, y))
}

/// `(number,amount)`, or a number alone.
fn first_of(facts: &Facts<'_>, term: &Term<'_>) -> Result<(Id, Option<i32>), Fault> {
    match (&term.kind, term.pair()) {
        (_, Some((id, amount))) => Ok((id, Some(amount))),
        (&Kind::Number(id), None) => Ok((id, None)),
        _ => Err(facts.unexpected(term.offset, "(number,amount)")),
    }
}
