//! The report of a plan, to be read on paper: what is proved, the map, costs, changes, who is last
//! and why, each robot, batteries, the busiest cells, the questions that were asked. Plain data, and its words as HTML and CSV.

mod batteries;
mod busy;
mod csv;
mod facts;
mod html;
mod last;
mod map;
mod marks;
mod objective;
mod robots;
mod subject;
#[cfg(test)]
mod tests;

use giveway_model::{Cell, Cost, Units};

pub use subject::Subject;

/// A longer link is not printed: nobody would type it.
const LONGEST_LINK: usize = 2000;

/// What a front knows of a plan beside the plan itself.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Known {
    /// What is proved, as a sentence: the headline.
    pub claim: String,
    /// Whether it is proved that no plan is better, and of which plans.
    pub proved: Proved,
    /// What else is to be said of the claim, a sentence each.
    pub remarks: Vec<String>,
    /// What is proved of a cost of any plan: at least so much.
    pub bounds: Vec<(Cost, u32)>,
    /// The costs of the plan before the world changed, where they are known.
    pub before: Option<giveway_model::Costs>,
    /// How the plan went on after the changes of a time, where that is known.
    pub methods: Vec<(u32, String)>,
    /// The questions that were asked.
    pub questions: Vec<Question>,
    /// What robots lose against their ways alone, where that is known.
    pub delays: Vec<LoneDelay>,
    /// The address that opens the plan on the page, where it is short enough.
    pub link: Option<String>,
    /// The day on which the report is made, as it is printed.
    pub date: Option<String>,
}

/// Whether a plan is proved best, and among which plans.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Proved {
    /// It is not.
    #[default]
    No,
    /// It is not, but the bounds hold for all plans.
    Bounded,
    /// Among all plans.
    OfAll,
    /// Among those that the claim names: up to a makespan, or from a time on.
    OfThese,
}

impl Proved {
    /// A plan that is proved best: among all plans, or among those up to a makespan.
    pub const fn within(within: Option<u32>) -> Self {
        match within {
            None => Self::OfAll,
            Some(_) => Self::OfThese,
        }
    }
}

/// What a robot loses against its best way alone.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct LoneDelay {
    /// The robot.
    pub robot: String,
    /// When it would arrive alone, in steps.
    pub alone: u32,
    /// How many steps it loses.
    pub delay: u32,
    /// Whom it lets pass, by their names; nothing where it loses nothing.
    pub passes: String,
    /// Whom it lets pass, as a sentence.
    pub why: String,
}

/// A question that was asked of the plan, with its answer.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Question {
    /// The question.
    pub asked: String,
    /// Which plan it was about, as a sentence, where it is another one.
    pub about: Option<String>,
    /// The verdict in a word or two.
    pub verdict: String,
    /// The reasons, a sentence each.
    pub reasons: Vec<String>,
}

/// The report of a plan.
#[derive(Clone, Debug, PartialEq)]
pub struct Report {
    /// The name of the scene.
    pub title: String,
    /// What the scene has, a line each.
    pub facts: Vec<String>,
    /// What is proved.
    pub known: Known,
    /// What the plan costs, in words.
    pub costs_told: String,
    /// Which costs count, in their order, and what is proved of them: a sentence each.
    pub objective: Vec<String>,
    /// The costs, those of the objective first.
    pub costs: Vec<CostRow>,
    /// What changed while the plan ran, by time.
    pub changes: Vec<ChangeRow>,
    /// Who is last and why, a sentence each; nothing where nobody arrives.
    pub last: Vec<String>,
    /// The robots, in the order of the scene.
    pub robots: Vec<RobotRow>,
    /// The busiest cells, the first one first.
    pub busiest: Vec<BusyCell>,
    /// Where robots wait longest, and how many steps: the longest first.
    pub waited: Vec<(Cell, u32)>,
    /// The map as SVG, in black and white.
    pub map: String,
    /// What the signs of the map mean.
    pub signs: Vec<Sign>,
    /// How cells and times are told, and what a slow zone does: a sentence each.
    pub conventions: Vec<String>,
    /// How batteries are told; `None` where no robot has one.
    pub battery_rule: Option<String>,
    units: Option<Units>,
}

/// A cost of the plan.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct CostRow {
    /// The cost.
    pub cost: Cost,
    /// What the plan has.
    pub value: u32,
    /// The time that it is, where it counts steps and the scene has units.
    pub time: Option<String>,
    /// What is proved of any plan: at least so much.
    pub at_least: Option<u32>,
    /// What the plan had before the world changed.
    pub before: Option<u32>,
}

/// Something that changed while the plan ran.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ChangeRow {
    /// When, in steps.
    pub at: u32,
    /// What.
    pub what: String,
    /// How the plan went on.
    pub method: Option<String>,
}

/// A robot and its plan.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct RobotRow {
    /// Its name.
    pub name: String,
    /// What stands for it on the map.
    pub number: String,
    /// Where it starts.
    pub start: Cell,
    /// When it starts, in steps.
    pub begins: u32,
    /// Its waypoints, by the time of the first visit; `None` where it does not come there.
    pub waypoints: Vec<(Cell, Option<u32>)>,
    /// Its goal; `None` where it may rest anywhere.
    pub goal: Option<Cell>,
    /// When it arrives, in steps; `None` where it does not.
    pub arrives: Option<u32>,
    /// When it is removed.
    pub removed: Option<u32>,
    /// How many steps it waits.
    pub waits: u32,
    /// Where and when it charges.
    pub charges: Vec<(Cell, u32)>,
    /// The lowest level of its battery; `None` without one.
    pub lowest: Option<i64>,
    /// Its battery; `None` without one.
    pub battery: Option<BatteryRow>,
    /// What it loses against its way alone; `None` where that is not known.
    pub alone: Option<LoneDelay>,
}

/// A battery on its way.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct BatteryRow {
    /// How much it holds.
    pub capacity: u32,
    /// Its level when the robot begins.
    pub initial: u32,
    /// Its least level up to the arrival.
    pub least: i64,
    /// Where and when it is that for the first time.
    pub least_at: Option<(Cell, u32)>,
    /// Its level at the goal; `None` where the robot does not arrive.
    pub at_goal: Option<i64>,
}

/// A cell that is often used.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct BusyCell {
    /// Its letter on the map.
    pub letter: String,
    /// The cell.
    pub cell: Cell,
    /// How often a robot enters it.
    pub passes: u32,
    /// How many robots do.
    pub robots: usize,
    /// How many steps robots wait there on their way.
    pub waits: u32,
}

/// A sign of the map.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Sign {
    /// A robot starts.
    Start,
    /// Its goal.
    Goal,
    /// A busy cell.
    Busy,
    /// A robot breaks down.
    Breakdown,
    /// An obstacle.
    Obstacle,
    /// A slow cell.
    Slow,
    /// A charger.
    Charger,
}

impl Report {
    /// The report of a plan.
    pub fn of(subject: &Subject<'_>, mut known: Known) -> Self {
        known.link = known.link.filter(|link| link.len() <= LONGEST_LINK);
        let robots = robots::rows(subject, &known);
        let busiest = busy::busiest(subject);
        let waited = busy::waited(subject);
        let (map, signs) = map::map(subject, &robots, &busiest);
        Self {
            title: facts::title(subject),
            facts: facts::facts(subject),
            conventions: facts::conventions(subject),
            battery_rule: batteries::rule(subject),
            costs_told: facts::costs_told(subject),
            objective: objective::told(subject, &known),
            costs: facts::costs(subject, &known),
            changes: facts::changes(subject, &known),
            last: last::told(subject, &robots, &known),
            units: subject.units(),
            robots,
            busiest,
            waited,
            map,
            signs,
            known,
        }
    }
}
