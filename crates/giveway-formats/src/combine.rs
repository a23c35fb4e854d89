//! Files that belong together: a map, tasks and plans made one scene with its plans.

mod from_plan;
mod league;
mod missing;
mod names;
mod open;
mod orders;
mod origin;
mod outcome;
mod plan;
mod scenario;
mod scene;
mod turns;

use super::{Conventions, Format, Held, OpenGoals, Source, recognise};
use giveway_model::format::{base_name, stem};
use giveway_model::{Assumption, AtGoal, Instance, LeftOutRule, assumption, tr};
pub use outcome::{Combined, ForeignPlan, Missing, Refused};
use plan::{Body, Read};
use scene::{Base, Settled};

/// The choices of a person.
#[derive(Clone, Copy, Debug, Default)]
pub struct Options {
    /// How plans are to be read, instead of what fits best.
    pub conventions: Option<Conventions>,
    /// Only the first agents of a scenario, where no plan says how many there are.
    pub agents: Option<usize>,
    /// The rule for agents at their goals, instead of the one of the files.
    pub at_goal: Option<AtGoal>,
    /// The level below which no battery may fall, instead of what the files say.
    pub battery_floor: Option<u32>,
}

/// Matches files to each other.
///
/// # Errors
/// When one of them is wrong, when another is missing, or when they hold more
/// than one scene.
pub fn combine(sources: &[Source<'_>], options: &Options) -> Result<Combined, Refused> {
    let mut base = Base::default();
    let mut plans: Vec<Read<'_>> = Vec::new();
    let mut map_notes = Vec::new();
    let mut without_plan = Vec::new();
    let joined = league::join(sources)?;
    let taken = joined.as_ref().map_or(&[][..], |joined| &joined.taken);
    let others = sources.iter().enumerate();
    for (_, source) in others.filter(|(i, _)| !taken.contains(i)) {
        let file = base_name(source.name).to_owned();
        let (format, held) = recognise::read(source.text).map_err(|faults| Refused::File {
            file: file.clone(),
            faults,
        })?;
        match held {
            Held::Map(grid, notes) => {
                map_notes.extend(notes);
                base.take_map(file, grid)?;
            }
            Held::Scenario(scenario) => base.take_scenario(file, scenario)?,
            Held::Scene(mut scene, remarks) => {
                if matches!(format, Format::ClassProject | Format::Grid) {
                    stem(&file).clone_into(&mut scene.name);
                }
                base.take_scene((file, format), scene, remarks)?;
            }
            // The first problem was joined with its files above.
            Held::Problem(_) => {
                return Err(Refused::Apart(tr!(
                    "Open one scene at a time: {file} is a second problem.",
                    file
                )));
            }
            Held::OwnPlan(plan, notes) => plans.push(Read {
                file,
                format,
                body: Body::Own(plan, notes),
            }),
            Held::Changes(_) => {
                return Err(Refused::Apart(tr!(
                    "{file} is a list of changes. On the page it opens together with its scene and plan; the command takes it with check --changes, explain --changes and change.",
                    file
                )));
            }
            Held::NoPlan(sentence) => without_plan.push(format!("{file}: {sentence}")),
            Held::Asked(_) => {
                return Err(Refused::Apart(tr!(
                    "{file} is the answer to a question, and has no plan.",
                    file
                )));
            }
            Held::Plan(plan) => plans.push(Read::new(source, &file, format, plan)),
            Held::Both(scene, remarks, plan) => {
                plans.push(Read::new(source, &file, format, plan));
                base.take_scene((file, format), scene, remarks)?;
            }
        }
    }
    if let Some(league::Joined {
        file,
        scene: Some((mut scene, notes)),
        ..
    }) = joined
    {
        stem(&file).clone_into(&mut scene.name);
        base.take_scene((file, Format::League), scene, notes.into())?;
    }
    let first = plans.iter().find_map(|read| match &read.body {
        Body::Own(..) => None,
        Body::Written(plan, text) => Some(scene::First {
            file: &read.file,
            format: read.format,
            text,
            plan,
        }),
    });
    if let (Some(asked), Some(read)) = (options.agents, plans.first()) {
        read.has_agents(asked)?;
    }
    has_scene(&base, &without_plan)?;
    let mut settled = base.settle(first, options)?;
    decide_goals(&mut settled, plans.first(), options)?;
    settled.instance = settled.instance.assuming(left_out(&plans));
    let plans = plans.into_iter();
    let plans = plans.map(|plan| plan.on(&settled, options.conventions));
    let plans = plans.collect::<Result<Vec<ForeignPlan>, Refused>>()?;
    let instance = turns::settle(settled.instance, &plans);
    let mut notes = map_notes;
    notes.extend(without_plan);
    notes.extend(settled.remarks.notes);
    notes.extend(assumption::sentences(instance.assumptions()));
    Ok(Combined {
        instance,
        plans,
        notes,
    })
}

/// Refuses results without a plan that have no scene beside them.
fn has_scene(base: &Base, without_plan: &[String]) -> Result<(), Refused> {
    match without_plan.first() {
        Some(sentence) if base.is_empty() => Err(Refused::Apart(sentence.clone())),
        _ => Ok(()),
    }
}

/// The rules of the plans' problems that scenes do not have.
fn left_out(plans: &[Read<'_>]) -> Vec<Assumption> {
    let rules = plans.iter().flat_map(Read::left_out);
    let left_out = rules.map(|&rule| Assumption::RuleLeftOut { rule });
    left_out.collect()
}

/// Lets the first plan decide the goals that the scene leaves open, and notes how they were
/// chosen.
fn decide_goals(
    settled: &mut Settled,
    plan: Option<&Read<'_>>,
    options: &Options,
) -> Result<(), Refused> {
    let remarks = &mut settled.remarks;
    if let Some(plan) = plan {
        let mut scene = settled.instance.to_scene();
        if matches!(remarks.open, OpenGoals::Orders(_)) && plan.handled().is_empty() {
            // Robots of this plan lift nothing: to be at the shelves is enough (domain M).
            let rule = LeftOutRule::Handling;
            let handling = Assumption::RuleLeftOut { rule };
            scene.assumptions.retain(|one| *one != handling);
            if let Ok(instance) = Instance::new(scene.clone()) {
                settled.instance = instance;
            }
        }
        let paths = plan.paths(&settled.instance, options.conventions)?;
        let done = (&*plan.file, &paths, &plan.handled());
        if let Some(notes) = open::decide(&mut scene, &remarks.open, done)
            && let Ok(instance) = Instance::new(scene)
        {
            settled.instance = instance;
            remarks.notes.extend(notes);
            return Ok(());
        }
    }
    remarks.notes.splice(0..0, remarks.chosen.drain(..));
    Ok(())
}
