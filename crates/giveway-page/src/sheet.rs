//! A scene on paper: its title, what is said of it, its signs and the plan table, as the
//! page prints them.

mod rows;

use std::ops::Range;

use giveway_model::tr;

use crate::board::{Cast, Kind, legend};
use crate::lesson::Lesson;
use crate::table::{Level, Place, lanes, level, place};
use crate::timeline::Lane;
use crate::{State, words};

pub use rows::Row;

/// The most columns of robots beside each other, by what stands in them.
const COLUMNS: usize = 14;
const COLUMNS_WITH_LEVELS: usize = 8;
/// The most entries of a plan table on paper: some 60 pages.
const ENTRIES: usize = 50_000;

/// A scene on paper.
#[derive(Clone, Debug, PartialEq)]
pub struct Sheet {
    /// The name of the scene.
    pub title: String,
    /// What is said of the plan, as on the page; empty where a lesson hides it.
    pub standing: String,
    /// What the costs are, how many robots there are, and which time the board shows.
    pub facts: Vec<String>,
    /// What the signs on the board mean.
    pub signs: Vec<Kind>,
    /// The plan; `None` where there is none to be shown.
    pub table: Option<Table>,
}

/// The plan table on paper: a row each time, and one row for a long time in which nothing
/// changes.
#[derive(Clone, Debug, PartialEq)]
pub struct Table {
    /// All robots that the plan has.
    lanes: Vec<Lane>,
    /// The rows; empty where the table is left out.
    pub rows: Vec<Row>,
    /// The robots of each part, beside each other.
    pub parts: Vec<Range<usize>>,
    /// Why the table is left out, where it is too large.
    pub left_out: Option<String>,
}

impl Sheet {
    /// What the page prints of a state.
    pub fn of(state: &State, cast: &Cast) -> Self {
        let scene = state.document.draft.scene();
        let hides_plan = state.lesson().is_some_and(Lesson::hides_plan);
        let robots = tr!("{n} robot" | "{n} robots" % state.world().agents().len());
        let grid = state.world().grid();
        let size = tr!(
            "map of {width} × {height} cells",
            width = grid.width(),
            height = grid.height()
        );
        let objective = words::objective(&scene.objective).join(tr!(" then "));
        let mut facts = vec![robots, size, objective];
        facts.extend(scene.units.map(|units| {
            tr!(
                "a cell is {cell} m wide, a step takes {step} s",
                cell = units.cell,
                step = units.step
            )
        }));
        let answer = state.shown().filter(|_| !hides_plan);
        let answer = answer.filter(|answer| answer.plan().is_some());
        if answer.is_some() {
            let (time, last) = (state.view.playback.time, state.last_time());
            let [time, last] = [time, last].map(|time| words::timed(scene.units, time));
            facts.push(tr!("the board shows time {time} of {last}", time, last));
        }
        Self {
            title: match scene.name.as_str() {
                "" => tr!("Untitled").to_owned(),
                name => name.to_owned(),
            },
            standing: if hides_plan {
                String::new()
            } else {
                words::standing(state).sentence
            },
            facts,
            signs: legend(state, cast),
            table: answer
                .map(|answer| Table::of(lanes(answer, &state.document.draft), answer.makespan())),
        }
    }
}

impl Table {
    fn of(lanes: Vec<Lane>, last: u32) -> Self {
        let has_levels = lanes.iter().any(|lane| lane.capacity.is_some());
        let columns = if has_levels {
            COLUMNS_WITH_LEVELS
        } else {
            COLUMNS
        };
        let mut rows = rows::rows(&lanes, last);
        let entries = lanes.len().saturating_mul(rows.len());
        let left_out = (entries > ENTRIES).then(|| {
            tr!(
                "The plan table has {entries} entries, more than fit on paper. Save the plan to have all of it.",
                entries
            )
        });
        if left_out.is_some() {
            rows.clear();
        }
        let starts = (0..lanes.len()).step_by(columns);
        let parts = starts.map(|start| start..(start + columns).min(lanes.len()));
        Self {
            parts: if left_out.is_some() {
                Vec::new()
            } else {
                parts.collect()
            },
            lanes,
            rows,
            left_out,
        }
    }

    /// The robots of a part: the look of each, and its name.
    pub fn heads(&self, part: &Range<usize>) -> impl Iterator<Item = (usize, &str)> {
        let lanes = self.lanes.get(part.clone()).unwrap_or_default().iter();
        lanes.map(|lane| (lane.agent, lane.name.as_str()))
    }

    /// Where the robots of a part are at a time: the cell, and the level of the battery
    /// with an arrow where it charges; empty before a robot comes and after it arrived.
    pub fn row(&self, part: &Range<usize>, time: u32) -> impl Iterator<Item = String> {
        let lanes = self.lanes.get(part.clone()).unwrap_or_default().iter();
        lanes.map(move |lane| {
            let at = match place(lane, time) {
                Place::At(cell) => format!("({}, {})", cell.x, cell.y),
                other => other.text(),
            };
            match level(lane, time) {
                Some(Level { level, charges, .. }) if !at.is_empty() => {
                    let arrow = if charges { "\u{2191}" } else { "" };
                    format!("{at} {level}{arrow}")
                }
                _ => at,
            }
        })
    }

    /// What an entry is.
    pub fn caption(&self) -> &'static str {
        if self.lanes.iter().any(|lane| lane.capacity.is_some()) {
            tr!(
                "The cell of each robot at each time, and its battery; an arrow: it charges. Empty: not there yet, or arrived."
            )
        } else {
            tr!("The cell of each robot at each time. Empty: not there yet, or arrived.")
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Action, Draft, PlayAction, reduce, sample};

    #[test]
    fn the_sheet_has_the_whole_plan() {
        let state = reduce(&sample::solved(), Action::Play(PlayAction::Seek(7)));
        let sheet = Sheet::of(&state, &Cast::by(&state, state.shown()));
        assert_eq!(sheet.title, "warehouse");
        assert!(sheet.standing.contains("18"), "{}", sheet.standing);
        assert!(sheet.facts.iter().any(|fact| fact.contains("time 7 of 18")));
        let table = sheet.table.unwrap();
        assert_eq!((table.rows.len(), table.parts.len()), (19, 1));
        assert_eq!(table.parts[0], 0..2);
        let heads: Vec<&str> = table.heads(&(0..2)).map(|head| head.1).collect();
        assert_eq!(heads, ["A1", "A2"]);
        let first: Vec<String> = table.row(&(0..2), 0).collect();
        assert_eq!(first, ["(0, 0) 10", "(9, 2) 8"]);
        let each = (0..19).map(Row::Time);
        assert!(each.eq(table.rows.iter().copied()), "{:?}", table.rows);
        assert!((0..19).all(|time| table.row(&(0..2), time).count() == 2));
        assert!(table.left_out.is_none());
    }

    #[test]
    fn a_scene_without_a_plan_has_no_table_and_a_large_one_says_so() {
        let state = State::new(Draft::default());
        let sheet = Sheet::of(&state, &Cast::by(&state, state.shown()));
        assert_eq!((sheet.title.as_str(), sheet.table), ("Untitled", None));
        let state = sample::solved();
        let some = lanes(state.shown().unwrap(), &state.document.draft);
        let many: Vec<Lane> = some.iter().cycle().take(40).cloned().collect();
        let table = Table::of(many, 90);
        assert_eq!(table.parts.len(), 5);
        assert_eq!(table.parts.iter().map(Range::len).sum::<usize>(), 40);
        let many: Vec<Lane> = some.iter().cycle().take(4_000).cloned().collect();
        let table = Table::of(many, 90);
        assert!(table.parts.is_empty() && table.rows.is_empty());
        // 19 times at which somebody moves or charges, the one after, and the rest in one.
        assert!(table.left_out.unwrap().contains("84000 entries"));
    }
}
