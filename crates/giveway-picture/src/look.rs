//! How a picture looks: its theme, its size, how letters are drawn.

use borsh::{BorshDeserialize, BorshSerialize};
use giveway_model::Grid;

use crate::{Colours, Looks, Theme};

/// How a picture looks.
#[derive(Clone, Debug, PartialEq, Eq, BorshSerialize, BorshDeserialize)]
pub struct Look {
    /// Light or dark.
    pub theme: Theme,
    /// The side of a cell, in pixels.
    pub cell: u32,
    /// How letters are drawn.
    pub letters: Letters,
    /// Which look each agent has.
    pub looks: Looks,
    /// The colour of each look.
    pub colours: Colours,
}

/// How letters are drawn.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, BorshSerialize, BorshDeserialize)]
pub enum Letters {
    /// As text, in the font of whoever shows the picture.
    #[default]
    Text,
    /// As lines of our own, which look the same everywhere. There are letters of
    /// English and figures; others are left out.
    Strokes,
}

/// The smallest and the largest side of a cell, in pixels.
pub const CELL_PX: (u32, u32) = (2, 256);

/// The side of a cell where nobody asks for another one, in pixels.
const USUAL_PX: u32 = 64;

impl Look {
    /// A light look with text, whose cells are as large as usual, and smaller where
    /// the picture of this map would have a side of more pixels than that.
    ///
    /// ```
    /// use giveway_model::Grid;
    /// use giveway_picture::Look;
    /// let map = |side| Grid::from_rows(&[".".repeat(side)]).unwrap();
    /// let cell = |side| Look::fitting(&map(side), 1000).cell;
    /// assert_eq!((cell(4), cell(40), cell(2000)), (64, 25, 2));
    /// ```
    pub fn fitting(grid: &Grid, longest: u32) -> Self {
        let cells = grid.width().max(grid.height()).max(1);
        Self {
            theme: Theme::Light,
            cell: (longest / cells).clamp(CELL_PX.0, USUAL_PX),
            letters: Letters::Text,
            looks: Looks::default(),
            colours: Colours::default(),
        }
    }
}
