//! What an agent looks like: a colour, a form of its own, a short name.
//!
//! Colour is never alone: twelve colours go with six forms, the second six of
//! them with a rim. From agent 13 on the form is cut below, from 25 on above, from 37 on both;
//! agent 49 begins again, and its name tells it apart.

/// How many colours there are, each with its form.
pub const COLOURED: usize = 12;
/// How many looks there are.
pub const LOOKS: usize = 4 * COLOURED;

/// The cuts through forms of the same colour.
const CUTS: [Option<&str>; 4] = [
    None,
    Some("M-34 16.5H34"),
    Some("M-34-16.5H34"),
    Some("M-34 16.5H34M-34-16.5H34"),
];

/// The six forms around `(0, 0)`, within a radius of 27 units.
const SHAPES: [Shape; 6] = [
    Shape {
        body: "M-27 0a27 27 0 1 1 54 0a27 27 0 1 1-54 0Z",
        rim: "M-24.3 0a24.3 24.3 0 1 1 48.6 0a24.3 24.3 0 1 1-48.6 0Z",
        is_padded: false,
    },
    Shape {
        body: "M-15.1-23.2H15.1a8.1 8.1 0 0 1 8.1 8.1V15.1a8.1 8.1 0 0 1-8.1 8.1H-15.1a8.1 8.1 0 0 1-8.1-8.1V-15.1a8.1 8.1 0 0 1 8.1-8.1Z",
        rim: "M-13.6-20.9H13.6a7.3 7.3 0 0 1 7.3 7.3V13.6a7.3 7.3 0 0 1-7.3 7.3H-13.6a7.3 7.3 0 0 1-7.3-7.3V-13.6a7.3 7.3 0 0 1 7.3-7.3Z",
        is_padded: false,
    },
    Shape {
        body: "M0-29.2 29.2 0 0 29.2-29.2 0Z",
        rim: "M0-26.2 26.2 0 0 26.2-26.2 0Z",
        is_padded: true,
    },
    Shape {
        body: "M0-27 23.4-13.5V13.5L0 27-23.4 13.5V-13.5Z",
        rim: "M0-24.3 21-12.2V12.2L0 24.3-21 12.2V-12.2Z",
        is_padded: true,
    },
    Shape {
        body: "M-22.1-22.7H22.1V2.7Q22.1 19.4 0 28.1-22.1 19.4-22.1 2.7Z",
        rim: "M-19.9-20.4H19.9V2.4Q19.9 17.5 0 25.3-19.9 17.5-19.9 2.4Z",
        is_padded: true,
    },
    Shape {
        body: "M-13.5-13.5a13.5 13.5 0 0 1 27 0a13.5 13.5 0 0 1 0 27a13.5 13.5 0 0 1-27 0a13.5 13.5 0 0 1 0-27Z",
        rim: "M-12.15-12.15a12.15 12.15 0 0 1 24.3 0a12.15 12.15 0 0 1 0 24.3a12.15 12.15 0 0 1-24.3 0a12.15 12.15 0 0 1 0-24.3Z",
        is_padded: false,
    },
];

struct Shape {
    body: &'static str,
    rim: &'static str,
    is_padded: bool,
}

/// The form of an agent, to be drawn in its colour.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Form {
    /// The outline, as the `d` of an SVG path around `(0, 0)`.
    pub body: &'static str,
    /// Whether the outline is also stroked in its colour, which rounds its
    /// corners: 6.5 units wide.
    pub is_padded: bool,
    /// The rim within it, as the `d` of an SVG path.
    pub rim: Option<&'static str>,
    /// Lines across form and rim in the colour of the floor, as the `d` of an SVG path: 6.5 units
    /// wide.
    pub cut: Option<&'static str>,
}

/// The form of an agent, by its index in the scene.
///
/// ```
/// use giveway_picture::form;
/// assert_eq!(form::of(0).rim, None);
/// assert!(form::of(6).rim.is_some());
/// assert_eq!(form::of(0).body, form::of(12).body);
/// assert_ne!(form::of(0), form::of(12));
/// assert_eq!(form::of(0), form::of(48));
/// ```
pub fn of(agent: usize) -> Form {
    let look = agent % COLOURED;
    let shape = &SHAPES[look % SHAPES.len()];
    Form {
        body: shape.body,
        is_padded: shape.is_padded,
        rim: (look >= SHAPES.len()).then_some(shape.rim),
        cut: CUTS[agent / COLOURED % CUTS.len()],
    }
}

/// The class that sets an agent's colours, by its index in the scene: `ag-1` to
/// `ag-12`.
pub fn class(agent: usize) -> &'static str {
    const CLASSES: [&str; COLOURED] = [
        "ag-1", "ag-2", "ag-3", "ag-4", "ag-5", "ag-6", "ag-7", "ag-8", "ag-9", "ag-10", "ag-11",
        "ag-12",
    ];
    CLASSES[agent % COLOURED]
}

/// A name as it stands on a form, which has room for two letters, or three
/// small ones: of a longer name the first letter and the number, or what fits.
///
/// ```
/// use giveway_picture::form::short_name;
/// assert_eq!(short_name("A1"), "A1");
/// assert_eq!(short_name("A12"), "A12");
/// assert_eq!(short_name("robot 7"), "r7");
/// assert_eq!(short_name("a123"), "123");
/// assert_eq!(short_name("carrier"), "car");
/// ```
pub fn short_name(name: &str) -> String {
    const ROOM: usize = 3;
    if name.chars().count() <= ROOM {
        return name.to_owned();
    }
    let digits = name.chars().rev().take_while(char::is_ascii_digit).count();
    let number: String = name.chars().skip(name.chars().count() - digits).collect();
    match digits {
        0 => name.chars().take(ROOM).collect(),
        1 | 2 => name.chars().take(1).chain(number.chars()).collect(),
        _ => number.chars().skip(digits - ROOM).collect(),
    }
}

/// What stands on the forms of some agents: the short name of each where it can be drawn and
/// no other one has it too, else the agent's number, from 1.
///
/// ```
/// use giveway_picture::form::badges;
/// let all = |_: char| true;
/// assert_eq!(badges(&["A1", "robot 7"], all), ["A1", "r7"]);
/// assert_eq!(badges(&["carrier", "carton"], all), ["1", "2"]);
/// assert_eq!(badges(&["\u{8f66}1", "A1"], |c| c.is_ascii()), ["1", "A1"]);
/// assert_eq!(badges(&["\u{8f66}1", "1"], |c| c.is_ascii()), ["3", "1"]);
/// ```
pub fn badges(names: &[&str], is_drawn: impl Fn(char) -> bool) -> Vec<String> {
    unique(
        names.iter().map(|name| short_name(name)).collect(),
        is_drawn,
    )
}

/// What stands on small forms: names without the letters that all of them begin with, or what
/// stands on larger forms where they share none. No two agents have the same.
///
/// ```
/// use giveway_picture::form::numbers;
/// assert_eq!(numbers(&["A1", "A14", "A120"]), ["1", "14", "120"]);
/// assert_eq!(numbers(&["A10", "A11"]), ["10", "11"]);
/// assert_eq!(numbers(&["Forklift 1", "Forklift 2", "A1"]), ["F1", "F2", "A1"]);
/// assert_eq!(numbers(&["Anna", "Bertha"]), ["Ann", "Ber"]);
/// assert_eq!(numbers(&["carrier", "carton", "cat"]), ["1", "2", "cat"]);
/// ```
pub fn numbers(names: &[&str]) -> Vec<String> {
    const ROOM: usize = 3;
    let first = names.first().copied().unwrap_or_default();
    let is_shared = |end: usize| names.iter().all(|name| name.get(..end) == first.get(..end));
    let ends = first
        .char_indices()
        .map(|(at, letter)| at + letter.len_utf8());
    let shared = ends.take_while(|&end| is_shared(end)).last().unwrap_or(0);
    // The digits that all numbers begin with are part of them.
    let shared = first.get(..shared).unwrap_or_default();
    let shared = shared.trim_end_matches(|c: char| c.is_ascii_digit()).len();
    let rest = |name: &&str| name.get(shared..).unwrap_or_default().to_owned();
    let rests: Vec<String> = names.iter().map(rest).collect();
    let fits = |rest: &String| (1..=ROOM).contains(&rest.chars().count());
    if shared > 0 && rests.iter().all(fits) {
        return unique(rests, |_| true);
    }
    badges(names, |_| true)
}

/// Short names of agents: each where it can be drawn and no other agent has it too, else the
/// agent's number, from 1.
fn unique(mut badges: Vec<String>, is_drawn: impl Fn(char) -> bool) -> Vec<String> {
    let number = |agent: usize| short_name(&(agent + 1).to_string());
    let mut sorted = badges.clone();
    giveway_model::sorting::sort(&mut sorted);
    let is_shared = |badge: &String| {
        let first = sorted.partition_point(|other| other < badge);
        sorted.get(first + 1) == Some(badge)
    };
    let is_seen = |badge: &String| {
        let is_blank = badge.trim().is_empty() || badge.chars().any(char::is_control);
        !is_blank
            && badge
                .chars()
                .all(|letter| letter == ' ' || is_drawn(letter))
    };
    let numbered: Vec<bool> = badges
        .iter()
        .map(|badge| is_shared(badge) || !is_seen(badge))
        .collect();
    let all = badges.iter().zip(&numbered);
    let kept = all.filter_map(|(badge, &is_numbered)| (!is_numbered).then_some(badge));
    let kept = giveway_model::sorting::set(kept.cloned());
    // A number that is the name of another agent is left to that one.
    let mut further = badges.len();
    for (agent, badge) in badges.iter_mut().enumerate() {
        if numbered.get(agent) != Some(&true) {
            continue;
        }
        *badge = number(agent);
        while kept.contains(badge) {
            *badge = number(further);
            further += 1;
        }
    }
    badges
}

/// Whether a short name must be set smaller.
pub fn is_long(short_name: &str) -> bool {
    short_name.chars().count() > 2
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn as_many_agents_as_there_are_looks_look_different() {
        let look = |agent: usize| (of(agent), class(agent));
        for agent in 0..LOOKS {
            for other in 0..agent {
                assert_ne!(of(agent), of(other), "{agent} and {other}");
            }
        }
        assert_eq!(look(LOOKS), look(0));
    }

    #[test]
    fn a_name_that_is_cut_fits() {
        for name in ["", "é", "Ångström", "x0001", "漢字かな", "A1 of 30"] {
            assert!(short_name(name).chars().count() <= 3, "{name}");
        }
        assert_eq!(short_name("Ångström"), "Ång");
        assert_eq!(short_name("x0001"), "001");
        assert_eq!(short_name("A1 of 30"), "A30");
    }
}
