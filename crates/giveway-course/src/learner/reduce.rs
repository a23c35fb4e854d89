//! From a learner and an action to the next learner, and what must be done outside.

use giveway_model::Scene;
use giveway_solve::Response;

use super::pointed::{self, Pointed};
use super::{Action, AskNumber, Effect, Judge, Learner, Open, Proof, Stage};
use crate::judge::{Did, may_bring};
use crate::lesson::Id;
use crate::port::{BoardNumber, FromPage, Happened, ToPage};

/// What becomes of a learner, and what must be done outside, in this order.
#[must_use]
pub fn reduce(mut learner: Learner, action: Action) -> (Learner, Vec<Effect>) {
    let mut effects = Vec::new();
    learner.act(action, &mut effects);
    (learner, effects)
}

impl Learner {
    fn act(&mut self, action: Action, effects: &mut Vec<Effect>) {
        match action {
            Action::Open { id, lesson, at } => {
                let at = at.unwrap_or(match self.progress.stage(&id) {
                    Stage::Begun(step) | Stage::Seen { step, .. } => step,
                    Stage::New | Stage::Done => 0,
                });
                let at = at.min(lesson.steps.len().saturating_sub(1));
                let Some(scene) = lesson.scene(at).cloned() else {
                    return;
                };
                let open = Open::at(id, lesson, at, self.board, scene);
                self.enter(open, effects);
            }
            Action::Try { lesson, at } => {
                let (id, at) = (Id::tried(), Some(at));
                self.act(Action::Open { id, lesson, at }, effects);
            }
            Action::Reword { id, lesson } => {
                if let Some(open) = self.open.as_mut().filter(|open| open.id == id) {
                    open.lesson = lesson;
                }
            }
            Action::Next => self.next(effects),
            Action::Back => {
                let before = self.open.as_ref().and_then(|open| open.at.checked_sub(1));
                self.go(before, None, effects);
            }
            Action::Go(step) => self.go(Some(step), None, effects),
            Action::Page(message) => self.heard(message, effects),
            Action::Guess(value) => self.did(Did::Guessed(value), effects),
            Action::Reveal | Action::Hint if self.hides_answers() => {}
            Action::Reveal => self.did(Did::Revealed, effects),
            Action::Choose(answer) => self.did(Did::Chose(answer), effects),
            Action::Order(order) => self.did(Did::Ordered(order), effects),
            Action::NoOrder => self.did(Did::NoOrder, effects),
            Action::Went(method) => self.did(Did::Went(method), effects),
            Action::Hint => {
                if let Some(open) = &mut self.open {
                    let most = open.step().map_or(0, |step| step.hints.len());
                    open.hints = (open.hints + 1).min(most);
                }
            }
            Action::CheckProof => self.check_proof(effects),
            Action::ChangeByte => self.change_byte(),
            Action::ShowEvidence => self.show(effects),
            Action::TakeBack => self.take_back(effects),
            Action::Afresh => self.afresh(effects),
            Action::Answered { number, response } => self.answered(number, *response, effects),
            Action::Failed { number, sentence } => self.failed(number, sentence, effects),
            Action::Lead(name) if self.open.is_some() => {
                effects.push(Effect::Page(ToPage::Lead(name)));
            }
            Action::Wait if self.open.is_some() => effects.push(Effect::Page(ToPage::Wait)),
            Action::Light(lit) if self.open.is_some() => {
                effects.push(Effect::Page(ToPage::Light(lit)));
            }
            Action::Time(time) if self.open.is_some() => {
                effects.push(Effect::Page(ToPage::Go(time)));
            }
            Action::Lead(_) | Action::Wait | Action::Light(_) | Action::Time(_) => {}
            Action::Kept(progress) => self.progress.join(progress),
            Action::Reset => {
                self.left = None;
                self.progress.forget();
                if let Some(open) = &mut self.open {
                    (open.was_solved, open.before) = (false, None);
                }
                effects.push(Effect::Keep(self.progress.clone()));
            }
            Action::Close => self.close(effects),
        }
    }

    fn hides_answers(&self) -> bool {
        self.open.as_ref().is_some_and(Open::hides_answers)
    }

    fn next(&mut self, effects: &mut Vec<Effect>) {
        let Some(open) = &self.open else {
            return;
        };
        if open.is_last() {
            if !open.is_tried() {
                self.progress.finished(&open.id, &open.lesson);
                effects.push(Effect::Keep(self.progress.clone()));
            }
            return self.close(effects);
        }
        // A step without a scene goes on with the board as it is, if that can be: whoever
        // judges a hand-in later believes no other board.
        let after = open.at + 1;
        let board = Some(&open.scene).filter(|board| may_bring(&open.lesson, after, board).is_ok());
        let kept = board.cloned();
        self.go(Some(after), kept, effects);
    }

    /// To a step, with the scene on the board or else the lesson's.
    fn go(&mut self, step: Option<usize>, kept: Option<Scene>, effects: &mut Vec<Effect>) {
        let (Some(open), Some(step)) = (&self.open, step) else {
            return;
        };
        let scene = kept.or_else(|| open.lesson.scene(step).cloned());
        let Some(scene) = scene.filter(|_| step < open.lesson.steps.len()) else {
            return;
        };
        let open = Open::at(
            open.id.clone(),
            open.lesson.clone(),
            step,
            self.board,
            scene,
        );
        self.enter(open, effects);
    }

    fn enter(&mut self, open: Option<Open>, effects: &mut Vec<Effect>) {
        let Some(mut open) = open else {
            return;
        };
        self.leave(effects);
        open.board = self.next_board();
        if let Some(board) = open.as_board() {
            effects.push(Effect::Page(ToPage::Open(Box::new(board))));
        }
        if !open.is_tried() {
            self.progress.opened(&open.id, &open.lesson, open.at);
            let step = open.step();
            open.was_solved = step.is_some_and(|step| self.progress.is_solved(&open.id, step));
            let works = self.progress.works(&open.id, &open.lesson);
            open.before = works.into_iter().find(|work| work.step == open.at);
            effects.push(Effect::Keep(self.progress.clone()));
        }
        self.open = Some(open);
    }

    fn afresh(&mut self, effects: &mut Vec<Effect>) {
        self.forget(effects);
        let number = self.next_board();
        let Some(open) = &mut self.open else {
            return;
        };
        let hints = open.hints;
        let start = open.start.clone();
        let fresh = Open::at(open.id.clone(), open.lesson.clone(), open.at, number, start);
        if let Some(fresh) = fresh {
            *open = Open { hints, ..fresh };
            effects.push(Effect::Page(ToPage::StartAfresh(number)));
        }
    }

    fn close(&mut self, effects: &mut Vec<Effect>) {
        self.leave(effects);
        if self.open.take().is_some() {
            effects.push(Effect::Page(ToPage::Close));
        }
    }

    fn heard(&mut self, message: FromPage, effects: &mut Vec<Effect>) {
        let Some(open) = self.open.as_mut() else {
            return;
        };
        if open.board != message.number {
            return;
        }
        match message.what {
            Happened::Board(scene) => {
                open.scene = *scene;
                self.did(Did::Edits, effects);
            }
            Happened::Led(plan) => self.did(Did::Led(*plan), effects),
            Happened::Leads(name) => open.leads = Some(name),
            Happened::Picked(pick) => match pointed::picked(open, pick) {
                Pointed::Did(did) => self.did(did, effects),
                Pointed::Part => {}
                Pointed::Nothing(why) => effects.push(Effect::Page(ToPage::Say(why))),
            },
            Happened::Time(time) => open.time = time,
            Happened::Changed(method) => self.did(Did::Went(method), effects),
            Happened::Closed => {
                self.leave(effects);
                self.open = None;
            }
            // Only a tour is told of it.
            Happened::Seen(_) => {}
        }
    }

    /// What the solver has answered counts only for the question that is asked now.
    fn answered(&mut self, number: AskNumber, response: Response, effects: &mut Vec<Effect>) {
        if self.is_of_left(number) {
            return self.answered_left(response, effects);
        }
        let Some(open) = &mut self.open else {
            return;
        };
        if open.proof == Proof::Asked(number) {
            return self.proved(number, Some(response));
        }
        let Judge::Looking(looking) = &mut open.judge else {
            return;
        };
        if looking.number != number {
            return;
        }
        looking.responses.push(response);
        if looking.left.is_empty() {
            return self.conclude(effects);
        }
        let request = looking.left.remove(0);
        self.asked.0 = self.asked.0.wrapping_add(1);
        looking.number = self.asked;
        let (number, request) = (self.asked, Box::new(request));
        effects.push(Effect::Ask { number, request });
    }

    pub(super) fn next_board(&mut self) -> BoardNumber {
        self.board.0 = self.board.0.wrapping_add(1);
        self.board
    }

    /// The number of a question about the step that is open: what is asked of one that
    /// was left is of no more use then.
    pub(super) fn next_ask(&mut self) -> AskNumber {
        self.left = None;
        self.next_number()
    }

    pub(super) fn next_number(&mut self) -> AskNumber {
        self.asked.0 = self.asked.0.wrapping_add(1);
        self.asked
    }
}
