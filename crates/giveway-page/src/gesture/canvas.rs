//! What a stroke is made on.

use std::rc::Rc;

use giveway_model::Grid;

use crate::Draft;
use crate::changing::Changing;
use crate::edit::Sketch;

/// What a stroke is made on, with what has come of it so far.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Canvas {
    /// The scene.
    Scene {
        before: Rc<Draft>,
        sketch: Rc<Sketch>,
        shown: Rc<Draft>,
    },
    /// The world as it changes.
    World {
        before: Rc<Changing>,
        after: Rc<Changing>,
    },
}

impl Canvas {
    pub(crate) fn scene(before: &Rc<Draft>) -> Self {
        Self::Scene {
            before: Rc::clone(before),
            sketch: Rc::new(Sketch::of(before)),
            shown: Rc::clone(before),
        }
    }

    pub(crate) fn world(before: &Rc<Changing>) -> Self {
        Self::World {
            before: Rc::clone(before),
            after: Rc::clone(before),
        }
    }

    /// The map before the stroke.
    pub(super) fn grid_before(&self) -> &Grid {
        match self {
            Self::Scene { before, .. } => before.grid(),
            Self::World { before, .. } => before.draft().grid(),
        }
    }
}
