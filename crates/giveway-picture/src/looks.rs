//! Which look each agent has: its form, and the colour that comes with it. It is the
//! agent's own, and stays when another agent is removed.

use borsh::{BorshDeserialize, BorshSerialize};
use giveway_model::Agent;

use crate::form::LOOKS;

/// The looks of agents, by their index in a scene. Without any other word agents have the
/// looks in their order, and begin again after the last one.
///
/// ```
/// use giveway_picture::Looks;
/// assert_eq!(Looks::default().all(3), [0, 1, 2]);
/// // The second of three was removed; one that comes gets the look that is free.
/// let looks = Looks::from_numbers(vec![0, 2]);
/// assert_eq!(looks.all(3), [0, 2, 1]);
/// ```
#[derive(Clone, Debug, Default, PartialEq, Eq, BorshSerialize, BorshDeserialize)]
pub struct Looks(Vec<u8>);

impl Looks {
    /// The looks of so many agents. One of which nothing is known has the first of those
    /// that the fewest others have.
    pub fn all(&self, agents: usize) -> Vec<usize> {
        let mut all: Vec<usize> = self.0.iter().map(|&look| usize::from(look)).collect();
        all.truncate(agents);
        let mut counts = [0_u32; LOOKS];
        for &look in &all {
            counts[look % LOOKS] += 1;
        }
        while all.len() < agents {
            let look = rarest(&counts);
            counts[look] += 1;
            all.push(look);
        }
        all
    }

    /// The look of one of them.
    pub fn of(&self, agent: usize) -> usize {
        if self.0.is_empty() {
            return agent % LOOKS;
        }
        self.all(agent + 1).pop().unwrap_or(0)
    }

    /// The looks after some agents became others: one of the same name keeps its look, and
    /// so does one that was renamed in its place.
    #[must_use]
    pub fn after(&self, old: &[Agent], new: &[Agent]) -> Self {
        let looks = self.all(old.len());
        let is_in = |agents: &[Agent], name: &str| agents.iter().any(|agent| agent.name == name);
        let known = |(index, agent): (usize, &Agent)| {
            let same = old.iter().position(|other| other.name == agent.name);
            let renamed = || {
                let before = old.get(index).filter(|_| old.len() == new.len())?;
                (!is_in(new, &before.name)).then_some(index)
            };
            looks.get(same.or_else(renamed)?).copied()
        };
        let known: Vec<Option<usize>> = new.iter().enumerate().map(known).collect();
        let mut counts = [0_u32; LOOKS];
        for &look in known.iter().flatten() {
            counts[look % LOOKS] += 1;
        }
        let all = known.into_iter().map(|known| {
            known.unwrap_or_else(|| {
                let look = rarest(&counts);
                counts[look] += 1;
                look
            })
        });
        Self::from_numbers(all.map(|look| look as u8).collect())
    }

    /// All that are known, in the order of the agents; none where agents have them in
    /// their order.
    pub fn numbers(&self) -> &[u8] {
        &self.0
    }

    /// What [`Looks::numbers`] gave; a look that does not exist is one that many before.
    pub fn from_numbers(mut numbers: Vec<u8>) -> Self {
        for look in &mut numbers {
            *look %= LOOKS as u8;
        }
        let mut all = numbers.iter().enumerate();
        if all.all(|(index, &look)| usize::from(look) == index % LOOKS) {
            numbers.clear();
        }
        Self(numbers)
    }
}

/// The first of the looks that the fewest agents have.
fn rarest(counts: &[u32; LOOKS]) -> usize {
    let looks = counts.iter().enumerate();
    looks
        .min_by_key(|&(_, count)| *count)
        .map_or(0, |(look, _)| look)
}

#[cfg(test)]
mod tests {
    use giveway_model::Cell;

    use super::*;

    fn agents(names: &str) -> Vec<Agent> {
        let agent = |name: char| Agent {
            name: name.to_string(),
            start: Cell::new(0, 0),
            goal: None,
            waypoints: Vec::new(),
            battery: None,
            heading: None,
        };
        names.chars().map(agent).collect()
    }

    fn looks(names: &[&str]) -> Vec<usize> {
        let mut looks = Looks::default();
        for pair in names.windows(2) {
            looks = looks.after(&agents(pair[0]), &agents(pair[1]));
        }
        looks.all(names.last().unwrap().len())
    }

    #[test]
    fn a_robot_keeps_its_look() {
        assert_eq!(looks(&["abc", "ac"]), [0, 2], "another one was removed");
        assert_eq!(looks(&["abc", "ac", "acd"]), [0, 2, 1], "one came");
        assert_eq!(looks(&["abc", "axc"]), [0, 1, 2], "renamed");
        assert_eq!(looks(&["abc", "cab"]), [2, 0, 1], "another order");
        assert_eq!(looks(&["abc", "bc", "xc", "c"]), [2]);
    }

    #[test]
    fn in_their_order_they_are_not_written() {
        let all = Looks::default().after(&agents("ab"), &agents("abc"));
        assert_eq!(all, Looks::default());
        assert_eq!(Looks::default().all(50)[47..], [47, 0, 1]);
        assert_eq!(Looks::default().of(49), 1);
        assert_eq!(Looks::from_numbers(vec![0, 50]).all(2), [0, 2]);
    }
}
