//! A table as text: tabs, semicolons or commas between its cells.

use super::Column;

/// A pasted table: what its columns are, and its rows.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Grid {
    /// What each column is; `None` where it is nothing of a robot's.
    pub(crate) columns: Vec<Option<Part>>,
    /// Whether the columns have heads.
    pub(crate) has_heads: bool,
    pub(crate) rows: Vec<Vec<String>>,
}

/// What a column of a pasted table is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Part {
    /// A column as it stands here.
    Whole(Column),
    /// Only its x, or its y.
    Half(Column, bool),
}

/// Heads of columns in English and German, in lower case without blanks.
const HEADS: [(&str, Column); 23] = [
    ("name", Column::Name),
    ("robot", Column::Name),
    ("agent", Column::Name),
    ("roboter", Column::Name),
    ("start", Column::Start),
    ("from", Column::Start),
    ("von", Column::Start),
    ("waypoints", Column::Waypoints),
    ("waypoint", Column::Waypoints),
    ("wegpunkte", Column::Waypoints),
    ("zwischenziele", Column::Waypoints),
    ("goal", Column::Goal),
    ("to", Column::Goal),
    ("ziel", Column::Goal),
    ("battery", Column::Battery),
    ("akku", Column::Battery),
    ("batterie", Column::Battery),
    ("atthestart", Column::Level),
    ("level", Column::Level),
    ("zubeginn", Column::Level),
    ("amstart", Column::Level),
    ("amanfang", Column::Level),
    ("ladestand", Column::Level),
];

/// Whether a text is a table of robots: by its heads, or else by pairs of numbers in each row.
pub(crate) fn is_table(text: &str) -> bool {
    let grid = grid(text);
    let has = |column| {
        let is = |part: &Option<Part>| match part {
            Some(Part::Whole(of) | Part::Half(of, _)) => *of == column,
            None => false,
        };
        grid.columns.iter().any(is)
    };
    let is_placed =
        has(Column::Start) || (has(Column::Name) && grid.has_heads && grid.columns.len() > 1);
    is_placed && (has(Column::Goal) || grid.has_heads) && !grid.rows.is_empty()
}

/// Reads a table. Without heads its columns are told by what they hold.
pub(crate) fn grid(text: &str) -> Grid {
    let text = text.trim_start_matches('\u{feff}');
    let mark = separator(text);
    let lines = text.lines().filter(|line| !line.trim().is_empty());
    let mut rows: Vec<Vec<String>> = lines.map(|line| split(line, mark)).collect();
    let heads: Vec<Option<Part>> = rows
        .first()
        .into_iter()
        .flatten()
        .map(|head| headed(head))
        .collect();
    let has_heads = heads.iter().flatten().count() > 1
        || (heads.len() == 1 && heads.iter().flatten().count() == 1);
    let columns = if has_heads {
        rows.remove(0);
        heads
    } else {
        found(&rows)
    };
    Grid {
        columns,
        has_heads,
        rows,
    }
}

fn separator(text: &str) -> char {
    let first = text
        .lines()
        .find(|line| !line.trim().is_empty())
        .unwrap_or_default();
    let mut is_quoted = false;
    let mut bare = String::new();
    for c in first.chars() {
        is_quoted ^= c == '"';
        if !is_quoted {
            bare.push(c);
        }
    }
    ['\t', ';']
        .into_iter()
        .find(|&mark| bare.contains(mark))
        .unwrap_or(',')
}

/// The cells of a line; a quoted one may hold the separator, and a quote as two.
fn split(line: &str, mark: char) -> Vec<String> {
    let mut cells = vec![String::new()];
    let mut is_quoted = false;
    let mut chars = line.chars().peekable();
    while let Some(c) = chars.next() {
        let Some(cell) = cells.last_mut() else { break };
        match c {
            '"' if is_quoted && chars.peek() == Some(&'"') => {
                chars.next();
                cell.push('"');
            }
            '"' => is_quoted = !is_quoted,
            c if c == mark && !is_quoted => cells.push(String::new()),
            c => cell.push(c),
        }
    }
    cells.iter().map(|cell| plain(cell).to_owned()).collect()
}

/// A cell without the mark by which a file keeps spreadsheets from reading a formula.
fn plain(cell: &str) -> &str {
    let cell = cell.trim();
    let text = cell.strip_prefix('\'');
    text.filter(|text| text.starts_with(['=', '+', '-', '@']))
        .unwrap_or(cell)
}

fn headed(head: &str) -> Option<Part> {
    let plain: String = head
        .to_lowercase()
        .chars()
        .filter(|c| c.is_alphanumeric())
        .collect();
    let of = |name: &str| {
        let own = Column::ALL.into_iter().find(|column| {
            let own = column.name().to_lowercase();
            own.chars().filter(|c| c.is_alphanumeric()).eq(name.chars())
        });
        own.or_else(|| {
            HEADS
                .into_iter()
                .find(|(head, _)| *head == name)
                .map(|(_, column)| column)
        })
    };
    if let Some(column) = of(&plain) {
        return Some(Part::Whole(column));
    }
    let half = |is_y: bool, axis: char| {
        let place = plain.strip_suffix(axis).and_then(of);
        let place = place.filter(|column| matches!(column, Column::Start | Column::Goal));
        place.map(|column| Part::Half(column, is_y))
    };
    half(false, 'x').or_else(|| half(true, 'y'))
}

/// What columns are by what they hold: pairs of numbers are the start, then the goal, with
/// waypoints between them; single numbers are the battery, then its level; else it is the name.
fn found(rows: &[Vec<String>]) -> Vec<Option<Part>> {
    let width = rows.iter().map(Vec::len).max().unwrap_or(0);
    let count = |text: &String| numbers(text).map(|numbers| numbers.len());
    let cells = |column: usize| {
        rows.iter()
            .filter_map(move |row| row.get(column))
            .filter(|cell| !cell.is_empty())
    };
    let is_pair = |&column: &usize| {
        cells(column).next().is_some()
            && cells(column).all(|cell| count(cell).is_some_and(|n| n > 0 && n % 2 == 0))
    };
    let is_number = |&column: &usize| {
        cells(column).next().is_some() && cells(column).all(|cell| count(cell) == Some(1))
    };
    let pairs: Vec<usize> = (0..width).filter(is_pair).collect();
    let mut columns = vec![None; width];
    let mut put = |at: Option<usize>, column| {
        if let Some(place) = at.and_then(|at| columns.get_mut(at)) {
            *place = Some(Part::Whole(column));
        }
    };
    if let [start, between @ .., goal] = &*pairs {
        put(Some(*start), Column::Start);
        put(Some(*goal), Column::Goal);
        put(between.first().copied(), Column::Waypoints);
        let mut numbers = (goal + 1..width).filter(is_number);
        put(numbers.next(), Column::Battery);
        put(numbers.next(), Column::Level);
        let name = (0..*start).find(|&column| cells(column).any(|cell| count(cell).is_none()));
        put(name, Column::Name);
    }
    columns
}

/// The numbers of a text that has nothing else but what stands between and around them.
pub(super) fn numbers(text: &str) -> Option<Vec<u32>> {
    let is_between = |c: char| c.is_whitespace() || matches!(c, ',' | ';' | '(' | ')' | '|' | '/');
    let parts = text.split(is_between).filter(|part| !part.is_empty());
    parts.map(|part| part.parse().ok()).collect()
}
