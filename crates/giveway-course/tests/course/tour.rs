//! The tour: when its steps are done, what is done for a person; what it says of its
//! scene is so.

use giveway_course::port::{BoardNumber, Deed, FromPage, Happened, Sight, ToPage};
use giveway_course::tour::{Action, Effect, FIRST, Step, Target, Tour, begin, reduce, rule, scene};
use giveway_model::{Cell, Scene};
use giveway_solve::freedom::{FreedomRequest, PlanCount};
use giveway_solve::{Request, Response, SilentHost, SolveAnswer, SolveRequest, Status, serve};

fn solved(scene: Scene) -> SolveAnswer {
    let request = Request::Solve(SolveRequest {
        scene,
        ..SolveRequest::default()
    });
    match serve(&request, &SilentHost) {
        Response::Solved(solved) => solved,
        other => panic!("{other:?}"),
    }
}

/// What the page looks like with a plan that nobody has touched yet.
fn plan() -> Sight {
    Sight {
        last: 6,
        is_solved: true,
        ..Sight::default()
    }
}

fn seen(number: BoardNumber, sight: &Sight) -> Action {
    Action::Page(FromPage {
        number,
        what: Happened::Seen(sight.clone()),
    })
}

fn saw(tour: Tour, sight: &Sight) -> (Tour, Vec<Effect>) {
    let action = seen(tour.number(), sight);
    let (tour, effects) = reduce(tour, action);
    (tour.unwrap(), effects)
}

fn says(effects: &[Effect]) -> Vec<ToPage> {
    let says = effects.iter().map(|effect| match effect {
        Effect::Page(message) => message.clone(),
        Effect::Contents => panic!("it opens the contents"),
    });
    says.collect()
}

/// A tour at a step, with what it sees then.
fn at(step: Step) -> (Tour, Sight) {
    let (mut tour, mut sight) = (begin(FIRST).0, plan());
    tour = saw(tour, &sight).0;
    for done in Step::ALL.into_iter().take(step.index()) {
        match done {
            Step::Watch => sight.time = sight.last,
            Step::Select => sight.robot = Some("A1".to_owned()),
            Step::Ask => sight.is_asking = true,
            Step::Close => (sight.is_edited, sight.is_solved) = (true, false),
            Step::Solve => sight.is_solved = true,
            Step::Rule => (sight.is_ruled, sight.is_priced) = (true, true),
            Step::GoOn => {}
        }
        tour = saw(tour, &sight).0;
    }
    assert_eq!(tour.step(), step);
    (tour, sight)
}

#[test]
fn what_it_says_of_its_scene_is_so() {
    let open = solved(scene());
    assert_eq!(open.status, Status::Optimal);
    let (waits, way) = (Cell::new(4, 0), Cell::new(6, 1));
    let plan = open.plan.clone().unwrap();
    let path = |name: &str| &plan.paths[name];
    assert_eq!(path("A1")[..2], [Some(waits); 2], "A1 waits at once");
    assert_ne!(path("A2")[0], path("A2")[1], "A2 does not");
    assert!(path("A1").contains(&Some(way)), "it is on its way");
    let texts: Vec<&str> = Step::ALL.into_iter().map(Step::text).collect();
    assert!(texts[1].contains("A1 wears a pause sign"));
    assert!(texts[3].contains("cell (6, 1), which is on the way of A1"));
    assert!(texts[5].contains("the cells (3, 1) and (4, 1)"));

    // No other plan is as good: another one would wait elsewhere.
    let every = Request::Freedom(FreedomRequest {
        scene: scene(),
        ..FreedomRequest::default()
    });
    let Response::Freedom(every) = serve(&every, &SilentHost) else {
        panic!("it is no answer");
    };
    assert_eq!(every.plans.unwrap().number, PlanCount::Exactly(1));

    let mut closed = scene();
    closed.map[1].replace_range(6..7, "#");
    let longer = solved(closed.clone());
    assert_eq!(longer.status, Status::Optimal);
    assert_eq!(
        longer.costs.unwrap().makespan,
        open.costs.unwrap().makespan + 2
    );
    // The rule has a price, whether the cell was closed or not.
    for (mut scene, free) in [(scene(), open), (closed, longer)] {
        let (zone, rule) = rule();
        assert_eq!(
            zone.cells().collect::<Vec<_>>(),
            [Cell::new(3, 1), Cell::new(4, 1)]
        );
        (scene.zones, scene.constraints) = (vec![zone], vec![rule]);
        let ruled = solved(scene);
        assert_eq!(ruled.status, Status::Optimal);
        assert!(ruled.costs.unwrap().makespan > free.costs.unwrap().makespan);
    }
}

#[test]
fn every_step_waits_until_it_is_done() {
    for step in Step::ALL {
        let (tour, sight) = at(step);
        let (again, effects) = saw(tour, &sight);
        assert_eq!((again.step(), effects), (step, Vec::new()), "{step:?}");
    }
}

#[test]
fn what_is_done_already_is_not_asked_for() {
    let (tour, mut sight) = at(Step::Watch);
    sight.time = 6;
    sight.robot = Some("A1".to_owned());
    sight.is_asking = true;
    let (tour, effects) = saw(tour, &sight);
    assert_eq!(tour.step(), Step::Close);
    assert_eq!(effects, []);
}

/// What a person does next, as the page tells it.
type Change = fn(&mut Sight);

#[test]
fn it_points_at_what_comes_next() {
    let points = |step| at(step).0.target();
    assert_eq!(points(Step::Watch), Target::Play);
    assert_eq!(points(Step::Select), Target::Cell(Cell::new(4, 0)));
    assert_eq!(points(Step::Solve), Target::Solve);
    assert_eq!(points(Step::GoOn), Target::Course);
    let (tour, mut sight) = at(Step::Ask);
    assert_eq!(tour.target(), Target::Question);
    sight.robot = None;
    let (tour, _) = saw(tour, &sight);
    assert_eq!(tour.target(), Target::Cell(Cell::new(4, 0)));
    let (tour, mut sight) = at(Step::Close);
    assert_eq!(tour.target(), Target::Obstacle);
    sight.paints = true;
    let (tour, _) = saw(tour, &sight);
    assert_eq!(tour.target(), Target::Cell(Cell::new(6, 1)));
    let (mut tour, mut sight) = at(Step::Rule);
    let ways: [(Change, Target); 4] = [
        (|_| {}, Target::Zone),
        (|sight| sight.marks = true, Target::Cell(Cell::new(3, 1))),
        (|sight| sight.is_writing = true, Target::AddRule),
        (
            |sight| (sight.is_writing, sight.is_ruled) = (false, true),
            Target::Price,
        ),
    ];
    for (change, target) in ways {
        change(&mut sight);
        tour = saw(tour, &sight).0;
        assert_eq!(tour.target(), target);
    }
}

#[test]
fn a_plan_that_arrives_waits_for_the_person() {
    let (tour, effects) = saw(begin(FIRST).0, &plan());
    assert_eq!(says(&effects), [ToPage::Go(0)]);
    let playing = Sight { time: 1, ..plan() };
    assert_eq!(saw(tour, &playing).1, []);
}

#[test]
fn each_step_is_done_for_a_person() {
    let shown = |step| says(&reduce(at(step).0, Action::Show).1);
    let select = ToPage::Do(Deed::Select("A1".to_owned()));
    assert_eq!(shown(Step::Watch), [ToPage::Play]);
    assert_eq!(shown(Step::Select), [ToPage::Go(0), select.clone()]);
    let ask = ToPage::Do(Deed::Ask);
    assert_eq!(shown(Step::Ask), [ToPage::Go(0), select, ask]);
    let paint = ToPage::Do(Deed::Paint(Cell::new(6, 1)));
    assert_eq!(shown(Step::Close), [paint]);
    assert_eq!(shown(Step::Solve), [ToPage::Do(Deed::Solve)]);
    let (zone, rule) = rule();
    let (add, price) = (Deed::Rule(zone, rule), ToPage::Do(Deed::Price));
    assert_eq!(shown(Step::Rule), [ToPage::Do(add), price.clone()]);
    let (tour, mut sight) = at(Step::Rule);
    sight.is_ruled = true;
    let ruled = saw(tour, &sight).0;
    assert_eq!(says(&reduce(ruled, Action::Show).1), [price]);
    let (tour, effects) = reduce(at(Step::GoOn).0, Action::Show);
    assert_eq!(tour, None);
    assert_eq!(effects, [Effect::Page(ToPage::Close), Effect::Contents]);
}

#[test]
fn what_takes_a_plan_is_done_once_there_is_one() {
    let (tour, _) = begin(FIRST);
    let (tour, effects) = reduce(tour, Action::Show);
    assert_eq!(effects, []);
    let (tour, effects) = saw(tour.unwrap(), &plan());
    assert_eq!(says(&effects), [ToPage::Go(0), ToPage::Play]);
    // Only once.
    assert_eq!(saw(tour, &plan()).1, []);
}

#[test]
fn a_scene_that_was_edited_too_early_begins_anew() {
    let (tour, mut sight) = at(Step::Ask);
    (sight.is_edited, sight.is_solved) = (true, false);
    let (tour, _) = saw(tour, &sight);
    let (tour, effects) = reduce(tour, Action::Show);
    let tour = tour.unwrap();
    assert_ne!(tour.number(), FIRST);
    let [ToPage::Open(board)] = &says(&effects)[..] else {
        panic!("{effects:?}");
    };
    assert_eq!((board.number, &board.scene), (tour.number(), &scene()));
    // What is said of the board before is old news.
    let (tour, effects) = reduce(tour, seen(FIRST, &plan()));
    assert_eq!(effects, []);
    let (_, effects) = saw(tour.unwrap(), &plan());
    assert_eq!(says(&effects).last(), Some(&ToPage::Do(Deed::Ask)));
}

#[test]
fn it_ends_when_a_person_ends_it_here_or_on_the_page() {
    let (tour, effects) = reduce(at(Step::Ask).0, Action::End);
    assert_eq!((tour, says(&effects)), (None, vec![ToPage::Close]));
    let closed = |number| {
        Action::Page(FromPage {
            number,
            what: Happened::Closed,
        })
    };
    assert_eq!(reduce(at(Step::Ask).0, closed(FIRST)), (None, Vec::new()));
    let (tour, _) = reduce(at(Step::Ask).0, closed(BoardNumber(7)));
    assert_eq!(tour.unwrap().step(), Step::Ask, "that was a lesson");
}
