//! A plan of one's own, for this browser only: who is led, since when each agent
//! is led (`-` for one that is not), and the plan, joined by `!`.

use std::rc::Rc;

use giveway_model::Plan;

use super::plan;
use crate::Answer;
use crate::steering::Steering;

/// The plan; `None` where a link cannot hold it.
pub(super) fn write(own: &Steering) -> Option<String> {
    let (led, from) = own.led();
    let since = |from: &Option<u32>| from.map_or_else(|| "-".to_owned(), |from| from.to_string());
    let from: Vec<String> = from.iter().map(since).collect();
    let plan = plan::write(own.about.draft.agents(), led)?;
    Some(format!("{}!{}!{plan}", own.agent, from.join(".")))
}

/// What a text tells of a plan that was made of an answer; `None` where it does
/// not fit that.
pub(super) fn read(about: &Rc<Answer>, text: &str) -> Option<Steering> {
    let (agent, rest) = text.split_once('!')?;
    let (from, led) = rest.split_once('!')?;
    let since = |from: &str| match from {
        "-" => Some(None),
        from => from.parse().ok().map(Some),
    };
    let from: Option<Vec<Option<u32>>> = from.split('.').map(since).collect();
    let led = plan::read(about.draft.agents(), led, Plan::default())?;
    Steering::kept(about, led, from?, agent.parse().ok()?)
}
