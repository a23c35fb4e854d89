//! A plan of elsewhere is on the board: it is compared, and a better one looked
//! for, which never takes its place unasked.

use std::rc::Rc;

use giveway_formats::ForeignPlan;
use giveway_model::assumption::left_out;
use giveway_model::{Costs, Scene, tr_data};
use giveway_solve::{SolveAnswer, Status};

use super::document::{amend, put};
use super::{ask, file, find, intake, play, solve};
use crate::audit::{Audit, AuditAction, Beside, Dropped, conflicts};
use crate::files::Opened;
use crate::known::merged;
use crate::{
    Activity, Answer, Arrival, Document, Draft, Mode, Notice, Selection, Solving, State, Tab,
};

#[inline(never)]
pub(super) fn audit(state: &mut State, action: AuditAction) {
    if action == AuditAction::Begin {
        return begin(state);
    }
    let Some(audit) = state.audit().cloned() else {
        return;
    };
    match action {
        AuditAction::Begin => {}
        AuditAction::Show(index) => show(state, &audit, index),
        AuditAction::Next => match conflicts::next(state) {
            Ok(index) => show(state, &audit, index),
            Err(sentence) => state.view.notice = Some(Notice::refusal(sentence)),
        },
        AuditAction::Find => find(state, &audit),
        AuditAction::Compare(on) => beside(state, &audit, compared(on)),
        AuditAction::ShowOther(on) => {
            let side = if on { Beside::InPlace } else { Beside::Other };
            beside(state, &audit, side);
        }
        AuditAction::Take => take(state, &audit),
        AuditAction::Choose(index) => choose(state, &audit, index),
        AuditAction::ReadAs(conventions) => {
            let files = audit.files.to_vec();
            intake::read_as(state, files, conventions);
        }
        AuditAction::Leave => {
            ask::close(state);
            super::document::enter(state, Activity::Editing);
        }
    }
}

/// The plan on the board is audited, as one step of undo.
fn begin(state: &mut State) {
    let Some(audit) = Audit::of_own(state) else {
        return;
    };
    let document = Document {
        within: state.document.within,
        looks: state.document.looks.clone(),
        colours: state.document.colours,
        ..Document::audited(audit)
    };
    super::stroke::release(state);
    put(state, document);
    state.view.selection = Selection::Nothing;
    state.view.tab = Tab::Inspector;
    solve::start(state, solve::Start::quiet());
}

/// Shows a broken rule: its time, and its place.
fn show(state: &mut State, audit: &Audit, index: usize) {
    let Some(violation) = audit.plan.violations.get(index) else {
        return;
    };
    state.view.notice = None;
    play::seek(state, violation.time);
    state.view.conflict = Some(index);
    if let Some(cell) = conflicts::place(violation) {
        find::show(state, cell);
    }
}

const fn compared(on: bool) -> Beside {
    if on { Beside::InPlace } else { Beside::Nothing }
}

/// Looks for a plan of our own: the one that is there already, else by a search,
/// which then shows it.
fn find(state: &mut State, audit: &Audit) {
    let ours = audit.ours.as_ref();
    let is_final = ours.is_some_and(|ours| ours.solved.status == Status::Optimal);
    if is_final && audit.better().is_some() {
        return beside(state, audit, Beside::InPlace);
    }
    if !state.work.ask_for() {
        solve::start(state, solve::Start::step());
    }
}

/// Looks for what is proved of a plan of elsewhere, where nothing is known of that yet: the search
/// was cut off by a reload, or the document came back. A question that is open stays so.
pub(crate) fn go_on(state: &mut State) {
    let is_open = |audit: &Rc<Audit>| audit.ours.is_none();
    let is_free = state.lesson().is_none() && state.document.mode.asking().is_none();
    let is_wanted = is_free && state.audit().is_some_and(is_open);
    if is_wanted && state.document.draft.instance().is_ok() {
        solve::start(state, solve::Start::quiet());
    }
}

/// A document with plans of elsewhere takes the place of the one on the board, and
/// the search for what is proved of them begins.
///
/// # Errors
/// Why the scene cannot be opened.
pub(super) fn open(
    state: &mut State,
    scene: Scene,
    plans: Vec<ForeignPlan>,
    notes: Vec<String>,
    files: Vec<Opened>,
) -> Result<(), Notice> {
    let draft = file::drafted(scene)?;
    match document(&Rc::new(draft), plans, notes, files) {
        Some(document) => {
            file::replace(state, document);
            state.view.tab = Tab::Inspector;
            solve::start(state, solve::Start::quiet());
            Ok(())
        }
        None => Err(Notice::refusal(tr_data!(
            "There is no plan in these files."
        ))),
    }
}

/// A document with an audit; `None` without a plan.
fn document(
    draft: &Rc<Draft>,
    plans: Vec<ForeignPlan>,
    notes: Vec<String>,
    files: Vec<Opened>,
) -> Option<Document> {
    let judged = plans.into_iter().map(|plan| Dropped::new(draft, plan));
    let judged: Option<Vec<Dropped>> = judged.collect();
    let plans = judged?.into_iter().map(Rc::new).collect();
    Audit::new(plans, notes, Rc::new(files)).map(Document::audited)
}

impl Document {
    /// The document of an audit: a legal plan is the plan of the scene.
    pub(crate) fn audited(audit: Audit) -> Self {
        let answer = Rc::clone(&audit.plan.answer);
        let draft = Rc::clone(&answer.draft);
        let legal = audit.plan.is_legal().then_some(answer);
        Self {
            mode: Activity::Auditing(Rc::new(audit)).into(),
            ..Self::answered(draft, legal)
        }
    }
}

/// Another state of the audit, as part of the last step.
fn set(state: &mut State, audit: Audit) {
    let asking = state.document.mode.asking().cloned();
    let document = Document {
        mode: Mode::from(Activity::Auditing(Rc::new(audit))).with(asking),
        ..state.document.clone()
    };
    amend(state, document);
}

fn beside(state: &mut State, audit: &Audit, side: Beside) {
    ask::close(state);
    set(
        state,
        Audit {
            beside: side,
            ..audit.clone()
        },
    );
}

/// Our plan becomes the plan of the scene, as one step of undo.
fn take(state: &mut State, audit: &Audit) {
    if let Some(ours) = audit.better().cloned() {
        let document = Document {
            answer: Some(ours),
            mode: Mode::default(),
            ..state.document.clone()
        };
        put(state, document);
    }
}

/// Another plan of the files is looked at.
fn choose(state: &mut State, audit: &Audit, index: usize) {
    let Some(plan) = audit.plans.get(index).cloned() else {
        return;
    };
    ask::close(state);
    state.view.conflict = None;
    let other = Audit {
        plan,
        ..audit.clone()
    };
    let document = Document {
        within: state.document.within,
        looks: state.document.looks.clone(),
        colours: state.document.colours,
        ..Document::audited(other)
    };
    amend(state, document);
}

/// A search is over: what it knows is kept beside the plan.
pub(super) fn answered(state: &mut State, audit: &Audit, run: Solving, solved: SolveAnswer) {
    let objective = audit.objective();
    let mut solved = solved;
    if is_beyond_rules(audit, &solved) {
        (solved.plan, solved.costs) = (None, None);
        solved.status = Status::Unknown;
    }
    let solved = match &run.from {
        Some(from) => merged(&from.solved, solved, objective),
        None => solved,
    };
    let mut after = Audit {
        ours: Some(Rc::new(Answer::new(run.draft, run.request, solved))),
        ..audit.clone()
    };
    if run.arrival == Arrival::Step && after.better().is_some() {
        // It was asked for: here it is, beside the other one.
        after.beside = Beside::InPlace;
    }
    set(state, after);
}

/// Whether a plan that was found would be shown as a better one, though rules of the file's
/// problem are left out that nobody judges.
fn is_beyond_rules(audit: &Audit, solved: &SolveAnswer) -> bool {
    let scene = audit.plan.answer.draft.scene();
    let own = audit
        .plan
        .answer
        .solved
        .costs
        .filter(|_| audit.plan.is_legal());
    let is_better = |found: &Costs| {
        own.is_none_or(|own| found.vector(&scene.objective) < own.vector(&scene.objective))
    };
    left_out(&scene.assumptions).is_some() && solved.costs.as_ref().is_some_and(is_better)
}
