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
    /// Its scene, as a link writes it.
    pub scene: String,
}

/// Reads the list: of each example its title, the line and the scene, a line each.
///
/// # Errors
/// When the text is no such list, as a sentence.
///
/// ```
/// use giveway_page::examples::read;
/// let list = "A\nOne robot.\ngiveway=1&map=1.f&rules=0.0&costs=012&agents=\n";
/// let list = read(list).unwrap();
/// assert_eq!(list[0].title, "A");
/// assert_eq!(list[0].scene().unwrap().map, ["."]);
/// assert!(read("A\nOne robot.\n").is_err());
/// ```
pub fn read(text: &str) -> Result<Vec<Example>, String> {
    let lines: Vec<&str> = text.lines().collect();
    let (examples, rest) = lines.as_chunks();
    if !rest.is_empty() {
        return Err(tr!("its last example is not whole").to_owned());
    }
    let owned = |&[title, line, scene]: &[&str; 3]| Example {
        title: translated(title).to_owned(),
        line: translated(line).to_owned(),
        scene: scene.to_owned(),
    };
    Ok(examples.iter().map(owned).collect())
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
