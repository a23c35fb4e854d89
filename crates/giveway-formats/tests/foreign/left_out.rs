//! Rules of other problems that scenes do not have: told by the files that have them.

use giveway_formats::Combined;
use giveway_model::constraint::{ConstraintKind, Heading};
use giveway_model::format::link::scene::{read, write};
use giveway_model::format::native::{read_instance, write_scene};
use giveway_model::{Assumption, LeftOutRule, Scene};

use crate::support::{data, opened};

const ROOM: &str = "type octile\nheight 3\nwidth 4\nmap\n....\n....\n@...\n";

fn rules(combined: &Combined) -> Vec<LeftOutRule> {
    let assumptions = combined.instance.assumptions().iter();
    let rules = assumptions.filter_map(|one| match one {
        Assumption::RuleLeftOut { rule } => Some(*rule),
        _ => None,
    });
    rules.collect()
}

/// Whether each robot turns from where it faces at first, a step for a quarter turn.
fn turning(combined: &Combined) -> bool {
    let mut agents = combined.instance.agents().iter();
    let rules = combined.instance.constraints_in_force();
    let turns = rules.filter(|rule| {
        rule.constraint.kind == ConstraintKind::Turns { quarter: 1 }
            && rule.agents.len() == combined.instance.agents().len()
    });
    turns.count() == 1 && agents.all(|agent| agent.heading.is_some())
}

#[test]
fn plans_that_do_not_agree_on_turns_leave_them_out() {
    let turning = |heading: &str| {
        format!(
            r#"{{"actionModel": "MAPF_T", "start": [[0, 0, "{heading}"]], "actualPaths": ["F,F"]}}"#
        )
    };
    let paths = "schedule: {agent0: [{t: 0, x: 0, y: 0}, {t: 1, x: 1, y: 0}]}\n";
    let (east, south) = (turning("E"), turning("S"));
    for other in [&*south, paths] {
        let files = [("room.map", ROOM), ("a.json", &*east), ("b.json", other)];
        let read = opened(&files).unwrap();
        assert_eq!(rules(&read), [LeftOutRule::Turning]);
        assert!(read.instance.constraints().is_empty());
    }
    let read = opened(&[("room.map", ROOM), ("a.json", &east), ("b.json", &east)]).unwrap();
    assert_eq!(rules(&read), []);
    assert_eq!(read.instance.agents()[0].heading, Some(Heading::East));
}

#[test]
fn turns_long_moves_and_the_order_of_errands_are_told_by_results() {
    let of = |text: &str| {
        let read = opened(&[("room.map", ROOM), ("r.json", text)]).unwrap();
        let rules = rules(&read);
        let is_told = read.notes.iter().any(|note| note.contains("left out here"));
        assert_eq!(is_told, !rules.is_empty(), "{:?}", read.notes);
        (rules, turning(&read))
    };
    assert_eq!(
        of(include_str!("../data/plans/small-league-2024.json")),
        (vec![LeftOutRule::ErrandOrder], true)
    );
    assert_eq!(
        of(include_str!("../data/plans/small-league-2026.json")),
        (vec![LeftOutRule::LongMoves], true)
    );
    let plain = r#"{"actionModel": "MAPF", "start": [[0, 0, "N/A"]], "actualPaths": ["R"]}"#;
    assert_eq!(of(plain), (vec![], false));
}

#[test]
fn robots_of_a_problem_of_the_league_turn_and_have_chosen_tasks() {
    let problem = r#"{ "mapFile": "a.map", "agentFile": "a.agents", "taskFile": "a.tasks" }"#;
    let of = |tasks: &str| {
        let files = [
            ("p.json", problem),
            ("a.map", ROOM),
            ("a.agents", "1\n0\n"),
            ("a.tasks", tasks),
        ];
        opened(&files).unwrap()
    };
    let two = of("1\n5,3\n");
    assert_eq!(rules(&two), []);
    assert!(turning(&two));
    assert_eq!(two.instance.assumptions()[0], Assumption::GoalsChosen);
    // The first errand is at the goal: as a waypoint it is left out, and so is its order.
    for tasks in ["1\n5,6,3\n", "1\n3,5,3\n"] {
        assert_eq!(rules(&of(tasks)), [LeftOutRule::ErrandOrder]);
    }
}

#[test]
fn shelves_are_handled_where_there_are_picking_stations_or_actions() {
    let carried = data("asprilo/x2_y2_n4_r2_s2_ps1_pr2_u4_o2_N1.lp");
    let read = opened(&[("a.lp", &carried)]).unwrap();
    assert_eq!(rules(&read), [LeftOutRule::Handling]);
    let nodes = "init(object(node,1),value(at,(1,1))). init(object(node,2),value(at,(2,1))).\n\
        init(object(robot,1),value(at,(1,1))). init(object(shelf,1),value(at,(2,1))).\n\
        init(object(product,1),value(on,(1,1))). init(object(order,1),value(line,(1,1))).\n";
    assert_eq!(rules(&opened(&[("m.lp", nodes)]).unwrap()), []);
    let moves = "occurs(object(robot,1),action(move,(1,0)),1).\n";
    let lifts = "occurs(object(robot,1),action(pickup,()),2).\n";
    let plan = |text: &str| rules(&opened(&[("m.lp", nodes), ("p.lp", text)]).unwrap());
    assert_eq!(plan(moves), []);
    assert_eq!(plan(&format!("{moves}{lifts}")), [LeftOutRule::Handling]);
}

#[test]
fn a_rule_that_is_left_out_goes_through_files_and_links() {
    let instance = read_instance(r#"{ "giveway": 1, "map": [".."], "agents": [{ "name": "A1", "start": [0, 0], "goal": [1, 0] }] }"#).unwrap();
    for rule in LeftOutRule::ALL {
        let assumption = Assumption::RuleLeftOut { rule };
        let scene = instance.clone().assuming([assumption.clone()]).to_scene();
        let file = read_instance(&write_scene(&scene)).unwrap();
        assert_eq!(file.assumptions(), std::slice::from_ref(&assumption));
        let link = write(&scene);
        let mut linked = Scene::default();
        for part in link.split('&').skip(1) {
            let (key, value) = part.split_once('=').unwrap();
            read(&mut linked, key, value).unwrap();
        }
        assert_eq!(linked.assumptions, [assumption]);
    }
}
