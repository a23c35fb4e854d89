//! The names of a formula's variables.

use std::fmt::Write as _;

use giveway_model::constraint::Heading;
use giveway_model::{Cell, Cost, Instance};

/// The name of a variable; agents by their place in the file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Name {
    /// The agent is at the cell at the time.
    At(usize, Cell, u32),
    /// It is half way of a slow move from one cell to another at the time.
    Transit(usize, Cell, Cell, u32),
    /// It has arrived at the time or before.
    Done(usize, u32),
    /// It has been at a waypoint at the time or before.
    Seen(usize, Cell, u32),
    /// It charges at the time.
    Charge(usize, u32),
    /// It begins a move at the time.
    Move(usize, u32),
    /// It waits from the time to the next, before its arrival.
    Wait(usize, u32),
    /// An agent on the edge between the two cells, in the step that begins at the time, goes from the first
    /// to the second.
    Direction(Cell, Cell, u32),
    /// Some agents together cost at least so much.
    AtLeast(Cost, u32),
    /// The agent has at least so much of the cost.
    Level(usize, Cost, u32),
    /// Some agents together have at least so much of the cost beyond the least of each.
    Beyond(Cost, u32),
    /// The act of the condition happens at the time.
    Happens(u32),
    /// The agent that would be first has been at the cell of the question, at
    /// the time or before.
    Been(u32),
    /// By a rule, given by its number in the scene: the agent is in the zone at the time.
    Inside(usize, usize, u32),
    /// At least so many of the rule's agents are in its zone at the time.
    Crowd(usize, u32, u32),
    /// The agent is at the cell at the time, or was in the steps before that the rule names.
    Recent(usize, usize, Cell, u32),
    /// The agent has been at the first so many cells of the rule, in order, at the time or
    /// before.
    Reached(usize, usize, u32, u32),
    /// The agent begins the stay of the rule at the time.
    Stays(usize, usize, u32),
    /// The first agent of the rule has been at its cell, at the time or before.
    First(usize, u32),
    /// The agent faces the direction at the time.
    Facing(usize, usize, Heading, u32),
    /// The agent pays at the time.
    Pays(usize, usize, u32),
    /// An aid to say that at most one of some holds.
    Group,
    /// Both true and false: a rule that cannot be kept.
    Never,
}

/// Says what the lines of a list of names are.
const HEAD: &str = "\
# What each variable of the formula stands for, one a line: its number, then
#   at AGENT [X,Y] TIME              the robot AGENT is at the cell at the time
#   transit AGENT [X,Y] [X,Y] TIME   it is half way of a slow move between the cells
#   done AGENT TIME                  it has arrived, at the time or before
#   seen AGENT [X,Y] TIME            it has been at the waypoint, at the time or before
#   charge AGENT TIME                it charges at the time
#   move AGENT TIME                  it begins a move at the time
#   wait AGENT TIME                  it waits from the time to the next, not arrived yet
#   direction [X,Y] [X,Y] TIME       who is on the edge in the step from the time on goes from
#                                    the first cell to the second
#   at-least N COST                  some robots together cost at least so much
#   happens TIME                     what the claim is about happens at the time
#   been TIME                        what it must not come after has happened, at the time or before
#   group                            an aid to say that at most one of some variables is true
#   never                            a rule that cannot be kept
# Cells are [x,y] from 0 at the top left, times are steps from 0.
";

/// Says the same of the lines about rules of the scene's own, where it has some.
const RULES: &str = "\
# Of the rules of the scene's own, each by its number RULE in the list of the instance, from 0:
#   inside RULE AGENT TIME           the robot is in the zone at the time
#   crowd RULE N TIME                at least N robots are in the zone at the time
#   recent RULE AGENT [X,Y] TIME     the robot is at the cell at the time, or was a few steps before
#   reached RULE AGENT N TIME        it has been at the first N cells in order, at the time or before
#   stays RULE AGENT TIME            it begins its stay at the time
#   first RULE TIME                  who comes first has been at its cell, at the time or before
#   facing RULE AGENT SIDE TIME      the robot faces the side at the time
#   pays RULE AGENT TIME             it pays for the time
";

/// Says what the lines are where lemmas are put together.
const LEVELS: &str = "\
# What each variable of the formula stands for, one a line: its number, then
#   level AGENT N COST               the robot AGENT has at least N of the cost; of the sum of costs
#                                    that is its arrival
#   beyond N COST                    some robots together have at least N more than the least of each
#   never                            what cannot be
";

/// The list of names, a line a variable.
pub(super) fn text(names: &[Name], instance: &Instance) -> String {
    let agents: Vec<String> = instance
        .agents()
        .iter()
        .map(|agent| serde_json::to_string(&agent.name).unwrap_or_default())
        .collect();
    let agent = |index: usize| agents.get(index).map_or("?", String::as_str);
    let cell = |cell: Cell| format!("[{},{}]", cell.x, cell.y);
    let of_levels = matches!(names.first(), Some(Name::Level(..)));
    let mut text = if of_levels { LEVELS } else { HEAD }.to_owned();
    if instance.is_constrained() && !of_levels {
        text.push_str(RULES);
    }
    for (variable, name) in (1..).zip(names) {
        let meaning = match *name {
            Name::At(a, v, t) => format!("at {} {} {t}", agent(a), cell(v)),
            Name::Transit(a, u, v, t) => {
                format!("transit {} {} {} {t}", agent(a), cell(u), cell(v))
            }
            Name::Done(a, t) => format!("done {} {t}", agent(a)),
            Name::Seen(a, w, t) => format!("seen {} {} {t}", agent(a), cell(w)),
            Name::Charge(a, t) => format!("charge {} {t}", agent(a)),
            Name::Move(a, t) => format!("move {} {t}", agent(a)),
            Name::Wait(a, t) => format!("wait {} {t}", agent(a)),
            Name::Direction(u, v, t) => format!("direction {} {} {t}", cell(u), cell(v)),
            Name::AtLeast(cost, n) => format!("at-least {n} {cost}"),
            Name::Level(a, cost, n) => format!("level {} {n} {cost}", agent(a)),
            Name::Beyond(cost, n) => format!("beyond {n} {cost}"),
            Name::Happens(t) => format!("happens {t}"),
            Name::Been(t) => format!("been {t}"),
            Name::Inside(rule, a, t) => format!("inside {rule} {} {t}", agent(a)),
            Name::Crowd(rule, n, t) => format!("crowd {rule} {n} {t}"),
            Name::Recent(rule, a, v, t) => format!("recent {rule} {} {} {t}", agent(a), cell(v)),
            Name::Reached(rule, a, n, t) => format!("reached {rule} {} {n} {t}", agent(a)),
            Name::Stays(rule, a, t) => format!("stays {rule} {} {t}", agent(a)),
            Name::First(rule, t) => format!("first {rule} {t}"),
            Name::Facing(rule, a, heading, t) => {
                format!("facing {rule} {} {} {t}", agent(a), side(heading))
            }
            Name::Pays(rule, a, t) => format!("pays {rule} {} {t}", agent(a)),
            Name::Group => "group".to_owned(),
            Name::Never => "never".to_owned(),
        };
        let _ = writeln!(text, "{variable} {meaning}");
    }
    text
}

const fn side(heading: Heading) -> &'static str {
    match heading {
        Heading::North => "north",
        Heading::East => "east",
        Heading::South => "south",
        Heading::West => "west",
    }
}
