//! A sentence in pieces: the robots and cells that it names can be pressed.

use giveway_model::{Agent, Cell};

/// A piece of a sentence.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Piece {
    /// Plain text.
    Text(String),
    /// A robot, by its index in the plan that is asked about, with its name.
    Robot(usize, String),
    /// A cell.
    Cell(Cell),
}

/// A sentence cut at the robots and cells that it names. All pieces together are the sentence.
pub(super) fn pieces(sentence: &str, agents: &[Agent]) -> Vec<Piece> {
    let mut pieces = Vec::new();
    let mut text = String::new();
    let mut rest = sentence;
    let mut is_in_word = false;
    while let Some(first) = rest.chars().next() {
        let found = (!is_in_word)
            .then(|| robot(rest, agents).or_else(|| cell(rest)))
            .flatten();
        let Some((piece, after)) = found else {
            text.push(first);
            is_in_word = first.is_alphanumeric();
            rest = rest.get(first.len_utf8()..).unwrap_or_default();
            continue;
        };
        if !text.is_empty() {
            pieces.push(Piece::Text(std::mem::take(&mut text)));
        }
        pieces.push(piece);
        rest = after;
        is_in_word = false;
    }
    if !text.is_empty() {
        pieces.push(Piece::Text(text));
    }
    pieces
}

/// The robot with the longest name that a text begins with, and the text behind it. A name that
/// could be a word of the sentence does not count.
fn robot<'a>(text: &'a str, agents: &[Agent]) -> Option<(Piece, &'a str)> {
    let is_name = |name: &str| name.chars().any(|c| c.is_numeric() || c.is_uppercase());
    let begins = |agent: &Agent| {
        let after = text.strip_prefix(agent.name.as_str())?;
        let ends = !after.starts_with(char::is_alphanumeric);
        (ends && is_name(&agent.name)).then_some(after)
    };
    let found = agents.iter().enumerate();
    let found = found.filter_map(|(index, agent)| Some((index, agent, begins(agent)?)));
    let (index, agent, after) = found.max_by_key(|(_, agent, _)| agent.name.len())?;
    Some((Piece::Robot(index, agent.name.clone()), after))
}

/// The cell that a text begins with, as `(3, 1)`, and the text behind it.
fn cell(text: &str) -> Option<(Piece, &str)> {
    let (inside, after) = text.strip_prefix('(')?.split_once(')')?;
    let (x, y) = inside.split_once(", ")?;
    let (x, y) = (x.parse().ok()?, y.parse().ok()?);
    Some((Piece::Cell(Cell::new(x, y)), after))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn agents(names: &[&str]) -> Vec<Agent> {
        let scene = crate::sample::draft();
        let first = scene.agents().first().unwrap().clone();
        let named = |&name: &&str| Agent {
            name: name.to_owned(),
            ..first.clone()
        };
        names.iter().map(named).collect()
    }

    #[test]
    fn robots_and_cells_are_cut_out_and_nothing_is_lost() {
        let text = |text: &str| Piece::Text(text.to_owned());
        let robot = |index, name: &str| Piece::Robot(index, name.to_owned());
        let sentence = "If A1 goes first, A14 reaches (28, 5) late; A143 (soon) does not.";
        let found = pieces(sentence, &agents(&["A1", "A14", "soon"]));
        assert_eq!(
            found,
            [
                text("If "),
                robot(0, "A1"),
                text(" goes first, "),
                robot(1, "A14"),
                text(" reaches "),
                Piece::Cell(Cell::new(28, 5)),
                text(" late; A143 (soon) does not."),
            ]
        );
    }
}
