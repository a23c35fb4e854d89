//! Files as a person may open them.

use crate::FileAction;
use giveway_model::{Cell, Fault};

use super::*;

fn file(name: &str, text: &str) -> Opened {
    Opened {
        name: name.to_owned(),
        bytes: text.as_bytes().to_vec(),
    }
}

const MAP: &str = "type octile\nheight 2\nwidth 3\nmap\n.@.\n...\n";
const SCEN: &str =
    "version 1\n0\tmaps/small.map\t3\t2\t0\t0\t2\t0\t4\n0\tmaps/small.map\t3\t2\t2\t1\t0\t1\t2\n";

fn scene_of(files: &[Opened]) -> Scene {
    match read(files) {
        Ok(Reading::Scene(scene)) => *scene,
        other => panic!("{other:?}"),
    }
}

#[track_caller]
fn refused(files: &[Opened], detail: &str) {
    let notice = read(files).unwrap_err();
    assert!(!notice.sentence().is_empty());
    assert_eq!(notice.details(), [detail]);
}

#[test]
fn a_scene_of_its_own() {
    let text = r#"{"giveway": 1, "map": ["..", ".."], "agents": []}"#;
    let scene = scene_of(&[file("two by two.json", text)]);
    assert_eq!(scene.map, ["..", ".."]);
    assert_eq!(scene.name, "two by two", "named by its file");
}

#[test]
fn the_name_in_the_file_counts_more() {
    let text = r#"{"giveway": 1, "name": "own", "map": ["."], "agents": []}"#;
    assert_eq!(scene_of(&[file("other.json", text)]).name, "own");
}

#[test]
fn a_broken_scene_is_told_with_file_line_and_column() {
    let text = "{\n  \"giveway\": 1,\n  \"mapp\": []\n}";
    refused(
        &[file("broken.json", text)],
        &format!(
            "broken.json, {}",
            Fault::at(
                "",
                "the unknown key \"mapp\"",
                "one of giveway, name, map, rules, objective, agents, assumptions, zones, constraints, units"
            )
            .in_text(3, 3)
        ),
    );
}

#[test]
fn a_map_alone_has_no_agents() {
    let scene = scene_of(&[file("small.map", MAP)]);
    assert_eq!(scene.map, [".#.", "..."]);
    assert!(scene.agents.is_empty());
    assert_eq!(scene.name, "small");
}

#[test]
fn a_map_and_a_scenario_ask_for_a_number() {
    let files = [file("small-random-1.scen", SCEN), file("small.MAP", MAP)];
    let Ok(Reading::Scenario(choice)) = read(&files) else {
        panic!("no scenario");
    };
    assert_eq!((choice.most(), choice.proposed()), (2, 2));
    assert_eq!(choice.file(), "small-random-1.scen");
    let scene = choice.scene(2).unwrap();
    assert_eq!(scene.name, "small-random-1");
    assert_eq!(scene.agents[1].start, Cell::new(2, 1));
    assert!(choice.scene(3).is_err());
}

#[test]
fn a_scenario_alone_says_which_map_is_missing() {
    refused(
        &[file("small.scen", SCEN)],
        "it is a scenario for small.map: open both files together",
    );
}

#[test]
fn a_scenario_for_another_size_is_refused_at_once() {
    let wider = "type octile\nheight 2\nwidth 4\nmap\n....\n....\n";
    let files = [file("small.scen", SCEN), file("wider.map", wider)];
    let notice = read(&files).unwrap_err();
    assert!(notice.details()[0].starts_with("small.scen, line 2"));
}

#[test]
fn too_many_files() {
    let files = [file("a.json", "{}"), file("b.map", MAP)];
    let notice = read(&files).unwrap_err();
    assert_eq!(notice.details()[0], "found 1 JSON file, 1 map, 0 scenarios");
    assert!(read(&[]).is_err());
}

#[test]
fn bytes_that_are_no_text() {
    let file = Opened {
        name: "photo.json".to_owned(),
        bytes: vec![0xff, 0xd8, 0xff, 0xe0],
    };
    refused(
        &[file],
        "photo.json, line 1, column 1: found a picture (JPEG), expected a text: a map, a scenario, an instance or a plan",
    );
}

#[test]
fn large_files_are_refused_by_their_size() {
    let most = crate::intake::MAX_BYTES;
    assert_eq!(too_large("paths.txt", most), None);
    let notice = too_large("paths.txt", most + 1).unwrap();
    assert_eq!(notice.details(), ["found 21 MB, expected at most 20 MB"]);
    // Files of the page's own are smaller.
    let huge = " ".repeat(10_000_001);
    let notice = read(&[file("a.json", &huge)]).unwrap_err();
    assert_eq!(notice.details(), ["found 11 MB, expected at most 10 MB"]);
}

#[test]
fn an_unknown_ending_is_told_by_its_beginning() {
    assert_eq!(scene_of(&[file("small.txt", MAP)]).map.len(), 2);
    assert!(read(&[file("small", SCEN)]).is_err());
}

#[test]
fn many_faults_are_not_all_told() {
    let agent = |i| format!(r#"{{"name": "A{i}", "start": [9, 9], "goal": [0, 0]}}"#);
    let agents: Vec<String> = (0..9).map(agent).collect();
    let text = format!(
        r#"{{"giveway": 1, "map": ["..."], "agents": [{}]}}"#,
        agents.join(",")
    );
    let notice = read(&[file("many.json", &text)]).unwrap_err();
    assert_eq!(notice.details().len(), TOLD + 1);
    assert!(notice.details()[TOLD].starts_with("and "));
}

#[test]
fn a_scene_with_its_plan_and_what_changed() {
    let state = crate::tests::adopted();
    let saved = [
        scene_file(&state),
        plan_file(&state).unwrap(),
        changes_file(&state).unwrap(),
    ];
    assert_eq!(saved[2].name, "dynamic-3x3-changes.json");
    let all = saved.map(|saved| file(&saved.name, &saved.text));
    let Ok(Reading::Linked(linked)) = read(&all) else {
        panic!("they belong together");
    };
    let opened = crate::reduce(
        &state,
        crate::Action::File(FileAction::OpenLink(Box::new(linked.linked))),
    );
    let course = |state: &crate::State| {
        state
            .document
            .answer
            .as_ref()
            .unwrap()
            .course
            .clone()
            .unwrap()
    };
    assert_eq!(course(&opened).changes, course(&state).changes);
    assert_eq!(opened.plan(), state.plan());
    // Without its changes the plan breaks rules.
    let illegal = read(&all[..2]).unwrap();
    assert!(matches!(illegal, Reading::Illegal(_)), "{illegal:?}");
    refused(&all[1..2], "it is a plan: open it together with its scene");
    refused(
        &all[2..],
        "these are changes: open them together with their scene and plan",
    );
    let broken = file("c.json", r#"{ "giveway": 1, "changes": [{ "at": 1 }] }"#);
    let notice = read(&[all[0].clone(), all[1].clone(), broken]).unwrap_err();
    assert!(
        notice.details()[0].starts_with("c.json, line 1"),
        "{notice:?}"
    );
}

/// What the reader makes of a text that was pasted.
fn reader(state: &crate::State, text: &str) -> crate::State {
    let Ok(Pasted::File(files)) = pasted(state, text) else {
        panic!("it is for the reader");
    };
    let action = crate::IntakeAction::Read(files);
    let asked = crate::reduce(state, crate::Action::Intake(action));
    let job = asked.intake.job().unwrap();
    let reply = std::rc::Rc::new(crate::intake::work((*job.task).clone()));
    let action = crate::IntakeAction::Reply { job: job.id, reply };
    crate::reduce(&asked, crate::Action::Intake(action))
}

#[test]
fn a_pasted_plan_is_for_the_scene_on_the_board() {
    let state = crate::sample::solved();
    let plan = plan_file(&state).unwrap().text;
    let mut unsolved = state.clone();
    unsolved.document.answer = None;
    assert_eq!(reader(&unsolved, &plan).plan(), state.plan());
    let other = crate::State::new(crate::Draft::default());
    let refused = reader(&other, &plan).view.notice.unwrap();
    assert!(refused.sentence().contains("Pasted text"), "{refused:?}");
}

#[test]
fn a_pasted_scene_is_opened() {
    let fresh = crate::State::new(crate::Draft::default());
    let state = crate::sample::solved();
    let opened = reader(&fresh, &scene_file(&state).text);
    assert_eq!(
        opened.document.draft.scene().agents,
        state.document.agents()
    );
    assert!(opened.intake.job().is_none());
}

#[test]
fn a_run_is_read_by_the_reader_and_judged_by_the_page() {
    let state = crate::tests::adopted();
    let saved = [
        scene_file(&state),
        plan_file(&state).unwrap(),
        changes_file(&state).unwrap(),
    ];
    let files = saved.map(|saved| file(&saved.name, &saved.text)).to_vec();
    let fresh = crate::State::new(crate::Draft::default());
    assert_eq!(read_beside(&fresh, &files), None, "it is for the reader");
    let action = crate::IntakeAction::Read(files);
    let asked = crate::reduce(&fresh, crate::Action::Intake(action));
    let job = asked.intake.job().unwrap();
    let reply = std::rc::Rc::new(crate::intake::work((*job.task).clone()));
    let action = crate::IntakeAction::Reply { job: job.id, reply };
    let opened = crate::reduce(&asked, crate::Action::Intake(action));
    assert_eq!(opened.view.notice, None);
    assert_eq!(opened.plan(), state.plan());
    let changes = |state: &crate::State| {
        let answer = state.document.answer.clone().unwrap();
        answer.course.as_ref().unwrap().changes.clone()
    };
    assert_eq!(changes(&opened), changes(&state));
}

#[test]
fn a_pasted_link_is_opened_and_a_broken_one_refused() {
    let state = crate::sample::solved();
    let link = format!(
        " https://example.org/play?x#{}\n",
        crate::link::write(&state)
    );
    let opened = pasted(&state, &link);
    assert!(matches!(opened, Ok(Pasted::Read(Reading::Linked(_)))));
    let broken = pasted(&state, "https://example.org/#giveway=9").unwrap_err();
    assert!(broken.details()[0].contains("version 9"), "{broken:?}");
}

#[test]
fn a_pasted_text_is_refused_with_its_place() {
    let state = crate::sample::solved();
    let broken = reader(&state, "{\n  \"giveway\": 1,\n  \"map\": [");
    let broken = broken.view.notice.unwrap();
    assert!(
        broken.details()[0].contains("Pasted text, line 3"),
        "{broken:?}"
    );
    let huge = "x".repeat(10_000_001);
    let refused = pasted(&state, &huge).unwrap_err();
    assert!(refused.details()[0].contains("11 MB"), "{refused:?}");
}
