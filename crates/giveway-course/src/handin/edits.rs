//! Edits of a scene: what differs from the scene that the lecturer has.

use std::fmt;

use giveway_model::{Agent, Cell, Grid, Ground, Scene, object_only, tr};
use serde::de::{self, IgnoredAny, SeqAccess, Visitor};
use serde::{Deserialize, Deserializer, Serialize, Serializer};

/// What was edited of a scene.
///
/// As JSON: `{ "cells": [[3, 1, "#"]], "robots": [...], "gone": ["A2"] }`.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(remote = "Self", default, deny_unknown_fields)]
pub struct Edits {
    /// Cells with another ground.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub cells: Vec<CellEdit>,
    /// Robots that were taken away.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub gone: Vec<String>,
    /// Robots that are elsewhere now, and those that came, as they are now.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub robots: Vec<Agent>,
}

object_only!(Edits);

/// A cell, and the ground that it has now. As JSON: `[3, 1, "#"]`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct CellEdit {
    /// The cell.
    pub cell: Cell,
    /// The ground.
    pub ground: Ground,
}

impl Serialize for CellEdit {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        (self.cell.x, self.cell.y, self.ground.to_char()).serialize(serializer)
    }
}

impl<'de> Deserialize<'de> for CellEdit {
    /// By hand, so that the words name the three values.
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct Three;

        impl<'de> Visitor<'de> for Three {
            type Value = CellEdit;

            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str(tr!("a cell and its ground, [x, y, \"#\"]"))
            }

            fn visit_seq<A: SeqAccess<'de>>(self, mut list: A) -> Result<CellEdit, A::Error> {
                let short = |length| de::Error::invalid_length(length, &self);
                let x = list.next_element()?.ok_or_else(|| short(0))?;
                let y = list.next_element()?.ok_or_else(|| short(1))?;
                let letter: char = list.next_element()?.ok_or_else(|| short(2))?;
                if list.next_element::<IgnoredAny>()?.is_some() {
                    return Err(short(4));
                }
                let ground = Ground::from_char(letter);
                let unknown = || format!("found {letter:?}, expected . # ~ + *");
                let ground = ground.ok_or_else(|| de::Error::custom(unknown()))?;
                let cell = Cell::new(x, y);
                Ok(CellEdit { cell, ground })
            }
        }

        deserializer.deserialize_seq(Three)
    }
}

impl Edits {
    /// What makes one scene of another one; nothing where both are the same.
    ///
    /// ```
    /// use giveway_course::handin::Edits;
    /// use giveway_model::Scene;
    /// let before = Scene { map: vec!["..".into()], ..Scene::default() };
    /// let now = Scene { map: vec![".#".into()], ..before.clone() };
    /// let edits = Edits::between(&before, &now);
    /// assert_eq!(edits.cells.len(), 1);
    /// assert_eq!(edits.of(&before).unwrap(), now);
    /// ```
    pub fn between(before: &Scene, now: &Scene) -> Self {
        let mut edits = Self::default();
        let grids = (Grid::from_rows(&before.map), Grid::from_rows(&now.map));
        if let (Ok(was), Ok(is)) = grids {
            let changed = is
                .cells()
                .filter(|(cell, ground)| was.ground(*cell).is_some_and(|before| before != *ground));
            edits.cells = changed
                .map(|(cell, ground)| CellEdit { cell, ground })
                .collect();
        }
        // Those that stay keep their order; who comes stands behind them.
        let mut left = before.agents.as_slice();
        for agent in &now.agents {
            let place = left.iter().position(|other| other.name == agent.name);
            let Some((gone, [was, rest @ ..])) = place.map(|place| left.split_at(place)) else {
                edits.robots.push(agent.clone());
                continue;
            };
            edits
                .gone
                .extend(gone.iter().map(|agent| agent.name.clone()));
            left = rest;
            if was != agent {
                edits.robots.push(agent.clone());
            }
        }
        edits
            .gone
            .extend(left.iter().map(|agent| agent.name.clone()));
        edits
    }

    /// Whether nothing was edited.
    pub const fn is_empty(&self) -> bool {
        self.cells.is_empty() && self.robots.is_empty() && self.gone.is_empty()
    }

    /// About how many letters they take in a file.
    pub(crate) fn letters(&self) -> usize {
        let gone = self.gone.iter().map(|name| name.len() + 3);
        let robots = self.robots.iter().map(|agent| {
            let facing = agent.heading.map_or(0, |_| 20);
            let battery = agent.battery.map_or(0, |_| 40);
            60 + agent.name.len() + 8 * agent.waypoints.len() + facing + battery
        });
        12 * self.cells.len() + gone.chain(robots).sum::<usize>()
    }
}
