//! The scene and its plan in the formats of other makers, and a report of an audit.
//! What a format cannot hold is said before anything is saved.

use giveway_formats::Format;
use giveway_model::words::Later;
use giveway_model::{tr, tr_later};
use giveway_page::intake::Written;
use giveway_page::intake::protocol::ReportKind;
use giveway_page::{Action, IntakeAction, Save};
use gloo::file::Blob;
use yew::prelude::*;

use super::frame::Frame;
use crate::{Shown, files, icon, keep};

#[derive(Clone, PartialEq, Properties)]
pub(crate) struct SaveAsProps {
    /// The state: what was written last is in it.
    pub(crate) state: Shown,
    /// Takes actions.
    pub(crate) send: Callback<Action>,
    /// Called when it was closed.
    pub(crate) on_close: Callback<()>,
}

/// What is chosen.
#[derive(Clone, Copy)]
enum Choice {
    Format(Format),
    Report(ReportKind),
}

const REPORTS: [(ReportKind, Later, Later); 3] = [
    (
        ReportKind::Html,
        tr_later!("a format" => "Page"),
        tr_later!("HTML, for a browser"),
    ),
    (
        ReportKind::Markdown,
        tr_later!("Markdown"),
        tr_later!("For an issue or a wiki"),
    ),
    (
        ReportKind::Json,
        tr_later!("JSON"),
        tr_later!("For programs"),
    ),
];

/// The formats, then what was written.
#[component]
pub(crate) fn SaveAs(props: &SaveAsProps) -> Html {
    let SaveAsProps {
        state,
        send,
        on_close,
    } = props;
    let close = {
        let send = send.clone();
        on_close.reform(move |()| send.emit(Action::Intake(IntakeAction::Saved)))
    };
    let choice = |what: Choice, name: &str, detail: &str| {
        let state = state.clone();
        let press = send.reform(move |_: MouseEvent| {
            Action::Intake(IntakeAction::Save(match what {
                Choice::Format(format) => Save::As(format),
                Choice::Report(kind) => Save::Report(kind, keep::address(&state)),
            }))
        });
        html! {
            <li><button type="button" class="way" onclick={press}>{ name.to_owned() }<small>{ detail.to_owned() }</small></button></li>
        }
    };
    let report = |&(kind, name, detail): &(ReportKind, Later, Later)| {
        choice(Choice::Report(kind), name.text(), detail.text())
    };
    let formats = Format::ALL.into_iter();
    let formats = formats.filter(|format| *format != Format::Giveway);
    let format = |format: Format| {
        let detail = tr!("as {makers}", makers = format.makers());
        choice(Choice::Format(format), format.looks(), &detail)
    };
    html! {
        <Frame title={tr!("Save as")} narrow=true on_close={close.clone()}>
            <div class="audit" aria-live="polite">
                if let Some(written) = &state.intake.written {
                    { outcome(written, &close, send) }
                } else {
                    if state.audit().is_some() {
                        <section><h3>{ tr!("Report") }</h3><ul class="ways">{ for REPORTS.iter().map(report) }</ul></section>
                    }
                    <section><h3>{ tr!("Formats") }</h3><ul class="ways">{ for formats.map(format) }</ul></section>
                }
            </div>
        </Frame>
    }
}

/// What is lost, and the button that saves.
fn outcome(written: &Written, close: &Callback<()>, send: &Callback<Action>) -> Html {
    let files = written.files.clone();
    let names: Vec<&str> = files.iter().map(|(name, _)| name.as_str()).collect();
    let names = names.join(", ");
    let save = {
        let close = close.clone();
        move |_: MouseEvent| {
            for (name, text) in &files {
                files::save_as(name, Blob::new(text.as_str()));
            }
            close.emit(());
        }
    };
    let head = if written.files.is_empty() {
        tr!("This cannot be written so:")
    } else if written.losses.is_empty() {
        tr!("Nothing is lost.")
    } else {
        tr!("These files do not hold:")
    };
    html! {
        <section>
            <p><b>{ names }</b></p>
            <p>{ head }</p>
            <ul class="losses">{ for written.losses.iter().map(|loss| html! { <li>{ loss.clone() }</li> }) }</ul>
            <div class="dialog-foot">
                <button type="button" class="btn outline" onclick={send.reform(|_| Action::Intake(IntakeAction::Saved))}>{ tr!("Another format") }</button>
                if !written.files.is_empty() {
                    <button type="button" class="btn primary" onclick={save}>{ icon::show("save") }{ tr!("Save") }</button>
                }
            </div>
        </section>
    }
}
