//! What collisions and rules between agents ask of all agents at once.

use std::collections::BTreeSet;

use super::agent::{Mind, Where};
use super::scene::{Kind, RuleScene, Spot};

impl RuleScene {
    pub(super) fn orders(&self) -> impl Iterator<Item = ((usize, Spot), (usize, Spot))> {
        self.rules.iter().filter_map(|rule| match rule.kind {
            Kind::Before(first, second) => Some((first, second)),
            _ => None,
        })
    }

    pub(super) fn been(&self, minds: &[&Mind], before: &[bool]) -> Vec<bool> {
        let orders = self.orders().zip(before);
        orders
            .map(|((first, _), &been)| been || self.cell(first.0, minds[first.0]) == Some(first.1))
            .collect()
    }

    /// Whether agents may be where they are at a time; `been` of the time before.
    pub(super) fn may_be(&self, minds: &[&Mind], time: i64, been: &[bool]) -> bool {
        let cells: Vec<Option<Spot>> = minds
            .iter()
            .enumerate()
            .map(|(a, m)| self.cell(a, m))
            .collect();
        let held: Vec<Spot> = cells.iter().flatten().copied().collect();
        let apart: BTreeSet<Spot> = held.iter().copied().collect();
        let pairs = |agents: &[usize]| -> Vec<(usize, usize)> {
            let pair = |&a: &usize| agents.iter().map(move |&b| (a, b));
            agents
                .iter()
                .flat_map(pair)
                .filter(|(a, b)| a != b)
                .collect()
        };
        apart.len() == held.len()
            && self
                .rules
                .iter()
                .enumerate()
                .all(|(number, rule)| match &rule.kind {
                    Kind::Capacity(zone, most) if rule.is_about(time) => {
                        let counted = rule.agents.iter();
                        let counted = counted.filter(|&&a| !minds[a].uncounted.contains(&number));
                        let inside = counted.filter(|&&a| {
                            self.touches(a, minds[a])
                                .iter()
                                .any(|spot| zone.contains(spot))
                        });
                        inside.count() <= *most
                    }
                    Kind::Apart(distance) if rule.is_about(time) => {
                        pairs(&rule.agents).iter().all(|&(a, b)| {
                            self.touches(a, minds[a]).iter().all(|p| {
                                let others = self.touches(b, minds[b]);
                                others
                                    .iter()
                                    .all(|q| (p.0 - q.0).abs() + (p.1 - q.1).abs() >= *distance)
                            })
                        })
                    }
                    Kind::Gap(steps) => pairs(&rule.agents).iter().all(|&(a, b)| {
                        cells[b].is_none()
                            || !minds[a]
                                .past
                                .iter()
                                .take(*steps)
                                .any(|past| *past == cells[b])
                    }),
                    _ => true,
                })
            && self
                .orders()
                .zip(been)
                .all(|((_, second), &been)| been || cells[second.0] != Some(second.1))
    }

    /// Whether all have arrived, and may rest for ever.
    pub(super) fn is_over(&self, minds: &[Mind], time: i64) -> bool {
        let arrived = |mind: &Mind| matches!(mind.place, Where::Home | Where::Gone);
        if !minds.iter().all(arrived) {
            return false;
        }
        let mut rest = minds.to_vec();
        for mind in &mut rest {
            mind.past.clear();
        }
        let refs: Vec<&Mind> = rest.iter().collect();
        let orders = vec![true; self.orders().count()];
        self.vanish || (time + 1..=self.last + 1).all(|later| self.may_be(&refs, later, &orders))
    }
}
