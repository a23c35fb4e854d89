//! Questions as they are typed, and as JSON.

use giveway_model::Question;
use giveway_model::question::{from_words, to_words};

use super::question;

const TYPED: [&str; 25] = [
    "wait A2",
    "wait A2 --at 3,1 --from 0 --to 2",
    "wait A2 --at-least 2",
    "charge A1",
    "charge A1 --at 6,2 --time 9",
    "no-charge A1 --at 3,2",
    "visit A1 --at 3,1",
    "visit A1 --at 3,1 --time 0",
    "no-visit A1 --at 3,1",
    "no-visit any --at 3,1",
    "move A1 --from-cell 0,0 --to-cell 1,0 --time 4",
    "no-move A1 --from-cell 0,0 --to-cell 1,0",
    "slow A1",
    "slow A1 --from-cell 2,0 --to-cell 3,0",
    "order A1 --first 2,0 --second 4,2",
    "arrival A1",
    "length A1 --fewer-than 7",
    "makespan",
    "sum-of-costs",
    "penalty",
    "charges",
    "moves A1",
    "waits A1",
    "yield A1 A2 --at 3,1",
    "plan",
];

#[test]
fn words_and_json_come_back() {
    for typed in TYPED {
        let read = question(typed);
        assert_eq!(to_words(&read), typed);
        let json = serde_json::to_string(&read).unwrap();
        assert_eq!(serde_json::from_str::<Question>(&json).unwrap(), read);
        assert!(typed.starts_with(read.kind()));
    }
}

#[test]
fn the_keys_of_json() {
    let json = serde_json::to_string(&question("wait A2 --at 3,1 --from 0 --to 2")).unwrap();
    assert_eq!(
        json,
        r#"{"kind":"wait","agent":"A2","at":[3,1],"from":0,"to":2}"#
    );
    let json = serde_json::to_string(&question("length A1 --fewer-than 7")).unwrap();
    assert_eq!(json, r#"{"kind":"length","agent":"A1","fewer-than":7}"#);
    assert!(
        serde_json::from_str::<Question>(r#"{"kind":"arrival","agent":"A1","at":[0,0]}"#).is_err()
    );
}

#[test]
fn a_cell_may_be_written_as_in_sentences() {
    let words = ["visit", "A1", "--at", "(3, 1)"];
    assert_eq!(from_words(&words), Ok(question("visit A1 --at 3,1")));
}

#[test]
fn what_is_no_question() {
    for (typed, said) in [
        ("why A1", "Found \"why\", expected one of wait, charge"),
        ("wait", "\"wait\" needs a robot."),
        ("yield A1 --at 1,1", "\"yield\" needs two robots."),
        ("visit A1", "\"visit\" needs --at."),
        ("visit A1 --at", "Found --at without a value."),
        ("visit A1 --at 3", "--at: found \"3\", expected a cell X,Y."),
        ("visit A1 --at 3,x", "--at: found \"3,x\", expected a cell"),
        (
            "wait A1 --from -1",
            "--from: found \"-1\", expected a whole",
        ),
        ("wait A1 --time 3", "\"wait\" does not use --time."),
        ("wait A1 A2", "\"wait\" does not use \"A2\"."),
        ("makespan A1", "\"makespan\" does not use \"A1\"."),
        ("slow A1 --from-cell 1,1", "\"slow\" needs --to-cell."),
        ("wait A1 --when 3", "There is no option --when."),
    ] {
        let words: Vec<&str> = typed.split(' ').collect();
        let sentence = from_words(&words).unwrap_err().to_string();
        assert!(sentence.starts_with(said), "{typed}: {sentence}");
    }
    assert!(from_words::<&str>(&[]).is_err());
}
