//! Fields of the form, as their data says, with what is wrong beside each.

use giveway_course::author::{
    Action, Field, FormFault, Input, Pick, Whose, Words, field_of, sentence,
};
use web_sys::{HtmlInputElement, HtmlSelectElement, HtmlTextAreaElement};
use yew::prelude::*;

/// What fields need to be shown.
pub(super) struct Form<'a> {
    /// Whose they are.
    pub(super) whose: Whose,
    /// What is written.
    pub(super) words: &'a Words,
    /// All fields of the form, whether they are shown here or not.
    pub(super) fields: &'a [Field],
    /// What is wrong with the lesson as a whole, or with the step.
    pub(super) faults: &'a [FormFault],
    /// Whether what is missing is told, too.
    pub(super) is_strict: bool,
    /// Takes what is written.
    pub(super) send: &'a Callback<Action>,
}

impl Form<'_> {
    /// A field with its label, and what is wrong with it.
    pub(super) fn show(&self, field: &Field) -> Html {
        let id = self::id(self.whose, &field.name);
        let wrong = format!("{id}-wrong");
        let said = self.said(field);
        let describes = (!said.is_empty()).then(|| wrong.clone());
        let said = html! {
            if !said.is_empty() {
                <span class="wrong" id={wrong}>{ for said.iter().map(|said| html! { <span>{ said.clone() }</span> }) }</span>
            }
        };
        if let Input::Many(_) = field.input {
            return html! {
                <fieldset {id} class="af many" tabindex="-1" aria-describedby={describes}>
                    <legend>{ field.label }</legend>
                    <div class="chips">{ for field.picks(self.words).into_iter().map(|pick| self.chip(field, pick)) }</div>
                    { said }
                </fieldset>
            };
        }
        if field.input == Input::Switch {
            let on = field.is_on(self.words);
            let onchange = self
                .written(field)
                .reform(move |_: Event| Field::switched(!on).to_owned());
            return html! {
                <>
                    <label class="switch af"><input {id} type="checkbox" checked={on} aria-describedby={describes} {onchange} /><i></i><span>{ field.label }</span></label>
                    { said }
                </>
            };
        }
        html! {
            <div class={classes!("af", matches!(field.input, Input::Number).then_some("short"))}>
                <label for={id.clone()}>{ field.label }</label>
                { self.input(field, id, describes) }
                { said }
            </div>
        }
    }

    fn input(&self, field: &Field, id: String, describes: Option<String>) -> Html {
        let value = field.value(self.words).to_owned();
        let written = self.written(field);
        let wrong = describes.is_some().then_some("true");
        match &field.input {
            Input::Area => {
                let oninput = written.reform(|event: InputEvent| {
                    let area: HtmlTextAreaElement = event.target_unchecked_into();
                    area.value()
                });
                let rows = if field.name == "text" { "8" } else { "3" };
                html! {
                    <textarea {id} class="field area" {rows} {value} aria-describedby={describes} aria-invalid={wrong} {oninput} />
                }
            }
            Input::One(_) => {
                let onchange = written.reform(|event: Event| {
                    let select: HtmlSelectElement = event.target_unchecked_into();
                    select.value()
                });
                let option = |pick: Pick| {
                    let selected = pick.value == value;
                    html! { <option value={pick.value} {selected}>{ pick.label }</option> }
                };
                html! {
                    <select {id} class="field" aria-describedby={describes} aria-invalid={wrong} {onchange}>
                        { for field.picks(self.words).into_iter().map(option) }
                    </select>
                }
            }
            Input::Line | Input::Number | Input::Switch | Input::Many(_) => {
                let oninput = written.reform(|event: InputEvent| {
                    let input: HtmlInputElement = event.target_unchecked_into();
                    input.value()
                });
                let mode = (field.input == Input::Number).then_some("numeric");
                // The editor opens with the focus there, and not on what opens a file.
                let first = self.whose == Whose::Lesson && field.name == "title";
                html! {
                    <input {id} class="field" type="text" inputmode={mode} autocomplete="off" {value}
                        autofocus={first} aria-describedby={describes} aria-invalid={wrong} {oninput} />
                }
            }
        }
    }

    fn chip(&self, field: &Field, pick: Pick) -> Html {
        let on = field.has(self.words, &pick.value);
        let (name, value) = (field.name.clone(), pick.value);
        let onclick = self.send.reform(move |_: MouseEvent| Action::Toggle {
            field: name.clone(),
            value: value.clone(),
        });
        html! {
            <button type="button" class={classes!("btn", "chip", on.then_some("on"))} aria-pressed={on.to_string()} {onclick}>{ pick.label }</button>
        }
    }

    fn written(&self, field: &Field) -> Callback<String> {
        let (whose, name) = (self.whose, field.name.clone());
        self.send.reform(move |text: String| Action::Write {
            whose,
            field: name.clone(),
            text,
        })
    }

    /// What is wrong with a field, in sentences.
    fn said(&self, field: &Field) -> Vec<String> {
        let own = self.faults.iter().filter(|fault| {
            field_of(self.fields, &fault.place).is_some_and(|closest| closest.name == field.name)
        });
        let told = own.filter(|fault| self.is_strict || !fault.is_missing());
        let mut told: Vec<String> = told
            .map(|fault| sentence(&fault.wrong, Some(field)))
            .collect();
        told.dedup();
        told.truncate(3);
        told
    }
}

/// The id of a field.
pub(super) fn id(whose: Whose, name: &str) -> String {
    let whose = match whose {
        Whose::Lesson => "lesson",
        Whose::Step => "step",
    };
    format!("{whose}-{name}")
}

/// What is wrong with the task or the board and belongs to no field.
pub(super) fn rest(fields: &[Field], faults: &[FormFault], of_task: bool) -> Html {
    let rest = faults.iter().filter(|fault| {
        let place = &fault.place;
        place.field.starts_with("task") == of_task && field_of(fields, place).is_none()
    });
    let rest: Vec<String> = rest
        .map(|fault| sentence(&fault.wrong, None))
        .take(4)
        .collect();
    if rest.is_empty() {
        return html! {};
    }
    html! { <span class="wrong">{ for rest.into_iter().map(|said| html! { <span>{ said }</span> }) }</span> }
}
