//! The colours that a person gives to agents, in the place of those that come by
//! their order.

use borsh::{BorshDeserialize, BorshSerialize};

use giveway_model::tr_later;
use giveway_model::words::Later;

use crate::form::COLOURED;

/// What the colours are called, in the order of the looks that they come with.
pub const COLOURS: [Later; COLOURED] = [
    tr_later!("a colour" => "Blue"),
    tr_later!("a colour" => "Sea"),
    tr_later!("a colour" => "Plum"),
    tr_later!("a colour" => "Amber"),
    tr_later!("a colour" => "Lavender"),
    tr_later!("a colour" => "Forest"),
    tr_later!("a colour" => "Raspberry"),
    tr_later!("a colour" => "Mauve"),
    tr_later!("a colour" => "Violet"),
    tr_later!("a colour" => "Olive"),
    tr_later!("a colour" => "Dusk"),
    tr_later!("a colour" => "Moss"),
];

/// Which colour each look has. It belongs to the page and not to the scene, whose
/// format knows no colours; so agents that look alike keep one colour.
///
/// ```
/// use giveway_picture::Colours;
/// let mut colours = Colours::default();
/// assert_eq!((colours.of(2), colours.of(14)), (2, 2));
/// colours.set(2, 7);
/// assert_eq!((colours.of(2), colours.of(3)), (7, 3));
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, BorshSerialize, BorshDeserialize)]
pub struct Colours([u8; COLOURED]);

impl Default for Colours {
    fn default() -> Self {
        Self(std::array::from_fn(|look| look as u8))
    }
}

impl Colours {
    /// The colour of an agent, by its index in the scene: an index of [`COLOURS`].
    pub fn of(&self, agent: usize) -> usize {
        usize::from(self.0[agent % COLOURED])
    }

    /// Gives an agent a colour; one that does not exist changes nothing.
    pub fn set(&mut self, agent: usize, colour: usize) {
        if colour < COLOURED {
            self.0[agent % COLOURED] = colour as u8;
        }
    }

    /// All of them as one number a look, in their order.
    pub fn numbers(self) -> [u32; COLOURED] {
        self.0.map(u32::from)
    }

    /// What [`Colours::numbers`] gave; a colour that does not exist is left out.
    pub fn from_numbers(numbers: [u32; COLOURED]) -> Self {
        let mut colours = Self::default();
        for (look, colour) in numbers.into_iter().enumerate() {
            colours.set(look, colour as usize);
        }
        colours
    }
}
