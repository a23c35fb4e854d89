//! Plans of the MAPF tracker.

use giveway_formats::{Format, MAX_STEPS, Up, Walk, recognise};
use giveway_model::check::costs;

use crate::support::{
    assert_comes_back, assert_fault, data, one, opened, plan, violations, with_small,
};

/// The plan for the small map: `u` is `y - 1`.
const PATHS: [&str; 3] = ["2rdur", "3l", "2wu2rdr"];

fn csv(flip: &str, plan: &str) -> String {
    format!(
        "map_name,scen_type,type_id,agents,solution_plan,solution_cost,flip_up_down\n\
         \"small\",random,1,3,\"{plan}\",11,{flip}\n"
    )
}

#[test]
fn the_published_plan_is_legal_and_costs_what_it_says() {
    let text = data("plans/random-32-32-20_random-1_300.tracker.csv");
    assert_eq!(recognise(&text), Ok(Format::Tracker));
    let (map, scenario) = (
        data("movingai/random-32-32-20.map"),
        data("movingai/random-32-32-20-random-1.scen"),
    );
    let combined = opened(&[
        ("random-32-32-20-random-1.scen", &scenario),
        ("random-32-32-20_random-1_300.csv", &text),
        ("random-32-32-20.map", &map),
    ]);
    let read = one(&combined);
    assert_eq!(read.plan.paths.len(), 300);
    assert_eq!(read.conventions.up, Up::Raises);
    assert!(read.fit.is_perfect());
    assert!(read.alternatives[0].misfit.is_some());
    assert_eq!(violations(&combined), []);
    let costs = costs(&combined.instance, &read.plan).unwrap();
    assert_eq!(costs.sum_of_costs, 9647);
    assert_eq!(read.claimed.sum_of_costs, Some(9647));
    for format in [Format::Tracker, Format::Paths, Format::Result] {
        assert_comes_back(format, &combined);
    }
}

#[test]
fn both_meanings_of_up_are_found_out() {
    let flipped = PATHS.join("\n").replace('u', "_").replace('d', "u");
    let flipped = flipped.replace('_', "d");
    for (text, up) in [
        (csv("FALSE", &PATHS.join("\n")), Up::Lowers),
        (csv("TRUE", &flipped), Up::Raises),
        // The file says the opposite of what it means.
        (csv("TRUE", &PATHS.join("\n")), Up::Lowers),
        (csv("FALSE", &flipped), Up::Raises),
    ] {
        let combined = with_small("plan.csv", &text);
        assert_eq!(one(&combined).conventions.up, up, "{text}");
        assert_eq!(violations(&combined), []);
        assert_comes_back(Format::Tracker, &combined);
    }
}

#[test]
fn tables_json_and_yaml_hold_the_same_plan() {
    let lines = PATHS.join("\n");
    let expected = plan(&csv("false", &lines));
    let (one, escaped) = (PATHS[2], PATHS.join("\\n"));
    let head = r#""map_name": "small", "scen_type": "random", "type_id": 1, "agents": 3"#;
    let list = format!(r#"["{}", "lll", "ww{}"]"#, PATHS[0], "urrdr");
    let texts = [
        csv("", &PATHS.join("\r\n"))
            .replace('\n', "\r\n")
            .replace("\r\r", "\r"),
        csv("", &lines).trim_end().to_owned(),
        format!("\u{feff}{}", csv("", &lines)),
        format!(r#"{{ {head}, "solution_cost": 11, "solution_plan": "{escaped}" }}"#),
        format!(
            r#"[{{ {head}, "solution_cost": 11, "solution_plan": {list}, "paper_reference": [1] }}]"#
        ),
        format!(
            "map_name: small\nscen_type: random\ntype_id: 1\nagents: 3\nsolution_cost: 11\n\
             solution_plan:\n  - rrdur\n  - rrr\n  - {one}\n"
        )
        .replace("- rrr", "- \"lll\""),
        format!(
            "---\n# One.\n- map_name: \"small\"\n  agents: 3\n  solution_cost: 11\n  \
             lower_cost:\n  solution_plan: |\n    2rdur\n    3l\n    {one}\n"
        ),
    ];
    for text in texts {
        assert_eq!(recognise(&text), Ok(Format::Tracker), "{text}");
        assert_eq!(plan(&text), expected, "{text}");
    }
}

#[test]
fn of_several_solutions_the_largest_with_a_plan_is_taken() {
    let text = "map_name,scen_type,type_id,agents,solution_plan\n\
        m,even,2,3,\nm,even,2,2,\"u\n\"\nm,even,2,1,u\n";
    let read = plan(text);
    assert_eq!(read.agents.len(), 2);
    // The second robot does not move: its line is empty.
    assert_eq!(read.agents[1].walk, Walk::Moves(Vec::new()));
    assert_eq!(
        read.notes,
        ["The file has 3 solutions; this is the one with a plan for 2 robots of m-even-2."]
    );
    let yaml = "agents: 1\nsolution_plan: u\n---\nagents: 2\nsolution_plan:\n  - u\n  - d\n";
    assert_eq!(plan(yaml).agents.len(), 2);
}

#[test]
fn faults_have_their_places() {
    let letters = "u, d, l, r, w or a run length";
    assert_fault(&csv("", "3r\n3x\nu"), (3, 2), "\"x\"", letters);
    assert_fault(
        &csv("", "3r\n3\nu"),
        (3, 2),
        "the end of the path",
        "u, d, l, r or w",
    );
    assert_fault(&csv("maybe", "u"), (2, 27), "\"maybe\"", "TRUE or FALSE");
    assert_fault(&csv("", "u"), (2, 21), "1 path", "3, as \"agents\" says");
    assert_fault(
        "agents,path\n3\n",
        (2, 1),
        "1 value",
        "2, as the first line has columns",
    );
    assert_fault(
        "agents,path\n3,\"uu\n",
        (2, 3),
        "a quote without its end",
        "another quote",
    );
    let json = "{ \"agents\": 2,\n  \"solution_plan\": [\"u\",\n \"d?\"] }";
    assert_fault(json, (3, 4), "\"?\"", letters);
    assert_fault(
        "{ \"agents\": 2,\n \"solution_plan\": \"u\\nd?\" }",
        (2, 24),
        "\"?\"",
        letters,
    );
    assert_fault(
        "agents: 2\nsolution_plan:\n  - u\n  - d?\n",
        (4, 5),
        "\"?\" at letter 2 of the path",
        letters,
    );
    assert_fault(
        "flip_up_down: |\n  yes\n  no\nsolution_plan: u\n",
        (2, 3),
        "\"yes\u{fffd}no\u{fffd}\"",
        "true or false",
    );
    assert_fault(
        "agents: 2\nsolution_plan:\n  - u\n",
        (3, 3),
        "1 path",
        "2, as \"agents\" says",
    );
    assert_fault(
        "agents: 2\nsolution_plan: |\n  u\n  d?\n",
        (3, 3),
        "\"?\" at letter 4 of all paths",
        letters,
    );
    let fault = crate::support::fault("agents: 2\nsolution_plan:\n  - u\n  - d?\n");
    assert_eq!(fault.place, "solution_plan[1]");
    assert_eq!(crate::support::fault(json).place, "solution_plan[1]");
}

#[test]
fn a_long_run_is_refused_before_there_is_room_for_it() {
    let most = format!("at most {MAX_STEPS} steps of all robots");
    let found = format!("a plan of over {MAX_STEPS} steps");
    assert_fault(&csv("", "u\nd\n2000000000r"), (4, 1), &found, &most);
    assert_fault(
        &csv("", "u\nd\n99999999999r"),
        (4, 1),
        "a run of over 2147483647 steps",
        "at most 2147483647",
    );
}

#[test]
fn nothing_deep_fills_the_memory() {
    for text in [
        format!("solution_plan: {}", "[".repeat(100_000)),
        format!("other:\n  {}1\nsolution_plan: u", "- ".repeat(100_000)),
    ] {
        let fault = crate::support::fault(&text);
        assert!(fault.line.is_some(), "{fault}");
    }
}

#[test]
fn nothing_long_fills_the_memory() {
    let many = 200_000;
    for (text, found) in [
        (
            format!("agents,path\n,\"{}\"", "\n".repeat(many)),
            "over 10000 robots",
        ),
        (
            format!("agents,path\n{}", "1,u\n".repeat(many)),
            "over 4096 solutions",
        ),
        (
            format!("agents,path\n{}", ",".repeat(many)),
            "over 64 values",
        ),
        (
            format!("{{ \"solution_plan\": [{}\"u\"] }}", "\"u\",".repeat(many)),
            "over 10000 robots",
        ),
        (
            format!("[{}{{ \"solution_plan\": null }}]", "{},".repeat(many)),
            "over 4096 solutions",
        ),
        (
            format!("solution_plan:\n{}", "- u\n".repeat(19_000)),
            "over 10000 robots",
        ),
        (
            format!("{}solution_plan: u", "---\n{}\n".repeat(9_000)),
            "over 4096 solutions",
        ),
        (
            (0..19_000).fold(String::new(), |text, i| text + &format!("Agent {i}:\n")),
            "over 10000 robots",
        ),
        (
            "agents=2000000000\nsolution=\n".to_owned(),
            "over 10000 robots",
        ),
        (format!("0:{}", "(0,0),".repeat(many)), "over 10000 robots"),
        (
            format!("starts={}", "(0,0),".repeat(many)),
            "over 10000 robots",
        ),
    ] {
        let fault = crate::support::fault(&text);
        assert_eq!(fault.found, found);
        assert!(fault.line.is_some(), "{fault}");
    }
}
