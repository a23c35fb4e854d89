//! Where two agents collide whichever ways they take: both have only one place to be
//! at a time, and these two exclude each other.

use giveway_model::{Cell, sorting::sort_by_key};

use super::{MeetingKind, MustMeet, MustPass, ways::Ways};
use crate::{single::Place, terrain::Terrain};

/// Meetings, and the places that they follow from.
#[derive(Debug, Default)]
pub(super) struct Meetings {
    pub(super) meetings: Vec<MustMeet>,
    pub(super) passes: Vec<MustPass>,
}

/// An agent, by its name, and all its ways.
pub(super) type NamedWays<'a> = (&'a str, &'a Ways);

impl Meetings {
    /// The first meeting of each pair that has one.
    pub(super) fn of(agents: &[NamedWays], terrain: &Terrain) -> Self {
        let mut found = Self::default();
        for (i, &first) in agents.iter().enumerate() {
            for &second in &agents[i + 1..] {
                let pair = Pair {
                    agents: [first, second],
                    terrain,
                };
                // Later both rest.
                let last = first.1.by.max(second.1.by);
                let meeting = (0..=last).find_map(|time| pair.at(time));
                if let Some((meeting, passes)) = meeting {
                    found.meetings.push(meeting);
                    found.passes.extend(passes);
                }
            }
        }
        let place_in_order = |pass: &MustPass| {
            let mut names = agents.iter().map(|(name, _)| *name);
            (names.position(|name| name == pass.agent), pass.time)
        };
        sort_by_key(&mut found.passes, place_in_order);
        found.passes.dedup();
        found
    }
}

/// Two agents.
struct Pair<'a> {
    agents: [NamedWays<'a>; 2],
    terrain: &'a Terrain,
}

/// An arc that an agent has to go along.
#[derive(Clone, Copy)]
struct Crossing {
    arc: u32,
    /// When it sets out.
    from: u32,
    /// When it is at the other end.
    to: u32,
}

impl Pair<'_> {
    /// How they collide at a time, or in the step that begins then.
    fn at(&self, time: u32) -> Option<(MustMeet, Vec<MustPass>)> {
        self.at_vertex(time).or_else(|| self.at_edge(time))
    }

    fn at_vertex(&self, time: u32) -> Option<(MustMeet, Vec<MustPass>)> {
        let [a, b] = self.agents;
        let Place::At(v) = a.1.only_place(time)? else {
            return None;
        };
        if b.1.only_place(time)? != Place::At(v) {
            return None;
        }
        let cell = self.terrain.cell(v);
        let (first, second, kind) = match (a.1.rests(time), b.1.rests(time)) {
            (true, false) => (a, b, MeetingKind::Target { cell }),
            (false, true) => (b, a, MeetingKind::Target { cell }),
            _ => (a, b, MeetingKind::Vertex { cell }),
        };
        let passes = [a, b].map(|agent| {
            let since = if agent.1.rests(time) {
                agent.1.by
            } else {
                time
            };
            pass(agent, cell, since)
        });
        Some((meeting([first, second], time, kind), passes.into()))
    }

    fn at_edge(&self, time: u32) -> Option<(MustMeet, Vec<MustPass>)> {
        let [a, b] = self.agents;
        let first = self.crossing(a, time)?;
        let second = self.crossing(b, time)?;
        // The two arcs of an edge differ in the last bit.
        if first.arc != second.arc ^ 1 {
            return None;
        }
        let (from, to) = self.terrain.ends(first.arc);
        let edge = [self.terrain.cell(from), self.terrain.cell(to)];
        let passes = vec![
            pass(a, edge[0], first.from),
            pass(a, edge[1], first.to),
            pass(b, edge[1], second.from),
            pass(b, edge[0], second.to),
        ];
        let time = first.from.max(second.from);
        let kind = MeetingKind::Swap { edge };
        Some((meeting([a, b], time, kind), passes))
    }

    /// The arc that an agent goes along in the step from a time.
    fn crossing(&self, (_, ways): NamedWays, time: u32) -> Option<Crossing> {
        let slow = |arc, from| Crossing {
            arc,
            from,
            to: from + 2,
        };
        match (ways.only_place(time)?, ways.only_place(time + 1)?) {
            (_, Place::Along(arc)) => Some(slow(arc, time)),
            (Place::Along(arc), _) => Some(slow(arc, time.checked_sub(1)?)),
            (Place::At(u), Place::At(v)) => {
                let arc = self.terrain.arcs(u).iter().find(|arc| arc.to == v)?;
                Some(Crossing {
                    arc: arc.id,
                    from: time,
                    to: time + 1,
                })
            }
        }
    }
}

fn meeting(agents: [NamedWays; 2], time: u32, kind: MeetingKind) -> MustMeet {
    MustMeet {
        agents: agents.map(|(name, _)| name.to_owned()),
        time,
        kind,
    }
}

fn pass((agent, ways): NamedWays, cell: Cell, time: u32) -> MustPass {
    MustPass {
        agent: agent.to_owned(),
        cell,
        time,
        rests: ways.rests(time),
    }
}
