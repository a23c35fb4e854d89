//! Plans on a scene: their agents matched to those of the scene, their cells read by the
//! convention that fits.

use std::collections::BTreeMap;

use super::names::{self, Pairing};
use super::orders::Handled;
use super::scene::{Settled, another_map};
use super::{ForeignPlan, Refused};
use crate::decide::{self, Decision, Task};
use crate::{Conventions, Fit, Format, Heading, Source, WrittenPlan, place};
use giveway_model::compare::{Claimed, ClaimedBounds};
use giveway_model::{Instance, LeftOutRule, Plan, tr};

/// A plan by names, or one as a file writes it, with the text of the file.
pub(super) enum Body<'a> {
    Own(Plan, Vec<String>),
    Written(WrittenPlan, &'a str),
}

/// A plan with the name and the format of its file.
pub(super) struct Read<'a> {
    pub(super) file: String,
    pub(super) format: Format,
    pub(super) body: Body<'a>,
}

impl<'a> Read<'a> {
    pub(super) fn new(source: &Source<'a>, file: &str, format: Format, plan: WrittenPlan) -> Self {
        Self {
            file: file.to_owned(),
            format,
            body: Body::Written(plan, source.text),
        }
    }

    /// The rules of its problem that scenes do not have.
    pub(super) fn left_out(&self) -> &[LeftOutRule] {
        match &self.body {
            Body::Own(..) => &[],
            Body::Written(plan, _) => &plan.left_out,
        }
    }

    /// The goods that its agents handle on the way.
    pub(super) fn handled(&self) -> Handled<'_> {
        match &self.body {
            Body::Own(..) => Handled::default(),
            Body::Written(plan, _) => Handled::of(plan),
        }
    }

    /// Whether it has as many agents as a person asked for: a plan cannot be cut.
    ///
    /// # Errors
    /// When it has more or fewer.
    pub(super) fn has_agents(&self, asked: usize) -> Result<(), Refused> {
        let planned = match &self.body {
            Body::Own(plan, _) => plan.paths.len(),
            Body::Written(plan, _) => plan.agents.len(),
        };
        if planned == asked {
            return Ok(());
        }
        Err(Refused::Apart(tr!(
            "{file} has a plan for {planned}, and {asked} asked for. A plan cannot be cut: leave the number of robots out.",
            file = self.file,
            planned = tr!("{n} robot" | "{n} robots" % planned),
            asked = tr!("{n} robot is" | "{n} robots are" % asked)
        )))
    }

    /// The plan on the scene.
    ///
    /// # Errors
    /// When it has more agents than the scene.
    pub(super) fn on(
        self,
        settled: &Settled,
        chosen: Option<Conventions>,
    ) -> Result<ForeignPlan, Refused> {
        match self.body {
            Body::Own(plan, notes) => Ok(own(self.file, self.format, plan, notes)),
            Body::Written(plan, _) => written(self.file, self.format, &plan, settled, chosen),
        }
    }

    /// Its paths on an instance whose goals are not settled yet.
    ///
    /// # Errors
    /// When it has more agents than the scene.
    pub(super) fn paths(
        &self,
        instance: &Instance,
        chosen: Option<Conventions>,
    ) -> Result<Plan, Refused> {
        match &self.body {
            Body::Own(plan, _) => Ok(plan.clone()),
            Body::Written(plan, _) => {
                let file = (self.file.as_str(), self.format);
                let made = made(file, plan, instance, Tasks::Starts, chosen)?;
                Ok(made.plan)
            }
        }
    }
}

fn own(file: String, format: Format, plan: Plan, notes: Vec<String>) -> ForeignPlan {
    ForeignPlan {
        file,
        format,
        words: Vec::new(),
        conventions: Conventions::OWN,
        why: "There is only one way to read it.".to_owned(),
        alternatives: Vec::new(),
        fit: Fit::default(),
        claimed: Claimed::default(),
        written: every_step(&plan),
        headings: BTreeMap::new(),
        notes,
        plan,
        bounds: ClaimedBounds::default(),
    }
}

/// The costs of a plan whose agents never arrive before the end of their path.
fn every_step(plan: &Plan) -> Claimed {
    let steps = || {
        let paths = plan.paths.values();
        paths.map(|path| path.len().saturating_sub(1) as u64)
    };
    Claimed {
        makespan: steps().max(),
        sum_of_costs: Some(steps().sum()),
    }
}

/// The tasks as far as they are known, to decide how a plan is read.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Tasks {
    /// Nothing: they were taken from the plan itself.
    Unknown,
    /// Where agents start.
    Starts,
    /// Starts and goals.
    All,
}

/// The paths of a plan by the names of the scene.
struct Made {
    plan: Plan,
    headings: BTreeMap<String, Vec<Heading>>,
    decision: Decision,
    notes: Vec<String>,
}

/// Matches the agents by name; where they are numbered like `agent0` and their names do not
/// fit, by the number if that fits: the programs that write such names mean the order of
/// the scene.
fn made(
    (file, format): (&str, Format),
    plan: &WrittenPlan,
    instance: &Instance,
    tasks: Tasks,
    chosen: Option<Conventions>,
) -> Result<Made, Refused> {
    let agents = instance.agents();
    let pairing = names::pair((file, format), plan, agents)?;
    let decision = decided(plan, instance, &pairing, tasks, chosen);
    if !decision.fit.is_perfect()
        && let Some(by_number) = names::by_number(file, plan, agents)
    {
        let other = decided(plan, instance, &by_number, tasks, chosen);
        if other.fit.is_perfect() {
            return Ok(paths(plan, instance, by_number, other));
        }
    }
    Ok(paths(plan, instance, pairing, decision))
}

fn decided(
    plan: &WrittenPlan,
    instance: &Instance,
    pairing: &Pairing,
    tasks: Tasks,
    chosen: Option<Conventions>,
) -> Decision {
    let agents = instance.agents();
    let task = |index: &Option<usize>| -> Option<Task> {
        let agent = agents.get((*index)?)?;
        Some((agent.start, agent.goal.filter(|_| tasks == Tasks::All)))
    };
    let known: Vec<Option<Task>> = pairing.agents.iter().map(task).collect();
    let known = (tasks != Tasks::Unknown).then_some(&*known);
    decide::decide(plan, instance.grid(), known, chosen)
}

fn paths(plan: &WrittenPlan, instance: &Instance, pairing: Pairing, decision: Decision) -> Made {
    let agents = instance.agents();
    let mut made = Plan::default();
    let mut headings = BTreeMap::new();
    for (index, (walking, paired)) in plan.agents.iter().zip(&pairing.agents).enumerate() {
        let agent = paired.and_then(|index| agents.get(index));
        let start = agent.map(|agent| agent.start);
        let (path, looks) = place::path(walking, start, decision.conventions);
        let name = match agent {
            Some(agent) => agent.name.clone(),
            None if path.is_empty() || names::is_still(walking) => continue,
            None => decide::name(walking, index),
        };
        headings.extend(looks.map(|looks| (name.clone(), looks)));
        made.paths.insert(name, path);
    }
    for agent in pairing.idle.iter().filter_map(|&index| agents.get(index)) {
        made.paths
            .insert(agent.name.clone(), vec![Some(agent.start)]);
    }
    Made {
        plan: made,
        headings,
        decision,
        notes: pairing.notes,
    }
}

/// The remark that waits at the goal are left out: they are no part of a path where robots leave the map at
/// their goals.
fn cut(before: &Plan, after: &Plan, instance: &Instance) -> Option<String> {
    if instance.stays() {
        return None;
    }
    let names = instance.agents().iter().map(|agent| &agent.name);
    let cut = names.filter(|name| before.path(name).len() > after.path(name).len());
    let n = cut.count();
    (n > 0).then(|| {
        tr!(
            "Waits at the goal at the end of {n} path are left out, since robots leave the map at their goals."
                | "Waits at the goal at the end of {n} paths are left out, since robots leave the map at their goals." % n
        )
    })
}

fn written(
    file: String,
    format: Format,
    plan: &WrittenPlan,
    settled: &Settled,
    chosen: Option<Conventions>,
) -> Result<ForeignPlan, Refused> {
    let tasks = if settled.tasks_of.as_ref() == Some(&file) {
        Tasks::Unknown
    } else {
        Tasks::All
    };
    let made = made((&file, format), plan, &settled.instance, tasks, chosen)?;
    let Made {
        plan: mut paths,
        headings,
        decision,
        mut notes,
    } = made;
    let every_step = every_step(&paths);
    let uncut = paths.clone();
    paths.cut_trailing_goals(&settled.instance);
    notes.extend(cut(&uncut, &paths, &settled.instance));
    let words = decision.conventions.words(plan).into_iter();
    notes.extend(plan.notes.iter().cloned());
    let map_file = settled.map_file.as_deref();
    notes.extend(map_file.and_then(|map_file| another_map(&file, plan.map.as_deref(), map_file)));
    Ok(ForeignPlan {
        file,
        format,
        words: words.map(|(about, how)| (about.to_owned(), how)).collect(),
        conventions: decision.conventions,
        why: decision.why,
        alternatives: decision.alternatives,
        fit: decision.fit,
        claimed: plan.claimed,
        written: every_step,
        headings,
        notes,
        plan: paths,
        bounds: plan.bounds,
    })
}
