//! The list of the keys, as the help shows it.

/// A row of the help: keys that belong together, and what they do.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Row {
    /// The keys, each as it stands on a keyboard; those of a chord joined by `+`.
    pub keys: &'static [&'static str],
    /// What they do.
    pub what: &'static str,
}

/// The help: groups of rows, each with a title.
pub const HELP: [(&str, &[Row]); 5] = [
    (
        "Solving",
        &[
            row(&["Ctrl+Enter"], "Solve"),
            row(&["Escape"], "Cancel; close what is open"),
            row(&["Ctrl+Z"], "Undo"),
            row(&["Ctrl+Shift+Z"], "Redo"),
            row(
                &["Ctrl+V"],
                "Open what was copied: a scene, a plan, a map, a link",
            ),
        ],
    ),
    (
        "Time",
        &[
            row(&["Space"], "Play or pause"),
            row(&[",", "."], "One step back, one step forward"),
            row(&["Home", "End"], "To the start, to the end"),
            row(&["X"], "Change the world at the time shown"),
        ],
    ),
    (
        "Tools",
        &[
            row(&["V"], "Select"),
            row(&["O"], "Obstacle"),
            row(&["C"], "Charger"),
            row(&["S"], "Slow zone"),
            row(&["E"], "Erase"),
            row(&["A"], "Robot"),
            row(&["G"], "Goal"),
            row(&["W"], "Waypoint"),
        ],
    ),
    (
        "Board",
        &[
            row(
                &["\u{2190}", "\u{2191}", "\u{2192}", "\u{2193}"],
                "Move the cursor",
            ),
            row(&["Enter", "Space"], "Use the tool on the cell"),
            row(
                &[
                    "Shift+\u{2190}",
                    "Shift+\u{2191}",
                    "Shift+\u{2192}",
                    "Shift+\u{2193}",
                ],
                "Move what is on the cell (Select)",
            ),
            row(&["+", "\u{2212}", "0"], "Zoom in, zoom out, fit"),
            row(&["/"], "Find a robot by its name"),
            row(&["F"], "Follow the robot selected"),
            row(&["N"], "Next conflict (of the robot selected)"),
            row(&["M"], "What must be so in every best plan"),
            row(&["?"], "This list"),
        ],
    ),
    (
        "A robot by hand",
        &[
            row(&["L"], "Lead the robot that is selected"),
            row(
                &["\u{2190}", "\u{2191}", "\u{2192}", "\u{2193}"],
                "Lead it a step",
            ),
            row(&["W"], "Let it wait a step"),
            row(&["C"], "Let it charge in its next step"),
            row(&["Backspace"], "Take a step back"),
            row(&["Ctrl+Enter"], "Check your plan"),
        ],
    ),
];

const fn row(keys: &'static [&'static str], what: &'static str) -> Row {
    Row { keys, what }
}
