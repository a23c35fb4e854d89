//! The questions of a report: those asked before, and the one that is open.

use std::rc::Rc;

use giveway_model::tr;
use giveway_picture::report::Question;

use crate::{Answer, Asking, Document, State, ask, words};

/// The questions that were answered, in the order in which they were asked.
pub(super) fn asked(state: &State, answer: &Answer) -> Vec<Question> {
    let document = &state.document;
    let mut all = (*document.asked).clone();
    if let Some(open) = document.mode.asking() {
        ask::remember(&mut all, open);
    }
    let told = all.iter().filter_map(|asking| told(state, asking, answer));
    told.collect()
}

fn told(state: &State, asking: &Rc<Asking>, answer: &Answer) -> Option<Question> {
    let document = Document {
        mode: state.document.mode.with(Some(Rc::clone(asking))),
        ..state.document.clone()
    };
    let card = ask::card(&State {
        document,
        ..state.clone()
    })?;
    let verdict = card.verdict?;
    let reasons = card.witness.iter().flat_map(|(_, happenings)| happenings);
    let reasons = reasons.map(|happening| happening.text.clone());
    Some(Question {
        asked: card.question,
        about: about(asking, answer),
        verdict: verdict.title,
        reasons: std::iter::once(verdict.sentence.replace('\n', " "))
            .chain(reasons)
            .filter(|reason| !reason.is_empty())
            .collect(),
    })
}

/// Which plan a question was about, where it is not that of the report.
fn about(asking: &Asking, answer: &Answer) -> Option<String> {
    let about = &asking.about;
    if about.plan().is_some() && about.plan() == answer.plan() && about.draft == answer.draft {
        return None;
    }
    let costs = about.solved.costs.filter(|_| about.plan().is_some());
    let costs = costs.map(|costs| words::values(asking.objective(), &costs));
    let is_earlier_scene = about.draft != answer.draft;
    Some(match costs {
        Some(costs) if is_earlier_scene => tr!(
            "Asked about a plan of the scene before it was edited: {costs}.",
            costs
        ),
        Some(costs) if about.course.is_none() && answer.course.is_some() => {
            tr!("Asked about the plan before the change: {costs}.", costs)
        }
        Some(costs) => tr!("Asked about another plan: {costs}.", costs),
        None if is_earlier_scene => {
            tr!("Asked about the scene before it was edited, which had no plan.").to_owned()
        }
        None => tr!("Asked when there was no plan.").to_owned(),
    })
}
