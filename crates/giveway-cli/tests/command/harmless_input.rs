//! Input that looks odd and is fine.

use crate::run::{Folder, WAREHOUSE, two_agents};

/// Status, makespan and exit status of `giveway solve scene.json`.
fn check(text: &str, options: &str, expect: (&str, Option<u64>)) {
    let run = Folder::scene(text).run(&format!("solve scene.json --format json {options}"));
    let answer = run.json();
    let makespan = answer["costs"]["makespan"].as_u64();
    assert_eq!((answer["status"].as_str().unwrap(), makespan), expect);
}

#[test]
fn line_ends_and_marks() {
    check(&WAREHOUSE.replace('\n', "\r\n"), "", ("optimal", Some(18)));
    check(WAREHOUSE.trim_end(), "", ("optimal", Some(18)));
    check(&format!("\u{feff}{WAREHOUSE}"), "", ("optimal", Some(18)));
}

#[test]
fn no_agents() {
    let text = r#"{ "giveway": 1, "map": ["."], "agents": [] }"#;
    check(text, "", ("optimal", Some(0)));
    check(WAREHOUSE, "--agents 0", ("optimal", Some(0)));
}

#[test]
fn horizon_0() {
    check(WAREHOUSE, "--within 0", ("impossible", None));
    let at_home = two_agents(&[("[3, 1]", "[0, 0]"), ("[0, 1]", "[3, 0]")]);
    check(&at_home, "--within 0", ("optimal", Some(0)));
}

#[test]
fn a_battery_that_reaches_no_charger() {
    let flat = WAREHOUSE.replace("\"initial\": 8", "\"initial\": 2");
    check(&flat, "", ("impossible", None));
    let below_the_floor =
        WAREHOUSE.replacen("\"map\"", "\"rules\": { \"battery_floor\": 9 }, \"map\"", 1);
    check(&below_the_floor, "", ("impossible", None));
}

#[test]
fn standard_input() {
    let run = Folder::scene("").run_with("solve - --format json", WAREHOUSE);
    assert_eq!(run.json()["costs"]["makespan"], 18);
}

#[test]
fn a_name_that_steers_terminals_is_written_as_it_is_spelled() {
    let text = two_agents(&[("\"two\"", "\"\\u001b[31mred\"")]);
    let run = Folder::scene(text).run("solve scene.json");
    assert!(
        run.answer().starts_with("\\u{1b}[31mred: 4 x 2 cells"),
        "{}",
        run.out
    );
}

/// A name steers no terminal, whatever is asked about it.
#[test]
fn the_name_in_a_question_steers_no_terminal() {
    let name = "A\u{1b}[31mX\u{7}\n\u{202e}B";
    let scene = r#"{ "giveway": 1, "name": "n\u001b]0;t\u0007m", "map": ["..."], "agents": [
        { "name": "A\u001b[31mX\u0007\n\u202eB", "start": [0, 0], "goal": [2, 0] }] }"#;
    let folder = Folder::with(&[("scene.json", scene)]);
    for question in ["arrival", "length", "moves"] {
        let mut command = crate::run::command();
        command.current_dir(folder.path("."));
        let output = command
            .args(["explain", "scene.json", question, name])
            .output()
            .unwrap();
        let text = String::from_utf8(output.stdout).unwrap();
        assert!(!text.is_empty());
        let steers = |c: char| (c.is_control() && c != '\n') || c == '\u{202e}';
        assert!(!text.chars().any(steers), "{text:?}");
        assert!(!text.contains("\nB"), "{text:?}");
    }
}
