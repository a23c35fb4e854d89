//! Links that hide the answer, and links in a language.

use giveway_model::Question;

use super::why;
use crate::link::{From, Sharing, document, embed, open, read, write};
use crate::{Action, AskAction, Draft, Phase, PlayAction, State, ViewAction, reduce, sample};

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
    let scene = ["giveway", "map", "name", "rules", "costs", "agents"];
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
                "giveway", "map", "name", "rules", "costs", "agents", "within", "colours", "looks",
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
    assert!(html.contains("src=\"https://example.org/?embed&amp;lang=de#giveway=1&amp;map="));
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
    assert!(why(&format!("{text}&lang=de")).contains("lang"));
}
