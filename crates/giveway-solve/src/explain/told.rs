//! An answer about the rest of a course as one about the whole.

use giveway_model::tr;
use giveway_model::{
    Cell, Cost, Costs, Plan,
    change::{Timeline, Trajectory},
    check::check_history,
    sorting,
};

use super::{
    Edit, ExplainAnswer, Repair, Verdict,
    past::{Course, Past},
    words,
};

impl Past {
    /// The answer in times, costs and plans of the whole.
    pub(crate) fn told(&self, mut answer: ExplainAnswer, asked: Option<Costs>) -> ExplainAnswer {
        let Some(course) = self.course() else {
            return answer;
        };
        answer.since = Some(course.since);
        answer.question = course.question.clone();
        answer.within = answer.within.map(|within| self.time(within));
        if let Some(core) = &mut answer.core {
            core.within = core.within.map(|within| self.time(within));
            for further in &mut core.further {
                further.within = further.within.map(|within| self.time(within));
            }
        }
        answer.repairs = self.told_repairs(&answer.repairs);
        if let Some(plan) = answer.alternative.take() {
            let whole = course.whole(&plan);
            let costs = answer.costs.map(|costs| self.whole_costs(costs, &plan));
            let report = check_history(&course.history, &whole);
            if !report.is_valid() || report.costs != costs {
                return without_other(answer);
            }
            (answer.alternative, answer.costs) = (Some(whole), costs);
        } else if let Some(costs) = answer.costs {
            // Those of the plan asked about.
            answer.costs = asked.or(Some(costs));
        }
        if let (Some(costs), Some(asked)) = (answer.costs, asked)
            && let Some(delta) = answer.deltas.get_mut(&Cost::Makespan)
        {
            *delta = i64::from(costs.makespan) - i64::from(asked.makespan);
        }
        if !answer.words.is_empty() {
            let since = course.since;
            answer.words = tr!(
                "This is about the plan from time {since} on. {answer}",
                since,
                answer = answer.words
            );
        }
        answer
    }

    /// Repairs as those of the whole.
    pub(crate) fn told_repairs(&self, repairs: &[Repair]) -> Vec<Repair> {
        let Some(course) = self.course() else {
            return repairs.to_vec();
        };
        let told = |repair: &Repair| {
            let mut edits = repair.edits.clone();
            for edit in &mut edits {
                if let Edit::Deadline { within } = edit {
                    *within = self.time(*within);
                }
            }
            let costs = self.costs_of_repair(repair);
            Repair {
                text: words::repair(&edits, repair.least, &costs),
                edits,
                least: repair.least,
                costs,
                plan: course.whole(&repair.plan),
            }
        };
        repairs.iter().map(told).collect()
    }

    fn costs_of_repair(&self, repair: &Repair) -> Costs {
        self.whole_costs(repair.costs, &repair.plan)
    }
}

/// The answer where the other plan is none behind the past: never trust the
/// search.
fn without_other(mut answer: ExplainAnswer) -> ExplainAnswer {
    answer.verdict = Verdict::Unknown;
    (answer.costs, answer.complete, answer.within) = (None, false, None);
    answer.deltas.clear();
    answer.witness.clear();
    answer.core = None;
    answer.repairs.clear();
    answer.further_repairs = 0;
    answer.exhaustive = false;
    tr!("The plan that was found does not fit what happened before, so nothing is claimed.")
        .clone_into(&mut answer.words);
    answer
}

impl Course {
    /// A plan of the rest behind the past. An agent that it lacks is taken away
    /// at the time from which it begins.
    pub(super) fn whole(&self, rest: &Plan) -> Plan {
        let mut plan = self.plan.clone();
        plan.knows = self.history.times().last().max(plan.knows);
        for timeline in self.history.timelines() {
            let name = timeline.name();
            let Some(share) = self.shares.get(name) else {
                continue;
            };
            let before = (self.since - timeline.from.min(self.since)) as usize;
            let own = rest.path(name);
            let path = plan.paths.entry(name.to_owned()).or_default();
            if stays(own) && !path.is_empty() {
                path.truncate((share.base - timeline.from.min(share.base)) as usize + 1);
                // What follows its arrival it sleeps through anyway.
                if let Some(slept) = plan.slept.get_mut(name) {
                    slept.retain(|&[_, to]| to <= share.base);
                }
            } else {
                // An arrived agent stays at its goal.
                let last = path.last().copied().flatten();
                path.resize(before.max(path.len()), last);
                path.truncate(before);
                path.extend(own);
                let goal = Some(timeline.goal());
                while path.len() > before + 1 && path.ends_with(&[goal, goal]) {
                    path.pop();
                }
                plan.slept.insert(name.to_owned(), self.slept(timeline));
            }
            let charges = plan.charges.entry(name.to_owned()).or_default();
            charges.retain(|&time| time < self.since);
            charges.extend(rest.charges(name).iter().map(|time| time + self.since));
            if timeline.from > 0 {
                plan.from.insert(name.to_owned(), timeline.from);
            }
            if !rest.paths.contains_key(name) {
                plan.until.insert(name.to_owned(), self.since);
            }
        }
        plan.charges.retain(|_, charges| !charges.is_empty());
        plan.slept.retain(|_, slept| !slept.is_empty());
        plan
    }

    /// What an agent slept through up to the last change, told of one whose
    /// path goes on.
    fn slept(&self, timeline: &Timeline) -> Vec<[u32; 2]> {
        let Some(trajectory) = Trajectory::of(&self.history, timeline, &self.plan) else {
            return Vec::new();
        };
        let times = self.history.times().filter(|&time| timeline.from < time);
        let spans = trajectory.sleeps(times.filter(|&time| time <= self.since));
        let spans = sorting::set(spans.into_iter().map(|(from, to)| [from, to]));
        spans.into_iter().collect()
    }
}

/// Whether a path begins where it ends, and never leaves.
fn stays(path: &[Option<Cell>]) -> bool {
    path.first()
        .is_some_and(|first| path.iter().all(|entry| entry == first))
}
