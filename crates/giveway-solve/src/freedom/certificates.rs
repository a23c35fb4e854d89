//! Certificates of what is claimed of all best plans, each by itself.
//!
//! A visit of the backbone is the contrast of a question turned round: no plan as good is without it. "Must
//! it pass here?" is answered where no best plan meets "it is never here", so each such claim can be shown by
//! a proof of a plain formula.

use std::collections::BTreeMap;

use giveway_model::condition::{Act, Times};
use giveway_model::{Cell, Condition, Cost, Instance, sorting::map};
use giveway_proof::Claim;

use super::{Closed, CriticalCell, FreedomAnswer, Known, Visit, critical::scene_without};
use crate::{Certificate, CertifyRequest, Status};

impl FreedomAnswer {
    /// All that is claimed and can be certified: that the plan is a best one, what
    /// every best plan has, and what closing cells costs at least. The instance has
    /// the objective of the answer.
    pub fn certificates(&self, instance: &Instance) -> Vec<Certificate> {
        let best = matches!(self.status, Status::Optimal | Status::Impossible);
        let best = best.then(|| Certificate {
            name: "best".to_owned(),
            request: self.of_best(instance),
        });
        let closed = self.critical.iter().flatten();
        let closed = closed.filter_map(|it| self.of_closed(instance, it));
        let visits = self.of_visits(instance, |_, _| true);
        best.into_iter().chain(visits).chain(closed).collect()
    }

    /// All that is claimed of an agent and can be certified: where it must be.
    pub fn certificates_of_agent<'a>(
        &'a self,
        instance: &'a Instance,
        agent: &'a str,
    ) -> impl Iterator<Item = Certificate> + 'a {
        self.of_visits(instance, move |name, _| name == agent)
    }

    /// All that is claimed of a cell and can be certified: who must be there, what
    /// closing it costs at least.
    pub fn certificates_of_cell<'a>(
        &'a self,
        instance: &'a Instance,
        cell: Cell,
    ) -> impl Iterator<Item = Certificate> + 'a {
        let closed = self.critical.iter().flatten();
        let closed = closed.filter(move |it| it.cell == cell);
        let closed = closed.filter_map(|it| self.of_closed(instance, it));
        let visits = self.of_visits(instance, move |_, visit| visit.cell == Some(cell));
        visits.chain(closed)
    }

    /// The claims of the backbone, for some visits of some agents.
    fn of_visits<'a>(
        &'a self,
        instance: &'a Instance,
        wanted: impl Fn(&str, &Visit) -> bool + 'a,
    ) -> impl Iterator<Item = Certificate> + 'a {
        let agents = (1..).zip(instance.agents());
        let visits = agents.flat_map(|(number, agent)| {
            let visits = self.backbone.iter();
            let visits = visits.filter_map(|backbone| backbone.get(&agent.name));
            visits.flatten().map(move |visit| (number, agent, visit))
        });
        let visits = visits.filter(move |(_, agent, visit)| wanted(&agent.name, visit));
        visits.flat_map(move |(number, agent, visit)| {
            let excluded = excluded(visit).into_iter();
            excluded.map(move |(what, act)| Certificate {
                name: format!("robot-{number}-{what}-{}", visit.time),
                request: self.of_backbone(
                    instance,
                    Condition::Never {
                        agent: agent.name.clone(),
                        act,
                        times: Times::at(Some(visit.time)),
                    },
                ),
            })
        })
    }

    /// The claim that no plan is better than this one, or that there is none.
    fn of_best(&self, instance: &Instance) -> CertifyRequest {
        CertifyRequest {
            scene: instance.to_scene(),
            bounds: self.best(),
            impossible: self.status == Status::Impossible,
            complete: self.reach.is_complete(),
            within: self.reach.within(),
            plan: self.plan.clone(),
            ..CertifyRequest::default()
        }
    }

    /// The claim that no plan as good meets a condition.
    fn of_backbone(&self, instance: &Instance, condition: Condition) -> CertifyRequest {
        CertifyRequest {
            scene: instance.to_scene(),
            about: Claim {
                most: self.best(),
                condition: Some(condition),
                ..Claim::default()
            },
            impossible: true,
            complete: self.reach.is_complete(),
            within: self.reach.within(),
            ..CertifyRequest::default()
        }
    }

    /// The claim that without a cell no plan costs less than is said, or there is none. `None` where nothing
    /// is lost, as the plan of the whole scene shows it, or where an agent needs this very cell, so that no
    /// scene is left.
    fn of_closed(&self, instance: &Instance, it: &CriticalCell) -> Option<Certificate> {
        let (bounds, impossible, reach) = match &it.closed {
            Closed::Optimal { costs, reach, .. } if !it.closed.is_harmless() => {
                let costs = self.objective.costs().iter().map(|&c| (c, costs.get(c)));
                (map(costs), false, *reach)
            }
            Closed::Impossible {
                needed: None,
                reach,
            } => (BTreeMap::new(), true, *reach),
            _ => return None,
        };
        let mut scene = scene_without(&instance.to_scene(), it.cell)?;
        let name = format!("{} without {}", instance.name(), it.cell);
        name.trim().clone_into(&mut scene.name);
        let request = CertifyRequest {
            scene,
            bounds,
            impossible,
            complete: reach.is_complete(),
            within: reach.within(),
            ..CertifyRequest::default()
        };
        Some(Certificate {
            name: format!("without-{}-{}", it.cell.x, it.cell.y),
            request,
        })
    }

    fn best(&self) -> BTreeMap<Cost, u32> {
        let each = self.objective.costs().iter();
        map(each.filter_map(|&cost| Some((cost, self.costs?.get(cost)))))
    }
}

/// The acts that no best plan avoids. An agent's transit follows from its cells before and after; its start
/// is no choice.
fn excluded(visit: &Visit) -> Vec<(&'static str, Act)> {
    let mut excluded = Vec::new();
    let Some(at) = visit.cell else {
        return excluded;
    };
    if visit.always == Known::Yes && visit.time > 0 {
        excluded.push(("at", Act::Visit(at)));
    }
    if visit.charge.is_some_and(|it| it.always == Known::Yes) {
        excluded.push(("charges", Act::Charge(Some(at))));
    }
    excluded
}
