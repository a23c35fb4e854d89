//! Languages: no sentence is missing or left over, none loses a value, and none is said
//! without the catalogue where a person reads it.
//!
//! `GIVEWAY_UPDATE_LANGUAGES=1` brings the PO files up to date: new texts come without a
//! translation, and what nobody says any more goes.
#![allow(
    clippy::unwrap_used,
    clippy::print_stdout,
    clippy::panic,
    reason = "a test that cannot go on ends with a panic"
)]

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;
use std::sync::LazyLock;

use giveway_course::lesson::{Glossary, read_lesson};
use giveway_model::format::native;
use giveway_model::words::{Catalogue, Message, messages, speak};
use giveway_model::{Cell, Cost, Fault};
use giveway_proof::{Budget, Checked, export, verify};
use giveway_solve::change::{Cause, CauseKind, Method};
use giveway_solve::words::reason;
use giveway_solve::{CertifyRequest, Reason, Stop};
use giveway_tests::languages::{Part, Said, is_source, places, unsaid, updated};
use giveway_tests::source;

const FOLDER: &str = "static/languages";

/// The PO files of a part: their paths and texts.
fn catalogues(part: Part) -> Vec<(String, String)> {
    static UPDATED: LazyLock<()> = LazyLock::new(|| {
        if std::env::var_os("GIVEWAY_UPDATE_LANGUAGES").is_some() {
            update();
        }
    });
    LazyLock::force(&UPDATED);
    read(part)
}

fn read(part: Part) -> Vec<(String, String)> {
    let folder = part.folder();
    let is_own = |path: &str| {
        let name = path.strip_prefix(folder).unwrap_or_default();
        name.rfind('/') == Some(0) && Path::new(path).extension().is_some_and(|end| end == "po")
    };
    let files = source::files(folder).into_iter();
    let files = files.filter(|file| is_own(&file.path));
    let files: Vec<(String, String)> = files.map(|file| (file.path, file.text)).collect();
    assert!(!files.is_empty(), "there is no language in {folder}");
    files
}

/// Brings all up to date; what moved from one part to another keeps its translation.
fn update() {
    let [page, course] = Part::ALL.map(read);
    for ((page, of_page), (course, of_course)) in page.into_iter().zip(course) {
        let write = |path: &str, text: String| fs::write(source::root().join(path), text).unwrap();
        write(&page, updated(&of_page, &of_course, Part::Page.said()));
        write(&course, updated(&of_course, &of_page, Part::Course.said()));
    }
}

/// All PO files.
fn all_catalogues() -> Vec<(String, String)> {
    Part::ALL.into_iter().flat_map(catalogues).collect()
}

/// Fails with all complaints at once.
#[track_caller]
fn expect_none(complaints: &[String]) {
    assert!(complaints.is_empty(), "\n{}", complaints.join("\n"));
}

/// What every language says of what the sources say.
fn compare(complain: impl Fn(&Said, Option<&Message>) -> Option<String>) -> Vec<String> {
    let mut complaints = Vec::new();
    for part in Part::ALL {
        let said = part.said();
        for (path, text) in catalogues(part) {
            let read = messages(&text).unwrap();
            let read: BTreeMap<String, Message> = read.into_iter().map(|m| (m.key(), m)).collect();
            for one in said {
                if let Some(complaint) = complain(one, read.get(&one.key())) {
                    complaints.push(format!("{path}: {complaint}: {}", one.text));
                }
            }
        }
    }
    complaints
}

#[test]
fn no_text_is_missing() {
    expect_none(&compare(|_, message| {
        (!message.is_some_and(Message::is_translated)).then(|| "no translation".to_owned())
    }));
}

#[test]
fn no_text_is_left_over() {
    let mut complaints = Vec::new();
    for part in Part::ALL {
        let keys: Vec<String> = part.said().iter().map(Said::key).collect();
        for (path, text) in catalogues(part) {
            for message in messages(&text).unwrap() {
                if !message.text.is_empty() && !keys.contains(&message.key()) {
                    complaints.push(format!("{path}: nobody says {}", message.text));
                }
            }
        }
    }
    expect_none(&complaints);
}

#[test]
fn every_value_is_told_in_every_form() {
    expect_none(&compare(|said, message| {
        let message = message?;
        let all = places(said.plural.as_ref().unwrap_or(&said.text));
        let wrong = message.forms.iter().enumerate().find(|(i, form)| {
            let told = places(form);
            // The first form may say "one" in words.
            let is_whole = all
                .iter()
                .all(|name| told.contains(name) || *i == 0 && name == "n");
            let has_no_other = told.iter().all(|name| all.contains(name));
            !(form.is_empty() || is_whole && has_no_other)
        });
        wrong.map(|(_, form)| format!("\u{201c}{form}\u{201d} has other places"))
    }));
}

#[test]
fn what_is_counted_has_all_forms_of_its_language() {
    let mut complaints = Vec::new();
    for (path, text) in all_catalogues() {
        let read = messages(&text).unwrap();
        let head = read.iter().find(|message| message.text.is_empty()).unwrap();
        let forms = head.forms[0].split_once("nplurals=").unwrap().1;
        let forms: usize = forms.split(';').next().unwrap().trim().parse().unwrap();
        for message in read.iter().filter(|message| !message.text.is_empty()) {
            let expected = if message.plural.is_some() { forms } else { 1 };
            if message.forms.len() != expected {
                let found = message.forms.len();
                let text = &message.text;
                complaints.push(format!(
                    "{path}: {found} forms, expected {expected}: {text}"
                ));
            }
        }
    }
    expect_none(&complaints);
}

#[test]
fn a_form_begins_and_ends_with_the_blanks_of_the_english_one() {
    expect_none(&compare(|said, message| {
        let english = &said.text;
        // Where English has a blank, another language may begin with a comma.
        let fits = |form: &str| {
            if english.starts_with(' ') {
                form.starts_with([' ', ',', ';', ':', '.'])
            } else {
                !form.starts_with(' ')
            }
        };
        let ends = |form: &str| form.ends_with(' ') == english.ends_with(' ');
        let wrong = |form: &&String| !(form.is_empty() || fits(form) && ends(form));
        let wrong = message?.forms.iter().find(wrong)?;
        Some(format!("\u{201c}{wrong}\u{201d} has other blanks"))
    }));
}

#[test]
fn the_list_has_every_catalogue() {
    let list = fs::read_to_string(source::root().join(FOLDER).join("list.txt")).unwrap();
    for part in Part::ALL {
        let tags = list.lines().map(|line| line.split_once(' ').unwrap().0);
        let folder = part.folder();
        let listed: Vec<String> = tags.map(|tag| format!("{folder}/{tag}.po")).collect();
        let found: Vec<String> = catalogues(part).into_iter().map(|(path, _)| path).collect();
        assert_eq!(listed, found);
    }
}

#[test]
fn a_catalogue_is_read_as_other_programs_read_it() {
    for (path, text) in all_catalogues() {
        let catalogue = polib::po_file::parse(&source::root().join(&path)).unwrap();
        let theirs: Vec<Message> = catalogue.messages().map(message).collect();
        let mut ours = messages(&text).unwrap();
        ours.retain(|message| !message.text.is_empty());
        assert_eq!(ours, theirs, "{path}");
    }
}

fn message(message: &dyn polib::message::MessageView) -> Message {
    let is_counted = message.is_plural();
    Message {
        context: message.msgctxt().map(str::to_owned),
        text: message.msgid().to_owned(),
        plural: is_counted.then(|| message.msgid_plural().unwrap().to_owned()),
        forms: if is_counted {
            message.msgstr_plural().unwrap().clone()
        } else {
            vec![message.msgstr().unwrap().to_owned()]
        },
        is_fuzzy: message.is_fuzzy(),
    }
}

/// What the page says in German, and what the course says.
fn german() -> &'static Catalogue {
    let texts = [Part::Page, Part::Course].map(|part| {
        let path = source::root().join(part.folder()).join("de.po");
        fs::read_to_string(path).unwrap()
    });
    let german = Catalogue::read(&texts.join("\n"), Box::new(|n| usize::from(n != 1)));
    german.unwrap().kept()
}

/// What is wrong with a file, in German.
fn wrong<T>(read: Result<T, Vec<Fault>>) -> String {
    let faults = read.err().unwrap_or_default();
    let faults: Vec<String> = faults.iter().map(ToString::to_string).collect();
    faults.join(" / ")
}

#[test]
fn a_fault_of_a_file_is_told_in_the_language_that_is_spoken() {
    let scene = |start: &str| {
        format!(
            r#"{{ "giveway": 1, "map": ["..#"], "agents": [{{ "name": "A1", "start": {start}, "goal": [1, 0] }}] }}"#
        )
    };
    let native = |text: &str| wrong(native::read_instance(text));
    let other = |text: &str| wrong(giveway_formats::read(text));
    let lesson = |text: &str| wrong(read_lesson(text, &Glossary::default()));
    let in_english = native(&scene("[2, 0]"));
    speak(Some(german()));
    let told = [
        (
            native(&scene("[2, 0]")),
            "Zeile 1, Spalte 69: agents[0].start: gefunden: das Hindernis (2, 0); erwartet: eine freie Zelle",
        ),
        (
            native(&scene("7")),
            "Zeile 1, Spalte 69: agents[0].start: gefunden: die Zahl 7; erwartet: eine Zelle [x, y]",
        ),
        (
            native("{ \"giveway\": 1,"),
            "Zeile 1, Spalte 16: gefunden: das Ende der Datei; erwartet: ein Wert",
        ),
        (
            native("{ \"giveway\": 3, \"map\": [] }"),
            "Zeile 1, Spalte 14: giveway: gefunden: Version 3 des Formats; erwartet: Version 1, die einzige hier bekannte",
        ),
        (
            native(
                "{ \"giveway\": 1, \"map\": [\"..\"], \"agents\": [], \"objective\": [\"moves\", \"moves\"] }",
            ),
            "Zeile 1, Spalte 59: objective: gefunden: zweimal moves; erwartet: jede Art von Kosten nur einmal",
        ),
        (
            native(
                "{ \"giveway\": 1, \"map\": [\"..\"], \"agents\": [], \"rules\": { \"at_goal\": \"sing\" } }",
            ),
            "Zeile 1, Spalte 68: rules.at_goal: gefunden: \"sing\"; erwartet: stay oder vanish",
        ),
        (
            other("type octile\nheight 1\nwidth 3\nmap\n..\n"),
            "Zeile 5, Spalte 3: gefunden: eine Zeile mit 2 Zellen; erwartet: 3, die Breite im Kopf",
        ),
        (
            other("Agent 0: (0,0)->(0,x)->\n"),
            "Zeile 1, Spalte 20: gefunden: \"x)->\"; erwartet: eine Zahl",
        ),
        (
            lesson(r#"{ "giveway": 1, "title": "", "minutes": 1, "about": "A.", "steps": [] }"#),
            "Zeile 1, Spalte 26: title: gefunden: keine Wörter; erwartet: ein Titel / Zeile 1, Spalte 68: steps: gefunden: keine Schritte; erwartet: mindestens 1",
        ),
    ];
    let (told, expected): (Vec<_>, Vec<_>) = told.into_iter().unzip();
    assert_eq!(told, expected);
    speak(None);
    assert_eq!(
        in_english,
        "line 1, column 69: agents[0].start: found the obstacle (2, 0), expected a free cell"
    );
}

#[test]
fn a_certificate_is_the_same_whatever_is_spoken() {
    let text = r#"{ "giveway": 1, "map": ["...."], "agents": [{ "name": "A1", "start": [0, 0], "goal": [2, 0] }] }"#;
    let instance = native::read_instance(text).unwrap();
    let request = CertifyRequest {
        scene: instance.to_scene(),
        bounds: [(Cost::Makespan, 2), (Cost::SumOfCosts, 2)].into(),
        complete: true,
        ..CertifyRequest::default()
    };
    let bundle = || export(&request.claims(&instance), &Budget::default());
    let in_english = bundle();
    speak(Some(german()));
    let in_german = bundle();
    let report = verify(&in_english, &Budget::default());
    speak(None);
    assert_eq!(in_english, in_german);
    assert_eq!(report.reason, None);
    let claims = report.claims.iter().map(|claim| match claim {
        Checked::Proof { text, .. }
        | Checked::Lemmas { text, .. }
        | Checked::Search { text, .. }
        | Checked::None { text, .. } => text.as_str(),
    });
    let claims: Vec<&str> = claims.collect();
    assert_eq!(
        claims,
        [
            "Es gibt keinen Plan mit Makespan höchstens 1.",
            "Es gibt keinen Plan mit Makespan höchstens 2 und Summe der Kosten höchstens 1.",
        ]
    );
}

#[test]
fn reasons_are_said_in_the_language_that_is_spoken() {
    let stops = [
        Stop::Time,
        Stop::Conflicts,
        Stop::Memory,
        Stop::Sets,
        Stop::Cancelled,
        Stop::Contradiction,
    ];
    let english = stops.map(|stop| reason(&stop.into()));
    let agents = |n: usize| (1..=n).map(|i| format!("A{i}")).collect();
    speak(Some(german()));
    for (stop, english) in stops.into_iter().zip(english) {
        assert_ne!(reason(&stop.into()), english);
    }
    for (given, german) in [
        (
            Reason::Clash { agents: agents(2) },
            "A1 und A2 können nicht beide ankommen.",
        ),
        (
            Reason::Clash { agents: agents(3) },
            "A1, A2 und A3 können nicht alle ankommen.",
        ),
        (
            Reason::Alone {
                agent: "A1".into(),
                rules: Vec::new(),
            },
            "A1 kann die Aufgabe nicht einmal allein erfüllen.",
        ),
        (
            Reason::Cause(Box::new(Cause {
                agent: "A1".into(),
                kind: CauseKind::Goal,
                cell: Some(Cell::new(3, 1)),
                agents: Vec::new(),
                within: None,
                method: Method::Tunnel(1),
                held: Vec::new(),
                has_batteries: false,
                rule: None,
            })),
            "Das Ziel von A1 ist jetzt (3, 1), und das liegt nicht nahe dem alten Weg.",
        ),
    ] {
        assert_eq!(reason(&given), german);
    }
    speak(None);
}

#[test]
fn what_a_person_reads_goes_through_the_catalogue() {
    let mut complaints = Vec::new();
    for folder in [
        "web/src",
        "crates/giveway-page/src",
        "crates/giveway-course/src/judge/words",
    ] {
        for file in source::files(folder) {
            if is_source(&file.path) {
                let found = unsaid(&file).into_iter();
                complaints
                    .extend(found.map(|(line, text)| format!("{}:{line}: {text}", file.path)));
            }
        }
    }
    expect_none(&complaints);
}
