//! A draft as a text that the browser keeps, distrusted when it is read back.

use giveway_model::{Fault, format::native, tr};

use super::{Draft, MAX_FIELD};
use crate::lesson::read::{MAX_BYTES, MAX_STEPS};

impl Draft {
    /// The text that is kept.
    pub fn write(&self) -> String {
        // Texts, numbers and lists of them always have a JSON form.
        serde_json::to_string(self).unwrap_or_default()
    }

    /// Reads a text that was kept.
    ///
    /// # Errors
    /// Where it is no such text, or longer than one can be.
    pub fn read(text: &str) -> Result<Self, Fault> {
        let most = MAX_BYTES * 4;
        if text.len() > most {
            let found = tr!("{n} bytes", n = text.len());
            return Err(Fault::at("", found, tr!("at most {most}", most)));
        }
        let mut draft: Self = native::read_object(text)?;
        let count = draft.steps.len();
        if count > MAX_STEPS {
            let found = tr!("{count} steps", count);
            return Err(Fault::at(
                "steps",
                found,
                tr!("at most {most}", most = MAX_STEPS),
            ));
        }
        let steps = draft.steps.iter_mut().map(|step| &mut step.words);
        for words in steps.chain([&mut draft.words]) {
            words.retain(|name, word| name.len() < 200 && word.len() <= 4 * MAX_FIELD);
        }
        draft.mend();
        Ok(draft)
    }
}
