//! Links: round trips, and every way in which a text can be none.

use giveway_model::{AtGoal, Cell, Scene};
use giveway_solve::Status;

use super::*;
use crate::{Action, Phase, Selection, reduce, sample};

fn scene(text: &str) -> Scene {
    read(text, From::Anywhere).unwrap().draft.scene().clone()
}

fn why(text: &str) -> String {
    read(text, From::Anywhere).unwrap_err().details.join(" ")
}

#[test]
fn a_scene_comes_back_as_it_was() {
    let mut scene_before = sample::draft().scene().clone();
    scene_before.name = "<b>50 % & more; \u{fc}\u{1f600}".to_owned();
    scene_before.rules.at_goal = AtGoal::Vanish;
    scene_before.rules.battery_floor = 2;
    scene_before.agents[0].battery = None;
    scene_before.agents[1].name = "A.2;!&=#".to_owned();
    scene_before.map[1] = ".##*##.##.".to_owned();
    let state = State::new(Draft::new(scene_before.clone()).unwrap());
    let text = write(&state);
    assert!(
        text.bytes()
            .all(|byte| byte.is_ascii_alphanumeric() || b"-%&=.;!".contains(&byte)),
        "{text}"
    );
    assert_eq!(scene(&text), scene_before);
}

#[test]
fn a_plan_comes_back_judged_and_not_believed() {
    let state = reduce(&sample::solved(), Action::Seek(7));
    let text = write(&state);
    assert!(text.len() < 300, "{} letters", text.len());
    let linked = read(&text, From::Anywhere).unwrap();
    let answer = linked.answer.clone().unwrap();
    assert_eq!(answer.plan(), state.plan());
    assert_eq!(
        answer.solved.costs,
        state.answer.as_ref().unwrap().solved.costs
    );
    assert_eq!(
        answer.solved.status,
        Status::Feasible,
        "no proof came with it"
    );
    assert!(answer.solved.bounds.is_empty());
    assert_eq!(linked.time, 7);
    let claimed = keep(&state);
    assert!(why(&claimed).contains("claim"), "a link has no claims");
}

#[test]
fn what_the_browser_kept_is_as_it_was() {
    let state = reduce(&sample::solved(), Action::Seek(7));
    let linked = read(&keep(&state), From::Here).unwrap();
    let restored = State::restored(linked);
    assert_eq!(restored.phase(), Phase::Planned);
    assert_eq!(restored.playback.time, 7);
    let before = state.answer.as_ref().unwrap();
    assert_eq!(restored.answer.as_ref().unwrap().solved, before.solved);
    assert!(!restored.history.can_undo());

    let stale = sample::stale();
    let restored = State::restored(read(&keep(&stale), From::Here).unwrap());
    assert_eq!(restored.draft, stale.draft);
    assert_eq!(restored.answer, None, "a plan of another scene is not kept");

    let mut impossible = sample::solved();
    let mut answer = (**impossible.answer.as_ref().unwrap()).clone();
    answer.solved.status = Status::Impossible;
    answer.solved.plan = None;
    answer.solved.costs = None;
    answer.solved.reason = Some("A1 is in the way; so is A2".to_owned());
    impossible.answer = Some(Rc::new(answer));
    let restored = State::restored(read(&keep(&impossible), From::Here).unwrap());
    assert_eq!(restored.phase(), Phase::None);
    assert_eq!(
        restored.answer.unwrap().solved.reason.as_deref(),
        Some("A1 is in the way; so is A2")
    );
}

#[test]
fn a_scene_with_problems_can_be_kept_and_sent() {
    let mut scene_before = sample::draft().scene().clone();
    scene_before.agents[0].goal = Cell::new(1, 1);
    let state = State::new(Draft::new(scene_before.clone()).unwrap());
    assert_eq!(scene(&write(&state)), scene_before);
    let text = format!("{}&plan=;", write(&state));
    assert!(why(&text).contains("has none"), "{}", why(&text));
}

#[test]
fn opening_a_link_is_one_step_of_undo() {
    let before = sample::solved();
    let mut other = before.clone();
    other.draft = Rc::new(Draft::default());
    let text = write(&other);
    let state = reduce(&before, open(&text));
    assert_eq!(state.draft, other.draft);
    assert_eq!(state.answer, None);
    let undone = reduce(&state, Action::Undo);
    assert_eq!(undone.draft, before.draft);
    assert!(!undone.history.can_undo());

    let planned = reduce(&state, open(&write(&reduce(&before, Action::Seek(7)))));
    assert_eq!(
        (planned.phase(), planned.playback.time),
        (Phase::Stopped, 7)
    );
    assert_eq!(planned.selection, Selection::Nothing);
}

#[test]
fn a_hostile_link_is_refused_and_the_scene_stays() {
    let good = write(&sample::solved());
    let with = |key: &str, value: &str| {
        let parts = good.split('&').map(|part| match part.split_once('=') {
            Some((own, _)) if own == key => format!("{key}={value}"),
            _ => part.to_owned(),
        });
        parts.collect::<Vec<_>>().join("&")
    };
    let broken = |text: String, expect: &str| {
        let told = why(&text);
        assert!(told.contains(expect), "{told:?} for {text:.80}");
        let before = sample::solved();
        let state = reduce(&before, open(&text));
        assert_eq!(state.draft, before.draft);
        assert_eq!(state.answer, before.answer);
        assert!(state.notice.is_some());
    };
    broken(String::new(), "no scene");
    broken("<script>alert(1)</script>".to_owned(), "no scene");
    broken(with("giveway", "2"), "version 2");
    broken(format!("{good}&evil=1"), "evil");
    broken("x".repeat(LONGEST + 1), "longer");
    for map in [
        "",
        "10",
        "0.f",
        "10.x",
        "10.99999999999999999999f",
        "10.70000f",
        "5.7f",
        "300.300f",
        "10.3",
    ] {
        let text = with("map", map);
        assert!(read(&text, From::Anywhere).is_err(), "{map}");
    }
    broken(with("rules", "2.0"), "rules");
    broken(with("rules", "0"), "rules");
    for costs in ["", "9", "00", "x"] {
        broken(with("costs", costs), "costs");
    }
    for agents in [
        "A1",
        "A1.0",
        "A1.0.0",
        "A1.0.0.1",
        "A1.0.0.1.-1",
        "A1.0.0.1.1!5",
        "%.0.0.1.1",
        "%FF.0.0.1.1",
        "A1.0.0.1.1;",
    ] {
        broken(with("agents", agents), "agents");
    }
    let many = vec!["A.0.0.0.0"; 1001].join(";");
    broken(with("agents", &many), "1001 agents");
    for plan in ["", "r", "r;l;u", "9999999r;", "x;x", "u;u", "\u{e9};"] {
        broken(with("plan", plan), "plan");
    }
    broken(with("plan", "r;l"), "breaks a rule");
    broken(format!("{good}&time=x"), "time");
}

/// Reads a good link with faults strewn over it, again and again.
fn read_noise(good: &str, seed: u64, times: u32) {
    let mut rng = fastrand::Rng::with_seed(seed);
    for _ in 0..times {
        let mut bytes = good.as_bytes().to_vec();
        for _ in 0..rng.usize(1..6) {
            let place = rng.usize(0..bytes.len());
            match rng.u8(0..3) {
                0 => bytes[place] = rng.u8(32..127),
                1 => bytes.truncate(place + 1),
                _ => bytes.insert(place, rng.u8(b'.'..b'{')),
            }
        }
        let text = String::from_utf8_lossy(&bytes);
        let _ = read(&text, From::Here);
        let _ = read(&text, From::Anywhere);
    }
}

#[test]
fn noise_is_refused_and_never_a_panic() {
    read_noise(&keep(&sample::solved()), 7, 5000);
}

/// A3 joined at time 1 and a charger appears at time 2; something else is listed.
fn changed() -> State {
    let stroke = |tool, x, y| {
        let cell = Cell::new(x, y);
        [Action::PickTool(tool), Action::Press(cell), Action::Release]
    };
    let state = crate::tests::adopted();
    let state = reduce(&state, Action::Seek(2));
    let actions = [Action::BeginChange].into_iter();
    let actions = actions.chain(stroke(crate::Tool::Charger, 0, 0));
    actions.fold(state, |state, action| reduce(&state, action))
}

#[test]
fn a_course_comes_back_judged_with_its_changes() {
    let state = crate::tests::adopted();
    let text = write(&state);
    assert!(text.contains("&changes=1aA3.2.2.1.0&plan="), "{text}");
    let linked = read(&text, From::Anywhere).unwrap();
    let answer = linked.answer.unwrap();
    assert_eq!(answer.plan(), state.plan());
    let course = answer.course.as_deref().unwrap();
    let before = state.answer.as_ref().unwrap();
    assert_eq!(course.changes, before.course.as_deref().unwrap().changes);
    assert_eq!(course.steps[0].method, None, "a link is not believed");
    assert_eq!(answer.solved.status, Status::Feasible);
    assert_eq!(answer.arrivals, before.arrivals);
}

#[test]
fn what_the_browser_kept_of_a_course_is_as_it_was() {
    let state = changed();
    let restored = State::restored(read(&keep(&state), From::Here).unwrap());
    assert_eq!(restored.phase(), Phase::Changing);
    assert_eq!(restored.playback.time, 2);
    let list = |state: &State| state.changing.as_ref().unwrap().list.clone();
    assert_eq!(list(&restored), list(&state));
    let course = |state: &State| state.answer.as_ref().unwrap().course.clone();
    assert_eq!(course(&restored), course(&state));
    let left = State::restored(read(&keep(&crate::tests::adopted()), From::Here).unwrap());
    assert_eq!(left.phase(), Phase::Planned);
}

#[test]
fn every_kind_of_change_comes_back() {
    let text = "0aA%2E.0.0.1.1.0.1!9.4;1rA1;2o1.2;2f1.2;3m1.2.3.4;4s0.0.1.1;4n0.0;5c1.0;\
        5k1.0;6gA1.2.2;6wA1.0.2;7dA1.0.2;8bA1.5;9pA1.3";
    let changes = change::read(text, 2).unwrap();
    assert_eq!(changes.changes.len(), 14);
    assert_eq!(change::write(&changes.changes), text);
}

#[test]
fn hostile_changes_are_refused() {
    let good = write(&crate::tests::adopted());
    for (changes, expect) in [
        ("1", "changes"),
        ("x", "changes"),
        ("1zA3", "changes"),
        ("1o1", "changes"),
        ("1o1.2.3", "changes"),
        ("99999999999o1.1", "changes"),
        ("100001aA3.2.2.1.0", "changes"),
        ("1aA3.2.2.1.0;1o1.0", "do not fit"),
        ("1aA3.9.9.1.0", "do not fit"),
        ("1aA1.2.2.1.0", "do not fit"),
        ("", "plan is broken"),
    ] {
        let text = good.replace("1aA3.2.2.1.0", changes);
        assert!(why(&text).contains(expect), "{changes}: {}", why(&text));
    }
    let many: Vec<String> = (1..=300).map(|at| format!("{at}o0.0")).collect();
    assert!(change::read(&many.join(";"), 2).is_none(), "too many times");
    let late: Vec<String> = (0..11).map(|n| format!("100000aB{n}.0.0.1.1")).collect();
    assert!(change::read(&late.join(";"), 2).is_none(), "too many steps");
}

#[test]
fn noise_about_changes_is_never_a_panic() {
    read_noise(&keep(&changed()), 8, 3000);
}

#[test]
fn a_question_is_asked_again() {
    let question = Question::Charge {
        agent: "A1".to_owned(),
        at: Some(Cell::new(6, 2)),
        time: None,
    };
    let state = reduce(&sample::solved(), Action::Ask(question.clone()));
    let text = write(&state);
    assert!(text.contains("&ask="), "{text}");
    assert!(!keep(&state).contains("&ask="), "a reload asks nothing");
    let opened = reduce(&State::new(Draft::default()), open(&text));
    assert_eq!(opened.phase(), Phase::Asking);
    assert_eq!(opened.asking.unwrap().question(), &question);
    assert_eq!(opened.answer.unwrap().plan(), state.plan());
    let closed = reduce(&state, Action::CloseQuestion);
    assert!(!write(&closed).contains("&ask="));
}

#[test]
fn a_question_without_a_plan_waits_for_the_answer() {
    let (text, _) = {
        let text = write(&sample::solved());
        let at = text.find("&plan=").unwrap();
        (format!("{}&ask=makespan", &text[..at]), at)
    };
    let opened = reduce(&State::new(Draft::default()), open(&text));
    assert_eq!(opened.phase(), Phase::Solving);
    let run = opened.work.id().unwrap();
    let solved = sample::solved().answer.unwrap().solved.clone();
    let response = Box::new(giveway_solve::Response::Solved(solved));
    let answered = reduce(&opened, Action::Respond { run, response });
    assert_eq!(answered.phase(), Phase::Asking);
    assert_eq!(answered.asking.unwrap().question(), &Question::Makespan);
    let cancelled = reduce(&opened, Action::Cancel);
    assert_eq!(cancelled.phase(), Phase::Editing);
}

#[test]
fn every_question_comes_back() {
    for text in [
        "wait;A2!at.3.1!from.0!to.2!at-least.2",
        "wait;A2",
        "charge;A1!at.6.2!time.5",
        "no-charge;A1!at.6.2",
        "visit;%2D%2Dx%21!at.3.1!time.5",
        "no-visit;A1!at.3.1",
        "no-visit;any!at.3.1",
        "move;A1!from-cell.0.0!to-cell.1.0!time.5",
        "no-move;A1!from-cell.0.0!to-cell.1.0",
        "slow;A1!from-cell.0.0!to-cell.1.0",
        "slow;A1",
        "order;A1!first.0.0!second.1.0",
        "arrival;A1",
        "length;A1!fewer-than.9",
        "makespan",
        "sum-of-costs",
        "charges;A1",
        "moves",
        "waits",
        "yield;A1;%3Cb%3E%20x!at.3.1",
        "unsolvable",
        "plan",
    ] {
        let question = ask::read(text).unwrap_or_else(|| panic!("{text}"));
        let written = ask::write(&question);
        assert_eq!(ask::read(&written), Some(question), "{written}");
        assert_eq!(written.replace("--x", "%2D%2Dx"), text);
    }
}

#[test]
fn hostile_questions_are_refused() {
    let good = write(&sample::solved());
    for question in [
        "",
        "why",
        "wait",
        "wait;%FF",
        "wait;A1!",
        "wait;A1!at",
        "wait;A1!at.1",
        "wait;A1!at.x.y",
        "wait;A1!from.-1",
        "wait;A1!time.1",
        "wait;A1;A2",
        "makespan!at.1.1",
        "yield;A1!at.1.1",
        "wait;A1!__proto__.1",
        "charge;A1!time.99999999999",
    ] {
        let told = why(&format!("{good}&ask={question}"));
        assert!(
            told.contains("\u{201c}ask\u{201d} is broken"),
            "{question}: {told}"
        );
    }
    // It can be read, and does not fit: the plan is shown all the same.
    let text = format!("{good}&ask=wait;nobody");
    let state = reduce(&State::new(Draft::default()), open(&text));
    assert_eq!((state.phase(), state.asking), (Phase::Stopped, None));
    assert!(state.notice.unwrap().sentence.contains("nobody"));
}

#[test]
fn links_of_old_can_be_opened() {
    // Links of each form that the page ever wrote: they are in mails and papers.
    for text in [
        "giveway=1&map=1.f&rules=0.0&costs=012&agents=",
        "giveway=1&map=3.3f&name=a%20b&rules=1.2&costs=10&agents=A1.0.0.2.0.1.0!9.4&plan=2r&time=1",
        "giveway=1&map=10.2f6s3f2of2of2o4fc2fc3f&name=warehouse&rules=0.0&costs=012&\
         agents=A1.0.0.9.2.2.0.4.2.7.0!10.10;A2.9.2.0.0.5.0.1.2!10.8&\
         plan=2rR2d3rc2uR2r2d;3lc2u3L2dc3l2u&time=7",
        "giveway=1&map=3.9f&name=dynamic-3x3&rules=0.0&costs=012&agents=A1.0.0.2.2;A2.2.0.0.2&\
         changes=1aA3.2.2.1.0&plan=2r2d;d2ld;l2u&time=1",
    ] {
        let linked = read(text, From::Anywhere);
        let linked = linked.unwrap_or_else(|notice| panic!("{text}: {notice:?}"));
        assert_eq!(linked.answer.is_some(), text.contains("&plan="));
        // They are written so still.
        let state = reduce(
            &State::new(Draft::default()),
            Action::OpenLink(Box::new(linked)),
        );
        assert_eq!(write(&state), text);
    }
}
