//! Links that hide the answer, and links in a language.

use giveway_model::Question;
use giveway_solve::{Response, Status};

use crate::link::{From, Sharing, document, embed, open, read, write};
use crate::{
    Action, AskAction, Draft, Phase, PlayAction, SolveAction, State, ViewAction, WorkerAction,
    reduce, sample,
};

const PUZZLE: Sharing = Sharing {
    hides_answer: true,
    language: "",
};

fn asked() -> State {
    let state = reduce(&sample::solved(), Action::Play(PlayAction::Seek(7)));
    reduce(&state, Action::Ask(AskAction::Ask(Question::Makespan)))
}

/// The names of the parts of a link, in their order.
fn keys(link: &str) -> Vec<&str> {
    let (_, text) = link.split_once('#').unwrap();
    let parts = text.split('&');
    parts.map(|part| part.split('=').next().unwrap()).collect()
}

#[test]
fn a_link_can_hide_the_answer() {
    let state = asked();
    let whole = format!("https://example.org/#{}", write(&state));
    for key in ["plan", "time", "ask"] {
        assert!(keys(&whole).contains(&key), "{whole}");
    }
    let link = PUZZLE.link(&whole);
    let scene = [
        "giveway", "check", "map", "name", "rules", "costs", "agents",
    ];
    assert_eq!(keys(&link), scene, "the scene and nothing else: {link}");

    let (_, text) = link.split_once('#').unwrap();
    let linked = read(text, From::Anywhere).unwrap();
    assert_eq!(linked.document.draft, state.document.draft);
    assert_eq!(linked.document.answer, None);
    assert_eq!((linked.time, linked.question), (0, None));
}

#[test]
fn whatever_a_link_tells_of_an_answer_is_left_out() {
    // What other links hold, and even what only the browser keeps.
    let changed = "giveway=1&map=3.9f&name=a&rules=0.0&costs=0&agents=A.0.0.2.2&within=9&colours=1.0&looks=2.1\
         &changes=1aA3.2.2.1.0&plan=2r2d;l2u&knows=4&slept=1.4;&audit=x&time=1&ask=wait;A!at.3.1";
    let kept = format!(
        "{changed}&{}",
        document::write(&asked().document, From::Here)
    );
    for text in [changed, &kept] {
        let link = PUZZLE.link(&format!("https://example.org/#{text}"));
        let told = keys(&link);
        for key in told {
            let is_scene = [
                "giveway", "check", "map", "name", "rules", "costs", "agents", "within", "colours",
                "looks",
            ];
            assert!(is_scene.contains(&key), "{key} in {link}");
        }
    }
}

#[test]
fn a_hidden_answer_is_not_looked_for() {
    let whole = format!("#{}", write(&asked()));
    let link = PUZZLE.link(&whole);
    let mut fresh = State::new(Draft::default());
    fresh = reduce(&fresh, Action::View(ViewAction::SetSolveOnChange(false)));
    let opened = reduce(&fresh, open(&link[1..]));
    assert_eq!(opened.phase(), Phase::Editing);
    assert!(opened.work.is_idle(), "opening it solves nothing");
    assert_eq!(opened.plan(), None);
    assert_eq!(opened.document.mode.asking(), None);
}

#[test]
fn an_embed_hides_the_answer_and_has_its_language() {
    let whole = format!("https://example.org/#{}", write(&asked()));
    let german = Sharing {
        language: "de",
        ..PUZZLE
    };
    let html = embed(&german.link(&whole), "puzzle");
    assert!(html.contains("src=\"https://example.org/?embed&amp;lang=de#giveway=1&amp;check="));
    assert!(!html.contains("plan=") && !html.contains("time=") && !html.contains("ask="));
    let plain = embed(&whole, "plan");
    assert!(plain.contains("/?embed#giveway=1&amp;"), "{plain}");
    assert!(plain.contains("&amp;plan="));
}

#[test]
fn the_language_is_no_part_of_the_scene() {
    let whole = format!("https://example.org/#{}", write(&asked()));
    let german = Sharing {
        language: "de",
        ..Sharing::default()
    };
    let link = german.link(&whole);
    assert_eq!(link, whole.replace("/#", "/?lang=de#"));
    let (_, text) = whole.split_once('#').unwrap();
    // What stands behind a link is no part of it.
    let linked = read(&format!("{text}&lang=de"), From::Anywhere);
    assert_eq!(linked, read(text, From::Anywhere));
}

#[test]
fn a_link_of_a_scene_without_a_plan_finds_that_verdict_again() {
    let begun = reduce(
        &State::new(sample::draft()),
        Action::Solve(SolveAction::Solve),
    );
    let mut solved = sample::solved().document.answer.unwrap().solved.clone();
    solved.status = Status::Impossible;
    (solved.plan, solved.costs) = (None, None);
    let response = Box::new(Response::Solved(solved));
    let job = begun.work.id().unwrap();
    let state = reduce(
        &begun,
        Action::Worker(WorkerAction::Respond { job, response }),
    );
    assert_eq!(state.phase(), Phase::None);
    let text = write(&state);
    assert!(text.contains("&verdict=impossible"), "{text}");
    let opened = reduce(&State::new(Draft::default()), open(&text));
    assert_eq!(
        opened.phase(),
        Phase::Solving,
        "it is not believed, but found again"
    );
    assert_eq!(opened.document.answer, None);
    // What was not solved is not solved by opening it, and a puzzle tells nothing.
    let unsolved = write(&State::new(sample::draft()));
    let opened = reduce(&State::new(Draft::default()), open(&unsolved));
    assert_eq!(opened.phase(), Phase::Editing);
    let puzzle = PUZZLE.link(&format!("https://example.org/#{text}"));
    assert!(!puzzle.contains("verdict"), "{puzzle}");
    let other = text.replace("verdict=impossible", "verdict=maybe");
    assert!(read(&other, From::Anywhere).is_err());
}
