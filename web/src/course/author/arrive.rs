//! Lessons that come from elsewhere: as a file, pasted, or in a link.

use std::rc::Rc;

use giveway_course::grade::Came;
use giveway_course::lesson::{Glossary, Lesson, link, read_lesson};
use giveway_model::Fault;
use yew::prelude::*;

use super::super::class::ClassMsg;
use super::super::tutor::Tutor;
use super::AuthorMsg;

/// The address of the editor.
const WRITE: &str = "~write";

/// Reads the text of a file.
pub(super) fn from_file(text: &str, glossary: &Glossary) -> Result<Lesson, Vec<Fault>> {
    read_lesson(text, glossary)
}

/// Whether an address is no place of the course: the editor, a file or a link.
pub(in crate::course) fn is_own(address: &str) -> bool {
    let text = address.trim_start_matches('\u{feff}').trim_start();
    text.starts_with([link::MARK, '{'])
}

impl Tutor {
    /// Opens the editor, or a lesson that is whole in the address itself; as soon as
    /// the glossary is there, against which it is read.
    pub(in crate::course) fn arrive(&mut self, ctx: &Context<Self>, address: String) {
        let Some(shelf) = self.shelf.clone() else {
            self.author.arriving = Some(address);
            return;
        };
        if self.is_class_open() && !address.starts_with(link::MARK) && address != WRITE {
            // Hand-ins are judged against it.
            let came = Came::file(String::new(), 0.0, address);
            return self.collect(ctx, ClassMsg::Came(vec![came]));
        }
        if self.author.is_open && !address.starts_with(link::MARK) {
            // Whoever writes a lesson goes on with that of the file; there is a way back.
            return self.author(ctx, AuthorMsg::File(address));
        }
        self.author.leave();
        self.close_contents();
        let read = match address.as_str() {
            WRITE => return self.author(ctx, AuthorMsg::Open),
            letters if letters.starts_with(link::MARK) => link::read(letters, &shelf.glossary),
            text => from_file(text, &shelf.glossary).map(|lesson| (lesson, None)),
        };
        match read {
            Ok((lesson, at)) => {
                self.open_own(ctx, Rc::new(lesson), at);
            }
            Err(faults) => self.author.refuse(faults),
        }
    }

    /// Opens what came before the glossary was there.
    pub(in crate::course) fn arrive_late(&mut self, ctx: &Context<Self>) {
        if let Some(address) = self.author.arriving.take() {
            self.arrive(ctx, address);
        }
    }
}
