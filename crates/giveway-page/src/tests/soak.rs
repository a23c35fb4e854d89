//! Whatever a person does, in whatever order: nothing is lost, nothing panics, and
//! what cannot be together never is.

use giveway_model::{Cell, Question};
use giveway_solve::{SilentHost, serve};

use crate::changing;
use crate::steering::{self, Lead};
use crate::{
    Action, AskAction, BoardAction, ChangeAction, Draft, Edit, FileAction, Fill, Mode, PlayAction,
    SolveAction, State, Tool, ViewAction, ask, board, inspect, link, reduce, table, words,
};

/// How many actions in all.
const ACTIONS: u64 = 100_000;
/// A session begins anew after so many.
const SESSION: u64 = 1_000;

#[test]
fn nothing_is_ever_lost() {
    for seed in 0..ACTIONS / SESSION {
        Session::new(seed).run(SESSION);
    }
}

struct Session {
    rng: fastrand::Rng,
    state: State,
    /// The numbers of jobs that are over, with their answers.
    late: Vec<Action>,
    done: Vec<String>,
}

impl Session {
    fn new(seed: u64) -> Self {
        let scene = giveway_model::Scene {
            map: vec!["....".into(), ".#+.".into(), "~~..".into()],
            ..giveway_model::Scene::default()
        };
        Self {
            rng: fastrand::Rng::with_seed(seed),
            state: State::new(Draft::new(scene).unwrap()),
            late: Vec::new(),
            done: vec![format!("seed {seed}")],
        }
    }

    fn run(&mut self, actions: u64) {
        for step in 0..actions {
            for action in self.next() {
                self.done.push(format!("{action:.60?}"));
                self.state = reduce(&self.state, action);
                self.check(step);
            }
        }
    }

    fn cell(&mut self) -> Cell {
        let grid = self.state.document.draft.grid();
        // At times off the map.
        let (width, height) = (grid.width() + 1, grid.height() + 1);
        Cell::new(self.rng.u32(0..width), self.rng.u32(0..height))
    }

    fn agent(&mut self) -> usize {
        let count = self.state.world().agents().len();
        self.rng.usize(0..count + 2)
    }

    fn next(&mut self) -> Vec<Action> {
        match self.rng.u8(0..100) {
            0..25 => self.stroke(),
            25..40 => vec![Action::Undo],
            40..48 => vec![Action::Redo],
            48..58 => vec![Action::Edit(self.edit())],
            58..72 => self.solve(),
            72..80 => vec![Action::Ask(self.question())],
            80..88 => vec![Action::Change(self.change())],
            88..93 => vec![Action::Steer(self.lead())],
            93..97 => self.look(),
            _ => vec![self.file()],
        }
    }

    fn stroke(&mut self) -> Vec<Action> {
        let tool = *self.rng.choice(&Tool::ALL).unwrap();
        let mut actions = vec![BoardAction::PickTool(tool), BoardAction::Press(self.cell())];
        for _ in 0..self.rng.usize(0..4) {
            actions.push(BoardAction::Drag(self.cell()));
        }
        match self.rng.u8(0..10) {
            0 => actions.push(BoardAction::Abandon),
            // Left in the air.
            1 => {}
            _ => actions.push(BoardAction::Release),
        }
        actions.into_iter().map(Action::Board).collect()
    }

    fn edit(&mut self) -> Edit {
        let (agent, cell) = (self.agent(), self.cell());
        match self.rng.u8(0..14) {
            0 => Edit::RemoveAgent(agent),
            1 => Edit::SetGoal(agent, cell),
            2 => Edit::AddWaypoint(agent, cell),
            3 => Edit::DropWaypoint(agent, cell),
            4 => Edit::Rename(agent, "B".to_owned()),
            5 => Edit::Resize(self.rng.u32(1..6), self.rng.u32(1..5)),
            6 => Edit::Clear,
            7 => Edit::Fill(Fill {
                obstacles: 20,
                agents: self.rng.u32(0..4),
                seed: self.rng.u32(0..9),
            }),
            8 => Edit::SetBattery(
                agent,
                self.rng.bool().then_some(giveway_model::Battery {
                    capacity: 8,
                    initial: 5,
                }),
            ),
            9 => Edit::Within(self.rng.bool().then_some(9)),
            10 => Edit::Recolour(agent, self.rng.usize(0..13)),
            11 => Edit::Delay(agent, 2),
            12 => Edit::SetLevel(agent, 3),
            _ => Edit::Name("soak".to_owned()),
        }
    }

    /// Starts, ends or answers what runs; answers come late at times.
    fn solve(&mut self) -> Vec<Action> {
        let solve = match self.rng.u8(0..10) {
            0..4 => SolveAction::Solve,
            4 => SolveAction::Cancel,
            5 => SolveAction::CheckProof,
            6 => SolveAction::ShowPoint(0),
            _ => return self.answer(),
        };
        vec![Action::Solve(solve)]
    }

    fn answer(&mut self) -> Vec<Action> {
        let Some((job, request)) = self.state.work.request() else {
            return self.late.pop().into_iter().collect();
        };
        if self.rng.u8(0..12) == 0 {
            let sentence = "It broke off.".to_owned();
            return vec![Action::Solve(SolveAction::Crash {
                job,
                sentence,
                had_started: true,
            })];
        }
        let response = Box::new(serve(&request, &SilentHost));
        let answer = Action::Solve(SolveAction::Respond { job, response });
        self.late.push(answer.clone());
        self.late.truncate(4);
        vec![answer]
    }

    fn question(&mut self) -> AskAction {
        let cell = self.cell();
        let agents = self.state.document.draft.agents();
        let name = agents.first().map_or_else(String::new, |a| a.name.clone());
        match self.rng.u8(0..10) {
            0 => AskAction::Ask(Question::Makespan),
            1 => AskAction::Ask(Question::Unsolvable),
            2 => AskAction::Ask(Question::Plan),
            3 => AskAction::Ask(Question::NoVisit {
                agent: None,
                at: cell,
            }),
            4 => AskAction::Ask(Question::Arrival { agent: name }),
            5 => AskAction::Close,
            6 => AskAction::ShowOther(self.rng.bool()),
            7 => AskAction::TakeOther,
            8 => AskAction::TakeRepair(self.rng.usize(0..2)),
            _ => AskAction::Again,
        }
    }

    fn change(&mut self) -> ChangeAction {
        match self.rng.u8(0..8) {
            0..3 => ChangeAction::Begin,
            3 => ChangeAction::Discard,
            4 => ChangeAction::TakeBack(self.rng.usize(0..2)),
            5 => ChangeAction::Adapt,
            6 => ChangeAction::Preview(self.rng.usize(0..3)),
            _ => ChangeAction::Adopt(self.rng.usize(0..3)),
        }
    }

    fn lead(&mut self) -> Lead {
        match self.rng.u8(0..8) {
            0..3 => Lead::Begin,
            3 => Lead::Step((self.rng.i32(-1..2), 0)),
            4 => Lead::To(self.cell()),
            5 => Lead::Charge,
            6 => Lead::Back,
            _ => Lead::Discard,
        }
    }

    fn look(&mut self) -> Vec<Action> {
        let time = self.rng.u32(0..9);
        let select = if self.rng.bool() {
            crate::Selection::Agent(self.agent())
        } else {
            crate::Selection::Cell(self.cell())
        };
        vec![
            Action::Board(BoardAction::Select(select)),
            Action::Play(PlayAction::Seek(time)),
            Action::View(ViewAction::SetWide(self.rng.bool())),
            Action::View(ViewAction::SetSolveOnChange(self.rng.u8(0..4) == 0)),
            Action::View(ViewAction::SetFront(self.rng.u8(0..4) == 0)),
        ]
    }

    fn file(&mut self) -> Action {
        match self.rng.u8(0..3) {
            0 => Action::File(FileAction::Back),
            1 => {
                let scene = self.state.document.draft.scene().clone();
                Action::File(FileAction::Open(Box::new(scene)))
            }
            _ => link::open(&link::write(&self.state)),
        }
    }

    /// All that holds after whatever was done.
    fn check(&self, step: u64) {
        let state = &self.state;
        let told = || {
            let from = self.done.len().saturating_sub(12);
            format!("step {step}: {:#?}", &self.done[from..])
        };
        assert!(
            state.view.playback.time <= state.last_time(),
            "time: {}",
            told()
        );
        if let crate::Selection::Agent(agent) = state.view.selection {
            let is_drawn = state.has_gesture() || agent < state.world().agents().len();
            assert!(is_drawn, "selection: {}", told());
        }
        let mut kept = state.work.clone();
        kept.keep_to(&state.document);
        assert_eq!(kept.id(), state.work.id(), "work: {}", told());
        if !state.has_gesture() && state.history.can_undo() {
            let redone = reduce(&reduce(state, Action::Undo), Action::Redo);
            assert!(redone.document == state.document, "undo, redo: {}", told());
        }
        show(state);
        if step.is_multiple_of(64) {
            let again = link::kept(&link::keep(state)).unwrap_or_else(|notice| {
                panic!("kept: {notice:?} {}", told());
            });
            assert_eq!(link::keep(&again), link::keep(state), "kept: {}", told());
        }
    }
}

/// All that places of the page make of a state.
fn show(state: &State) {
    let _ = words::standing(state);
    let _ = (ask::offers(state), ask::card(state), inspect::whole(state));
    let _ = (changing::facts(state), changing::columns(state));
    let _ = (steering::facts(state), state.can_change());
    let _ = board::Cast::of(state);
    for agent in 0..=state.world().agents().len() {
        let _ = inspect::agent(state, agent);
        let _ = changing::offers(state, agent);
    }
    for answer in state.shown().into_iter().chain(state.beside()) {
        let lanes = table::lanes(answer, &state.document.draft);
        for lane in &lanes {
            let _ = (lane.sentence(), lane.level_at(state.view.playback.time));
        }
    }
    match &state.document.mode {
        Mode::Asking(_) => assert!(state.document.answer.is_some()),
        Mode::Steering(own) | Mode::Judging(own, _) => {
            assert!(own.about.course.is_none());
        }
        Mode::Stuck(comparing, _) => assert!(comparing.preview().is_none()),
        Mode::Editing | Mode::Changing(_) | Mode::Comparing(_) => {}
    }
}
