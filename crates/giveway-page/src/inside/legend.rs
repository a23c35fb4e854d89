//! What the signs on the board mean while one looks into how the plan was found.

use giveway_model::tr;

use super::{Method, Overlay};
use crate::State;

/// A sign and its meaning.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Sign {
    /// The class of its picture.
    pub class: &'static str,
    /// Whose colours it has, by the index of the robot.
    pub agent: Option<usize>,
    /// What it means.
    pub words: String,
}

/// The signs of what is drawn; `None` where the legend is that of the plan.
pub fn legend(state: &State, overlay: &Overlay) -> Option<Vec<Sign>> {
    if !state.is_inside() {
        return None;
    }
    let sign = |class, words: &str| Sign {
        class,
        agent: None,
        words: words.to_owned(),
    };
    let mut signs = Vec::new();
    for (index, shade) in overlay.shades.iter().take(2).enumerate() {
        let agents = state.document.agents();
        let name = agents
            .get(shade.agent)
            .map_or("", |agent| agent.name.as_str());
        signs.push(Sign {
            class: "k-reach",
            agent: Some(shade.agent),
            words: if index == 0 {
                tr!("Cells where {name} is still on time", name)
            } else {
                tr!("The same for {name}", name)
            },
        });
    }
    if !overlay.meetings.is_empty() {
        signs.push(sign("k-meet", tr!("They meet here")));
    }
    if overlay.bans.iter().any(|ban| !ban.is_asked) {
        signs.push(sign("k-ban", tr!("Not at this time")));
    }
    if overlay.bans.iter().any(|ban| ban.is_asked) {
        let words = match state.inside.method {
            Method::Proof | Method::Tree | Method::Orders => tr!("At this time, and nobody else"),
            Method::Pibt => tr!("It pushes the robot that stands there"),
            Method::Lacam => tr!("It has to go there, or pushes who stands there"),
        };
        signs.push(sign("k-asked", words));
    }
    if !overlay.bursts.is_empty() {
        signs.push(sign("k-burst", tr!("Conflict of this node")));
    }
    if overlay.stuck.is_some() {
        signs.push(sign("k-stuck", tr!("No way on")));
    }
    signs.push(sign("k-goal", tr!("Goal")));
    if state.inside.method != Method::Proof {
        signs.push(sign("k-ahead", tr!("Way ahead")));
    }
    Some(signs)
}
