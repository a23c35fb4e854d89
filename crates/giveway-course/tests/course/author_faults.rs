//! Faults of a lesson that is written: each has words of the form in each language, and
//! a field where they are said.

use giveway_course::author::{Action, Draft, Whose, Wrong, field_of, form, reduce, sentence};
use giveway_course::lesson::read::{Flaw, Things};
use giveway_course::lesson::{Glossary, Text};
use giveway_model::words::{Catalogue, speak};
use giveway_model::{Cell, Cost, Fault};

use super::shipped;

/// One fault of each kind.
fn all() -> Vec<Wrong> {
    let count = |things| Flaw::TooMany {
        things,
        count: 9,
        most: 8,
    };
    let number = Flaw::OutOfRange {
        number: 0,
        least: 1,
        most: 90,
    };
    let fault = Fault::at("agents[0].start", "the obstacle (1, 1)", "a free cell");
    let name = || "A9".to_owned();
    let flaws = [
        count(Things::Hints),
        number,
        Flaw::NoTitle,
        Flaw::ControlCharacter,
        Flaw::NoWords,
        Flaw::LinkedRobot(name()),
        Flaw::LinkedCell(Cell::new(9, 9)),
        Flaw::LinkedTerm("swap".parse().unwrap()),
        Flaw::LinkedTime(99_999),
        Flaw::NoSteps,
        Flaw::NoScene,
        Flaw::BadScene(fault.clone()),
        Flaw::NoParagraphs,
        Flaw::TwoPlans,
        Flaw::NoPlan,
        Flaw::LegalPlan,
        Flaw::UnknownCell(Cell::new(9, 9)),
        Flaw::UnknownRobot(name()),
        Flaw::NoHints,
        Flaw::NoReason,
        Flaw::NoTask,
        Flaw::NoTools,
        Flaw::NoRobots,
        Flaw::OneAnswer,
        Flaw::FewAnswers(1),
        Flaw::NoRightAnswer,
        Flaw::OtherKind(name()),
        Flaw::Twice("7".to_owned()),
        Flaw::NoFront(1),
        Flaw::NotOptimised(Cost::Charges),
        Flaw::SameCosts,
        Flaw::NoMethods,
        Flaw::NoAim,
        Flaw::UnknownRule(2),
    ];
    let markup = "*open".parse::<Text>().unwrap_err();
    let own = [
        Wrong::Missing,
        Wrong::NotNumber,
        Wrong::NotCell,
        Wrong::NotCells,
        Wrong::NotQuestion("nothing was asked".to_owned()),
        Wrong::NotChanges(fault),
        Wrong::NotChoice,
        Wrong::Markup(markup),
    ];
    own.into_iter()
        .chain(flaws.into_iter().map(Wrong::Flaw))
        .collect()
}

/// Fails to compile when a kind is added, until it has a place in the list above.
const fn number(wrong: &Wrong) -> usize {
    let flaw = match wrong {
        Wrong::Missing => return 0,
        Wrong::NotNumber => return 1,
        Wrong::NotCell => return 2,
        Wrong::NotCells => return 3,
        Wrong::NotQuestion(_) => return 4,
        Wrong::NotChanges(_) => return 5,
        Wrong::NotChoice => return 6,
        Wrong::Markup(_) => return 7,
        Wrong::Flaw(flaw) => flaw,
    };
    let of_flaws = match flaw {
        Flaw::TooMany { .. } => 0,
        Flaw::OutOfRange { .. } => 1,
        Flaw::NoTitle => 2,
        Flaw::ControlCharacter => 3,
        Flaw::NoWords => 4,
        Flaw::LinkedRobot(_) => 5,
        Flaw::LinkedCell(_) => 6,
        Flaw::LinkedTerm(_) => 7,
        Flaw::LinkedTime(_) => 8,
        Flaw::NoSteps => 9,
        Flaw::NoScene => 10,
        Flaw::BadScene(_) => 11,
        Flaw::NoParagraphs => 12,
        Flaw::TwoPlans => 13,
        Flaw::NoPlan => 14,
        Flaw::LegalPlan => 15,
        Flaw::UnknownCell(_) => 16,
        Flaw::UnknownRobot(_) => 17,
        Flaw::NoHints => 18,
        Flaw::NoReason => 19,
        Flaw::NoTask => 20,
        Flaw::NoTools => 21,
        Flaw::NoRobots => 22,
        Flaw::OneAnswer => 23,
        Flaw::FewAnswers(_) => 24,
        Flaw::NoRightAnswer => 25,
        Flaw::OtherKind(_) => 26,
        Flaw::Twice(_) => 27,
        Flaw::NoFront(_) => 28,
        Flaw::NotOptimised(_) => 29,
        Flaw::SameCosts => 30,
        Flaw::NoMethods => 31,
        Flaw::NoAim => 32,
        Flaw::UnknownRule(_) => 33,
    };
    8 + of_flaws
}

/// Signs and words of files that no form shows.
const OF_FILES: [&str; 8] = [
    "[",
    "{",
    "\"paint\"",
    "\"right\"",
    "kept\"",
    "steps.",
    "task.",
    "until",
];

#[test]
fn each_kind_of_fault_has_words_of_the_form_in_both_languages() {
    let all = all();
    let numbers: Vec<usize> = all.iter().map(number).collect();
    assert_eq!(numbers, (0..42).collect::<Vec<_>>());
    let said = || -> Vec<String> { all.iter().map(|wrong| sentence(wrong, None)).collect() };
    let english = said();
    let file = |name: &str| {
        let path = shipped::folder().join("../languages").join(name);
        std::fs::read_to_string(path).unwrap()
    };
    let texts = [file("de.po"), file("course/de.po")].join("\n");
    let german = Catalogue::read(&texts, Box::new(|n| usize::from(n != 1)));
    speak(Some(german.unwrap().kept()));
    let german = said();
    speak(None);
    for (english, german) in english.iter().zip(&german) {
        assert_ne!(english, german);
        for said in [english, german] {
            assert!(said.ends_with('.'), "{said}");
            let sign = OF_FILES.iter().find(|sign| said.contains(**sign));
            assert_eq!(sign, None, "{said}");
        }
    }
}

fn write(draft: Draft, field: &str, text: &str) -> Draft {
    let (field, text) = (field.to_owned(), text.to_owned());
    let whose = Whose::Step;
    reduce(draft, Action::Write { whose, field, text })
}

#[test]
fn a_fault_is_said_at_its_field_and_in_the_list() {
    let lesson = shipped::lesson("two-robots-one-cell");
    let scene = lesson.steps[0].scene.clone().unwrap();
    let mut draft = reduce(Draft::default(), Action::TakeScene(Box::new(scene)));
    draft = write(draft, "text", "See [A9](robot:A9).");
    draft = write(draft, "edits", "one");
    draft = write(draft, "tools", "obstacle");
    draft = write(draft, "task.kind", "choose");
    draft = write(draft, "task.answers[0].claim.is", "legal");
    let looked = draft.look(&Glossary::default());
    let fields = form(draft.step().unwrap(), draft.scene(0));
    let list: Vec<String> = looked
        .to_do(&draft)
        .into_iter()
        .map(|line| line.text)
        .collect();
    for (name, line) in [
        (
            "text",
            "Step 1, Text: The board of this step has no robot A9.",
        ),
        (
            "edits",
            "Step 1, The most edits: Write a whole number here.",
        ),
        ("task.say", "Step 1, What it asks: Write something here."),
    ] {
        let mut faults = looked.faults().iter();
        let is_there = |field: &str| field == name;
        assert!(
            faults
                .any(|fault| field_of(&fields, &fault.place)
                    .is_some_and(|field| is_there(&field.name))),
            "{name}"
        );
        assert!(list.iter().any(|said| said == line), "{line}: {list:#?}");
    }

    // What no answer is right with is mended at a switch, and a plan at its choice.
    for (field, text) in [
        ("task.say", "Who?"),
        ("task.answers[0].text", "A1"),
        ("task.answers[0].reply", "No."),
        ("task.answers[1].text", "A2"),
        ("task.answers[1].reply", "No."),
        ("reason", "So."),
    ] {
        draft = write(draft, field, text);
    }
    let looked = draft.look(&Glossary::default());
    let fields = form(draft.step().unwrap(), draft.scene(0));
    let at = |flaw: &Flaw| {
        let mut faults = looked.faults().iter();
        let fault = faults.find(|fault| fault.wrong == Wrong::Flaw(flaw.clone()));
        let field = field_of(&fields, &fault.unwrap().place);
        field.map(|field| field.name.clone()).unwrap_or_default()
    };
    assert_eq!(at(&Flaw::NoRightAnswer), "task.answers[0].right");
    assert_eq!(at(&Flaw::NoPlan), "plan");
}
