//! The camera goes with an agent, until a person looks elsewhere; and to what is
//! looked for.

use std::rc::Rc;

use giveway_page::board::Cast;
use giveway_page::{Action, Sought, ViewAction};
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

/// Changes what is in sight as a person wants it: the camera goes with nobody then.
#[hook]
pub(super) fn use_by_hand(
    followed: Option<usize>,
    look: &Callback<Look>,
    send: &Callback<Action>,
) -> Callback<Look> {
    let deps = (followed.is_some(), look.clone(), send.clone());
    use_callback(deps, |wanted: Look, (follows, look, send)| {
        let goes_elsewhere = !matches!(wanted, Look::Zoom(..) | Look::Pinch(..));
        if *follows && goes_elsewhere {
            send.emit(Action::View(ViewAction::Follow(false)));
        }
        look.emit(wanted);
    })
}

/// Brings what was looked for into view.
#[hook]
pub(super) fn use_sought(sought: Option<Sought>, look: &Callback<Look>) {
    let look = look.clone();
    let first = use_memo((), |()| sought);
    use_effect_with(sought, move |&sought| {
        // What was looked for before the board was there has been seen.
        if let Some(wanted) = sought.filter(|_| sought != *first) {
            look.emit(Look::Find(wanted.cell));
        }
    });
}
