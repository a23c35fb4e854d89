//! How a rule names the robots that it binds.

use giveway_model::constraint::ConstraintKind;
use giveway_model::{Agent, tr};

/// What no sentence says.
const NOBODY: &str = "qcqc";

/// How the sentence of a kind names all robots, where it does so by a word of its own: `No robot in
/// zone 1`. The others count them: `At most 1 of all robots`.
pub(super) fn said_of_all(kind: &ConstraintKind) -> &'static str {
    match kind {
        ConstraintKind::Closed { .. } | ConstraintKind::NoWaiting { .. } => tr!("No robot"),
        ConstraintKind::Depart { .. }
        | ConstraintKind::Arrive { .. }
        | ConstraintKind::Visit { .. }
        | ConstraintKind::Turns { .. } => tr!("Each robot"),
        ConstraintKind::Late { .. } => tr!("each robot"),
        ConstraintKind::Apart { .. } => tr!("All robots"),
        ConstraintKind::Gap { .. } => tr!("a cell stays free behind" => "any robot"),
        ConstraintKind::Capacity { .. }
        | ConstraintKind::OneWay { .. }
        | ConstraintKind::Sequence { .. }
        | ConstraintKind::Before { .. }
        | ConstraintKind::Avoid { .. } => NOBODY,
    }
}

/// All robots, as they stand in the sentence of a kind.
pub(super) fn all_robots(kind: &ConstraintKind) -> &'static str {
    match kind {
        ConstraintKind::Apart { .. } => tr!("All robots"),
        ConstraintKind::OneWay { .. } => tr!("a rule is for" => "all robots"),
        ConstraintKind::Capacity { .. }
        | ConstraintKind::Closed { .. }
        | ConstraintKind::Gap { .. }
        | ConstraintKind::Sequence { .. }
        | ConstraintKind::Visit { .. }
        | ConstraintKind::Arrive { .. }
        | ConstraintKind::Late { .. }
        | ConstraintKind::Depart { .. }
        | ConstraintKind::Before { .. }
        | ConstraintKind::NoWaiting { .. }
        | ConstraintKind::Turns { .. }
        | ConstraintKind::Avoid { .. } => tr!("at most 1, each or none of" => "all robots"),
    }
}

/// Words in English with the names of robots in the place of `all robots but A1 and A2`: the page
/// says so, and a rule has names.
pub(crate) fn with_names(words: &str, agents: &[Agent]) -> Option<String> {
    let at = words.to_lowercase().find(ALL_BUT)?;
    let mut rest = words.get(at + ALL_BUT.len()..)?;
    let mut left_out = Vec::new();
    loop {
        // Of A1 and A11 the longer one is meant, where it stands there.
        let begins = agents.iter().filter(|agent| rest.starts_with(&agent.name));
        let agent = begins.max_by_key(|agent| agent.name.len())?;
        left_out.push(&agent.name);
        rest = rest.get(agent.name.len()..)?;
        match [", ", " and "].iter().find_map(|it| rest.strip_prefix(it)) {
            Some(more) if agents.iter().any(|agent| more.starts_with(&agent.name)) => rest = more,
            Some(_) | None => break,
        }
    }
    let bound = agents.iter().map(|agent| &agent.name);
    let bound: Vec<&String> = bound.filter(|name| !left_out.contains(name)).collect();
    let (names, begin) = (english_list(&bound), words.get(..at)?);
    (!bound.is_empty()).then(|| format!("{begin}{names}{rest}"))
}

/// What the words of [`with_names`] begin with.
const ALL_BUT: &str = "all robots but ";

/// Names as the words of rules have them.
fn english_list(names: &[&String]) -> String {
    let all: Vec<&str> = names.iter().map(|name| name.as_str()).collect();
    match all.split_last() {
        Some((last, init)) if !init.is_empty() => format!("{} and {last}", init.join(", ")),
        Some(_) | None => all.concat(),
    }
}

#[cfg(test)]
mod tests {
    use giveway_model::Cell;

    use super::*;

    #[test]
    fn the_others_are_named() {
        let names = ["A1", "A11", "A2", "and co"];
        let agents = names.map(|name| Agent::new(name, Cell::new(0, 0), None));
        let named = |words: &str| with_names(words, &agents);
        for (words, expected) in [
            (
                "All robots but A1 keep 2 apart",
                "A11, A2 and and co keep 2 apart",
            ),
            (
                "at most 1 of all robots but A11 and A1 in x",
                "at most 1 of A2 and and co in x",
            ),
            (
                "all robots but A1, A11 and and co keep 2 apart",
                "A2 keep 2 apart",
            ),
        ] {
            assert_eq!(named(words).as_deref(), Some(expected));
        }
        for words in [
            "all robots keep 2 apart",
            "all robots but B1 keep 2 apart",
            "all robots but A1, A11, A2 and and co keep 2 apart",
            "all robots but ",
        ] {
            assert_eq!(named(words), None, "{words}");
        }
    }
}
