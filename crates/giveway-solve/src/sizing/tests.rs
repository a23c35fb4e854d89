//! How many robots a floor bears, compared with solves of their own.

use std::cell::RefCell;

use giveway_model::{Agent, Battery, Cell, Scene, check::check, fleet::Fleet};

use super::{Finding, SizingFloor, SizingRequest, findings, words};
use crate::{Host, Progress, Request, Response, SilentHost, SolveRequest, Status, serve};

/// A floor of two racks with robots that go across it, both ways.
fn floor(chargers: &[(u32, u32)]) -> Scene {
    let mut map: Vec<Vec<char>> = [
        "..........",
        "..####.##.",
        "..........",
        "..####.##.",
        "..........",
    ]
    .iter()
    .map(|row| row.chars().collect())
    .collect();
    for &(x, y) in chargers {
        map[y as usize][x as usize] = '+';
    }
    let map: Vec<String> = map.into_iter().map(String::from_iter).collect();
    let scene = Scene {
        map,
        ..Scene::default()
    };
    let grid = giveway_model::Grid::from_rows(&scene.map).unwrap();
    let fleet = Fleet {
        goals: Some((Cell::new(9, 0), Cell::new(9, 4))),
        back: true,
        waypoints: 1,
        battery: Some(Battery {
            capacity: 40,
            initial: 14,
        }),
        ..Fleet::along(Cell::new(0, 0), Cell::new(0, 4))
    };
    Scene {
        agents: fleet.mixed(&grid),
        ..scene
    }
}

fn request(scene: Scene, counts: &[u32]) -> SizingRequest {
    SizingRequest {
        scene,
        counts: counts.to_vec(),
        ..SizingRequest::default()
    }
}

fn sized(request: SizingRequest) -> super::SizingAnswer {
    match serve(&Request::Sizing(request), &SilentHost) {
        Response::Sized(answer) => *answer,
        other => panic!("{other:?}"),
    }
}

#[test]
fn each_point_is_a_solve_of_its_own() {
    let scene = floor(&[(1, 2)]);
    let beside = floor(&[(1, 2), (8, 2)]);
    let answer = sized(SizingRequest {
        beside: Some(beside.clone()),
        ..request(scene.clone(), &[2, 4, 6])
    });
    assert_eq!(answer.pending, 0);
    for (floor, points) in [(scene, &answer.points), (beside, &answer.beside)] {
        assert_eq!(points.len(), 3);
        for point in points {
            let mut floor = floor.clone();
            floor.agents.truncate(point.robots as usize);
            let own = SolveRequest {
                scene: floor.clone(),
                ..SolveRequest::default()
            };
            let Response::Solved(own) = serve(&Request::Solve(own), &SilentHost) else {
                panic!("a solve")
            };
            assert_eq!((point.status, point.costs), (own.status, own.costs));
            assert_eq!(point.plan, own.plan);
            let alone: u32 = floor.agents.iter().map(|agent| alone(&floor, agent)).sum();
            assert_eq!(point.alone, Some(alone), "{} robots", point.robots);
            let instance = giveway_model::Instance::new(floor).unwrap();
            assert!(check(&instance, point.plan.as_ref().unwrap()).is_valid());
        }
    }
}

/// When a robot arrives that has the floor for itself.
fn alone(floor: &Scene, agent: &Agent) -> u32 {
    let scene = Scene {
        agents: vec![agent.clone()],
        ..floor.clone()
    };
    let solve = SolveRequest {
        scene,
        ..SolveRequest::default()
    };
    match serve(&Request::Solve(solve), &SilentHost) {
        Response::Solved(answer) => answer.costs.unwrap().sum_of_costs,
        other => panic!("{other:?}"),
    }
}

#[test]
fn a_charger_more_is_compared_by_the_sum() {
    let answer = sized(SizingRequest {
        beside: Some(floor(&[(1, 2), (8, 2)])),
        ..request(floor(&[(1, 2)]), &[2, 4, 6])
    });
    let by = |place: usize| {
        let sum = |points: &[super::SizingPoint]| points[place].costs.unwrap().sum_of_costs;
        i64::from(sum(&answer.points)) - i64::from(sum(&answer.beside))
    };
    let all = [by(0), by(1), by(2)];
    let found = findings(&answer);
    let saves = found.iter().find_map(|it| match it {
        Finding::Saves { steps, by, .. } => Some((*steps, *by)),
        _ => None,
    });
    let steps = (*all.iter().min().unwrap(), *all.iter().max().unwrap());
    assert_eq!(saves, Some((steps, all[2])));
    assert!(
        answer.words.contains("6 robots: makespan"),
        "{}",
        answer.words
    );
}

#[test]
fn the_first_robots_do_not_change_with_those_that_follow() {
    let all = floor(&[(1, 2)]);
    let six = sized(request(all.clone(), &[6]));
    let both = sized(request(all, &[2, 6]));
    assert_eq!(six.points[0].costs, both.points[1].costs);
}

#[test]
fn numbers_of_robots_that_are_none_are_refused() {
    let scene = floor(&[]);
    let most = scene.agents.len() as u32;
    for counts in [&[][..], &[0], &[2, 2], &[4, 2], &[2, most + 1]] {
        let response = serve(
            &Request::Sizing(request(scene.clone(), counts)),
            &SilentHost,
        );
        let Response::Refused(refusal) = response else {
            panic!("{counts:?}: {response:?}")
        };
        let said = refusal.sentences().join(" ");
        assert!(said.contains("counts"), "{said}");
    }
}

/// A host that cancels after so many plans.
struct Cancels {
    after: usize,
    heard: RefCell<Vec<(SizingFloor, u32, u32)>>,
}

impl Host for Cancels {
    fn wall_seconds(&self) -> f64 {
        0.0
    }

    fn cancelled(&self) -> bool {
        self.heard.borrow().len() >= self.after
    }

    fn progress(&self, event: &Progress) {
        if let Progress::Sized {
            floor,
            point,
            pending,
        } = event
        {
            self.heard
                .borrow_mut()
                .push((*floor, point.robots, *pending));
        }
    }
}

#[test]
fn what_is_cancelled_keeps_what_is_there() {
    let host = Cancels {
        after: 3,
        heard: RefCell::default(),
    };
    let asked = SizingRequest {
        beside: Some(floor(&[(8, 2)])),
        ..request(floor(&[(1, 2)]), &[2, 4, 6])
    };
    let Response::Sized(answer) = serve(&Request::Sizing(asked), &host) else {
        panic!("plans of robots")
    };
    assert_eq!((answer.points.len(), answer.beside.len()), (2, 1));
    assert_eq!(answer.pending, 3);
    let heard = [
        (SizingFloor::This, 2, 5),
        (SizingFloor::Beside, 2, 4),
        (SizingFloor::This, 4, 3),
    ];
    assert_eq!(*host.heard.borrow(), heard);
}

#[test]
fn rules_of_robots_that_are_not_there_yet_do_not_count() {
    let mut scene = floor(&[(1, 2)]);
    scene.agents.truncate(6);
    // A battery that lasts: those that wait for the last one may have to go round.
    for agent in &mut scene.agents {
        agent.battery = None;
    }
    let last = scene.agents[5].name.clone();
    scene.constraints =
        vec![giveway_model::Constraint::from_words(&format!("{last} starts from 30 on")).unwrap()];
    let answer = sized(request(scene, &[2, 6]));
    let makespans = |place: usize| {
        let costs = answer.points[place].costs;
        costs.expect(&answer.words).makespan
    };
    assert!(makespans(0) < 30 && makespans(1) > 30);
    assert_eq!(answer.points[0].status, Status::Optimal);
}

#[test]
fn a_jump_of_the_last_arrival_names_the_robot_that_needs_as_long_alone() {
    let mut scene = floor(&[(1, 2)]);
    for agent in &mut scene.agents {
        (agent.waypoints, agent.battery) = (Vec::new(), None);
    }
    scene.agents.truncate(2);
    let far = Agent {
        waypoints: vec![Cell::new(9, 4), Cell::new(0, 4)],
        name: "far".to_owned(),
        start: Cell::new(1, 2),
        goal: Some(Cell::new(8, 4)),
        battery: None,
        heading: None,
    };
    scene.agents.push(far);
    let answer = sized(request(scene, &[2, 3]));
    let found = findings(&answer);
    let Some(Finding::Later { from: 3, alone, .. }) = found.first() else {
        panic!("{found:?}")
    };
    assert_eq!(alone.as_deref(), Some("far"));
    let said = words::finding_parts(&found[0], "one charger more");
    assert!(said.1.contains("far alone needs"), "{said:?}");
}
