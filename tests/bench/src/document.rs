//! `docs/benchmarks.md`: the tables between two markers, the prose around them
//! as it is.

use std::error::Error;
use std::fs;
use std::path::Path;

const BEGIN: &str = "<!-- tables: written by `./x bench` -->";
const END: &str = "<!-- end of the tables -->";

/// Puts the tables into the document.
///
/// # Errors
/// Where the document is missing or has not both markers.
pub(crate) fn put(tables: &str) -> Result<(), Box<dyn Error>> {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs/benchmarks.md");
    let old = fs::read_to_string(&path)?;
    let Some(new) = replaced(&old, tables) else {
        return Err(format!("docs/benchmarks.md: expected the lines {BEGIN} and {END}").into());
    };
    fs::write(&path, new)?;
    Ok(())
}

fn replaced(text: &str, tables: &str) -> Option<String> {
    let (before, rest) = text.split_once(BEGIN)?;
    let (_, after) = rest.split_once(END)?;
    let tables = tables.trim();
    Some(format!("{before}{BEGIN}\n\n{tables}\n\n{END}{after}"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_what_is_between_the_markers_changes() {
        let text = format!("before\n{BEGIN}\nold\n{END}\nafter\n");
        let new = replaced(&text, "new\n").unwrap();
        assert_eq!(new, format!("before\n{BEGIN}\n\nnew\n\n{END}\nafter\n"));
        assert_eq!(replaced(&new, "new").unwrap(), new);
    }

    #[test]
    fn a_document_without_markers_is_left_alone() {
        assert_eq!(replaced("before\n", "new"), None);
    }
}
