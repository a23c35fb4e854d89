//! The tour of the page: seven steps on the real page, each of which ends when a person
//! has done it, as plain data with a pure reducer.
//!
//! A person's own page is put aside for it, as for a lesson: on the scene of the tour
//! every step can be done, and nobody's work is touched.

mod step;

use giveway_model::condition::Times;
use giveway_model::constraint::ConstraintKind;
use giveway_model::{Agent, Cell, Constraint, Scene, Zone, tr};

use crate::lesson::Layer;
use crate::port::{Board, BoardNumber, BoardPlan, Deed, FromPage, Hand, Happened, Sight, ToPage};

pub use step::{Step, Target};

/// Its name among what the page can open of the course.
pub const NAME: &str = "tour";
/// The number of its first board: no lesson ever comes so far.
pub const FIRST: BoardNumber = BoardNumber(1 << 31);

/// The robot that waits at time 0 of the plan.
const ROBOT: &str = "A1";
/// Where it waits.
const WAITS: Cell = Cell::new(4, 0);
/// The cell to be closed, which is on its way: there is another one around it.
const CLOSED: Cell = Cell::new(6, 1);

/// The cells of the zone of the rule, where the robots pass one after the other.
const MARKED: [Cell; 2] = [Cell::new(3, 1), Cell::new(4, 1)];

/// The tour, on its way.
#[derive(Clone, Debug, PartialEq)]
pub struct Tour {
    /// The number of its board.
    number: BoardNumber,
    /// The step.
    step: Step,
    /// What it sees of the page.
    sight: Sight,
    /// Whether the step is to be done for the person, as soon as that can be.
    is_wanted: bool,
}

/// What happens on the tour.
#[derive(Clone, Debug, PartialEq)]
pub enum Action {
    /// The page says something.
    Page(FromPage),
    /// The step is to be done for the person.
    Show,
    /// The tour ends.
    End,
}

/// What must be done outside of it.
#[derive(Clone, Debug, PartialEq)]
pub enum Effect {
    /// Tells the page something.
    Page(ToPage),
    /// Opens the contents of the course.
    Contents,
}

/// A tour that begins on a board of this number, and what must be done outside.
#[must_use]
pub fn begin(number: BoardNumber) -> (Tour, Vec<Effect>) {
    let tour = Tour {
        number,
        step: Step::Watch,
        sight: Sight::default(),
        is_wanted: false,
    };
    let effects = vec![tour.open()];
    (tour, effects)
}

/// What becomes of a tour, and what must be done outside, in this order; `None` once it
/// is over.
#[must_use]
pub fn reduce(mut tour: Tour, action: Action) -> (Option<Tour>, Vec<Effect>) {
    let mut effects = Vec::new();
    let goes_on = tour.act(action, &mut effects);
    (goes_on.then_some(tour), effects)
}

impl Tour {
    /// The step.
    pub const fn step(&self) -> Step {
        self.step
    }

    /// The number of its board.
    pub const fn number(&self) -> BoardNumber {
        self.number
    }

    /// What the step is about, as the page is now.
    pub fn target(&self) -> Target {
        let is_selected = self.sight.robot.as_deref() == Some(ROBOT);
        match self.step {
            Step::Watch => Target::Play,
            Step::Ask if is_selected => Target::Question,
            Step::Select | Step::Ask => Target::Cell(WAITS),
            Step::Close if self.sight.paints => Target::Cell(CLOSED),
            Step::Close => Target::Obstacle,
            Step::Solve => Target::Solve,
            Step::Rule if self.sight.is_writing => Target::AddRule,
            Step::Rule if self.sight.is_ruled => Target::Price,
            Step::Rule if self.sight.marks => Target::Cell(MARKED[0]),
            Step::Rule => Target::Zone,
            Step::GoOn => Target::Course,
        }
    }

    /// Whether it goes on.
    fn act(&mut self, action: Action, effects: &mut Vec<Effect>) -> bool {
        match action {
            Action::End => {
                effects.push(Effect::Page(ToPage::Close));
                return false;
            }
            Action::Show if self.step == Step::GoOn => {
                effects.push(Effect::Page(ToPage::Close));
                effects.push(Effect::Contents);
                return false;
            }
            Action::Show => self.show(effects),
            // What it says of an earlier board is old news.
            Action::Page(message) if message.number == self.number => match message.what {
                Happened::Closed => return false,
                Happened::Seen(sight) => self.saw(sight, effects),
                _ => {}
            },
            Action::Page(_) => {}
        }
        true
    }

    fn saw(&mut self, sight: Sight, effects: &mut Vec<Effect>) {
        let is_new = sight.is_solved && !self.sight.is_solved;
        self.sight = sight;
        let before = self.step;
        if is_new && before == Step::Watch {
            // A plan that arrives plays by itself: here, a person begins it.
            effects.push(Effect::Page(ToPage::Go(0)));
        }
        while self.step.is_done(&self.sight) {
            self.step = self.step.next();
            self.is_wanted = false;
        }
        if self.step != before && matches!(self.step, Step::Select | Step::Ask) {
            // The robot waits there.
            effects.push(Effect::Page(ToPage::Go(0)));
        }
        if self.is_wanted && self.sight.is_solved {
            self.show(effects);
        }
    }

    /// Does the step for the person; where it needs a plan and there is none, the board
    /// begins anew before.
    fn show(&mut self, effects: &mut Vec<Effect>) {
        self.is_wanted = self.step.needs_plan() && !self.sight.is_solved;
        if self.is_wanted {
            if self.sight.is_edited {
                self.number.0 = self.number.0.wrapping_add(1);
                self.sight = Sight::default();
                effects.push(self.open());
            }
            return;
        }
        let select = || ToPage::Do(Deed::Select(ROBOT.to_owned()));
        let says = match self.step {
            Step::Watch => vec![ToPage::Play],
            Step::Select => vec![ToPage::Go(0), select()],
            Step::Ask => vec![ToPage::Go(0), select(), ToPage::Do(Deed::Ask)],
            Step::Close => vec![ToPage::Do(Deed::Paint(CLOSED))],
            Step::Solve => vec![ToPage::Do(Deed::Solve)],
            Step::Rule => {
                let (zone, rule) = rule();
                let add = (!self.sight.is_ruled).then_some(Deed::Rule(zone, rule));
                let deeds = add.into_iter().chain([Deed::Price]);
                deeds.map(ToPage::Do).collect()
            }
            Step::GoOn => Vec::new(),
        };
        effects.extend(says.into_iter().map(Effect::Page));
    }

    fn open(&self) -> Effect {
        Effect::Page(ToPage::Open(Box::new(Board {
            number: self.number,
            scene: scene(),
            plan: BoardPlan::Best,
            changes: None,
            time: 0,
            playing: false,
            tools: Vec::new(),
            edits: None,
            cells: None,
            show: vec![Layer::Trails],
            hand: Hand::Tours,
        })))
    }
}

/// The rule that the tour adds, with its zone: one robot at a time where the robots pass.
pub fn rule() -> (Zone, Constraint) {
    let name = tr!("the name of a zone" => "zone {number}", number = 1);
    let kind = ConstraintKind::Capacity {
        zone: name.clone(),
        most: 1,
        times: Times::default(),
    };
    let rule = Constraint {
        kind,
        agents: None,
        name: None,
        off: false,
    };
    (Zone::of(&name, MARKED.to_vec()), rule)
}

/// The scene of the tour: one robot comes out of a bay when another one passes by. In the
/// only best plan it waits at time 0.
pub fn scene() -> Scene {
    let agent = |name: &str, start: (u32, u32), goal: (u32, u32)| Agent {
        name: name.to_owned(),
        start: Cell::new(start.0, start.1),
        goal: Some(Cell::new(goal.0, goal.1)),
        waypoints: Vec::new(),
        battery: None,
        heading: None,
    };
    let map = ["####.####", ".........", "#####...#"];
    Scene {
        name: "side bay".to_owned(),
        map: map.map(str::to_owned).to_vec(),
        agents: vec![
            agent(ROBOT, (WAITS.x, WAITS.y), (8, 1)),
            agent("A2", (5, 1), (0, 1)),
        ],
        ..Scene::default()
    }
}
