//! The examples that come with the page, with their scenes as links write them: the
//! page need not read JSON for them. A test writes the list from `static/examples/`.

use giveway_model::words::translated;
use giveway_model::{Scene, tr};

use crate::Notice;
use crate::link::{self, From};

/// An example.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Example {
    /// What it is called.
    pub title: String,
    /// What there is to see, in one line.
    pub line: String,
    /// The heading of its group; empty before the first one.
    pub group: String,
    /// Its scene, as a link writes it.
    pub scene: String,
}

/// What a line begins with that is the heading of the examples after it.
const HEADING: &str = "# ";

/// Reads the list: of each example its title, the line and the scene, a line each, and
/// headings of groups.
///
/// # Errors
/// When the text is no such list, as a sentence.
///
/// ```
/// use giveway_page::examples::read;
/// let list = "# Small\nA\nOne robot.\ngiveway=1&map=1.f&rules=0.0&costs=012&agents=\n";
/// let list = read(list).unwrap();
/// assert_eq!((&*list[0].title, &*list[0].group), ("A", "Small"));
/// assert_eq!(list[0].scene().unwrap().map, ["."]);
/// assert!(read("A\nOne robot.\n").is_err());
/// ```
pub fn read(text: &str) -> Result<Vec<Example>, String> {
    let mut lines = text.lines();
    let mut examples = Vec::new();
    let mut group = String::new();
    while let Some(title) = lines.next() {
        if let Some(heading) = title.strip_prefix(HEADING) {
            translated(heading).clone_into(&mut group);
            continue;
        }
        let (Some(line), Some(scene)) = (lines.next(), lines.next()) else {
            return Err(tr!("its last example is not whole").to_owned());
        };
        examples.push(Example {
            title: translated(title).to_owned(),
            line: translated(line).to_owned(),
            group: group.clone(),
            scene: scene.to_owned(),
        });
    }
    Ok(examples)
}

impl Example {
    /// Its scene.
    ///
    /// # Errors
    /// Why there is none.
    pub fn scene(&self) -> Result<Scene, Notice> {
        let linked = link::read(&self.scene, From::Anywhere)?;
        Ok(linked.document.draft.scene().clone())
    }
}
