//! What a person does next, by chance.

use giveway_model::{Cell, Question};
use giveway_solve::plan::Planner;

use super::Session;
use super::by_hand::by_hand;
use crate::draw::Shape;
use crate::find::FindAction;
use crate::freedom::FreedomAction;
use crate::inside::{InsideAction, Method};
use crate::ledger::{LedgerAction, LedgerLit};
use crate::planners::By;
use crate::steering::Lead;
use crate::tests::{answer, seek};
use crate::{
    Action, AskAction, BoardAction, ChangeAction, Edit, FileAction, Fill, SolveAction, Tool,
    ViewAction, WorkerAction, link,
};

impl Session {
    pub(super) fn cell(&mut self) -> Cell {
        let grid = self.state.document.draft.grid();
        // At times off the map.
        Cell::new(
            self.rng.u32(..=grid.width()),
            self.rng.u32(..=grid.height()),
        )
    }

    fn agent(&mut self) -> usize {
        self.rng.usize(0..self.state.world().agents().len() + 2)
    }

    pub(super) fn next(&mut self) -> Vec<Action> {
        match self.rng.u8(0..100) {
            0..25 => self.stroke(),
            25..28 => vec![Action::Fleet(self.fleet())],
            28..40 => vec![Action::Undo],
            40..48 => vec![Action::Redo],
            48..58 => vec![Action::Edit(self.edit())],
            58..72 => self.solve(),
            72..80 => vec![Action::Ask(self.question())],
            80..88 => vec![Action::Change(self.change())],
            88..91 => vec![Action::Steer(self.lead())],
            91..93 => vec![Action::Audit(self.audit())],
            93..95 => self.look(),
            95..97 => vec![Action::Inside(self.inside())],
            97 => self.dropped(),
            98 if self.rng.bool() => vec![Action::Area(self.area())],
            98 if self.rng.bool() => self.grow(),
            98 if self.rng.bool() => self.find(),
            98 if self.rng.bool() => vec![Action::Freedom(self.freedom())],
            98 if self.rng.bool() => vec![Action::Ledger(self.ledger())],
            98 => vec![Action::Order(self.order())],
            _ => vec![self.file()],
        }
    }

    fn inside(&mut self) -> InsideAction {
        let n = self.rng.usize(0..6);
        match self.rng.u8(0..16) {
            0..2 => InsideAction::Show(n > 0),
            // Without a clock CBS has no end where there is no plan.
            2..5 => InsideAction::By(*self.rng.choice(&[Method::Proof, Method::Orders]).unwrap()),
            5 => InsideAction::Step(n),
            6 => InsideAction::Node(n as u64),
            7 => InsideAction::Order(n),
            8 => InsideAction::Robots(n),
            9 => InsideAction::Last,
            10 => InsideAction::Next,
            11 => InsideAction::Play(n > 0),
            12 => InsideAction::Tick,
            13 => InsideAction::Alone(n > 1),
            14 => by_hand(&mut self.rng, n),
            _ => *self
                .rng
                .choice(&[
                    InsideAction::Again,
                    InsideAction::Reasons,
                    InsideAction::PlayPlan,
                ])
                .unwrap(),
        }
    }

    fn stroke(&mut self) -> Vec<Action> {
        let tool = *self.rng.choice(&Tool::ALL).unwrap();
        let mut actions = vec![BoardAction::PickTool(tool)];
        if let Some(&shape) = self.rng.choice(Shape::of(tool)) {
            actions.push(BoardAction::PickShape(shape));
        }
        actions.push(match self.rng.u8(0..4) {
            0 => BoardAction::Mark {
                cell: self.cell(),
                takes: self.rng.bool(),
                is_rect: self.rng.bool(),
            },
            _ => BoardAction::Press(self.cell()),
        });
        for _ in 0..self.rng.usize(0..4) {
            actions.push(BoardAction::Drag(vec![self.cell()]));
        }
        match self.rng.u8(0..10) {
            0 => actions.push(BoardAction::Abandon),
            // Left in the air.
            1 => {}
            _ => actions.push(BoardAction::Release),
        }
        actions.into_iter().map(Action::Board).collect()
    }

    /// What is said of several robots, whether or not rows of them were drawn.
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
        let planner = *self.rng.choice(&Planner::ALL).unwrap_or(&Planner::Cbs);
        let by = *self
            .rng
            .choice(&[By::Search, By::Planner(planner)])
            .unwrap();
        let solve = match self.rng.u8(0..14) {
            10 => SolveAction::Plan(planner),
            11 => SolveAction::ShowPlan(by),
            12 => SolveAction::ShowBeside(by),
            0..4 => SolveAction::Solve,
            4 => SolveAction::Cancel,
            5 => SolveAction::CheckProof,
            13 => SolveAction::SaveProof,
            6 => SolveAction::ShowPoint(0),
            _ => return self.answer(),
        };
        vec![Action::Solve(solve)]
    }

    fn answer(&mut self) -> Vec<Action> {
        let Some(job) = self.state.work.id() else {
            return self.late.pop().into_iter().collect();
        };
        if self.rng.u8(0..12) == 0 {
            let sentence = "It broke off.".to_owned();
            return vec![Action::Worker(WorkerAction::Crash {
                job,
                sentence,
                had_started: true,
            })];
        }
        let answer = answer(&self.state);
        self.late.push(answer.clone());
        self.late.truncate(4);
        vec![answer]
    }

    fn question(&mut self) -> AskAction {
        let cell = self.cell();
        let agents = self.state.document.draft.agents();
        let name = agents.first().map_or_else(String::new, |a| a.name.clone());
        match self.rng.u8(0..14) {
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
            9 => AskAction::GoTo(cell),
            10 => AskAction::Group(self.rng.usize(0..3)),
            12 => AskAction::TakeFound,
            11 => AskAction::Choose(self.rng.bool().then_some(self.rng.usize(0..3))),
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

    fn ledger(&mut self) -> LedgerAction {
        let n = self.rng.usize(0..4);
        match self.rng.u8(0..7) {
            0..3 => LedgerAction::Show(n > 0),
            3 => LedgerAction::Turn(n > 1),
            4 => LedgerAction::Light(Some(LedgerLit::Place(n))),
            5 => LedgerAction::AddUp,
            _ => LedgerAction::Light((n > 0).then_some(LedgerLit::Robot(n))),
        }
    }

    fn freedom(&mut self) -> FreedomAction {
        match self.rng.u8(0..12) {
            0..5 => FreedomAction::Show(true),
            5 => FreedomAction::Show(false),
            6 => FreedomAction::Ask,
            7 => FreedomAction::GoOn,
            8 => FreedomAction::ShowOther(self.rng.bool()),
            9 | 10 => FreedomAction::Close(self.cell()),
            _ => FreedomAction::Open,
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
            seek(time),
            Action::View(ViewAction::SetWide(self.rng.bool())),
            Action::View(ViewAction::SetSolveOnChange(self.rng.u8(0..4) == 0)),
            Action::View(ViewAction::SetFront(self.rng.u8(0..4) == 0)),
        ]
    }

    fn find(&mut self) -> Vec<Action> {
        let part = *self.rng.choice(&["", "A", "1", "B2", "x"]).unwrap();
        let actions = [
            FindAction::Open,
            FindAction::Type(part.to_owned()),
            FindAction::Step {
                on: self.rng.bool(),
            },
            if self.rng.bool() {
                FindAction::Close
            } else {
                FindAction::Step { on: true }
            },
        ];
        actions.map(Action::Find).to_vec()
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
}
