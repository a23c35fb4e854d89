//! The report of the plan on the board: what the page shows, prints and saves of it.

mod questions;

use std::rc::Rc;

use giveway_model::Cost;
use giveway_picture::report::{Known, LoneDelay, Proved, Report, Subject};
use giveway_solve::Status;
use giveway_solve::delays::{
    AgentDelay,
    words::{passes, row},
};
use giveway_solve::words::{on_paper, reach_of_bounds, reason};

use crate::files::Saved;
use crate::words::change::method;
use crate::{Answer, State, files, inspect, words};

/// Where and when a report is made.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Imprint {
    /// The address of the page with the plan in it.
    pub address: Option<String>,
    /// The day, as the reader writes it.
    pub date: Option<String>,
}

/// The report of the plan; `None` where there is no plan of the scene as it is.
pub fn report(state: &State, imprint: Imprint) -> Option<Report> {
    with(state, |subject, answer| {
        let known = Known {
            link: imprint.address,
            date: imprint.date,
            ..known(state, answer)
        };
        Report::of(subject, known)
    })
}

/// Whether what robots lose against their ways alone is still to come.
pub fn is_coming(state: &State) -> bool {
    state.is_adding_up()
}

/// The report as a page of HTML, in a language.
pub fn report_file(state: &State, imprint: Imprint, language: &str) -> Option<Saved> {
    Some(Saved {
        name: files::name_of(state, "report.html"),
        text: report(state, imprint)?.page(language),
    })
}

/// Where each robot is at each time, as a table for spreadsheets.
pub fn plan_csv_file(state: &State) -> Option<Saved> {
    Some(Saved {
        name: files::name_of(state, "plan.csv"),
        text: with(state, |subject, _| subject.csv())?,
    })
}

/// A line for each robot of the plan, as a table for spreadsheets.
pub fn arrivals_csv_file(state: &State) -> Option<Saved> {
    Some(Saved {
        name: files::name_of(state, "arrivals.csv"),
        text: report(state, Imprint::default())?.csv(),
    })
}

fn with<T>(state: &State, tell: impl FnOnce(&Subject<'_>, &Answer) -> T) -> Option<T> {
    let answer: &Rc<Answer> = state.document.fresh_answer()?;
    let instance = answer.draft.instance().ok()?;
    let changes = answer.course.as_ref().map(|course| &course.changes);
    let subject = Subject::new(instance, answer.plan()?, changes).ok()?;
    Some(tell(&subject, answer))
}

fn known(state: &State, answer: &Answer) -> Known {
    let solved = &answer.solved;
    let is_own = answer.is_searched() && answer.by.is_none() && answer.course.is_none();
    let (claim, is_proved) = if is_own {
        on_paper(solved)
    } else {
        let claim = inspect::claim(answer);
        let claim = claim.unwrap_or_else(|| words::standing(state).sentence);
        let is_proved = answer.is_searched() && solved.status == Status::Optimal;
        (claim, is_proved)
    };
    let bounds = |(&cost, &least): (&Cost, &u32)| (cost, least);
    let steps = answer.course.as_ref().map_or(&[][..], |it| &it.steps);
    let remarks = [solved.reason.as_ref().map(reason), reach_of_bounds(solved)];
    Known {
        claim,
        proved: match (is_proved, is_own) {
            (false, true) if reach_of_bounds(solved).is_none() => Proved::Bounded,
            (false, _) => Proved::No,
            (true, true) => Proved::within(solved.reach.within()),
            // Of the plans from a time on.
            (true, false) => Proved::OfThese,
        },
        remarks: remarks.into_iter().flatten().collect(),
        bounds: solved.bounds.iter().map(bounds).collect(),
        before: steps.first().and_then(|step| step.before),
        methods: steps
            .iter()
            .filter_map(|step| Some((step.at, method(step.method?).to_owned())))
            .collect(),
        questions: questions::asked(state, answer),
        delays: delays(state),
        ..Known::default()
    }
}

/// What robots lose against their ways alone, as far as the ledger of the plan is known.
fn delays(state: &State) -> Vec<LoneDelay> {
    let ledger = state.document.ledger();
    let told = ledger.and_then(|ledger| ledger.told.as_deref());
    let lone = |told: &AgentDelay| LoneDelay {
        robot: told.agent.clone(),
        alone: told.alone,
        delay: told.delay,
        passes: passes(told),
        why: row(told),
    };
    told.map_or_else(Vec::new, |told| told.agents.iter().map(lone).collect())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sample;

    #[test]
    fn the_figures_are_those_of_the_plan() {
        let state = sample::solved();
        let report = report(&state, Imprint::default()).unwrap();
        let answer = state.document.answer.as_ref().unwrap();
        let costs = answer.solved.costs.unwrap();
        assert_eq!(report.costs.len(), 5);
        for row in &report.costs {
            assert_eq!(row.value, costs.get(row.cost));
            let least = answer.solved.bounds.get(&row.cost).copied();
            assert_eq!(row.at_least, least, "{:?}", row.cost);
        }
        assert_eq!(report.known.proved, Proved::OfAll);
        assert_eq!(report.known.claim, "Proved: no plan is better.");
        let arrivals: Vec<_> = report.robots.iter().map(|row| row.arrives).collect();
        assert_eq!(arrivals, answer.arrivals);
        let waits: u32 = report.robots.iter().map(|row| row.waits).sum();
        assert_eq!(waits, costs.waits);
        let charges: usize = report.robots.iter().map(|row| row.charges.len()).sum();
        assert_eq!(u32::try_from(charges), Ok(costs.charges));
        let lowest = answer.levels.iter().map(|levels| levels.iter().min());
        for (row, lowest) in report.robots.iter().zip(lowest) {
            assert_eq!(row.lowest.as_ref(), lowest);
        }
    }

    #[test]
    fn without_a_plan_there_is_no_report() {
        let state = State::new(sample::draft());
        assert_eq!(report(&state, Imprint::default()), None);
        assert_eq!(plan_csv_file(&state), None);
        assert_eq!(report_file(&state, Imprint::default(), "en"), None);
    }

    #[test]
    fn a_link_is_printed_unless_it_is_long() {
        let state = sample::solved();
        let link = |length: usize| {
            let address = format!("https://example.org/#{}", "a".repeat(length));
            let imprint = Imprint {
                address: Some(address.clone()),
                ..Imprint::default()
            };
            let html = report(&state, imprint).unwrap().html();
            (html.matches(&address).count(), html.contains("open it"))
        };
        assert_eq!(link(90), (2, false), "its address and its text");
        assert_eq!(link(1000), (1, true), "nobody would type it");
        assert_eq!(link(2000), (0, false));
    }

    #[test]
    fn files_have_the_name_of_the_scene() {
        let state = sample::solved();
        let names = [
            report_file(&state, Imprint::default(), "en").unwrap().name,
            plan_csv_file(&state).unwrap().name,
            arrivals_csv_file(&state).unwrap().name,
        ];
        assert_eq!(
            names,
            [
                "warehouse-report.html",
                "warehouse-plan.csv",
                "warehouse-arrivals.csv"
            ]
        );
    }
}
