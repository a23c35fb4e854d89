//! The map, drawn with characters.
//!
//! Three drawings, the richest that fits: cells wide enough for the letters of
//! the agents, one character a cell, or a sentence that says that it is too
//! large.

use std::collections::BTreeMap;
use std::fmt::Write as _;

use giveway_model::{Agent, Cell, Ground, Instance, change::History};

use super::{
    marks::{LETTERS, Style, letter, marks},
    plain,
};

/// Maps of more rows are not drawn.
const MAX_ROWS: u32 = 120;

/// Draws the map and its legend, in lines of at most so many columns.
pub(crate) fn draw(instance: &Instance, columns: usize) -> String {
    let grid = instance.grid();
    let margin = grid.height().saturating_sub(1).to_string().len() + 2;
    let fits = |cell: usize| margin + cell * grid.width() as usize <= columns;
    let lettered = Drawing::new(instance, Style::Letters);
    if grid.height() > MAX_ROWS || !fits(1) {
        return format!(
            "The map is too large to be drawn here: {} x {} cells.\n",
            grid.width(),
            grid.height()
        );
    }
    let drawing = if instance.agents().len() <= LETTERS && fits(lettered.pitch()) {
        lettered
    } else {
        let mut kinds = Drawing::new(instance, Style::Kinds);
        kinds.gap = fits(2);
        kinds
    };
    drawing.picture(margin) + &drawing.legend(columns)
}

/// Draws the map as it is after all changes, with the agents of then where each
/// has a start and a goal of its own.
pub(crate) fn draw_over_time(instance: &Instance, history: &History, columns: usize) -> String {
    let mut scene = instance.to_scene();
    scene.map = history.last_grid().rows();
    let there = history.timelines().iter().filter(|it| it.until.is_none());
    scene.agents = there.map(|it| it.agent_now(None)).collect();
    let mut drawn = Instance::new(scene.clone());
    if drawn.is_err() {
        scene.agents.clear();
        drawn = Instance::new(scene);
    }
    draw(drawn.as_ref().unwrap_or(instance), columns)
}

struct Drawing<'a> {
    instance: &'a Instance,
    style: Style,
    marks: BTreeMap<Cell, String>,
    /// Whether there is a blank between two cells.
    gap: bool,
}

impl<'a> Drawing<'a> {
    fn new(instance: &'a Instance, style: Style) -> Self {
        Self {
            instance,
            style,
            marks: marks(instance, style),
            gap: true,
        }
    }

    /// The columns of a cell, without the gap.
    fn cell_columns(&self) -> usize {
        match self.style {
            Style::Kinds => 1,
            // The ground, then the marks.
            Style::Letters => 1 + self.marks.values().map(String::len).max().unwrap_or(0),
        }
    }

    /// The columns from one cell to the next.
    fn pitch(&self) -> usize {
        self.cell_columns() + usize::from(self.gap)
    }

    fn picture(&self, margin: usize) -> String {
        let grid = self.instance.grid();
        let mut text = self.ruler(margin);
        for y in 0..grid.height() {
            let mut line = plain::pad_left(&y.to_string(), margin - 1) + " ";
            for x in 0..grid.width() {
                let cell = Cell::new(x, y);
                let drawn = self.cell(cell, grid.ground(cell).unwrap_or(Ground::Obstacle));
                line += &plain::pad_right(&drawn, self.pitch());
            }
            text += line.trim_end();
            text.push('\n');
        }
        text
    }

    /// The numbers of the columns, as many as there is room for.
    fn ruler(&self, margin: usize) -> String {
        let width = self.instance.grid().width();
        let widest = width.saturating_sub(1).to_string().len();
        let step = if widest < self.pitch() { 1 } else { 5 };
        let mut line = " ".repeat(margin);
        for x in (0..width).step_by(step) {
            line += &plain::pad_right(&x.to_string(), self.pitch() * step);
        }
        line.trim_end().to_owned() + "\n"
    }

    fn cell(&self, cell: Cell, ground: Ground) -> String {
        match (self.marks.get(&cell), self.style) {
            (Some(mark), Style::Letters) => format!("{}{mark}", ground.to_char()),
            (Some(mark), Style::Kinds) => mark.clone(),
            // A wall is seen as one.
            (None, _) if ground == Ground::Obstacle => "#".repeat(self.cell_columns()),
            (None, _) => ground.to_char().to_string(),
        }
    }

    /// What the characters mean, then whose letters they are.
    fn legend(&self, columns: usize) -> String {
        let mut words = self.ground_words();
        let agents = self.instance.agents();
        if !agents.is_empty() {
            let kinds: &[&str] = match self.style {
                Style::Letters => &["A start", "a goal", "a' waypoint"],
                Style::Kinds => &["S start", "G goal", "X start and goal", "w waypoint"],
            };
            let has_waypoints = agents.iter().any(|agent| !agent.waypoints.is_empty());
            let shown = kinds.len() - usize::from(!has_waypoints);
            words.extend(kinds.iter().take(shown).map(|&word| word.to_owned()));
        }
        let names: Vec<String> = match self.style {
            Style::Kinds => Vec::new(),
            Style::Letters => agents.iter().enumerate().filter_map(name_of).collect(),
        };
        wrap(&words, columns) + &wrap(&names, columns)
    }

    /// The grounds that occur on the map, in words.
    fn ground_words(&self) -> Vec<String> {
        let occurs = |ground| self.instance.grid().cells().any(|(_, g)| g == ground);
        [
            (Ground::Obstacle, "# obstacle"),
            (Ground::Slow, "~ slow zone"),
            (Ground::Charger, "+ charger"),
            (Ground::SlowCharger, "* charger in the slow zone"),
        ]
        .into_iter()
        .filter(|(ground, _)| occurs(*ground))
        .map(|(_, word)| word.to_owned())
        .collect()
    }
}

/// `B = robot`, where the agent has a letter.
fn name_of((i, agent): (usize, &Agent)) -> Option<String> {
    let name = plain::cut_middle(&plain::text(&agent.name), 40);
    Some(format!("{} = {name}", letter(i)?))
}

/// The words with commas, in indented lines of at most so many columns.
fn wrap(words: &[String], columns: usize) -> String {
    let mut text = String::new();
    let mut line = String::new();
    for (i, word) in words.iter().enumerate() {
        let comma = if i + 1 < words.len() { "," } else { "" };
        if !line.is_empty() && 3 + plain::width(&line) + plain::width(word) + 1 > columns {
            let _ = writeln!(text, " {line}");
            line.clear();
        }
        let _ = write!(line, " {word}{comma}");
    }
    if !line.is_empty() {
        let _ = writeln!(text, " {line}");
    }
    text
}

#[cfg(test)]
mod tests {
    use expect_test::{Expect, expect};
    use giveway_model::Scene;

    use super::*;

    /// Name, start and goal, waypoints.
    type Task<'a> = (&'a str, [u32; 4], &'a [[u32; 2]]);

    fn check(map: &[&str], agents: &[Task<'_>], columns: usize, expect: &Expect) {
        let scene = Scene {
            map: map.iter().map(|&row| row.to_owned()).collect(),
            agents: agents
                .iter()
                .map(|&(name, [x, y, goal_x, goal_y], waypoints)| Agent {
                    name: name.to_owned(),
                    start: Cell::new(x, y),
                    goal: Some(Cell::new(goal_x, goal_y)),
                    waypoints: waypoints.iter().map(|w| Cell::new(w[0], w[1])).collect(),
                    battery: None,
                    heading: None,
                })
                .collect(),
            ..Scene::default()
        };
        let drawn = draw(&Instance::new(scene).unwrap(), columns);
        // A first line that is not indented: else the indentation of all is lost.
        expect.assert_eq(&format!("{columns} columns\n{drawn}"));
    }

    const WAREHOUSE: [&str; 3] = ["..~~~~~~..", ".##.##.##.", "...+..+..."];

    #[test]
    fn a_small_map_shows_whose_cells_they_are() {
        check(
            &WAREHOUSE,
            &[
                ("A1", [0, 0, 9, 2], &[[2, 0], [4, 2], [7, 0]]),
                ("A2", [9, 2, 0, 0], &[[5, 0], [1, 2]]),
            ],
            100,
            &expect![[r#"
                100 columns
                   0   1   2   3   4   5   6   7   8   9
                 0 .Ab .   ~a' ~   ~   ~b' ~   ~a' .   .
                 1 .   ### ### .   ### ### .   ### ### .
                 2 .   .b' .   +   .a' .   +   .   .   .Ba
                  # obstacle, ~ slow zone, + charger, A start, a goal, a' waypoint
                  A = A1, B = A2
            "#]],
        );
    }

    #[test]
    fn a_map_too_wide_for_letters_shows_kinds() {
        check(
            &WAREHOUSE,
            &[
                ("A1", [0, 0, 9, 2], &[[2, 0], [4, 2], [7, 0]]),
                ("A2", [9, 2, 0, 1], &[[5, 0], [1, 2]]),
            ],
            25,
            &expect![[r#"
                25 columns
                   0 1 2 3 4 5 6 7 8 9
                 0 S . w ~ ~ w ~ w . .
                 1 G # # . # # . # # .
                 2 . w . + w . + . . X
                  # obstacle,
                  ~ slow zone,
                  + charger, S start,
                  G goal,
                  X start and goal,
                  w waypoint
            "#]],
        );
    }

    #[test]
    fn a_map_too_wide_for_anything_is_not_drawn() {
        check(
            &WAREHOUSE,
            &[],
            12,
            &expect![[r#"
                12 columns
                The map is too large to be drawn here: 10 x 3 cells.
            "#]],
        );
    }

    #[test]
    fn a_map_without_agents_has_no_marks() {
        check(
            &["..", "*#"],
            &[],
            100,
            &expect![[r#"
                100 columns
                   0 1
                 0 . .
                 1 * #
                  # obstacle, * charger in the slow zone
            "#]],
        );
    }
}
