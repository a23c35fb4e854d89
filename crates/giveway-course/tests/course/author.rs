//! Lessons that are written: a draft, what is wrong with it, links.

use fastrand::Rng;
use giveway_course::author::{
    Action, Draft, Field, Input, StepDraft, Whose, Words, form, reduce, sentence,
};
use giveway_course::learner::{self, Effect, Learner, Stage};
use giveway_course::lesson::{Glossary, Lesson, link, read_lesson, write_lesson};
use giveway_model::Scene;
use std::rc::Rc;

use super::shipped;

/// How many random actions are tried.
const ACTIONS: usize = 4000;

fn scene() -> Scene {
    let lesson = shipped::lesson("two-robots-one-cell");
    lesson.steps[0].scene.clone().unwrap()
}

fn write(draft: Draft, whose: Whose, field: &str, text: &str) -> Draft {
    let (field, text) = (field.to_owned(), text.to_owned());
    reduce(draft, Action::Write { whose, field, text })
}

fn step(draft: Draft, field: &str, text: &str) -> Draft {
    write(draft, Whose::Step, field, text)
}

/// A lesson of one step, written from nothing.
fn written() -> Draft {
    let mut draft = Draft::default();
    draft = write(draft, Whose::Lesson, "title", "A door");
    draft = write(draft, Whose::Lesson, "about", "One door, two robots.");
    draft = reduce(draft, Action::TakeScene(Box::new(scene())));
    draft = step(draft, "title", "Shut it");
    step(
        draft,
        "text",
        "Two robots\nshare a floor.\n\nOne is [A1](robot:A1).",
    )
}

fn places(draft: &Draft, glossary: &Glossary) -> Vec<String> {
    let looked = draft.look(glossary);
    looked
        .faults()
        .iter()
        .map(|fault| fault.place.path())
        .collect()
}

#[test]
fn a_lesson_is_written_from_nothing() {
    let glossary = Glossary::default();
    let empty = Draft::default();
    let missing = places(&empty, &glossary);
    for place in [
        "title",
        "about",
        "steps[0].title",
        "steps[0].text",
        "steps[0].scene",
    ] {
        assert!(
            missing.iter().any(|missing| missing == place),
            "{place}: {missing:?}"
        );
    }
    let mut draft = written();
    assert_eq!(places(&draft, &glossary), Vec::<String>::new());
    draft = step(draft, "task.kind", "paint");
    draft = step(draft, "task.say", "Shut the door.");
    let missing = places(&draft, &glossary);
    assert!(
        missing.contains(&"steps[0].reason".to_owned()),
        "{missing:?}"
    );
    assert!(
        missing.contains(&"steps[0].tools".to_owned()),
        "no tools: {missing:?}"
    );
    draft = step(draft, "reason", "So.");
    draft = step(draft, "hints[0]", "Look at the door.");
    draft = step(draft, "tools", "obstacle");
    draft = step(draft, "edits", "one");
    assert_eq!(places(&draft, &glossary), ["steps[0].edits"]);
    draft = step(draft, "edits", "1");
    draft = step(draft, "cells", "(1, 0), 2,0");
    let lesson = draft.look(&glossary).whole().unwrap().clone();
    let first = &lesson.steps[0];
    assert_eq!(first.text[0].plain(), "Two robots share a floor.");
    assert_eq!(first.text.len(), 2);
    assert_eq!(first.cells.as_ref().unwrap().len(), 2);
    assert_eq!(first.task.as_ref().unwrap().kind(), "paint");
    let read = read_lesson(&write_lesson(&lesson), &glossary).unwrap();
    assert_eq!(read, lesson);
}

#[test]
fn faults_of_markup_have_their_place() {
    let draft = step(written(), "text", "Good.\n\nThis is *not closed.");
    let looked = draft.look(&Glossary::default());
    let faults = looked.of(Some(0));
    assert_eq!(faults[0].place.field, "text[1]");
    let said = sentence(&faults[0].wrong, None);
    assert!(said.starts_with("Character 9: "), "{said}");
    // It is shown as it is.
    let shown = &looked.step(0).unwrap().text;
    assert_eq!(shown[1].plain(), "This is *not closed.");
}

#[test]
fn what_is_shipped_can_be_opened_and_is_the_same() {
    let glossary = shipped::glossary();
    for (name, lesson) in shipped::lessons() {
        let draft = Draft::of(&lesson);
        let again = draft.look(&glossary);
        assert_eq!(again.whole().map_err(<[_]>::to_vec), Ok(&lesson), "{name}");
        let kept = Draft::read(&draft.write()).unwrap();
        assert_eq!(kept.look(&glossary).whole(), again.whole(), "{name}");
    }
}

#[test]
fn what_is_removed_comes_back() {
    let mut draft = reduce(written(), Action::Copy(0));
    draft = step(draft, "title", "Again");
    draft = reduce(draft, Action::Move { from: 1, to: 0 });
    assert_eq!((draft.at(), draft.steps()[0].word("title")), (0, "Again"));
    let before = draft.clone();
    draft = reduce(draft, Action::Remove(0));
    assert_eq!(draft.steps().len(), 1);
    // What is written meanwhile stays.
    draft = step(draft, "title", "Other");
    draft = reduce(draft, Action::Undo);
    assert_eq!(draft.steps()[0].words(), before.steps()[0].words());
    assert_eq!(draft.steps()[1].word("title"), "Other");

    draft = step(draft, "task.kind", "choose");
    for _ in 0..3 {
        draft = reduce(draft, Action::AddAnswer);
    }
    draft = step(draft, "task.answers[2].text", "the last");
    draft = reduce(draft, Action::RemoveAnswer(1));
    assert_eq!(draft.steps()[0].word("task.answers[1].text"), "the last");
    draft = reduce(draft, Action::Undo);
    assert_eq!(draft.steps()[0].word("task.answers[2].text"), "the last");

    draft = reduce(draft, Action::DropBoard);
    assert!(draft.steps()[0].scene().is_none());
    draft = reduce(draft, Action::Undo);
    assert!(draft.steps()[0].scene().is_some());
    draft = reduce(draft, Action::New);
    assert!(draft.is_empty());
    draft = reduce(draft, Action::Undo);
    assert_eq!(draft.words()["title"], "A door");
}

#[test]
fn no_lesson_is_lost_when_another_one_takes_its_place() {
    let title = |draft: &Draft| draft.words().get("title").cloned().unwrap_or_default();
    let named = |draft: Draft, name| write(draft, Whose::Lesson, "title", name);
    let first = named(Draft::default(), "First");
    let second = named(Draft::default(), "Second");

    // That of another tab; what is undone can be undone.
    let mut draft = reduce(first.clone(), Action::Take(Box::new(second.clone())));
    for name in ["Second", "First", "Second", "First"] {
        assert_eq!(title(&draft), name);
        draft = reduce(draft, Action::Undo);
    }
    // The same again is no other lesson.
    let same = reduce(first.clone(), Action::Take(Box::new(first.clone())));
    assert_eq!(same.can_undo(), None);

    // The one before is kept, and there is a way back to it after the page was loaded anew.
    let draft = reduce(first, Action::New);
    let before = Draft::read(&draft.before().unwrap().write()).unwrap();
    let draft = Draft::read(&named(draft, "Third").write()).unwrap();
    assert_eq!((draft.can_undo(), draft.before()), (None, None));
    let draft = reduce(draft, Action::Before(Box::new(before.clone())));
    // It is offered once, and never in the place of a later one.
    let again = reduce(draft.clone(), Action::Before(Box::new(second)));
    assert_eq!(again, draft);
    let draft = reduce(draft, Action::Undo);
    assert_eq!(title(&draft), "First");
    assert_eq!(title(&draft.before().unwrap()), "Third");
    // Not to what is there already, or is nothing.
    let draft = reduce(Draft::default(), Action::Kept(Box::new(before.clone())));
    for nothing in [before, Draft::default()] {
        let same = reduce(draft.clone(), Action::Before(Box::new(nothing)));
        assert_eq!(same.can_undo(), None);
    }
}

#[test]
fn links_hold_a_lesson_or_say_that_they_were_cut() {
    let glossary = shipped::glossary();
    for (name, lesson) in shipped::lessons() {
        let text = link::write(&lesson, Some(1));
        let is_plain = |c: char| c.is_ascii_alphanumeric() || "~.-_".contains(c);
        assert!(text.chars().all(is_plain), "{name}");
        assert!(
            text.len() < write_lesson(&lesson).len() * 2 / 3,
            "{name}: {}",
            text.len()
        );
        assert_eq!(
            link::read(&text, &glossary),
            Ok((lesson, Some(1))),
            "{name}"
        );
        let mut rng = Rng::with_seed(3);
        for _ in 0..40 {
            let cut = rng.usize(1..text.len() - 3);
            assert!(
                link::read(&text[..cut], &glossary).is_err(),
                "{name} at {cut}"
            );
        }
    }
    // What unfolds to more than a lesson can be is not unfolded.
    let bomb = miniz_oxide::deflate::compress_to_vec(&vec![b' '; 40_000_000], 6);
    let bomb = format!("~{}", data_encoding::BASE64URL_NOPAD.encode(&bomb));
    assert!(link::read(&bomb, &glossary).is_err());
}

#[test]
fn answers_can_be_hidden_and_a_lesson_tried_leaves_no_trace() {
    let glossary = shipped::glossary();
    let (mut lesson, mut found) = (None, 0);
    for (_, shipped) in shipped::lessons() {
        let is_choose = |step: &giveway_course::lesson::Step| {
            step.task
                .as_ref()
                .is_some_and(|task| task.kind() == "choose")
        };
        if let Some(at) = shipped.steps.iter().position(is_choose) {
            found = at;
            lesson = Some(shipped);
        }
    }
    let draft = write(
        Draft::of(&lesson.unwrap()),
        Whose::Lesson,
        "hides-answers",
        "yes",
    );
    let lesson: Lesson = draft.look(&glossary).whole().unwrap().clone();
    assert!(lesson.hides_answers);
    let Some(giveway_course::lesson::Task::Choose(task)) = &lesson.steps[found].task else {
        unreachable!();
    };
    let wrong = task
        .answers
        .iter()
        .position(|answer| !answer.right)
        .unwrap();
    let id = lesson.own_id();
    assert!(id.as_str().starts_with("own-"));
    let lesson = Rc::new(lesson);
    let (learner, effects) = learner::reduce(
        Learner::default(),
        learner::Action::Try {
            lesson: Rc::clone(&lesson),
            at: found,
        },
    );
    assert!(
        !effects
            .iter()
            .any(|effect| matches!(effect, Effect::Keep(_)))
    );
    let (learner, _) = learner::reduce(learner, learner::Action::Hint);
    let (learner, _) = learner::reduce(learner, learner::Action::Choose(wrong));
    let open = learner.open.as_ref().unwrap();
    assert!(open.is_tried() && open.hints().is_empty());
    if let Some(verdict) = open.judge().verdict() {
        assert_eq!(verdict.why, giveway_course::judge::Why::Untold);
    }
    // One that is shared is kept by what is in it.
    let open = learner::Action::Open {
        id: id.clone(),
        lesson,
        at: Some(0),
    };
    let (learner, _) = learner::reduce(Learner::default(), open);
    assert_eq!(learner.progress.stage(&id), Stage::Begun(0));
}

/// A word that somebody might type, or not.
fn word(rng: &mut Rng, field: &Field, words: &Words) -> String {
    let picks = field.picks(words);
    if let (Some(pick), true) = (rng.choice(&picks), rng.u8(0..8) > 0) {
        return pick.value.clone();
    }
    if field.input == Input::Switch {
        return Field::switched(rng.bool()).to_owned();
    }
    let typed = [
        "",
        "3",
        "4294967296",
        "-1",
        "A1",
        "3,1",
        "(0, 0) (1, 0)",
        "*so*",
        "*",
        "[A1](robot:A1)",
        "[x](robot:)",
        "wait A1 --at 0,0",
        "A sentence.",
        "One.\n\nTwo.",
        "{\"giveway\": 1, \"changes\": []}",
        "\u{7}",
        "<b>",
        "cost",
    ];
    (*rng.choice(typed.as_slice()).unwrap()).to_owned()
}

fn random(rng: &mut Rng, draft: &Draft, lessons: &[(String, Lesson)]) -> Action {
    let count = draft.steps().len();
    let fields = form(draft.step().unwrap(), draft.scene(draft.at()));
    match rng.u8(0..30) {
        0 => Action::Add,
        1 => Action::Copy(rng.usize(0..=count)),
        2 => Action::Remove(rng.usize(0..=count)),
        3 => Action::Move {
            from: rng.usize(0..=count),
            to: rng.usize(0..=count),
        },
        4 => Action::Go(rng.usize(0..=count)),
        5 => Action::TakeScene(Box::new(scene())),
        6 => Action::DropBoard,
        7 => Action::AddAnswer,
        8 => Action::RemoveAnswer(rng.usize(0..7)),
        9 | 10 => Action::Undo,
        11 => Action::TakeTime(rng.u32(..)),
        12 if rng.u8(0..10) == 0 => Action::New,
        13 => Action::Open(Box::new(rng.choice(lessons).unwrap().1.clone())),
        14 => match draft.steps().iter().find_map(|step| step.plan()) {
            Some(plan) => Action::TakePlan(Box::new(plan.clone())),
            None => Action::Undo,
        },
        17 => Action::Take(Box::new(Draft::of(&rng.choice(lessons).unwrap().1))),
        18 => Action::Before(Box::new(Draft::of(&rng.choice(lessons).unwrap().1))),
        15 => Action::Kept(Box::new(Draft::read(&draft.write()).unwrap())),
        16 => {
            let (field, text) = ("title".to_owned(), "T".to_owned());
            Action::Write {
                whose: Whose::Lesson,
                field,
                text,
            }
        }
        _ => {
            let field = rng.choice(&fields).unwrap();
            let text = word(rng, field, draft.step().unwrap().words());
            let field = field.name.clone();
            Action::Write {
                whose: Whose::Step,
                field,
                text,
            }
        }
    }
}

#[test]
fn random_actions_never_panic_and_what_is_whole_reads_back_the_same() {
    let glossary = shipped::glossary();
    let mut lessons = shipped::lessons();
    lessons.retain(|(_, lesson)| write_lesson(lesson).len() < 12_000);
    let mut rng = Rng::with_seed(11);
    let mut draft = Draft::default();
    let mut whole = 0;
    for _ in 0..ACTIONS {
        let action = random(&mut rng, &draft, &lessons);
        draft = reduce(draft, action);
        assert!(draft.step().is_some());
        let keys: std::collections::BTreeSet<u32> =
            draft.steps().iter().map(StepDraft::key).collect();
        assert_eq!(keys.len(), draft.steps().len());
        let looked = draft.look(&glossary);
        let _ = looked.to_try(draft.at());
        if let Ok(lesson) = looked.whole() {
            whole += 1;
            let read = read_lesson(&write_lesson(lesson), &glossary).unwrap();
            assert_eq!(&read, lesson);
            let again = Draft::of(lesson).look(&glossary);
            assert_eq!(again.whole(), Ok(lesson));
        }
    }
    assert!(whole > ACTIONS / 40, "{whole}");
}
