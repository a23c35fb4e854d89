//! The tour on the page: the page is as it is without a lesson, and a person's own one is
//! put aside; the whole tour, done by the person and done for them.

use giveway_course::port::{Deed, FromPage, Happened, ToPage};
use giveway_course::tour::{self, Effect, Step, Tour};
use giveway_model::Cell;

use super::{heard, opened, say, says};
use crate::lesson::{LessonAction, happened};
use crate::link;
use crate::reduce::tests::{after, stroke};
use crate::rules::RuleAction;
use crate::tests::{answered, seek, select};
use crate::{Action, AskAction, FileAction, PlayAction, SolveAction, State, Tool, ask, sample};

/// The page, and the tour that is taken on it; neither knows the other.
struct Both {
    page: State,
    tour: Option<Tour>,
    /// Whether the contents of the course were opened.
    has_contents: bool,
}

impl Both {
    fn begin(own: &State) -> Self {
        let (tour, effects) = tour::begin(tour::FIRST);
        let mut both = Self {
            page: own.clone(),
            tour: Some(tour),
            has_contents: false,
        };
        both.take(effects);
        both.solve();
        both
    }

    fn take(&mut self, effects: Vec<Effect>) {
        for effect in effects {
            match effect {
                Effect::Page(message) => self.act(Action::Lesson(says(message))),
                Effect::Contents => self.has_contents = true,
            }
        }
    }

    /// An action on the page, which the tour hears of.
    fn act(&mut self, action: Action) {
        self.become_of(after(&self.page, [action]));
    }

    fn become_of(&mut self, next: State) {
        let before = std::mem::replace(&mut self.page, next);
        for message in happened(&before, &self.page.clone()) {
            self.guide(tour::Action::Page(message));
        }
    }

    fn guide(&mut self, action: tour::Action) {
        let Some(tour) = self.tour.take() else { return };
        let (tour, effects) = tour::reduce(tour, action);
        self.tour = tour;
        self.take(effects);
    }

    /// The solver answers.
    fn solve(&mut self) {
        self.become_of(answered(&self.page));
    }

    fn step(&self) -> Step {
        self.tour.as_ref().unwrap().step()
    }
}

/// A page of one's own, with a plan, an edit that was undone, and something selected.
fn own() -> State {
    let edited = after(&sample::solved(), stroke(Tool::Obstacle, &[(8, 2)]));
    after(&edited, [Action::Undo, select(1), seek(3)])
}

fn play(action: PlayAction) -> Action {
    Action::Play(action)
}

#[test]
fn a_person_does_it_step_by_step() {
    let mut both = Both::begin(&own());
    assert_eq!(both.page.document.draft.scene(), &tour::scene());
    assert!(both.page.lesson().is_none(), "the page is as it always is");
    assert_eq!(both.step(), Step::Watch);
    both.act(play(PlayAction::Play));
    both.act(play(PlayAction::Reach(5)));
    assert_eq!(both.step(), Step::Watch);
    both.act(play(PlayAction::Reach(6)));
    assert_eq!(both.step(), Step::Select);
    assert_eq!(both.page.view.playback.time, 0, "the robot waits there");
    both.act(select(1));
    assert_eq!(both.step(), Step::Select, "the other one does not wait");
    both.act(select(0));
    assert_eq!(both.step(), Step::Ask);
    let groups = ask::offers(&both.page);
    let question = groups[0].offers[0].question.clone();
    both.act(Action::Ask(AskAction::Ask(question)));
    assert_eq!(both.step(), Step::Close);
    for action in stroke(Tool::Obstacle, &[(6, 1)]) {
        both.act(action);
    }
    assert_eq!(both.step(), Step::Solve);
    both.act(Action::Solve(SolveAction::Solve));
    assert_eq!(both.step(), Step::Solve);
    both.solve();
    assert_eq!(both.step(), Step::Rule);
    for action in stroke(Tool::Zone, &[(3, 1), (4, 1)]) {
        both.act(action);
    }
    let (zone, rule) = tour::rule();
    assert!(both.page.is_writing_rule());
    both.act(Action::Rules(RuleAction::Add));
    let scene = both.page.document.draft.scene();
    assert_eq!(
        (&scene.zones[..], &scene.constraints[..]),
        (&[zone][..], &[rule][..])
    );
    both.act(Action::Rules(RuleAction::Price));
    assert_eq!(both.step(), Step::Rule);
    both.solve();
    assert_eq!(both.step(), Step::GoOn);
    both.guide(tour::Action::End);
    assert!(both.tour.is_none() && !both.has_contents);
    assert_eq!(both.page.document, own().document);
    assert_eq!(both.page.history, own().history);
    assert_eq!(both.page.view.playback, own().view.playback);
}

#[test]
fn it_is_shown_step_by_step() {
    let mut both = Both::begin(&own());
    for step in Step::ALL {
        assert_eq!(both.step(), step);
        both.guide(tour::Action::Show);
        match step {
            Step::Watch => {
                assert!(both.page.view.playback.playing);
                both.act(play(PlayAction::Reach(6)));
            }
            Step::Ask => {
                let asking = both.page.document.mode.asking().unwrap();
                let question = crate::words::question(asking.question());
                assert!(
                    question.starts_with("Why does A1 give way to A2"),
                    "{question}"
                );
            }
            Step::Solve => both.solve(),
            Step::Rule => {
                both.solve();
                let rows = crate::rules::list(&both.page).unwrap().rows;
                let prices = rows.iter().map(|row| row.price.clone().map(|tag| tag.text));
                assert_eq!(
                    prices.collect::<Vec<_>>(),
                    [Some("costs 1 step of the makespan".to_owned())]
                );
            }
            Step::Select | Step::Close | Step::GoOn => {}
        }
    }
    assert!(both.tour.is_none() && both.has_contents);
    assert_eq!(both.page.document, own().document);
}

#[test]
fn what_needs_a_plan_is_shown_on_the_scene_as_it_was() {
    let mut both = Both::begin(&own());
    both.act(play(PlayAction::Seek(6)));
    for action in stroke(Tool::Obstacle, &[(2, 1)]) {
        both.act(action);
    }
    assert_eq!(both.step(), Step::Select);
    both.guide(tour::Action::Show);
    assert_eq!(both.page.document.draft.scene(), &tour::scene());
    both.solve();
    assert_eq!(both.step(), Step::Ask);
}

#[test]
fn nothing_of_it_is_kept_and_a_file_ends_it() {
    let kept = link::keep(&own());
    let mut both = Both::begin(&own());
    for action in stroke(Tool::Obstacle, &[(6, 1)]) {
        both.act(action);
    }
    assert_eq!(link::keep(&both.page), kept);
    let opened = Action::File(FileAction::Open(Box::new(super::scene())));
    both.act(opened);
    assert!(both.tour.is_none());
    assert_eq!(both.page.document.draft.scene(), &super::scene());
    let back = after(&both.page, [Action::Undo]);
    assert_eq!(back.document, own().document, "one step back is one's own");
}

#[test]
fn a_tour_and_a_lesson_take_the_place_of_each_other() {
    let mut both = Both::begin(&own());
    both.page = opened(&both.page, super::board(1));
    assert!(both.page.lesson().is_some());
    let (_, effects) = tour::begin(tour::FIRST);
    both.take(effects);
    assert!(both.page.lesson().is_none());
    let left = say(&both.page, ToPage::Close);
    assert_eq!(left.document, own().document);
}

#[test]
fn outside_of_a_tour_nothing_is_done_for_anybody() {
    let lesson = opened(&own(), super::board(1));
    for deed in [
        Deed::Select("A2".to_owned()),
        Deed::Ask,
        Deed::Paint(Cell::new(1, 1)),
        Deed::Solve,
        Deed::Rule(tour::rule().0, tour::rule().1),
        Deed::Price,
    ] {
        for state in [&lesson, &own()] {
            let after = say(state, ToPage::Do(deed.clone()));
            assert_eq!(&after, state, "{deed:?}");
        }
    }
}

#[test]
fn it_hears_what_is_seen_and_that_it_is_over() {
    let toured = Both::begin(&own()).page;
    let (_, said) = heard(&toured, [select(0), Action::Lesson(LessonAction::Leave)]);
    let [
        FromPage {
            what: Happened::Seen(sight),
            ..
        },
        FromPage {
            number,
            what: Happened::Closed,
        },
    ] = &said[..]
    else {
        panic!("{said:?}");
    };
    assert_eq!(*number, tour::FIRST);
    assert_eq!(sight.robot.as_deref(), Some("A1"));
    assert_eq!((sight.time, sight.last), (0, 6));
    assert!(sight.is_solved && !sight.is_edited && !sight.is_asking && !sight.paints);
    assert!(!sight.marks && !sight.is_writing && !sight.is_ruled && !sight.is_priced);
}
