//! Agents are led by hand, and the plan is checked.

use giveway_model::{Agent, AtGoal, Cell, Question, Rules, Scene};
use giveway_solve::{Response, SilentHost, Status, serve};

use crate::board::reasons;
use crate::keys::{Command, Key, command};
use crate::link::{From, keep, kept, read};
use crate::reduce::tests::{after, stroke};
use crate::steering::{Facts, Lead, facts};
use crate::{
    Action, AskAction, BoardAction, ChangeAction, Draft, Edit, FileAction, Phase, PlayAction,
    Selection, SolveAction, State, Tool, ask, inspect, reduce, sample, words,
};

const RIGHT: Action = Action::Steer(Lead::Step((1, 0)));
const LEFT: Action = Action::Steer(Lead::Step((-1, 0)));
const UP: Action = Action::Steer(Lead::Step((0, -1)));
const DOWN: Action = Action::Steer(Lead::Step((0, 1)));
const WAIT: Action = Action::Steer(Lead::Step((0, 0)));
const BACK: Action = Action::Steer(Lead::Back);
const BEGIN: Action = Action::Steer(Lead::Begin);
const DISCARD: Action = Action::Steer(Lead::Discard);

fn agent(name: &str, start: (u32, u32), goal: (u32, u32)) -> Agent {
    Agent {
        name: name.to_owned(),
        start: start.into(),
        goal: goal.into(),
        waypoints: Vec::new(),
        battery: None,
    }
}

/// The state after the solver answered what it is to do.
fn answered(state: &State) -> State {
    let (run, request) = state.work.request().expect("it works");
    let response = Box::new(serve(&request, &SilentHost));
    assert!(!matches!(*response, Response::Refused(_)), "{response:?}");
    after(
        state,
        [Action::Solve(SolveAction::Respond { job: run, response })],
    )
}

/// Two rows of four cells: A1 goes along the upper one, A2 along the lower one,
/// the other way.
fn rows(at_goal: AtGoal) -> State {
    let scene = Scene {
        map: vec!["....".into(), "....".into(), "####".into()],
        agents: vec![agent("A1", (0, 0), (3, 0)), agent("A2", (3, 1), (0, 1))],
        rules: Rules {
            at_goal,
            ..Rules::default()
        },
        ..Scene::default()
    };
    let state = State::new(Draft::new(scene).unwrap());
    let state = answered(&after(&state, [Action::Solve(SolveAction::Solve)]));
    after(&state, [Action::Play(PlayAction::Seek(0))])
}

/// An agent of that scene is led from a time on.
fn leading(agent: usize, time: u32) -> State {
    let select = Action::Board(BoardAction::Select(Selection::Agent(agent)));
    after(
        &rows(AtGoal::Stay),
        [select, Action::Play(PlayAction::Seek(time)), BEGIN],
    )
}

/// The warehouse's first agent is led from a time on.
fn warehouse(time: u32) -> State {
    let select = Action::Board(BoardAction::Select(Selection::Agent(0)));
    after(
        &sample::solved(),
        [select, Action::Play(PlayAction::Seek(time)), BEGIN],
    )
}

fn saying(state: &State) -> String {
    words::standing(state).sentence
}

fn told(state: &State) -> Facts {
    facts(state).expect("an agent is led")
}

fn path(state: &State, agent: &str) -> Vec<Option<Cell>> {
    state.plan().unwrap().path(agent).to_vec()
}

fn cells(path: &[(u32, u32)]) -> Vec<Option<Cell>> {
    path.iter().map(|&cell| Some(cell.into())).collect()
}

#[test]
fn an_agent_is_led_only_where_there_is_a_plan_of_it() {
    let refused = after(&State::new(Draft::default()), [BEGIN]);
    assert!(refused.document.mode.steering().is_none() && refused.view.notice.is_some());
    let state = rows(AtGoal::Stay);
    assert_eq!(state.can_steer(), None, "nobody is selected");
    assert!(after(&state, [BEGIN]).view.notice.is_some());
    let stale = after(&state, stroke(Tool::Charger, &[(1, 1)]));
    let stale = after(
        &stale,
        [Action::Board(BoardAction::Select(Selection::Agent(0)))],
    );
    assert_eq!(stale.can_steer(), None);
    let course = after(
        &super::adopted(),
        [
            Action::Board(BoardAction::Select(Selection::Agent(0))),
            BEGIN,
        ],
    );
    assert!(course.document.mode.steering().is_none() && course.view.notice.is_some());
    let state = leading(0, 1);
    assert_eq!(state.phase(), Phase::Steering);
    assert!(!state.can_change());
    assert!(
        saying(&state).starts_with("A1 is at (1, 0) at time 1. Lead it"),
        "{}",
        saying(&state)
    );
}

#[test]
fn each_step_is_added_to_the_path_and_time_goes_on() {
    let state = after(&leading(0, 1), [DOWN, WAIT, RIGHT]);
    assert_eq!(
        path(&state, "A1"),
        cells(&[(0, 0), (1, 0), (1, 1), (1, 1), (2, 1)])
    );
    assert_eq!(path(&state, "A2"), path(&rows(AtGoal::Stay), "A2"));
    assert_eq!(state.view.playback.time, 4);
    assert_eq!(state.view.cursor, Cell::new(2, 1));
    assert_eq!(state.agent_at(Cell::new(2, 1)), Some(0));
    let facts = told(&state);
    assert_eq!(facts.place, "A1 is at (2, 1) at time 4");
    assert_eq!(
        facts.to_do,
        ["A1 ends at (2, 1) at time 4, but its goal is (3, 0)."]
    );
    let costs: Vec<_> = facts.rows.iter().map(|row| (row.this, row.other)).collect();
    assert_eq!(costs, [(3, 4), (6, 7), (0, 0), (6, 6), (0, 1)]);
    let lane = inspect::planned(&state, 0).unwrap();
    assert!(!lane.arrives && !lane.stays);
    let before = after(&state, [Action::Play(PlayAction::Seek(1)), RIGHT]);
    assert_eq!(before.view.playback.time, 5, "a step is added to the end");
    assert_eq!(path(&before, "A1").last(), Some(&Some(Cell::new(3, 1))));
}

#[test]
fn a_move_in_the_slow_zone_takes_two_steps() {
    let state = after(&warehouse(2), [RIGHT]);
    let slow = [Some(Cell::new(2, 0)), None, Some(Cell::new(3, 0))];
    assert_eq!(path(&state, "A1")[2..], slow);
    assert_eq!(state.view.playback.time, 4);
    assert_eq!(
        told(&state).place,
        "A1 is at (3, 0) at time 4, battery 6 of 10"
    );
    let state = after(&state, [BACK]);
    assert_eq!(state.view.playback.time, 2);
    // Led from within the move, it is made first.
    let within = warehouse(3);
    assert_eq!(
        (within.view.playback.time, path(&within, "A1").len()),
        (4, 5)
    );
    assert!(!told(&within).can_go_back);
}

#[test]
fn what_no_agent_can_do_is_refused_and_said() {
    let state = leading(0, 0);
    for (step, why) in [
        (UP, "A1 stays: the map ends there."),
        (LEFT, "A1 stays: the map ends there."),
        (BACK, "There is no step to take back."),
        (Action::Steer(Lead::Charge), "A1 cannot charge at (0, 0)."),
        (
            Action::Board(BoardAction::Press(Cell::new(2, 0))),
            "A1 stays: (2, 0) is not beside it.",
        ),
    ] {
        let refused = after(&state, [step]);
        assert_eq!(path(&refused, "A1"), path(&state, "A1"));
        assert!(saying(&refused).ends_with(why), "{}", saying(&refused));
        assert_eq!(refused.history, state.history);
    }
    let state = after(&state, [DOWN, DOWN]);
    let why = "A1 stays: at (0, 2) there is an obstacle.";
    assert!(saying(&state).ends_with(why), "{}", saying(&state));
}

#[test]
fn a_collision_shows_as_it_arises() {
    let state = after(&leading(0, 0), [DOWN]);
    assert_eq!(told(&state).violations, []);
    assert_eq!(reasons(&state).bursts, []);
    // A2 comes from (1, 1) at time 2, so that they cross.
    let state = after(&leading(0, 0), [DOWN, RIGHT]);
    let [met] = &told(&state).violations[..] else {
        panic!("{:?}", told(&state).violations);
    };
    assert_eq!(met.text, "A1 and A2 are both at (1, 1) at time 2.");
    assert!(met.is_lit);
    assert_eq!(
        saying(&state),
        "A1 is at (1, 1) at time 2. A1 and A2 are both at (1, 1) at time 2."
    );
    assert_eq!(reasons(&state).bursts, [(150.0, 150.0)]);
    let earlier = after(&state, [Action::Play(PlayAction::StepBack)]);
    assert_eq!(reasons(&earlier).bursts, [], "only at its time");
    let state = after(&state, [BACK, WAIT, RIGHT]);
    let [swap] = &told(&state).violations[..] else {
        panic!("{:?}", told(&state).violations);
    };
    assert!(swap.is_lit, "the step lasts up to the time shown");
    assert_eq!(reasons(&state).bursts, [(100.0, 150.0)], "between both");
    let state = after(&state, [BACK, BACK]);
    assert_eq!(told(&state).violations, []);
}

#[test]
fn who_is_not_at_its_goal_yet_is_in_nobodys_way_later() {
    let state = after(&leading(0, 0), [DOWN]);
    assert_eq!(told(&state).violations, [], "it may yet be led away");
    let checked = answered(&after(
        &state,
        [Action::Ask(AskAction::Ask(Question::Plan))],
    ));
    let card = ask::card(&checked).unwrap();
    let (badge, text) = card.verdict.unwrap();
    assert_eq!(badge.word, "Against the rules");
    assert!(text.starts_with("The plan breaks a rule: "), "{text}");
    let (title, broken) = card.witness.unwrap();
    assert_eq!(title, "What is against the rules");
    let [goal, meets] = &broken[..] else {
        panic!("{broken:?}");
    };
    assert!(goal.text.contains("its goal is (3, 0)"), "{}", goal.text);
    assert!(
        meets.text.contains("A2 is at (0, 1) at time 3"),
        "{}",
        meets.text
    );
    let spots = reasons(&checked).spots;
    assert_eq!(
        spots.iter().map(|spot| spot.number).collect::<Vec<_>>(),
        [1, 2]
    );
}

#[test]
fn an_agent_charges_in_the_step_after_that_was_chosen() {
    // A1 is on the charger (6, 2) at time 9, where it charges.
    let state = warehouse(9);
    assert_eq!(told(&state).charges, Some(false));
    let charge = Action::Steer(Lead::Charge);
    let state = after(&state, [charge.clone()]);
    assert_eq!(told(&state).charges, Some(true));
    assert_eq!(told(&state).violations, [], "it is no step yet");
    let moved = after(&state, [UP]);
    assert_eq!(
        told(&moved).place,
        "A1 is at (6, 1) at time 10, battery 10 of 10"
    );
    assert_eq!(told(&moved).charges, None);
    let back = after(&moved, [BACK]);
    assert_eq!(told(&back).charges, Some(true), "the choice stays");
    let without = after(&back, [charge, UP]);
    assert_eq!(
        told(&without).place,
        "A1 is at (6, 1) at time 10, battery 0 of 10"
    );
    let empty = after(&without, [WAIT]);
    assert!(
        saying(&empty).contains("The battery of A1 is at -1 at time 11"),
        "{}",
        saying(&empty)
    );
    assert_eq!(reasons(&empty).bursts, [(650.0, 150.0)]);
}

#[test]
fn other_agents_are_led_in_the_same_plan() {
    let state = after(&leading(0, 1), [DOWN]);
    let other = after(
        &state,
        [
            Action::Board(BoardAction::Select(Selection::Agent(1))),
            Action::Play(PlayAction::Seek(1)),
        ],
    );
    assert_eq!(other.can_steer(), Some(1));
    let state = after(&other, [BEGIN, UP]);
    assert_eq!(path(&state, "A1"), cells(&[(0, 0), (1, 0), (1, 1)]));
    assert_eq!(path(&state, "A2"), cells(&[(3, 1), (2, 1), (2, 0)]));
    assert_eq!(told(&state).to_do.len(), 2);
    // The first one again: it goes on where it was led to.
    let again = after(
        &state,
        [
            Action::Board(BoardAction::Select(Selection::Agent(0))),
            BEGIN,
        ],
    );
    assert_eq!(path(&again, "A1"), path(&state, "A1"));
    assert!(told(&again).can_go_back);
    let anew = after(&again, [Action::Play(PlayAction::Seek(0)), BEGIN]);
    assert_eq!(path(&anew, "A1"), cells(&[(0, 0)]));
    let undone = after(&anew, [Action::Undo]);
    assert_eq!(path(&undone, "A1"), path(&state, "A1"));
}

#[test]
fn one_that_has_arrived_waits_at_its_goal_until_it_is_led() {
    let state = after(&leading(0, 1), [RIGHT, RIGHT, WAIT, WAIT]);
    assert_eq!(state.view.playback.time, 5);
    assert_eq!(path(&state, "A1").len(), 4, "the wait after all is none");
    assert_eq!(told(&state).to_do, [""; 0]);
    assert!(saying(&state).ends_with("All robots do their tasks. Check your plan."));
    let state = after(&state, [LEFT]);
    assert_eq!(path(&state, "A1").len(), 7);
    assert_eq!(path(&state, "A1")[3..6], cells(&[(3, 0), (3, 0), (3, 0)]));
    let gone = after(
        &rows(AtGoal::Vanish),
        [
            Action::Board(BoardAction::Select(Selection::Agent(0))),
            Action::Play(PlayAction::Seek(3)),
        ],
    );
    assert_eq!(gone.can_steer(), Some(0), "it is there at its arrival");
    let longer = Scene {
        agents: vec![agent("A1", (0, 0), (1, 0)), agent("A2", (3, 1), (0, 1))],
        ..gone.document.draft.scene().clone()
    };
    let state = after(
        &gone,
        [
            Action::File(FileAction::Open(Box::new(longer))),
            Action::Solve(SolveAction::Solve),
        ],
    );
    let look = [
        Action::Board(BoardAction::Select(Selection::Agent(0))),
        Action::Play(PlayAction::Seek(3)),
    ];
    let state = after(&answered(&state), look);
    assert_eq!(state.can_steer(), None, "it has left the map");
}

#[test]
fn every_step_is_one_of_undo_and_nothing_is_lost() {
    let two = after(&leading(0, 0), [DOWN, RIGHT]);
    let one = after(&two, [Action::Undo]);
    assert_eq!(path(&one, "A1"), cells(&[(0, 0), (0, 1)]));
    assert_eq!(one.view.playback.time, 1);
    assert_eq!(
        after(&one, [Action::Redo]).document.mode.steering(),
        two.document.mode.steering()
    );
    let left = after(&one, [Action::Undo, Action::Undo]);
    assert_eq!(
        (left.document.mode.steering(), left.phase()),
        (None, Phase::Planned)
    );
    let discarded = after(&two, [DISCARD]);
    assert_eq!(discarded.phase(), Phase::Planned);
    assert_eq!(discarded.plan(), left.plan(), "the solver's plan again");
    assert_eq!(
        after(&discarded, [Action::Undo]).document.mode.steering(),
        two.document.mode.steering()
    );
    let scene = sample::draft().scene().clone();
    let opened = after(&two, [Action::File(FileAction::Open(Box::new(scene)))]);
    assert_eq!(opened.document.mode.steering(), None);
    let back = after(&opened, [Action::Undo]);
    assert_eq!(
        (back.document.mode.steering(), back.document.answer),
        (two.document.mode.steering(), two.document.answer)
    );
}

#[test]
fn the_scene_stays_as_it_is() {
    let state = after(&leading(0, 0), [DOWN]);
    let edits = [
        Action::Board(BoardAction::PickTool(Tool::Obstacle)),
        Action::Edit(Edit::BatteryFloor(1)),
        Action::Change(ChangeAction::Begin),
        Action::Ask(AskAction::Ask(Question::Makespan)),
    ];
    for edit in edits {
        let next = after(&state, [edit.clone()]);
        let why = next.view.notice.clone().map(|notice| notice.sentence);
        assert!(
            why.is_some_and(|why| why.contains("You lead A1")),
            "{edit:?}"
        );
        assert_eq!(
            (&next.document.draft, next.document.mode.steering()),
            (&state.document.draft, state.document.mode.steering())
        );
    }
    assert_eq!(ask::offers(&state), []);
    assert!(!state.can_move(Cell::new(3, 0)));
}

#[test]
fn keys_lead_and_escape_leaves() {
    let act = |name, state: &State| {
        let key = Key {
            name,
            ..Key::default()
        };
        match command(key, state) {
            Some(Command::Act(action)) => Some(reduce(state, action)),
            _ => None,
        }
    };
    let fresh = rows(AtGoal::Stay);
    for name in ["l", "ArrowDown", "Backspace"] {
        assert_eq!(act(name, &fresh), None, "{name}");
    }
    let state = after(
        &fresh,
        [Action::Board(BoardAction::Select(Selection::Agent(0)))],
    );
    let mut state = act("l", &state).unwrap();
    for name in [
        "ArrowDown",
        "ArrowRight",
        "w",
        "ArrowLeft",
        "ArrowUp",
        "Backspace",
    ] {
        state = act(name, &state).unwrap();
    }
    let led = cells(&[(0, 0), (0, 1), (1, 1), (1, 1), (0, 1)]);
    assert_eq!(path(&state, "A1"), led);
    // With the focus on the board.
    let step = Action::Board(BoardAction::StepCursor {
        by: (1, 0),
        carries: false,
    });
    let state = after(&state, [step]);
    assert_eq!(path(&state, "A1").len(), 6);
    let look = Action::Board(BoardAction::StepCursor {
        by: (1, 0),
        carries: true,
    });
    let state = after(&state, [look, Action::Board(BoardAction::UseTool)]);
    assert_eq!(path(&state, "A1").len(), 7, "Enter goes to the cursor");
    let other = after(
        &state,
        [Action::Board(BoardAction::Select(Selection::Agent(1)))],
    );
    let back = act("Escape", &other).unwrap();
    assert_eq!(back.view.selection, Selection::Agent(0));
    assert_eq!(act("Escape", &back).unwrap().document.mode.steering(), None);
}

#[test]
fn a_press_on_the_board_leads_or_selects() {
    let state = after(
        &leading(0, 0),
        [Action::Board(BoardAction::Press(Cell::new(0, 1)))],
    );
    assert_eq!(path(&state, "A1"), cells(&[(0, 0), (0, 1)]));
    let same = after(&state, [Action::Board(BoardAction::Press(Cell::new(0, 1)))]);
    assert_eq!(
        same.document.mode.steering(),
        state.document.mode.steering()
    );
    let other = after(&state, [Action::Board(BoardAction::Press(Cell::new(2, 1)))]);
    assert_eq!(other.view.selection, Selection::Agent(1), "A2 is there");
    assert_eq!(
        other.document.mode.steering(),
        state.document.mode.steering()
    );
}

#[test]
fn a_plan_that_is_as_good_is_confirmed() {
    let state = after(
        &leading(0, 0),
        [RIGHT, RIGHT, RIGHT, Action::Solve(SolveAction::Solve)],
    );
    assert_eq!(state.phase(), Phase::Asking);
    let state = answered(&state);
    let (badge, text) = ask::card(&state).unwrap().verdict.unwrap();
    assert_eq!(badge.word, "Optimal");
    assert_eq!(text, "The plan keeps all rules, and no plan is better.");
    let state = after(&state, [Action::Ask(AskAction::Close)]);
    assert_eq!(state.phase(), Phase::Steering);
}

#[test]
fn of_a_worse_plan_it_is_told_what_is_too_much() {
    let own = after(&leading(0, 0), [WAIT, RIGHT, RIGHT, RIGHT]);
    let state = answered(&after(&own, [Action::Ask(AskAction::Ask(Question::Plan))]));
    let card = ask::card(&state).unwrap();
    let (badge, text) = card.verdict.unwrap();
    assert_eq!(badge.word, "Improvable");
    assert!(text.contains("A1 waits 1 step less"), "{text}");
    assert_eq!((card.rows[0].this, card.rows[0].other), (4, 3));
    let taken = after(&state, [Action::Ask(AskAction::TakeOther)]);
    assert_eq!(taken.document.mode.steering(), None);
    let answer = taken.document.answer.as_ref().unwrap();
    assert_eq!(answer.solved.status, Status::Optimal, "the bounds hold");
    assert_eq!(
        after(&taken, [Action::Undo]).document.mode.steering(),
        own.document.mode.steering()
    );
}

#[test]
fn a_step_closes_the_answer_and_ends_the_search() {
    let state = after(
        &leading(0, 0),
        [WAIT, Action::Ask(AskAction::Ask(Question::Plan)), RIGHT],
    );
    assert_eq!(
        (state.phase(), state.document.mode.asking()),
        (Phase::Steering, None)
    );
    assert_eq!(path(&state, "A1").len(), 3);
}

#[test]
fn the_plan_comes_back_after_a_reload() {
    let state = after(&leading(0, 1), [DOWN, WAIT]);
    let text = keep(&state);
    assert!(text.contains("\n=own=0!2.0!"), "{text}");
    let restored = kept(&text).unwrap();
    assert_eq!(restored.phase(), Phase::Steering);
    assert_eq!(path(&restored, "A1"), path(&state, "A1"));
    assert_eq!(told(&restored), told(&state));
    assert_eq!(restored.view.playback.time, 3);
    assert_eq!(path(&after(&restored, [BACK, BACK]), "A1").len(), 2);
    assert!(!told(&after(&restored, [BACK, BACK])).can_go_back);
    let link = crate::link::write(&state);
    assert!(!link.contains("own="), "no link has it");
    assert!(read(&format!("{link}&own=0!2.0!rdw;lll"), From::Anywhere).is_err());
    for broken in [
        "9!2.0!rdw;lll",
        "0!0.0!rdw;lll",
        "0!99.0!rdw;lll",
        "0!2!r;l",
        "x",
    ] {
        let own = text.lines().find(|line| line.starts_with("=own=")).unwrap();
        let text = text.replace(own, &format!("=own={broken}"));
        assert!(kept(&text).is_err(), "{broken}");
    }
}
