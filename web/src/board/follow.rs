//! The camera goes with an agent.

use std::rc::Rc;

use giveway_page::board::Cast;
use yew::prelude::*;

use super::legend::ZOOM;
use super::viewport::{Look, Viewport};
use crate::Clock;

/// Keeps the agent in the middle, in every frame; where all of the map is in
/// sight, nearer first.
#[hook]
pub(super) fn use_follow(agent: Option<usize>, cast: &Rc<Cast>, viewport: &Viewport) {
    let clock = use_context::<Clock>();
    let (look, is_fit) = (viewport.look.clone(), viewport.camera.is_fit());
    {
        let look = look.clone();
        use_effect_with(agent, move |agent| {
            if agent.is_some() && is_fit {
                look.emit(Look::Zoom(ZOOM * ZOOM, None));
            }
        });
    }
    use_effect_with((agent, Rc::clone(cast)), move |(agent, cast)| {
        let cast = Rc::clone(cast);
        let listening = clock.zip(*agent).map(|(clock, agent)| {
            clock.listen(move |time| {
                if let Some(pose) = cast.pose(agent, time) {
                    look.emit(Look::Middle(pose.at));
                }
            })
        });
        move || drop(listening)
    });
}
