//! The list of the keys, as the help shows it.

use giveway_model::words::Later;
use giveway_model::{tr, tr_later};

/// A row of the help: keys that belong together, and what they do.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Row {
    /// The keys, each as it stands on a keyboard; those of a chord joined by `+`.
    pub keys: &'static [&'static str],
    /// What they do.
    pub what: Later,
}

/// The help: groups of rows, each with a title.
pub const HELP: [(Later, &[Row]); 7] = [
    (
        tr_later!("Solving"),
        &[
            row(&["Ctrl+Enter"], tr_later!("Solve")),
            row(&["Escape"], tr_later!("Cancel; close what is open")),
            row(&["Ctrl+Z"], tr_later!("Undo")),
            row(&["Ctrl+Shift+Z"], tr_later!("Redo")),
            row(
                &["Ctrl+V"],
                tr_later!(
                    "Open what was copied: a scene, a plan, a map, a link, a table of robots"
                ),
            ),
        ],
    ),
    (
        tr_later!("Time"),
        &[
            row(&["Space"], tr_later!("Play or pause")),
            row(&[",", "."], tr_later!("One step back, one step forward")),
            row(&["Home", "End"], tr_later!("To the start, to the end")),
            row(&["X"], tr_later!("Change the world at the time shown")),
            row(&["1", "9"], tr_later!("Choose a conflict (By hand)")),
            row(&["Enter"], tr_later!("Split on it (By hand)")),
        ],
    ),
    (
        tr_later!("Tools"),
        &[
            row(&["V"], tr_later!("Select")),
            row(&["O"], tr_later!("Obstacle")),
            row(&["C"], tr_later!("Charger")),
            row(&["S"], tr_later!("Slow zone")),
            row(&["E"], tr_later!("Erase")),
            row(&["Z"], tr_later!("a tool" => "Zone")),
            row(&["R"], tr_later!("a tool" => "One-way")),
            row(&["A"], tr_later!("Robot")),
            row(&["G"], tr_later!("Goal")),
            row(&["W"], tr_later!("Waypoint")),
            row(
                &["1", "7"],
                tr_later!("Shapes from pen to aisle (Obstacle and others)"),
            ),
            row(&["Shift"], tr_later!("Rectangle with the pen, else a line")),
            row(&["Alt"], tr_later!("Take away what the tool draws")),
        ],
    ),
    (
        tr_later!("Board"),
        &[
            row(
                &["\u{2190}", "\u{2191}", "\u{2192}", "\u{2193}"],
                tr_later!("Move the cursor"),
            ),
            row(&["Enter", "Space"], tr_later!("Use the tool on the cell")),
            row(
                &[
                    "Shift+\u{2190}",
                    "Shift+\u{2191}",
                    "Shift+\u{2192}",
                    "Shift+\u{2193}",
                ],
                tr_later!("Move what is on the cell; select an area (Select)"),
            ),
            row(&["Ctrl+A"], tr_later!("Select all of the floor")),
            row(
                &["Ctrl+C", "Ctrl+V", "Ctrl+D"],
                tr_later!("Copy, paste, repeat the area"),
            ),
            row(
                &["H", "Shift+H", "T"],
                tr_later!("Mirror the area, turn it"),
            ),
            row(
                &["Alt+Space"],
                tr_later!("Take the cell out of the zone (Zone)"),
            ),
            row(&["Delete"], tr_later!("Remove what is selected")),
            row(&["+", "\u{2212}", "0"], tr_later!("Zoom in, zoom out, fit")),
            row(&["/"], tr_later!("Find a robot by its name")),
            row(&["F"], tr_later!("Follow the robot selected")),
            row(&["N"], tr_later!("Next conflict (of the robot selected)")),
            row(
                &["N", "Shift+N"],
                tr_later!("Next difference of two plans, the one before"),
            ),
            row(&["M"], tr_later!("What all best plans share")),
            row(&["P"], tr_later!("Present: the board full screen")),
            row(&["?"], tr_later!("This list")),
        ],
    ),
    (
        tr_later!("The tab Order: who passes a cell after whom"),
        &[
            row(
                &["\u{2190}", "\u{2191}", "\u{2192}", "\u{2193}"],
                tr_later!("Choose the cell of the order"),
            ),
            row(
                &["Escape"],
                tr_later!("Leave the late robot, the links, the order"),
            ),
        ],
    ),
    (
        tr_later!("While presenting"),
        &[
            row(
                &["\u{2190}", "\u{2192}"],
                tr_later!("One step back, one step forward"),
            ),
            row(
                &["\u{2191}", "\u{2193}"],
                tr_later!("The question before, the next one"),
            ),
            row(
                &["PageUp", "PageDown"],
                tr_later!("Back, on: a step of the lesson, a question, a time"),
            ),
            row(&["H"], tr_later!("Hide all answers, show them again")),
            row(&["Escape"], tr_later!("End the presentation")),
        ],
    ),
    (
        tr_later!("A robot by hand"),
        &[
            row(&["L"], tr_later!("Lead the robot that is selected")),
            row(
                &["\u{2190}", "\u{2191}", "\u{2192}", "\u{2193}"],
                tr_later!("Lead it a step"),
            ),
            row(&["W"], tr_later!("Let it wait a step")),
            row(&["C"], tr_later!("Let it charge in its next step")),
            row(&["Backspace"], tr_later!("Take a step back")),
            row(&["Ctrl+Enter"], tr_later!("Check your plan")),
        ],
    ),
];

const fn row(keys: &'static [&'static str], what: Later) -> Row {
    Row { keys, what }
}

/// A key as it is written on keyboards of the language.
pub fn key_name(key: &'static str) -> &'static str {
    match key {
        "Ctrl" => tr!("a key" => "Ctrl"),
        "Shift" => tr!("a key" => "Shift"),
        "Space" => tr!("a key" => "Space"),
        "Home" => tr!("a key" => "Home"),
        "End" => tr!("a key" => "End"),
        "Delete" => tr!("a key" => "Delete"),
        "PageUp" => tr!("a key" => "Page Up"),
        "PageDown" => tr!("a key" => "Page Down"),
        other => other,
    }
}
