//! `docs/benchmarks.md`: the tables between two markers, the prose around them
//! as it is.

use std::error::Error;
use std::fs;
use std::path::Path;

/// Where a part of the document begins and ends.
pub(crate) struct Marks {
    begin: &'static str,
    end: &'static str,
}

/// The tables of the solver's work.
pub(crate) const TABLES: Marks = Marks {
    begin: "<!-- tables: written by `./x bench` -->",
    end: "<!-- end of the tables -->",
};
/// The table of certificates.
pub(crate) const PROOFS: Marks = Marks {
    begin: "<!-- proofs: written by `./x bench --proofs` -->",
    end: "<!-- end of the proofs -->",
};
/// The table of answers to questions.
pub(crate) const QUESTIONS: Marks = Marks {
    begin: "<!-- questions: written by `./x bench --questions` -->",
    end: "<!-- end of the questions -->",
};

/// The table of agents that join others.
pub(crate) const CHANGES: Marks = Marks {
    begin: "<!-- changes: written by `./x bench --changes` -->",
    end: "<!-- end of the changes -->",
};

/// The table of crowds.
pub(crate) const CROWDS: Marks = Marks {
    begin: "<!-- crowds: written by `./x bench --crowds` -->",
    end: "<!-- end of the crowds -->",
};

/// The table of rules of a scene's own.
pub(crate) const RULES: Marks = Marks {
    begin: "<!-- rules: written by `./x bench --rules` -->",
    end: "<!-- end of the rules -->",
};

/// The table of bottlenecks.
pub(crate) const GATES: Marks = Marks {
    begin: "<!-- gates: written by `./x bench --gates` -->",
    end: "<!-- end of the gates -->",
};

/// The table of questions on warehouse floors.
pub(crate) const FLOOR: Marks = Marks {
    begin: "<!-- floor: written by `./x bench --floor` -->",
    end: "<!-- end of the floor -->",
};

/// Puts tables into the document.
///
/// # Errors
/// Where the document is missing or has not both markers.
pub(crate) fn put(marks: &Marks, tables: &str) -> Result<(), Box<dyn Error>> {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs/benchmarks.md");
    let old = fs::read_to_string(&path)?;
    let Some(new) = replaced(&old, marks, tables) else {
        let Marks { begin, end } = marks;
        return Err(format!("docs/benchmarks.md: expected the lines {begin} and {end}").into());
    };
    fs::write(&path, new)?;
    Ok(())
}

fn replaced(text: &str, marks: &Marks, tables: &str) -> Option<String> {
    let Marks { begin, end } = marks;
    let (before, rest) = text.split_once(begin)?;
    let (_, after) = rest.split_once(end)?;
    let tables = tables.trim();
    Some(format!("{before}{begin}\n\n{tables}\n\n{end}{after}"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_what_is_between_the_markers_changes() {
        for marks in [
            TABLES, PROOFS, QUESTIONS, CHANGES, CROWDS, RULES, GATES, FLOOR,
        ] {
            let Marks { begin, end } = marks;
            let text = format!("before\n{begin}\nold\n{end}\nafter\n");
            let new = replaced(&text, &marks, "new\n").unwrap();
            assert_eq!(new, format!("before\n{begin}\n\nnew\n\n{end}\nafter\n"));
            assert_eq!(replaced(&new, &marks, "new").unwrap(), new);
        }
    }

    #[test]
    fn a_document_without_markers_is_left_alone() {
        assert_eq!(replaced("before\n", &TABLES, "new"), None);
    }
}
