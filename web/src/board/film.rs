//! A small board with its plan, as the course shows it beside a title.

use std::rc::Rc;

use giveway_course::lesson::Picture;
use giveway_model::check::{Rule, check};
use giveway_model::{Instance, Plan};
use giveway_page::Draft;
use giveway_page::board::{ConflictPlace, Mark, Track, Way, marks};

/// The most robots whose ways are drawn on a small board.
const MOST_WAYS: usize = 8;

/// A scene and its plan, ready to be drawn at any time.
pub(crate) struct Film {
    pub(super) draft: Rc<Draft>,
    pub(super) tracks: Vec<Track>,
    /// None where there are too many robots.
    pub(super) ways: Vec<Way>,
    pub(super) marks: Vec<Mark>,
    /// The time that is shown as long as nothing moves.
    pub(super) time: u32,
    /// The last time of the plan.
    pub(super) last: u32,
    /// The first conflict of two robots: when, and where.
    pub(super) conflict: Option<(u32, ConflictPlace)>,
}

impl Film {
    /// The film of a picture; `None` where its scene cannot be drawn.
    pub(crate) fn of(picture: &Picture) -> Option<Rc<Self>> {
        let draft = Rc::new(Draft::new(picture.scene.clone()).ok()?);
        let plan = picture.plan.as_ref();
        let agents = draft.agents();
        let track = |agent: &giveway_model::Agent| {
            let path = plan.map_or(&[][..], |plan| plan.path(&agent.name));
            let mut path = path.to_vec();
            if path.is_empty() {
                path.push(Some(agent.start));
            }
            let charges = plan.map_or(&[][..], |plan| plan.charges(&agent.name));
            let at_end = picture.scene.rules.at_end_of(agent);
            Track::new(path, charges.to_vec(), None, at_end)
        };
        let tracks: Vec<Track> = agents.iter().map(track).collect();
        let ways = if tracks.len() <= MOST_WAYS {
            Way::of_all(&tracks)
        } else {
            Vec::new()
        };
        let last = tracks.iter().map(Track::arrival).max().unwrap_or(0);
        Some(Rc::new(Self {
            marks: marks(agents, &tracks),
            conflict: plan.and_then(|plan| conflict(&picture.scene, plan)),
            time: picture.time,
            last,
            tracks,
            ways,
            draft,
        }))
    }
}

fn conflict(scene: &giveway_model::Scene, plan: &Plan) -> Option<(u32, ConflictPlace)> {
    let instance = Instance::new(scene.clone()).ok()?;
    let violations = check(&instance, plan).violations;
    let mut conflicts = violations.iter();
    let first = conflicts
        .find(|violation| matches!(violation.rule, Rule::Vertex | Rule::Swap | Rule::SlowSwap))?;
    let cell = first.cell.map(ConflictPlace::Cell);
    let place = cell.or_else(|| first.edge.map(ConflictPlace::Edge))?;
    Some((first.time, place))
}
