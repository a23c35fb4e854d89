//! The foot of the table: how far the judging is, and what is done with the table.

use giveway_course::grade::Came;
use giveway_model::tr;
use gloo::file::File;
use gloo::file::futures::read_as_bytes;
use web_sys::HtmlInputElement;
use yew::platform::spawn_local;
use yew::prelude::*;

use super::arrive::chosen;
use super::{ClassMsg, Collected};
use crate::course::card::bar;
use crate::course::sight::once;
use crate::course::tutor::Msg;
use crate::icon;

impl Collected {
    pub(super) fn foot(&self, send: &Callback<Msg>) -> Html {
        let press = |msg: ClassMsg| once(send, move || Msg::Class(msg.clone()));
        let progress = self.class.progress();
        let is_judging = self.asked.is_some() || self.pause.is_some();
        let has_files = !self.class.files().is_empty();
        let is_open = self.class.is_cancelled() || self.undecided() > 0;
        let choose = send.reform(|files: Vec<Came>| Msg::Class(ClassMsg::Came(files)));
        let onchange = move |event: Event| read_chosen(&event.target_unchecked_into(), &choose);
        html! {
            <footer class="sf">
                <span class="prog" role="status">
                    if has_files { { self.standing(progress.done, progress.all, is_judging) } }
                </span>
                if is_judging && progress.all > 0 {
                    <span class="pb-at">{ bar(progress.done as u64, progress.all as u64) }</span>
                }
                if is_judging {
                    <button type="button" class="btn outline" onclick={press(ClassMsg::Cancel)}>{ icon::show("cancel") }<span>{ tr!("Cancel") }</span></button>
                } else if is_open {
                    <button type="button" class="btn outline" onclick={press(ClassMsg::GoOn)}>{ icon::show("play") }<span>{ tr!("Go on") }</span></button>
                }
                <span class="grow"></span>
                if has_files {
                    <button type="button" class="btn ghost" onclick={press(ClassMsg::Forget)}><span>{ tr!("Forget them") }</span></button>
                    <button type="button" class="btn outline" onclick={press(ClassMsg::Copy)}>{ icon::show("copy") }<span>{ tr!("Copy table") }</span></button>
                    <button type="button" class="btn primary" onclick={press(ClassMsg::Save)}>{ icon::show("save") }<span>{ tr!("Save as CSV") }</span></button>
                }
                <label class={classes!("btn", if has_files { "outline" } else { "primary" })}>
                    { icon::show("open") }<span>{ tr!("Choose files") }</span>
                    <input type="file" multiple=true class="vh" {onchange} />
                </label>
            </footer>
        }
    }

    fn undecided(&self) -> usize {
        let shares = self.class.shares(self.looking.lesson);
        shares.iter().map(|share| share.undecided).sum()
    }

    /// Those of the lesson whose table is shown.
    fn false_claims(&self) -> usize {
        let shares = self.class.shares(self.looking.lesson);
        shares.iter().map(|share| share.false_claims).sum()
    }

    /// How far the judging is, and what became of the table.
    fn standing(&self, done: usize, all: usize, is_judging: bool) -> String {
        if is_judging {
            // Read aloud every ten, not at each.
            return tr!("Judging: {done} of {all}", done = done / 10 * 10, all);
        }
        if !self.told.is_empty() {
            return self.told.clone();
        }
        if all == 0 {
            // Nothing is judged before its lesson is there.
            return String::new();
        }
        if self.class.is_cancelled() {
            return tr!("Stopped: {done} of {all} judged.", done, all);
        }
        match (self.false_claims(), self.undecided()) {
            (0, 0) => tr!("All judged.").to_owned(),
            (0, n) => tr!("{n} task is not decided." | "{n} tasks are not decided." % n),
            (n, _) => tr!("{n} task is said to be solved, and is not."
                | "{n} tasks are said to be solved, and are not." % n),
        }
    }
}

/// Reads the files that were chosen.
fn read_chosen(input: &HtmlInputElement, send: &Callback<Vec<Came>>) {
    let Some(files) = input.files() else {
        return;
    };
    let files: Vec<File> = gloo::file::FileList::from(files).to_vec();
    // The same files can be chosen again.
    input.set_value("");
    let send = send.clone();
    spawn_local(async move {
        let mut came = Vec::new();
        for file in files {
            if let Ok(bytes) = read_as_bytes(&file).await {
                came.push(chosen(&file, &bytes));
            }
        }
        send.emit(came);
    });
}
