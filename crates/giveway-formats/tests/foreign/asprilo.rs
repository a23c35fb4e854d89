//! asprilo: the published instances and the published plan.

use giveway_formats::{Format, Held, Missing, read, recognise, write};
use giveway_model::check::Rule;
use giveway_model::{Agent, Cell, Instance, Plan, Scene};

use crate::support::{comes_back, data, lacking, opened, refused, reopened, violations};

const FILES: [&str; 17] = [
    "x10_y10_n100_r5_s20_ps6_pr5_u10_o5_N50.lp",
    "x10_y10_n100_r70_s70_ps0_pr0_u0_o0_N1.lp",
    "x11_y6_n66_r3_s12_ps2_pr5_u50_o3_N001.lp",
    "x12_y5_n52_r30_s30_ps0_pr0_u0_o0_N1.lp",
    "x19_y9_n171_r5_s45_ps3_pr10_u40_o6_N1.lp",
    "x19_y9_n171_r6_s45_ps3_pr180_u540_o12_N1.lp",
    "x26_y26_n676_r5_s16_ps4_pr4_u32_o8_N1.lp",
    "x2_y2_n4_r2_s2_ps1_pr2_u4_o2_N1-ONE.lp",
    "x2_y2_n4_r2_s2_ps1_pr2_u4_o2_N1.lp",
    "x30_y30_n810_r20_s20_ps0_pr0_u0_o0_N1.lp",
    "x30_y30_n900_r10_s10_ps0_pr0_u0_o0_N1.lp",
    "x3_y3_n9_r1_s1_ps1_pr1_u1_o1_N1.lp",
    "x46_y15_n690_r10_s160_ps10_pr5_u10_o2_N1.lp",
    "x4_y4_n16_r2_s3_ps1_pr2_u4_o2_N1.lp",
    "x4_y4_n16_r8_s8_ps0_pr0_u0_o0_N1.lp",
    "x8_y8_n64_r4_s10_ps2_pr3_u16_o4_N1-THREE-ONLY.lp",
    "x8_y8_n64_r4_s10_ps2_pr3_u16_o4_N1.lp",
];

/// The number behind a letter of a file's name: `x10_y10_n100` has 100 for `n`.
fn told(file: &str, letter: char) -> usize {
    let mut parts = file.split(['_', '.', '-']);
    let number = parts.find_map(|part| part.strip_prefix(letter)?.parse().ok());
    number.unwrap()
}

#[test]
fn every_published_instance_is_read_written_and_read_again() {
    for file in FILES {
        let text = data(&format!("asprilo/{file}"));
        assert_eq!(recognise(&text), Ok(Format::Asprilo), "{file}");
        let read = opened(&[(file, &text)]).unwrap_or_else(|error| panic!("{file}: {error:?}"));
        let grid = read.instance.grid();
        assert_eq!(grid.width() as usize, told(file, 'x'), "{file}");
        assert_eq!(grid.height() as usize, told(file, 'y'), "{file}");
        let nodes = grid.cells().filter(|(_, ground)| ground.is_vertex());
        assert_eq!(nodes.count(), told(file, 'n'), "{file}");
        if !file.contains("ON") {
            // Their names count robots that a comment takes out.
            assert_eq!(read.instance.agents().len(), told(file, 'r'), "{file}");
        }
        let written = comes_back(Format::Asprilo, &read);
        assert_eq!(written.losses, Vec::<String>::new(), "{file}");
    }
}

#[test]
fn orders_are_given_to_robots_in_turn() {
    let text = data("asprilo/x4_y4_n16_r2_s3_ps1_pr2_u4_o2_N1.lp");
    let read = opened(&[("a.lp", &text)]).unwrap();
    let [one, two] = read.instance.agents() else {
        panic!("two robots")
    };
    // One of them ends at the only station, the other passes it and returns.
    assert_ne!(one.goal, Some(one.start));
    assert_eq!(two.goal, Some(two.start));
    assert_eq!(two.waypoints.last(), one.goal.as_ref());
    assert!(read.notes[0].starts_with("Any robot may serve an order in asprilo."));
}

#[test]
fn a_file_without_orders_asks_for_goals() {
    let text = data("asprilo/x4_y4_n16_r8_s8_ps0_pr0_u0_o0_N1.lp");
    let read = opened(&[("a.lp", &text)]).unwrap();
    assert!(
        read.instance
            .agents()
            .iter()
            .all(|it| it.goal == Some(it.start))
    );
    assert_eq!(
        read.notes,
        [
            "The file has no orders: every robot's goal is its start. Give them goals.",
            "Not kept as such: 8 shelves.",
            "The file leaves goals or tasks open. Whatever is said here is said for those that were chosen."
        ]
    );
}

#[test]
fn the_published_plan_is_read_with_its_instance_and_is_legal() {
    let text = data("asprilo/small_outcome_plan.txt");
    let read = opened(&[("small_outcome_plan.txt", &text)]).unwrap();
    assert_eq!(read.instance.agents().len(), 3);
    let plan = &read.plans[0];
    assert_eq!(plan.conventions.origin, giveway_formats::Origin::One);
    assert!(plan.fit.is_perfect(), "{:?}", plan.fit);
    // Robot 1 goes four cells to the right, three up, and lifts a shelf there.
    let path = plan.plan.path("A1");
    assert_eq!(path[0], Some(Cell::new(0, 5)));
    assert_eq!(path[4], Some(Cell::new(4, 5)));
    assert_eq!(path[7], Some(Cell::new(4, 2)));
    assert_eq!(read.instance.agents()[0].waypoints[0], Cell::new(4, 2));
    assert_eq!(violations(&read.instance, plan), []);
    let left: Vec<&String> = plan
        .notes
        .iter()
        .filter(|note| note.contains("does not deliver"))
        .collect();
    assert_eq!(left.len(), 0, "{left:?}");
    comes_back(Format::Asprilo, &read);
}

#[test]
fn what_a_plan_does_not_deliver_is_said() {
    let text = data("asprilo/small_outcome_plan.txt");
    let text = text.replace("occurs(object(robot,1),action(deliver,(2,4,1)),22).\n", "");
    let read = opened(&[("a.lp", &text)]).unwrap();
    let said = "The plan does not deliver all of product 4 of order 2.";
    assert!(read.notes.iter().any(|note| note == said));
}

const CROSSING: &str = "\
init(object(node,1),value(at,(1,1))). init(object(node,2),value(at,(2,1))). init(object(node,3),value(at,(3,1))).
init(object(node,4),value(at,(2,2))). %* a pocket
below *% init(object(robot,1),value(at,(1,1))). init(object(robot,2),value(at,(3,1))).
";

#[test]
fn a_faulty_plan_shows_every_violation() {
    let text = format!(
        "{CROSSING}occurs(object(robot,1),action(move,(1,0)),1). \
         occurs(object(robot,2),action(move,(-1,0)),1). \
         occurs(object(robot,1),action(move,(0,-1)),2)."
    );
    let read = opened(&[("a.lp", &text)]).unwrap();
    assert_eq!(read.instance.grid().rows(), ["...", "#.#"]);
    let found = violations(&read.instance, &read.plans[0]);
    let both = || vec!["A1".to_owned(), "A2".to_owned()];
    assert!(found.contains(&(Rule::Vertex, 1, both())), "{found:?}");
    let one = vec!["A1".to_owned()];
    assert!(found.contains(&(Rule::Obstacle, 2, one)), "{found:?}");
}

#[test]
fn shelves_and_stations_without_a_node_are_left_out() {
    let text = format!(
        "{CROSSING}init(object(shelf,1),value(at,(1,2))). init(object(product,1),value(on,(1,1))). \
         init(object(order,1),value(line,(1,1))). init(object(order,1),value(pickingStation,1)). \
         init(object(pickingStation,1),value(at,(9,9)))."
    );
    let read = opened(&[("a.lp", &text)]).unwrap();
    assert!(read.instance.agents()[0].waypoints.is_empty());
    assert_eq!(
        read.notes[..2],
        [
            "Product 1 of order 1 is on no shelf with a place.",
            "Order 1 has no picking station with a place."
        ]
    );
    // So it is with what a robot lifts outside the map.
    let lifted = format!(
        "{CROSSING}occurs(object(robot,1),action(move,(0,1)),1). \
         occurs(object(robot,1),action(pickup,()),2). occurs(object(robot,1),action(deliver,(1,1)),3)."
    );
    let read = opened(&[("a.lp", &lifted)]).unwrap();
    assert!(read.instance.agents()[0].waypoints.is_empty());
    assert_eq!(
        read.instance.agents()[0].goal,
        Some(read.instance.agents()[0].start)
    );
}

#[test]
fn a_plan_may_stand_apart_from_its_instance() {
    let plan =
        "#include \"a.lp\". #const horizon=3.\noccurs(object(robot,2),action(move,(-1,0)),2).";
    let Ok((Format::Asprilo, Held::Plan(held))) = read(plan) else {
        panic!("a plan")
    };
    assert_eq!(held.agents.len(), 2);
    let (what, sentence) = lacking("plan.lp", plan);
    assert_eq!(what, Missing::Problem);
    assert!(
        sentence.contains(": open its instance (.lp), "),
        "{sentence}"
    );
    let read = opened(&[("a.lp", CROSSING), ("plan.lp", plan)]).unwrap();
    let path = read.plans[0].plan.path("A2");
    let cells = [(2, 0), (2, 0), (1, 0)].map(|cell| Some(Cell::from(cell)));
    assert_eq!(path, cells);
}

#[test]
fn a_plan_in_which_no_robot_moves_comes_back() {
    let read = opened(&[("a.lp", CROSSING)]).unwrap();
    let stay = |agent: &Agent| (agent.name.clone(), vec![Some(agent.start)]);
    let plan = Plan {
        paths: read.instance.agents().iter().map(stay).collect(),
        ..Plan::default()
    };
    let written = write(Format::Asprilo, "it", Some(&read.instance), Some(&plan)).unwrap();
    let again = reopened(&written);
    assert_eq!(again.plans[0].plan.paths, plan.paths);
}

#[test]
fn names_and_borders_that_cannot_be_written_are_losses() {
    let scene = r#"{"giveway": 1, "map": ["..+X", "...X", "XXXX"],
            "agents": [{"name": "Robbie", "start": [0, 0], "goal": [1, 1],
                        "waypoints": [[2, 1], [0, 1]], "battery": {"capacity": 9, "initial": 3}},
                       {"name": "B", "start": [1, 1], "goal": [0, 0]}]}"#;
    let scene: Scene = serde_json::from_str(&scene.replace('X', "#")).unwrap();
    let instance = Instance::new(scene).unwrap();
    let written = write(Format::Asprilo, "it", Some(&instance), None).unwrap();
    assert_eq!(
        written.losses,
        [
            "the chargers (1 cell)",
            "the batteries of 1 robot",
            "the names of 2 robots",
            "1 column of obstacles at the right and 1 row at the bottom"
        ]
    );
    let read = opened(&[("it.lp", &written.files[0].1)]).unwrap();
    let agents = read.instance.agents();
    assert_eq!(agents[0].waypoints, [Cell::new(2, 1), Cell::new(0, 1)]);
    assert_eq!(agents[0].goal, Some(Cell::new(1, 1)));
    assert_eq!(agents[1].goal, Some(Cell::new(0, 0)));
}

#[test]
fn faults_have_their_place() {
    let cases = [
        (
            "init(object(node,1),value(at,(0,1))).",
            "line 1, column 30: found \"(0,1))).\", expected a node (X,Y) with numbers from 1",
        ),
        (
            "init(object(node,1),value(at,(3000,1))).",
            "line 1, column 30: found the node (3000,1), expected a map of at most 2048 x 2048 nodes",
        ),
        (
            "init(object(node,99999999999),value(at,(1,1))).",
            "line 1, column 18: found \"99999999999),value(at,(1,1))).\", expected a whole number from -2147483648 to 2147483647",
        ),
        (
            "init(object(shelf,1),value(at,(1,1))).",
            "line 1, column 1: found no node, expected facts init(object(node,1),value(at,(X,Y))), or a plan",
        ),
        (
            "init(object(node,1),value(at,(1,1))).\ninit(object(robot,1),value(at,(2,1))).",
            "line 2, column 1: found robot 1 at (2,1), where there is no node, expected a node",
        ),
        (
            "occurs(object(robot,1),action(move,(1,1)),1).",
            "line 1, column 36: found \"(1,1)),1).\", expected a move (1,0), (-1,0), (0,1) or (0,-1)",
        ),
        (
            "occurs(object(robot,1),action(move,(1,0)),2000000000).",
            "line 1, column 1: found a plan of over 24000000 steps, expected at most 24000000 steps of all robots",
        ),
        (
            "occurs(object(robot,1),action(move,(1,0)),1).\noccurs(object(robot,1),action(move,(0,1)),1).",
            "line 2, column 1: found a second action of robot 1 at time 1, expected one action a step",
        ),
        (
            "init(object(node,1),value(at,(1,1))",
            "line 1, column 36: found the end of the file, expected a comma or a closing )",
        ),
        (
            "init(X) :- node(X).",
            "line 1, column 6: found \"X) :- node(X).\", expected a fact, since rules are not read",
        ),
        (
            "init(object(node,1),value(at,(1,1))). %* no end",
            "line 1, column 39: found a comment without end, expected *% after it",
        ),
    ];
    for (text, said) in cases {
        assert_eq!(refused(text).to_string(), said, "{text}");
    }
    let deep = format!("init({}1{}).", "(".repeat(40), ")".repeat(40));
    assert_eq!(refused(&deep).found, "terms nested very deeply");
}

#[test]
fn robots_of_a_plan_alone_are_matched_by_their_numbers() {
    let world = "init(object(node,1),value(at,(1,1))). init(object(node,2),value(at,(2,1))).\n\
        init(object(node,3),value(at,(1,2))). init(object(node,4),value(at,(2,2))).\n\
        init(object(robot,2),value(at,(1,1))). init(object(robot,5),value(at,(1,2))).\n";
    let plan = "occurs(object(robot,5),action(move,(1,0)),1).\n";
    let read = opened(&[("w.lp", world), ("p.lp", plan)]).unwrap();
    assert_eq!(violations(&read.instance, &read.plans[0]), []);
    assert_eq!(read.plans[0].plan.path("A5").len(), 2);
    assert_eq!(read.plans[0].plan.path("A2").len(), 1);
    let other = "occurs(object(robot,2),action(move,(1,0)),1).\n";
    let still = opened(&[("w.lp", world), ("p.lp", other)]).unwrap();
    assert_eq!(violations(&still.instance, &still.plans[0]), []);
    assert_eq!(
        still.plans[0].notes[0],
        "p.lp has no action of A5: they stand still."
    );
    // A plan that does not serve what is ordered keeps the goals that were chosen.
    let ordered = "init(object(shelf,1),value(at,(2,1))). init(object(product,1),value(on,(1,1))).\n\
        init(object(order,1),value(line,(1,1))). init(object(order,1),value(pickingStation,1)).\n\
        init(object(pickingStation,1),value(at,(1,1))).\n";
    let read = opened(&[("w.lp", &format!("{world}{ordered}")), ("p.lp", plan)]).unwrap();
    assert!(!violations(&read.instance, &read.plans[0]).is_empty());
}

#[test]
fn a_plan_apart_decides_who_serves_which_order_as_one_in_the_same_file_does() {
    let text = data("asprilo/small_outcome_plan.txt");
    let together = opened(&[("all.lp", &text)]).unwrap();
    let of = |is_plan: bool| {
        let lines = text.lines();
        let lines = lines.filter(|line| line.starts_with("occurs(") == is_plan);
        lines.fold(String::new(), |text, line| text + line + "\n")
    };
    let (instance, plan) = (of(false), of(true));
    for files in [["a.lp", "p.lp"], ["p.lp", "a.lp"]] {
        let text = |name| if name == "a.lp" { &instance } else { &plan };
        let apart = opened(&files.map(|name| (name, text(name).as_str()))).unwrap();
        assert_eq!(apart.instance.agents(), together.instance.agents());
        assert_eq!(apart.plans[0].plan, together.plans[0].plan);
        assert_eq!(violations(&apart.instance, &apart.plans[0]), []);
        let said = "Which robot serves which order is taken from the plan";
        assert!(apart.notes.iter().any(|note| note.starts_with(said)));
    }
    // Given in turn they are others.
    let alone = opened(&[("a.lp", &instance)]).unwrap();
    assert_ne!(alone.instance.agents(), together.instance.agents());
}
