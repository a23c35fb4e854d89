//! Named parts of a map.

use std::collections::BTreeSet;

use borsh::{BorshDeserialize, BorshSerialize};
use serde::{Deserialize, Serialize};

use crate::sorting::set;
use crate::{Cell, object_only};

/// A named set of cells, listed or as a rectangle; obstacles may be among them.
///
/// ```
/// use giveway_model::{Cell, Zone};
/// let zone: Zone = serde_json::from_str(r#"{ "name": "aisle", "rect": [1, 0, 2, 1] }"#).unwrap();
/// assert_eq!(zone.cells().count(), 4);
/// assert!(zone.has(Cell::new(2, 0)));
/// ```
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, BorshSerialize, BorshDeserialize)]
#[serde(remote = "Self", deny_unknown_fields)]
pub struct Zone {
    /// Its name, unique in the scene.
    pub name: String,
    /// Its cells, where they are listed.
    #[serde(default, rename = "cells", skip_serializing_if = "Option::is_none")]
    pub listed: Option<Vec<Cell>>,
    /// Its first and last column and row: `[x0, y0, x1, y1]`, both corners included.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub rect: Option<[u32; 4]>,
}

object_only!(Zone);

impl Zone {
    /// A zone of listed cells.
    pub fn of(name: impl Into<String>, cells: Vec<Cell>) -> Self {
        Self {
            name: name.into(),
            listed: Some(cells),
            rect: None,
        }
    }

    /// Its cells.
    pub fn cells(&self) -> impl Iterator<Item = Cell> + '_ {
        let listed = self.listed.iter().flatten().copied();
        let rect = self.rect.into_iter().flat_map(|[x0, y0, x1, y1]| {
            (y0..=y1).flat_map(move |y| (x0..=x1).map(move |x| Cell::new(x, y)))
        });
        listed.chain(rect)
    }

    /// Its cells as a set.
    pub fn cell_set(&self) -> BTreeSet<Cell> {
        set(self.cells())
    }

    /// Whether a cell is one of them.
    pub fn has(&self, cell: Cell) -> bool {
        let is_inside =
            |[x0, y0, x1, y1]: [u32; 4]| (x0..=x1).contains(&cell.x) && (y0..=y1).contains(&cell.y);
        self.rect.is_some_and(is_inside)
            || self
                .listed
                .as_ref()
                .is_some_and(|cells| cells.contains(&cell))
    }
}
