//! Goals and waypoints: a flag or a star with the agent's name.

use std::fmt::Write;

use giveway_model::{Agent, Cell};

use giveway_model::sorting::sort_by_key;

use crate::Track;
use crate::form::{badges, short_name};

/// A goal or a waypoint.
#[derive(Clone, Debug, PartialEq)]
pub struct Mark {
    /// Which.
    pub kind: MarkKind,
    /// Of which agent, by its index in the scene.
    pub agent: usize,
    /// Where.
    pub cell: Cell,
    /// How far it makes way for others on its cell, in units.
    pub shift: (f64, f64),
    /// Its number among those of its kind on its cell, from 0.
    pub place: usize,
    /// The names written at it; `None` where another mark of the cell has them.
    pub label: Option<String>,
    /// When it is first visited; `None` if never.
    pub visited: Option<u32>,
}

/// Goal or waypoint.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum MarkKind {
    /// A flag.
    Goal,
    /// A star.
    Waypoint,
}

/// From mark to mark where several are on one cell, in units.
const APART: f64 = 18.0;
/// The most names that are written at one place.
const NAMES: usize = 2;
/// The letters of a name that is written whole.
const WIDEST: usize = 6;

/// The marks of some agents, with what they do.
pub fn marks(agents: &[Agent], tracks: &[Track]) -> Vec<Mark> {
    let names: Vec<&str> = agents.iter().map(|agent| agent.name.as_str()).collect();
    marks_with(agents, tracks, &badges(&names, |_| true))
}

/// The same where something else stands on the form of each agent: `badges`.
pub fn marks_with(agents: &[Agent], tracks: &[Track], badges: &[String]) -> Vec<Mark> {
    let mut marks = Vec::new();
    for (index, agent) in agents.iter().enumerate() {
        let mut mark = |kind, cell| {
            let path = tracks.get(index).map_or(&[][..], Track::path);
            let visited = path.iter().position(|&at| at == Some(cell));
            marks.push(Mark {
                kind,
                agent: index,
                cell,
                shift: (0.0, 0.0),
                place: 0,
                label: None,
                visited: visited.map(|time| time as u32),
            });
        };
        if let Some(goal) = agent.goal {
            mark(MarkKind::Goal, goal);
        }
        for &cell in &agent.waypoints {
            mark(MarkKind::Waypoint, cell);
        }
    }
    // By cell, so that those on the same one stand together; it also keeps the
    // order of drawing from depending on the order of the agents.
    sort_by_key(&mut marks, |mark| {
        (mark.cell.y, mark.cell.x, mark.kind, mark.agent)
    });
    for cell in marks.chunk_by_mut(|a, b| a.cell == b.cell) {
        let goals = cell.partition_point(|mark| mark.kind == MarkKind::Goal);
        let (goals, waypoints) = cell.split_at_mut(goals);
        arrange(goals, agents, badges, |place, _| (-APART * place, 0.0));
        let aside = if goals.is_empty() {
            (0.0, 0.0)
        } else {
            (-12.0, 10.0)
        };
        arrange(waypoints, agents, badges, |place, count| {
            (APART * (place - (count - 1.0) / 2.0) + aside.0, aside.1)
        });
    }
    marks
}

/// Places marks of one kind on one cell: the place of each from its number and
/// their count.
fn arrange(
    marks: &mut [Mark],
    agents: &[Agent],
    badges: &[String],
    shift: impl Fn(f64, f64) -> (f64, f64),
) {
    let count = marks.len();
    let names: Vec<String> = marks
        .iter()
        .map(|mark| label_of(&agents[mark.agent].name, &badges[mark.agent]))
        .collect();
    let mut label = names[..names.len().min(NAMES)].join(" ");
    if names.len() > NAMES {
        // Writing to a string cannot fail.
        let _ = write!(label, " +{}", names.len() - NAMES);
    }
    for (place, mark) in marks.iter_mut().enumerate() {
        mark.shift = shift(place as f64, count as f64);
        mark.place = place;
        mark.label = (place + 1 == count).then(|| std::mem::take(&mut label));
    }
}

/// A name beside a mark: whole where it is about as wide as a cell, else as it stands on
/// the form.
fn label_of(name: &str, badge: &str) -> String {
    // A number that stands for a name stands for it here, too.
    if name.chars().count() <= WIDEST && short_name(name) == badge {
        name.to_owned()
    } else {
        badge.to_owned()
    }
}

#[cfg(test)]
mod tests {
    use giveway_model::AtGoal;

    use super::*;

    fn agent(name: &str, goal: (u32, u32), waypoints: &[(u32, u32)]) -> Agent {
        Agent {
            name: name.to_owned(),
            start: Cell::new(0, 0),
            goal: Some(goal.into()),
            waypoints: waypoints.iter().map(|&cell| cell.into()).collect(),
            battery: None,
            heading: None,
        }
    }

    #[test]
    fn a_waypoint_is_visited_when_the_agent_first_comes_there() {
        let path = [(0, 0), (1, 0), (0, 0)].map(|cell| Some(Cell::from(cell)));
        let track = Track::new(path.to_vec(), Vec::new(), None, AtGoal::Stay);
        let agents = [agent("A", (0, 0), &[(1, 0), (2, 0)])];
        let marks = marks(&agents, &[track]);
        let visited: Vec<_> = marks.iter().map(|mark| (mark.kind, mark.visited)).collect();
        let waypoint = MarkKind::Waypoint;
        assert_eq!(
            visited,
            [
                (MarkKind::Goal, Some(0)),
                (waypoint, Some(1)),
                (waypoint, None)
            ]
        );
    }

    #[test]
    fn marks_of_one_cell_make_way_and_share_a_label() {
        let agents = ["A", "B", "C"].map(|name| agent(name, (5, 5), &[(5, 5)]));
        let marks = marks(&agents, &[]);
        let stars = &marks[3..];
        assert_eq!(marks[2].label.as_deref(), Some("A B +1"));
        assert_eq!([&marks[0].label, &marks[1].label], [&None, &None]);
        let shifts: Vec<_> = stars.iter().map(|mark| mark.shift).collect();
        assert_eq!(shifts, [(-30.0, 10.0), (-12.0, 10.0), (6.0, 10.0)]);
        assert!(stars.iter().map(|mark| mark.place).eq(0..3));
    }

    #[test]
    fn a_long_name_is_as_short_as_on_the_form() {
        let marks = marks(&[agent("carrier 12", (1, 0), &[])], &[]);
        assert_eq!(marks[0].label.as_deref(), Some("c12"));
    }

    #[test]
    fn one_alone_stands_where_it_should() {
        let marks = marks(&[agent("A", (1, 0), &[(2, 0)])], &[]);
        assert!(marks.iter().all(|mark| mark.shift == (0.0, 0.0)));
        assert!(marks.iter().all(|mark| mark.label.as_deref() == Some("A")));
    }
}
