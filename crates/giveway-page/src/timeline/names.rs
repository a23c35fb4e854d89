//! Names of robots in narrow columns: no two robots have the same.

use giveway_model::words::middle_cut;
use giveway_model::{Agent, sorting};
use giveway_picture::form::badges;

/// The most letters of a name in a narrow column.
const MOST: usize = 14;

/// A name in a narrow column.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct ShownName {
    /// All of it, or of a long one the beginning and the end.
    pub cut: String,
    /// What stands on the robot's form on the board, where no more has room.
    pub short: String,
}

/// The names of some robots; those of all robots of the scene tell which of them can be mixed up.
pub fn shown_names<'a>(names: &[&'a str], agents: &'a [Agent]) -> Vec<ShownName> {
    let mut all: Vec<&'a str> = agents.iter().map(|agent| agent.name.as_str()).collect();
    // Robots of a changed world need not be in the scene.
    let place = |&name: &&'a str| {
        let known = all.iter().position(|&other| other == name);
        known.unwrap_or_else(|| {
            all.push(name);
            all.len() - 1
        })
    };
    let places: Vec<usize> = names.iter().map(place).collect();
    let short = badges(&all, |_| true);
    let cut: Vec<String> = all.iter().map(|name| middle_cut(name, MOST)).collect();
    let mut sorted = cut.clone();
    sorting::sort(&mut sorted);
    let is_shared = |cut: &String| {
        let first = sorted.partition_point(|other| other < cut);
        sorted.get(first + 1) == Some(cut)
    };
    let shown = |&place: &usize| {
        let (cut, short) = cut.get(place).zip(short.get(place))?;
        Some(ShownName {
            cut: if is_shared(cut) { short } else { cut }.clone(),
            short: short.clone(),
        })
    };
    places.iter().filter_map(shown).collect()
}

#[cfg(test)]
mod tests {
    use giveway_model::Cell;

    use super::*;

    fn agents(names: &[&str]) -> Vec<Agent> {
        let agent = |name: &&str| Agent::new(*name, Cell::new(0, 0), None);
        names.iter().map(agent).collect()
    }

    #[test]
    fn a_short_name_is_the_one_on_the_board() {
        let names = ["Forklift 1", "Forklift 2", "A1"];
        let agents = agents(&names);
        let shown = shown_names(&["Forklift 2", "A1", "Forklift 1"], &agents);
        let short: Vec<&str> = shown.iter().map(|name| name.short.as_str()).collect();
        assert_eq!(short, ["F2", "A1", "F1"]);
        assert_eq!(shown[0].cut, "Forklift 2");
        assert_eq!(
            badges(&names, |_| true),
            giveway_picture::form::numbers(&names)
        );
    }

    #[test]
    fn no_two_robots_have_the_same() {
        let names = [
            "Transporter_hall_1_East_01",
            "Transporter_hall_2_East_01",
            "Transporter_hall_2_East_02",
            "carrier",
            "carton",
        ];
        let agents = agents(&names);
        // One that came later is not in the scene.
        let asked = [&names[..], &["carbon"]].concat();
        let shown = shown_names(&asked, &agents);
        assert_eq!(shown.len(), asked.len());
        for (index, one) in shown.iter().enumerate() {
            for other in &shown[..index] {
                assert!(
                    one.cut != other.cut && one.short != other.short,
                    "{shown:?}"
                );
            }
        }
        assert_eq!(shown[2].cut, "Transp\u{2026}East_02");
    }
}
