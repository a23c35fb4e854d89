//! The steps of the proof: as rows, as a chart, live, and by keys.

use std::cell::RefCell;

use giveway_solve::{Host, Progress, serve};

use super::*;
use crate::WorkerAction;
use crate::inside::{Kind, chart, rows};
use crate::keys::{Command, Key, command};

fn open() -> State {
    inside(&solved(&crossing()), [InsideAction::Show(true)])
}

fn texts(state: &State) -> Vec<String> {
    let (rows, _) = rows(state, &(0..100));
    rows.into_iter().map(|row| row.text).collect()
}

fn at(state: &State) -> String {
    steps(state).unwrap().at
}

fn press(state: &State, name: &str) -> State {
    let key = Key {
        name,
        ..Key::default()
    };
    match command(key, state) {
        Some(Command::Act(action)) => after(state, [action]),
        _ => panic!("{name} does nothing"),
    }
}

#[test]
fn it_is_told_from_the_bounds_alone_to_the_end() {
    let state = open();
    let told = texts(&state);
    assert_eq!(told[0], "Each robot alone, by its fastest way");
    assert!(
        told.contains(&"A and B cannot both be on time".to_owned()),
        "{told:?}"
    );
    assert_eq!(
        told.last().unwrap(),
        "Plan and bound meet: sum of costs 5, makespan 3. No plan is better"
    );
    let (all, count) = rows(&state, &(0..100));
    assert_eq!(all.len(), count);
    assert_eq!(
        all.iter()
            .filter(|row| row.is_chosen)
            .map(|row| row.number)
            .sum::<usize>(),
        0
    );
    assert_eq!(all.last().unwrap().kind, Kind::End);
    // Only what is seen is made.
    let (some, of) = rows(&state, &(1..3));
    assert_eq!((some.len(), some[0].number, of), (2, 1, count));
}

#[test]
fn the_chart_shows_bound_and_best_plan_until_they_meet() {
    let room = (400.0, 248.0);
    let state = open();
    let first = chart(&state, room).unwrap();
    assert_eq!(first.title, "Sum of costs");
    assert_eq!(
        first.name,
        "Sum of costs: proved bound and best plan by step. The bound rises from 4 to 5. The best \
         plan is 5."
    );
    assert!(first.seal.is_some(), "the sum of costs is proved");
    // The next cost has a chart of its own.
    let last = chart(&inside(&state, [InsideAction::Last]), room).unwrap();
    assert_eq!(last.title, "Makespan");
    assert_eq!(last.steps.0, first.steps.1 + 1);
    // A press on the chart is a step.
    let (left, right) = first.across_from;
    assert_eq!(first.step_at(left - 50.0), first.steps.0);
    assert_eq!(first.step_at(right), first.steps.1);
}

#[test]
fn keys_step_through_it() {
    let state = open();
    let (_, count) = rows(&state, &(0..1));
    let next = press(&press(&state, "."), ".");
    assert_eq!(at(&next), "2");
    assert_eq!(at(&press(&next, ",")), "1");
    let end = press(&next, "End");
    assert_eq!(at(&end), (count - 1).to_string());
    assert_eq!(at(&press(&end, "Home")), "0");
    assert_eq!(
        end.view.playback, state.view.playback,
        "the plan stands still"
    );
}

#[test]
fn it_plays_step_by_step_and_stops_at_the_end() {
    let state = open();
    let mut playing = press(&state, " ");
    assert!(playing.inside.is_playing);
    assert!(!press(&playing, " ").inside.is_playing);
    let (_, count) = rows(&state, &(0..1));
    for step in 1..count {
        assert!(playing.inside.is_playing, "before {step}");
        playing = inside(&settled(&playing), [InsideAction::Tick]);
        assert_eq!(at(&playing), step.to_string());
    }
    assert!(!playing.inside.is_playing);
    // Once more from the start.
    let again = press(&settled(&playing), " ");
    assert_eq!((at(&again).as_str(), again.inside.is_playing), ("0", true));
    let chosen = inside(&again, [InsideAction::Step(1)]);
    assert!(!chosen.inside.is_playing, "a person chose");
}

/// Keeps what a search tells on its way.
#[derive(Default)]
struct Ear(RefCell<Vec<Progress>>);

impl Host for Ear {
    fn wall_seconds(&self) -> f64 {
        0.0
    }

    fn progress(&self, event: &Progress) {
        self.0.borrow_mut().push(event.clone());
    }
}

/// Somebody who stops at once.
struct Stopping;

impl Host for Stopping {
    fn wall_seconds(&self) -> f64 {
        0.0
    }

    fn cancelled(&self) -> bool {
        true
    }

    fn progress(&self, _: &Progress) {}
}

#[test]
fn it_grows_while_the_search_goes_on_and_follows_its_end() {
    let mut state = inside(&after(&crossing(), [SOLVE]), [InsideAction::Show(true)]);
    let (job, request) = state.work.request().unwrap();
    let ear = Ear::default();
    let response = Box::new(serve(&request, &ear));
    let mut counts = Vec::new();
    let events: Vec<Progress> = ear.0.into_inner();
    assert!(
        events
            .iter()
            .any(|event| matches!(event, Progress::Traced { .. }))
    );
    for event in events {
        state = after(
            &state,
            [Action::Worker(WorkerAction::Progress { job, event })],
        );
        let (told, count) = rows(&state, &(0..100));
        assert!(
            told.last().is_none_or(|last| last.is_chosen),
            "it follows the end"
        );
        assert_eq!(overlay(&state).shades, [], "the worker is busy");
        counts.push(count);
    }
    assert!(counts.is_sorted() && counts.last() > Some(&1), "{counts:?}");
    let live = texts(&state);
    let done = after(
        &state,
        [Action::Worker(WorkerAction::Respond { job, response })],
    );
    let told = texts(&done);
    assert_eq!(told[..live.len()], live, "the record is what was told live");
    assert_eq!(at(&done), (told.len() - 1).to_string());
}

#[test]
fn a_step_that_a_person_chose_stays_while_more_come() {
    let state = after(&open(), [SOLVE]);
    assert_eq!(steps(&state), None, "the last search is forgotten");
    let (job, request) = state.work.request().unwrap();
    let ear = Ear::default();
    let _ = serve(&request, &ear);
    let mut state = state;
    for event in ear.0.into_inner() {
        state = after(
            &state,
            [Action::Worker(WorkerAction::Progress { job, event })],
        );
        if steps(&state).is_some() {
            state = inside(&state, [InsideAction::Step(0)]);
            assert_eq!(at(&state), "0");
        }
    }
}

#[test]
fn what_was_cut_off_has_no_seal() {
    let state = after(&crossing(), [SOLVE]);
    let (job, request) = state.work.request().unwrap();
    let response = Box::new(serve(&request, &Stopping));
    let state = after(
        &state,
        [Action::Worker(WorkerAction::Respond { job, response })],
    );
    let state = inside(&state, [InsideAction::Show(true), InsideAction::Last]);
    let (told, _) = rows(&state, &(0..100));
    assert_eq!(
        told.last().map(|last| last.kind),
        Some(Kind::Stopped),
        "{told:?}"
    );
    let drawn = chart(&state, (400.0, 200.0));
    assert!(drawn.is_none_or(|chart| chart.seal.is_none()));
}

#[test]
fn no_plan_opens_the_reasons() {
    let stuck = solved(&State::new(draft(
        r#"{ "giveway": 1, "map": ["..."], "agents": [
            { "name": "A", "start": [0, 0], "goal": [2, 0] },
            { "name": "B", "start": [2, 0], "goal": [0, 0] } ] }"#,
    )));
    let open = inside(&stuck, [InsideAction::Show(true), InsideAction::Last]);
    let column = shown(&open);
    assert_eq!(column.verdict.as_ref().unwrap().word, "No plan");
    let reasons = column.foot.last().unwrap();
    assert_eq!(reasons.text, "Why is there no plan?");
    let asked = inside(&open, [reasons.action.unwrap()]);
    assert!(asked.document.mode.asking().is_some() && !asked.is_inside());
}

#[test]
fn the_record_is_saved_as_the_command_writes_it() {
    let state = open();
    let saved = crate::files::trace_file(&state).unwrap();
    assert_eq!(saved.name, "scene-trace.json");
    let read: giveway_solve::trace::SearchTrace = serde_json::from_str(&saved.text).unwrap();
    let answer = state.document.answer.as_ref().unwrap();
    let told = answer.solved.trace.as_ref().unwrap();
    assert_eq!((&read.events, read.left_out), (&told.events, told.left_out));
    assert_eq!(read.objective, told.objective);
}
