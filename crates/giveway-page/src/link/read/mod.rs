//! The text of a document, read with distrust: plans are judged, and a claim is
//! believed only where this browser kept it itself.

mod judged;
mod mode;
mod parts;

use std::collections::BTreeMap;
use std::rc::Rc;

use giveway_model::change::Changes;
use giveway_model::format::link::scene::PARTS as SCENE;
use giveway_model::{Agent, Plan, Scene, tr};

use super::text::{numbers, unescape};
use super::{
    From, IMPOSSIBLE, LONGEST, Linked, Source, answers, ask, change, found, knowledge, plan, scene,
};
use crate::audit::Audit;
use crate::front::Front;
use crate::{Activity, Answer, Colours, Document, Draft, Looks, Mode};

pub(crate) use judged::{changing, judged};
pub(super) use parts::{is_of_scene, is_public};

use judged::answer;
use mode::mode;
use parts::{ANSWER, Parts, broken};

/// Reads documents; what several have in common is read once.
#[derive(Debug, Default)]
pub(super) struct Reader {
    drafts: BTreeMap<String, Rc<Draft>>,
    answers: BTreeMap<String, Rc<Answer>>,
    audits: BTreeMap<String, Rc<Audit>>,
}

impl Reader {
    /// Reads a document.
    ///
    /// # Errors
    /// What is wrong with it, as a sentence.
    pub(super) fn read(&mut self, text: &str, from: From) -> Result<Linked, String> {
        if text.len() > LONGEST {
            return Err(tr!("It is longer than the page takes.").to_owned());
        }
        let parts = Parts::split(text, from)?;
        let draft = self.draft(&parts)?;
        let answer = self.answer(&draft, &parts)?;
        let mut document = Document::answered(draft, answer);
        document.within = parts.read("within", |text| text.parse().ok())?;
        if let Some(colours) = parts.read("colours", colours)? {
            document.colours = colours;
        }
        if let Some(looks) = parts.read("looks", looks)? {
            document.looks = looks;
        }
        self.keep(&mut document, &parts)?;
        let time = parts.read("time", |text| text.parse().ok())?;
        let question = parts.read("ask", ask::read)?;
        let is_verdict = |text: &str| (text == IMPOSSIBLE).then_some(());
        let verdict = parts.read("verdict", is_verdict)?;
        let last = document.shown(true).map_or(0, |answer| answer.makespan());
        Ok(Linked {
            time: u32::min(time.unwrap_or(0), last),
            document,
            question,
            was_impossible: verdict.is_some(),
            source: Source::Link,
            is_checked: true,
        })
    }

    fn draft(&mut self, parts: &Parts<'_>) -> Result<Rc<Draft>, String> {
        let key = parts.joined(&SCENE);
        if let Some(draft) = self.drafts.get(&key) {
            return Ok(Rc::clone(draft));
        }
        let mut read = Scene::default();
        for key in SCENE {
            parts.read(key, |value| scene::read(&mut read, key, value))?;
        }
        let draft = Draft::new(read).map_err(|faults| {
            let fault = judged::first(&faults);
            tr!("Its scene cannot be drawn: {fault}.", fault)
        })?;
        let draft = Rc::new(draft);
        self.drafts.insert(key, Rc::clone(&draft));
        Ok(draft)
    }

    fn answer(
        &mut self,
        draft: &Rc<Draft>,
        parts: &Parts<'_>,
    ) -> Result<Option<Rc<Answer>>, String> {
        let key = parts.joined(&SCENE) + &parts.joined(&ANSWER);
        if let Some(answer) = self.answers.get(&key) {
            return Ok(Some(Rc::clone(answer)));
        }
        let agents = draft.agents();
        let changes = parts.read("changes", |text| change::read(text, agents.len()))?;
        let plan = match parts.get("plan") {
            None => None,
            Some(text) => Some(plan(agents, text, changes.as_ref(), parts)?),
        };
        let answer = answer(draft, plan, changes, parts)?.map(Rc::new);
        if let Some(answer) = &answer {
            self.answers.insert(key, Rc::clone(answer));
        }
        Ok(answer)
    }

    /// A plan of elsewhere, judged anew.
    fn audit(
        &mut self,
        document: &Document,
        parts: &Parts<'_>,
    ) -> Result<Option<Rc<Audit>>, String> {
        let Some(text) = parts.get("audit") else {
            return Ok(None);
        };
        let key = parts.joined(&SCENE) + &parts.joined(&["plan", "audit", "ours"]);
        if let Some(audit) = self.audits.get(&key) {
            return Ok(Some(Rc::clone(audit)));
        }
        let audit = super::audit::read(&document.draft, document.answer.as_ref(), text);
        let mut audit = audit.ok_or_else(|| broken("audit"))?;
        if let Some(text) = parts.read("ours", unescape)? {
            audit.ours = self.read(&text, From::Here)?.document.answer;
        }
        let audit = Rc::new(audit);
        self.audits.insert(key, Rc::clone(&audit));
        Ok(Some(audit))
    }

    /// What only this browser's own text tells.
    fn keep(&mut self, document: &mut Document, parts: &Parts<'_>) -> Result<(), String> {
        if let Some(text) = parts.read("stale", unescape)? {
            document.answer = self.read(&text, From::Here)?.document.answer;
        }
        if let Some(prices) = parts.read("prices", |text| found::prices(document, text))? {
            document.found_prices = prices.map(Rc::new);
        }
        if let Some(audit) = self.audit(document, parts)? {
            return audited(document, audit, parts);
        }
        let Some(mut about) = document.answer.clone() else {
            let of_an_answer = [
                "front", "report", "listed", "compared", "own", "asked", "ours", "ledger", "past",
            ];
            let found = of_an_answer.iter().find(|key| parts.get(key).is_some());
            return found.map_or(Ok(()), |key| Err(broken(key)));
        };
        if let Some(told) = parts.read("front", answers::read)?.flatten() {
            let front = Front::new(Rc::clone(&document.draft), &about.request, told);
            let mut points = front.points.iter();
            // The plan shown is the very one of the front.
            if let Some(point) = points.find(|point| point.plan() == about.plan()) {
                about = Rc::clone(point);
                document.answer = Some(Rc::clone(point));
            }
            document.found_front = Some(Rc::new(front));
        }
        if let Some(report) = parts.read("report", answers::read)?.flatten() {
            document.checked = Some((about.clone(), Rc::new(report)));
        }
        if let Some(ledger) = parts.read("ledger", |text| found::ledger(&about, text))? {
            document.found_ledger = ledger.map(Rc::new);
        }
        if let Some(past) = parts.read("past", |text| found::past(&about, text))? {
            document.asked = Rc::new(past);
        }
        document.mode = mode(&about, parts)?;
        Ok(())
    }
}

/// Puts a plan of elsewhere into a document, with the question that was asked of it.
fn audited(document: &mut Document, audit: Rc<Audit>, parts: &Parts<'_>) -> Result<(), String> {
    let legal = audit.plan.is_legal();
    document.answer = legal.then(|| Rc::clone(&audit.plan.answer));
    let asking = mode::asking(&audit.plan.answer, parts)?.filter(|_| legal);
    document.mode = Mode::from(Activity::Auditing(audit)).with(asking);
    Ok(())
}

/// A plan of the agents of a scene and of those that join it.
fn plan(
    agents: &[Agent],
    text: &str,
    changes: Option<&Changes>,
    parts: &Parts<'_>,
) -> Result<Plan, String> {
    let mut agents = agents.to_vec();
    let mut times = Plan::default();
    if let Some(changes) = changes {
        agents.extend(change::joined(changes));
        change::put_times(&mut times, changes);
    }
    times.knows = parts.read("knows", knowledge::read)?;
    if let Some(slept) = parts.read("slept", |text| knowledge::read_slept(&agents, text))? {
        times.slept = slept;
    }
    let plan = plan::read(&agents, text, times);
    plan.ok_or_else(|| tr!("Its plan is broken.").to_owned())
}

fn looks(text: &str) -> Option<Looks> {
    let numbers = text.split('.').map(|number| number.parse().ok());
    numbers.collect::<Option<_>>().map(Looks::from_numbers)
}

fn colours(text: &str) -> Option<Colours> {
    let numbers = numbers(text)?;
    numbers.try_into().ok().map(Colours::from_numbers)
}
