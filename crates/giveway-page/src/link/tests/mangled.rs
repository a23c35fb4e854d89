//! Links as they arrive: cut, encoded, wrapped, lengthened. They open the same, or it is
//! said why not.

use std::rc::Rc;

use giveway_model::Question;
use giveway_model::format::link::repair;

use super::why;
use crate::files::{Pasted, Reading, pasted};
use crate::link::{From, Sharing, embed, is_link, lesson, open, read, write};
use crate::slot::message;
use crate::{Action, AskAction, Draft, Place, PlayAction, State, reduce, sample};

fn named(names: [&str; 2], scene: &str) -> State {
    let mut written = sample::draft().scene().clone();
    written.name = scene.to_owned();
    for (agent, name) in written.agents.iter_mut().zip(names) {
        agent.name = name.to_owned();
    }
    State::new(Draft::new(written).unwrap())
}

/// States whose links have every part and every letter that links may have.
fn states() -> Vec<State> {
    let planned = reduce(&sample::solved(), Action::Play(PlayAction::Seek(7)));
    let asked = reduce(&planned, Action::Ask(AskAction::Ask(Question::Makespan)));
    vec![
        State::new(Draft::default()),
        planned,
        asked,
        named(["my robot", "\u{8f66} 1"], "a (b), c. "),
        named(["A.2;!&=#", "50 %"], "<b>&amp; %21 + / ?"),
    ]
}

/// A change of a link, by its name.
type Mangle = (&'static str, fn(&str) -> String);

fn encoded(text: &str) -> String {
    let mut encoded = String::new();
    for byte in text.bytes() {
        if byte.is_ascii_alphanumeric() || b"-_.~".contains(&byte) {
            encoded.push(char::from(byte));
        } else {
            let _ = std::fmt::Write::write_fmt(&mut encoded, format_args!("%{byte:02X}"));
        }
    }
    encoded
}

fn wrapped(text: &str, columns: usize, between: &str) -> String {
    let bytes: Vec<&[u8]> = text.as_bytes().chunks(columns).collect();
    let lines = bytes.iter().map(|line| std::str::from_utf8(line).unwrap());
    lines.collect::<Vec<_>>().join(between)
}

/// What programs do, and what is undone for every link.
const UNDONE: [Mangle; 26] = [
    ("nothing", str::to_owned),
    ("&amp;", |text| text.replace('&', "&amp;")),
    ("&amp; twice", |text| text.replace('&', "&amp;amp;")),
    ("all encoded", encoded),
    ("all encoded, small letters", |text| {
        encoded(text).replace("%3D", "%3d").replace("%3B", "%3b")
    }),
    ("all encoded twice", |text| encoded(&encoded(text))),
    ("only percent encoded", |text| text.replace('%', "%25")),
    (")", |text| format!("{text})")),
    (".", |text| format!("{text}.")),
    (",", |text| format!("{text},")),
    (">", |text| format!("{text}>")),
    ("%3E", |text| format!("{text}%3E")),
    ("\"", |text| format!("{text}\"")),
    (").", |text| format!("{text}).")),
    ("]", |text| format!("{text}]")),
    ("\u{201d}", |text| format!("{text}\u{201d}")),
    (" and so on", |text| format!("{text} and so on")),
    ("utm", |text| format!("{text}&utm_source=mail&utm_medium=x")),
    ("fbclid", |text| format!("{text}&fbclid=IwAR0_x-y")),
    ("gclid, encoded", |text| {
        format!("{}&gclid=Cj0K", encoded(text))
    }),
    ("lines", |text| wrapped(text, 60, "\n")),
    ("lines of Windows", |text| wrapped(text, 60, "\r\n")),
    ("quoted lines", |text| wrapped(text, 60, "\n> ")),
    ("lines and blanks", |text| wrapped(text, 60, "\n   ")),
    ("encoded lines", |text| wrapped(text, 60, "%0D%0A")),
    ("quoted-printable", |text| {
        wrapped(&text.replace('=', "=3D"), 60, "=\r\n")
    }),
];

/// What is undone unless a name has the very letters; then it is said.
const AMBIGUOUS: [Mangle; 7] = [
    ("%21", |text| text.replace('!', "%21")),
    ("%3D", |text| text.replace('=', "%3D")),
    ("%26", |text| text.replace('&', "%26")),
    ("%3B", |text| text.replace(';', "%3b")),
    ("marks", |text| {
        text.replace('!', "%21")
            .replace(';', "%3B")
            .replace('=', "%3D")
    }),
    ("decoded", |text| text.replace("%20", " ")),
    ("blanks for a line", |text| wrapped(text, 60, "%20")),
];

#[test]
fn what_programs_do_to_a_link_is_undone() {
    for state in states() {
        let link = write(&state);
        let expected = read(&link, From::Anywhere).unwrap();
        assert!(expected.is_checked);
        for (name, mangle) in UNDONE {
            let text = mangle(&link);
            let found = read(&text, From::Anywhere);
            let found = found.unwrap_or_else(|why| panic!("{name}: {why:?} for {text}"));
            assert_eq!(found, expected, "{name}: {text}");
            assert!(is_link(&text), "{name}");
        }
        for (name, mangle) in AMBIGUOUS {
            let text = mangle(&link);
            match read(&text, From::Anywhere) {
                Ok(found) => assert_eq!(found, expected, "{name}: {text}"),
                Err(notice) => {
                    assert!(link.contains("%2"), "{name}: {notice:?} for {text}");
                    assert!(why(&text).contains("check sum"), "{name}: {notice:?}");
                }
            }
        }
    }
}

#[test]
fn a_cut_link_is_told_at_every_length() {
    for state in states() {
        for mangle in [str::to_owned, encoded, |text: &str| {
            text.replace('&', "&amp;")
        }] {
            let link: String = mangle(&write(&state));
            for cut in 1..link.len() {
                let text = &link[..cut];
                assert!(is_link(text), "{text} is not seen to be a link");
                let told = read(text, From::Anywhere);
                let told = told.map(|linked| linked.document.draft.scene().clone());
                let told = told.expect_err(text).details().join(" ");
                assert!(told.contains("cut"), "{told} for {text}");
            }
            for behind in [")", "...", "&utm_source=a"] {
                let text = format!("{}{behind}", &link[..link.len() - 2]);
                assert!(why(&text).contains("cut"), "{text}");
            }
        }
    }
}

#[test]
fn a_link_that_was_changed_is_refused() {
    let link = write(&sample::solved());
    let begin = link.find("&map=").unwrap();
    let mut rng = fastrand::Rng::with_seed(11);
    for _ in 0..300 {
        let mut bytes = link.clone().into_bytes();
        let at = rng.usize(begin..bytes.len());
        let other = rng.u8(b'a'..=b'z');
        if bytes[at] == other {
            continue;
        }
        bytes[at] = other;
        let text = String::from_utf8(bytes).unwrap();
        assert!(why(&text).contains("changed"), "{text}");
    }
}

#[test]
fn links_of_earlier_versions_open_and_are_said_to_be_unchecked() {
    let old = "giveway=1&map=3.3f&name=x&rules=0.0&costs=0&agents=A.0.0.2.0";
    let fresh = State::new(Draft::default());
    for (text, agents) in [
        (old.to_owned(), 1),
        (format!("{old}%219.6"), 1),
        (format!("{old}&time=0)"), 1),
        (format!("{old}&time=0."), 1),
        (format!("{old}&time=0%3E"), 1),
        (format!("{old}&utm_source=a"), 1),
        (old.replace('=', "%3D").replace('&', "%26"), 1),
        (old.replace('&', "&amp;"), 1),
        (wrapped(old, 20, "\n"), 1),
    ] {
        let opened = reduce(&fresh, open(&text));
        assert_eq!(opened.document.draft.agents().len(), agents, "{text}");
        let told = message(&opened).unwrap_or_else(|| panic!("{text}: nothing is said"));
        assert!(
            told.text.contains("cannot see whether it was cut"),
            "{}",
            told.text
        );
        assert!(told.text.contains("1 robot arrived"), "{}", told.text);
        let closed = reduce(&opened, told.close.unwrap());
        assert_eq!(message(&closed), None);
        let link = write(&opened);
        assert!(
            message(&reduce(&fresh, open(&link))).is_none(),
            "its own link is checked"
        );
    }
    for text in [
        "giveway%3D1%26map%3D3.3f",
        "giveway=1&map=3.3f",
        "giveway=1",
        "gi",
    ] {
        assert!(why(text).contains("cut"), "{text}: {}", why(text));
    }
}

#[test]
fn pasted_links_are_repaired_and_refused_as_those_of_the_address() {
    let state = State::new(Draft::default());
    let link = format!("https://example.org/#{}", write(&sample::solved()));
    let html = embed(&link, "plan");
    for text in [
        link.clone(),
        format!("See <{link}>."),
        link.replace('&', "&amp;"),
        link.replace('#', "%23")
            .replace('=', "%3D")
            .replace('&', "%26"),
        wrapped(&link, 70, "\r\n"),
        html,
    ] {
        let read = pasted(&state, &text);
        let Ok(Pasted::Read(Reading::Linked(linked))) = read else {
            panic!("{read:?} for {text}");
        };
        assert_eq!(
            linked.linked.document.draft,
            sample::solved().document.draft
        );
    }
    let cut = pasted(&state, &link[..link.len() - 9]).unwrap_err();
    assert!(cut.details()[0].contains("was cut"), "{cut:?}");
    for text in ["good morning", "#top", "type octile\n#g"] {
        assert!(!is_link(text) || text == "#g", "{text}");
    }
}

#[test]
fn an_embed_with_a_broken_link_shows_nothing_else() {
    let mut embedded = State::new(Draft::default());
    embedded.view.place = Place::Embedded;
    let refused = reduce(&embedded, open("giveway%3D1%26map%3D3.3f"));
    assert!(refused.view.waiting.refused && refused.view.notice.is_some());
    let opened = reduce(&refused, open(&write(&sample::solved())));
    assert!(!opened.view.waiting.refused);
    let own = reduce(&State::new(Draft::default()), open("giveway=1"));
    assert!(!own.view.waiting.refused, "the page itself goes on");
}

#[test]
fn what_hides_the_answer_has_a_check_of_its_own() {
    let puzzle = Sharing {
        hides_answer: true,
        language: "",
    };
    let whole = format!("#{}", write(&states()[2]));
    let link = puzzle.link(&whole);
    let linked = read(&link[1..], From::Anywhere).unwrap();
    assert!(linked.is_checked && linked.document.answer.is_none());
    assert!(read(&link[1..link.len() - 1], From::Anywhere).is_err());
}

#[test]
fn the_address_of_a_lesson_is_repaired() {
    for text in [
        "lesson=room-to-pass.2",
        "lesson%3Droom-to-pass.2",
        "lesson=room-to-pass.2)",
        "lesson=room-to-pass.2%3E.",
        "lesson=room-to-pass.2&utm_source=x",
        "lesson=room-to-\npass.2",
    ] {
        assert_eq!(lesson(text).as_deref(), Some("room-to-pass.2"), "{text}");
    }
    assert_eq!(lesson("lesson=~Xy_-9.2").as_deref(), Some("~Xy_-9.2"));
    assert_eq!(lesson("lesson%3D%7EXy_-_").as_deref(), Some("~Xy_-_"));
    assert_eq!(lesson("lesson=").as_deref(), Some(""));
    assert_eq!(lesson("giveway=1&name=lesson"), None);
    let _ = Rc::new(repair::readings(&"%".repeat(1000)));
}
