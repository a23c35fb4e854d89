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

#[cfg(test)]
mod tests {
    use std::fs;
    use std::path::Path;

    use giveway_model::format::native;

    use super::*;
    use crate::Draft;

    /// The page's examples are listed, can be read, and fit the page.
    #[test]
    fn every_example_can_be_opened() {
        let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../static/examples");
        let text = |name: &str| fs::read_to_string(folder.join(name)).unwrap();
        let examples = read(&text("index.json")).unwrap();
        assert!(examples.len() > 3);
        for example in &examples {
            let instance = native::read_instance(&text(&example.file)).unwrap();
            assert!(Draft::new(instance.to_scene()).is_ok(), "{}", example.file);
            assert!(!example.title.is_empty() && example.line.ends_with('.'));
        }
        let files = fs::read_dir(&folder).unwrap();
        let scenes = files.filter(|file| {
            let name = file.as_ref().unwrap().file_name();
            let name = name.to_string_lossy().into_owned();
            name.rsplit('.').next() == Some("json") && name != "index.json"
        });
        assert_eq!(scenes.count(), examples.len(), "each is listed");
    }
}
