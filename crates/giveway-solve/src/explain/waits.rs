//! The witness of a question about a wait: the wait is taken out of the plan, the agent does everything later
//! one step earlier, all others stay as they are.

use giveway_model::{Cell, Instance, Path, Plan, Question, check::Violation};

use super::whole::WholePlan;

/// A plan from which the waits that are asked about were taken.
pub(crate) struct TakenOut {
    /// The plan: the agent does everything later earlier, all others as before.
    pub(crate) plan: Plan,
    /// The wait steps that were taken out.
    pub(crate) steps: u32,
    /// When the first wait that is asked about begins and ends.
    pub(crate) from: u32,
    pub(crate) to: u32,
}

/// The violations that would follow; none where the question is about no wait.
pub(crate) fn witness(
    instance: &Instance,
    question: &Question,
    plan: &Plan,
    whole: WholePlan,
) -> Vec<Violation> {
    without_waits(instance, question, plan)
        .map_or_else(Vec::new, |taken| whole.check(instance, &taken.plan))
}

/// The plan without the waits that are asked about; `None` where the question is about no wait.
pub(crate) fn without_waits(
    instance: &Instance,
    question: &Question,
    plan: &Plan,
) -> Option<TakenOut> {
    let Question::Wait {
        agent,
        at,
        from,
        to,
        at_least,
    } = question
    else {
        return None;
    };
    let mut other = plan.clone();
    other.cut_trailing_goals(instance);
    let asked = AskedWaits {
        at: *at,
        from: from.unwrap_or(0) as usize,
        to: to.map_or(usize::MAX, |to| to as usize),
        spared: at_least.map_or(0, |steps| steps.saturating_sub(1)),
        begun: instance.start_state(agent).waits_begun,
    };
    let path = other.paths.get_mut(agent)?;
    let moved = asked.take_out(path);
    let steps = (moved.len() as u32).saturating_sub(path.len() as u32);
    // An entry that was taken out has the time of the one before it.
    let is_out = |pair: &[u32]| pair.first() == pair.last();
    let from = moved.windows(2).position(is_out).unwrap_or(0);
    let out = moved.windows(2).skip(from).take_while(|pair| is_out(pair));
    let to = from + out.count();
    if let Some(charges) = other.charges.get_mut(agent) {
        // A charge of a wait step is made by the step that takes its place.
        let now = charges
            .iter()
            .filter_map(|&charge| moved.get(charge as usize));
        let mut now: Vec<u32> = now.copied().collect();
        now.dedup();
        *charges = now;
    }
    Some(TakenOut {
        plan: other,
        steps,
        from: from as u32,
        to: to as u32,
    })
}

/// The wait steps that are asked about.
struct AskedWaits {
    at: Option<Cell>,
    from: usize,
    to: usize,
    /// How many wait steps on end may stay.
    spared: u32,
    /// How many were made before time 0.
    begun: u32,
}

impl AskedWaits {
    /// Takes them out of a path; for each time of it, the time that it becomes.
    fn take_out(&self, path: &mut Path) -> Vec<u32> {
        let mut shorter = Path::new();
        let mut moved = Vec::new();
        let mut run = self.begun;
        for (time, &entry) in path.iter().enumerate() {
            let before = time.checked_sub(1).and_then(|before| path.get(before));
            let waits = entry.is_some()
                && before == Some(&entry)
                && self.at.is_none_or(|at| entry == Some(at))
                && self.from < time
                && time <= self.to;
            if time > 0 {
                run = if waits { run + 1 } else { 0 };
            }
            if time == 0 || run <= self.spared {
                shorter.push(entry);
            }
            moved.push((shorter.len() as u32).saturating_sub(1));
        }
        *path = shorter;
        moved
    }
}
