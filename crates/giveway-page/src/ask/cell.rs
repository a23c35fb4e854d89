//! Questions about a cell: why is it passed, or why not?

use giveway_model::{Cell, Ground, Question, tr};

use super::{About, Group, Offer};
use crate::Answer;
use crate::timeline::Lane;
use crate::words::at;

/// The most agents that are asked about a charger.
const AGENTS: usize = 3;

/// The questions; first whether `asker` passes, the agent that was selected before the cell.
pub(super) fn groups(answer: &Answer, cell: Cell, asker: Option<usize>) -> Vec<Group> {
    let grid = answer.draft.grid();
    let ground = grid.ground(cell);
    if ground.is_none() || ground == Some(Ground::Obstacle) {
        return Vec::new();
    }
    let lanes = (0..answer.draft.agents().len()).filter_map(|agent| Lane::of(answer, agent));
    let passes = |lane: &Lane| lane.entry == cell || lane.steps.iter().any(|s| s.to == cell);
    let mut offers: Vec<Offer> = Vec::new();
    let own = asker.and_then(|agent| Lane::of(answer, agent));
    if let Some(lane) = own.filter(|lane| !passes(lane)) {
        let agent = Some(lane.name);
        offers.push(Offer::new(
            "question",
            Question::NoVisit { agent, at: cell },
        ));
    }
    let mut nobody = true;
    let mut visits: Vec<(bool, Offer)> = Vec::new();
    for lane in lanes {
        if passes(&lane) {
            nobody = false;
            let visit = Question::Visit {
                agent: lane.name.clone(),
                at: cell,
                time: None,
            };
            let given = answer.draft.agents().get(lane.agent);
            // It must, and a question would only say so.
            let must = given.is_some_and(|agent| {
                agent.start == cell || agent.goal == Some(cell) || agent.waypoints.contains(&cell)
            });
            if !must {
                visits.push((asker != Some(lane.agent), Offer::new("question", visit)));
            }
        }
    }
    // That of the agent that was selected comes first.
    visits.sort_by_key(|visit| visit.0);
    offers.extend(visits.into_iter().map(|visit| visit.1));
    if nobody {
        offers.push(Offer::new(
            "question",
            Question::NoVisit {
                agent: None,
                at: cell,
            },
        ));
    }
    if grid.is_charger(cell) {
        let agents = answer.draft.agents().iter().enumerate();
        let mut batteries: Vec<_> = agents.filter(|(_, a)| a.battery.is_some()).collect();
        batteries.sort_by_key(|(agent, _)| asker != Some(*agent));
        let asks = batteries.into_iter().map(|(_, agent)| Question::NoCharge {
            agent: agent.name.clone(),
            at: cell,
        });
        offers.extend(asks.take(AGENTS).map(|ask| Offer::new("charger", ask)));
    }
    vec![Group {
        title: tr!("Ask about {cell}", cell = at(cell)),
        offers,
        about: About::Selected,
    }]
}
