//! A plan of one's own, for this browser only: who is led, one more than the time
//! since when each agent is led (0 for one that is not), and the plan, joined by
//! `!`.

use std::fmt::Write as _;
use std::rc::Rc;

use giveway_model::Plan;

use super::plan;
use super::text::numbers;
use crate::Answer;
use crate::steering::Steering;

/// The plan; `None` where a link cannot hold it.
pub(super) fn write(own: &Steering) -> Option<String> {
    let (led, from) = own.led();
    let mut text = own.agent.to_string();
    let mut gap = '!';
    for from in from {
        let since = from.map_or(0, |from| from.saturating_add(1));
        // Writing to a string cannot fail.
        let _ = write!(text, "{gap}{since}");
        gap = '.';
    }
    text.push('!');
    text += &plan::write(own.about.draft.agents(), led)?;
    Some(text)
}

/// What a text tells of a plan that was made of an answer; `None` where it does
/// not fit that.
pub(super) fn read(about: &Rc<Answer>, text: &str) -> Option<Steering> {
    let (agent, rest) = text.split_once('!')?;
    let (from, led) = rest.split_once('!')?;
    let mut since = Vec::new();
    for from in numbers(from)? {
        since.push(from.checked_sub(1));
    }
    let led = plan::read(about.draft.agents(), led, Plan::default())?;
    Steering::kept(about, led, since, agent.parse().ok()?)
}
