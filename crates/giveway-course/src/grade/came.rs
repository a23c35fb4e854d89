//! Files and links as a page gets them, before they are read.

use giveway_model::tr;

use crate::handin::link;

/// A file, a text or a link that came.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Came {
    /// Its name; a link has none.
    pub name: Option<String>,
    /// When it was changed last, in seconds since 1970; what was pasted has none.
    pub date: Option<u64>,
    /// What is in it.
    pub text: String,
}

impl Came {
    /// Whether a text holds hand-ins by a look at it: files as a list, a file, or links.
    pub fn is_in(text: &str) -> bool {
        text.starts_with('[') || text.contains(link::KEY) || has_key(text)
    }

    /// What a text holds: files as a JSON list of name, milliseconds since 1970 and text; one
    /// file; or links, one a line. Nothing where it holds no such.
    ///
    /// ```
    /// use giveway_course::grade::Came;
    /// let files = Came::all(r#"[["a.json", 2000, "{}"]]"#);
    /// assert_eq!((files[0].name.as_deref(), files[0].date), (Some("a.json"), Some(2)));
    /// assert_eq!(Came::all("https://a.org/#hand-in=~A\nhttps://a.org/#hand-in=~B").len(), 2);
    /// assert!(Came::all("nothing").is_empty());
    /// ```
    pub fn all(text: &str) -> Vec<Self> {
        if text.starts_with('[') {
            let list: Vec<(String, f64, String)> = serde_json::from_str(text).unwrap_or_default();
            let file = |(name, time, text)| Self::file(name, time, text);
            return list.into_iter().map(file).collect();
        }
        if has_key(text) {
            return vec![Self {
                name: Some(tr!("Pasted text").to_owned()),
                date: None,
                text: text.to_owned(),
            }];
        }
        let lines = text.lines().filter(|line| line.contains(link::KEY));
        let link = |line: &str| Self {
            name: None,
            date: None,
            text: line.to_owned(),
        };
        lines.map(link).collect()
    }

    /// A file by its name, the milliseconds from 1970 to its last change, and its text.
    pub fn file(name: String, time: f64, text: String) -> Self {
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "a conversion of floats saturates, and no file is of before 1970"
        )]
        let date = (time / 1_000.0) as u64;
        Self {
            name: Some(name),
            date: Some(date),
            text,
        }
    }

    /// Whether it is a lesson by a look at it.
    pub fn is_lesson(&self) -> bool {
        self.text.contains("\"steps\"") && !has_key(&self.text)
    }
}

fn has_key(text: &str) -> bool {
    text.contains("\"hand-in\":")
}
