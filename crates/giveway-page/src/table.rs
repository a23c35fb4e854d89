//! The plan table: time by agent, cells and levels, as the papers print it.

use std::fmt::Write as _;

use giveway_model::{Cell, tr};

use crate::timeline::Lane;
use crate::{Answer, Draft, Reserve};

/// Where an agent is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Place {
    /// Not there yet, arrived before, or gone.
    Nowhere,
    /// On a cell.
    At(Cell),
    /// Half way along a slow move.
    Half,
}

impl Place {
    /// As it stands in the table.
    pub fn text(self) -> String {
        match self {
            Self::Nowhere => String::new(),
            Self::At(cell) => format!("{},{}", cell.x, cell.y),
            Self::Half => tr!("half way along a move" => "half").to_owned(),
        }
    }
}

/// A battery's entry.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Level {
    /// The level.
    pub level: u32,
    /// Whether the agent charges then.
    pub charges: bool,
    /// How full that is.
    pub reserve: Reserve,
}

/// A row of the table: of cells, or of the levels of the battery.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum RowKind {
    /// Where the robot is.
    Cells,
    /// How full its battery is.
    Levels,
}

/// The rows of the table, each of a lane by its place: those of the lane that is pinned, which
/// stay in sight, and all others.
pub fn rows(lanes: &[Lane], pinned: Option<usize>) -> [Vec<(usize, RowKind)>; 2] {
    let of = |is_first: bool| {
        let lanes = lanes.iter().enumerate();
        let lanes = lanes.filter(|(place, _)| (Some(*place) == pinned) == is_first);
        let rows = lanes.flat_map(|(place, lane)| {
            let levels = lane.capacity.map(|_| (place, RowKind::Levels));
            [Some((place, RowKind::Cells)), levels]
        });
        rows.flatten().collect()
    };
    [of(true), of(false)]
}

/// Where an agent is at a time.
pub fn place(lane: &Lane, time: u32) -> Place {
    if time == lane.arrival {
        return Place::At(lane.end());
    }
    match lane.step_at(time) {
        None => Place::Nowhere,
        Some(step) if step.begins == time => Place::At(step.from),
        Some(_) => Place::Half,
    }
}

/// What an agent's battery has at a time up to its arrival.
pub fn level(lane: &Lane, time: u32) -> Option<Level> {
    let index = time.checked_sub(lane.begins)? as usize;
    let level = *lane.levels.get(index)?;
    Some(Level {
        level,
        charges: lane.charges.contains(&time),
        reserve: Reserve::of(level, lane.capacity?),
    })
}

/// The table as text, for papers and letters: a column a time.
///
/// A charge is marked with `*`, half way along a slow move is `..`.
pub fn text(answer: &Answer) -> String {
    let last = answer.makespan();
    let mut rows = vec![row(
        tr!("a row of the plan table" => "time"),
        0..=last,
        |time| time.to_string() + " ",
    )];
    for lane in lanes(answer, &answer.draft) {
        rows.push(row(&lane.name, 0..=last, |time| match place(&lane, time) {
            Place::Half => ".. ".to_owned(),
            place => place.text() + " ",
        }));
        if lane.capacity.is_some() {
            rows.push(row(
                tr!("a row of the plan table" => "  level"),
                0..=last,
                |time| {
                    level(&lane, time).map_or(String::new(), |entry| {
                        format!("{}{}", entry.level, if entry.charges { '*' } else { ' ' })
                    })
                },
            ));
        }
    }
    aligned(&rows)
}

/// The plans of the agents of a draft, as far as an answer has one of each; a lane
/// has the agent's index in that draft. An answer whose world changed has lanes for
/// all agents that there ever are.
pub fn lanes(answer: &Answer, draft: &Draft) -> Vec<Lane> {
    if answer.course.is_some() {
        let agents = 0..answer.agents().len();
        return agents.filter_map(|agent| Lane::of(answer, agent)).collect();
    }
    let agents = 0..draft.agents().len();
    let lane = |agent: usize| {
        let lane = Lane::of(answer, answer.agent(draft, agent)?)?;
        Some(Lane { agent, ..lane })
    };
    agents.filter_map(lane).collect()
}

/// The most columns that one cell of a table can span: browsers take no more
/// (HTML, 4.9.11, "colspan").
const MOST_SPANNED: u32 = 1000;

/// The cells that together span so many columns.
///
/// ```
/// let spans: Vec<u32> = giveway_page::table::spans(2_500).collect();
/// assert_eq!(spans, [1_000, 1_000, 500]);
/// assert_eq!(giveway_page::table::spans(0).count(), 0);
/// ```
pub fn spans(columns: u32) -> impl Iterator<Item = u32> {
    let starts = (0..columns).step_by(MOST_SPANNED as usize);
    starts.map(move |start| (columns - start).min(MOST_SPANNED))
}

/// The least width of a column that holds its entries, in pixels: up to 7.4 a
/// digit at the table's size, and some room between two of them.
pub fn least_column(answer: &Answer) -> f64 {
    const HALF: f64 = 24.0;
    let grid = answer.draft.grid();
    let digits = |n: u32| n.to_string().len() as f64;
    let last = |side: u32| digits(side.saturating_sub(1));
    let cell = (last(grid.width()) + last(grid.height())) * 7.4 + 3.5;
    let batteries = answer.agents().iter().filter_map(|agent| agent.battery);
    // A charge has an arrow beside its level.
    let level = |capacity: u32| digits(capacity) * 7.4 + 7.0;
    let widest = batteries.map(|battery| level(battery.capacity));
    widest.fold(cell.max(HALF), f64::max) + 7.0
}

fn row(
    name: &str,
    times: impl Iterator<Item = u32>,
    entry: impl FnMut(u32) -> String,
) -> Vec<String> {
    // A name of control characters would break the lines.
    let name = name.replace(char::is_control, " ");
    std::iter::once(name).chain(times.map(entry)).collect()
}

fn aligned(rows: &[Vec<String>]) -> String {
    let length = |text: &String| text.chars().count();
    let names = rows.iter().filter_map(|row| row.first()).map(length);
    let names = names.max().unwrap_or(0);
    let entries = rows.iter().flat_map(|row| row.iter().skip(1)).map(length);
    let entries = entries.max().unwrap_or(0) + 1;
    let mut text = String::new();
    for row in rows {
        let mut line = String::new();
        for (i, entry) in row.iter().enumerate() {
            let _ = if i == 0 {
                write!(line, "{entry:names$}")
            } else {
                write!(line, "{entry:>entries$}")
            };
        }
        text += line.trim_end();
        text.push('\n');
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sample::warehouse;

    #[test]
    fn the_warehouse_as_text() {
        let text = text(&warehouse());
        let lines: Vec<&str> = text.lines().collect();
        assert_eq!(lines.len(), 5);
        assert!(
            lines[0].starts_with("time      0    1    2    3 "),
            "{text}"
        );
        assert!(
            lines[1].starts_with("A1      0,0  1,0  2,0   ..  3,0"),
            "{text}"
        );
        assert!(
            lines[2].starts_with("  level  10    9    8    7    6"),
            "{text}"
        );
        assert!(lines[2].contains(" 1*  "), "{text}");
        assert!(lines[4].ends_with(" 6"), "{text}");
    }

    #[test]
    fn the_rows_of_a_lane_that_is_pinned_stand_above_all_others() {
        let answer = warehouse();
        let lanes = lanes(&answer, &answer.draft);
        assert!(lanes.len() == 2 && lanes.iter().all(|lane| lane.capacity.is_some()));
        let of = |place| [(place, RowKind::Cells), (place, RowKind::Levels)];
        assert_eq!(rows(&lanes, None), [vec![], [of(0), of(1)].concat()]);
        assert_eq!(rows(&lanes, Some(1)), [of(1).to_vec(), of(0).to_vec()]);
        let mut bare = lanes;
        bare[0].capacity = None;
        assert_eq!(
            rows(&bare, Some(0)),
            [vec![(0, RowKind::Cells)], of(1).to_vec()]
        );
    }

    #[test]
    fn nothing_stands_after_the_arrival() {
        let answer = warehouse();
        let lane = Lane::of(&answer, 0).unwrap();
        assert_eq!(place(&lane, 17), Place::At(Cell::new(9, 2)));
        assert_eq!(place(&lane, 18), Place::Nowhere);
        assert_eq!(place(&lane, 3), Place::Half);
        assert_eq!(level(&lane, 18), None);
        let charge = level(&lane, 9).unwrap();
        assert_eq!((charge.level, charge.charges), (1, true));
        assert_eq!(charge.reserve, Reserve::Critical);
    }

    #[test]
    fn a_column_has_room_for_its_cells() {
        let least = least_column(&warehouse());
        assert!((24.0..32.0).contains(&least), "{least}");
    }
}
