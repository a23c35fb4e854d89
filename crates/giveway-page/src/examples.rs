//! The list of examples that comes with the page.

use serde::Deserialize;

/// An example.
#[derive(Clone, Debug, PartialEq, Eq, Deserialize)]
pub struct Example {
    /// Its file, beside the list.
    pub file: String,
    /// What it is called.
    pub title: String,
    /// What there is to see, in one line.
    pub line: String,
}

/// Reads the list.
///
/// # Errors
/// When the text is no such list, as a sentence.
///
/// ```
/// use giveway_page::examples::read;
/// let list = r#"[{"file": "a.json", "title": "A", "line": "One robot."}]"#;
/// assert_eq!(read(list).unwrap()[0].title, "A");
/// assert!(read("{}").is_err());
/// ```
pub fn read(text: &str) -> Result<Vec<Example>, String> {
    serde_json::from_str(text).map_err(|error| error.to_string())
}
