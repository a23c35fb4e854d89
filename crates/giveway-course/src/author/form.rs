//! Which fields there are: of a lesson, and of a step by what is written in it.

use giveway_model::{Scene, tr};

use super::field::Shape;
use super::{ANSWERS, Field, Input, KIND, PLAN, Part, StepDraft, Words, choices, tasks};

/// The fields of the lesson as a whole.
pub fn head() -> Vec<Field> {
    let field = |name: &str, label, input, shape, must| Field {
        name: name.to_owned(),
        label,
        part: Part::Text,
        input,
        must,
        shape,
    };
    vec![
        field("title", tr!("Title"), Input::Line, Shape::Word, true),
        field(
            "minutes",
            tr!("Minutes"),
            Input::Number,
            Shape::Number,
            true,
        ),
        field(
            "about",
            tr!("What it is about, in one sentence"),
            Input::Line,
            Shape::Text,
            true,
        ),
        field(
            "hides-answers",
            tr!("Hide the hints and the answers"),
            Input::Switch,
            Shape::Flag,
            false,
        ),
    ]
}

/// The fields of a step, with the scene on its board, by what is written in it.
pub fn form(step: &StepDraft, scene: Option<&Scene>) -> Vec<Field> {
    let mut form = Form {
        words: &step.words,
        scene,
        part: Part::Text,
        fields: Vec::new(),
    };
    form.line("title", tr!("Title of the step"), Shape::Word, true);
    form.add("text", tr!("Text"), Input::Area, Shape::Paragraphs, true);
    form.part = Part::Board;
    let plans = choices::plans(step.plan.is_some());
    form.add(PLAN, tr!("Plan"), Input::One(plans), Shape::None, true);
    form.number("time", tr!("Time shown first"), false);
    form.add(
        "playing",
        tr!("It plays at once"),
        Input::Switch,
        Shape::Flag,
        false,
    );
    let layers = Input::Many(choices::layers());
    form.add("show", tr!("Beside the map"), layers, Shape::Words, false);
    form.part = Part::Tools;
    let tools = Input::Many(choices::tools());
    form.add("tools", tr!("Tools"), tools, Shape::Words, false);
    if !step.word("tools").is_empty() {
        form.number("edits", tr!("The most edits"), false);
        form.line(
            "cells",
            tr!("Only these cells may be changed"),
            Shape::Cells,
            false,
        );
    }
    form.part = Part::Task;
    form.one(KIND, tr!("What there is to do"), choices::kinds());
    let kind = step.word(KIND);
    if kind.is_empty() {
        return form.fields;
    }
    form.line("task.say", tr!("What it asks"), Shape::Text, true);
    tasks::task(&mut form, kind, step.answers());
    form.part = Part::Help;
    let labels = [
        tr!("First hint"),
        tr!("Second hint"),
        tr!("Last hint: the answer"),
    ];
    for (index, label) in labels.into_iter().enumerate() {
        form.line(&format!("hints[{index}]"), label, Shape::Text, false);
    }
    form.add(
        "reason",
        tr!("Said once it is solved: why it is so"),
        Input::Area,
        Shape::Text,
        true,
    );
    form.fields
}

/// The form of a step while it is made.
pub(super) struct Form<'a> {
    pub(super) words: &'a Words,
    pub(super) scene: Option<&'a Scene>,
    pub(super) part: Part,
    fields: Vec<Field>,
}

impl Form<'_> {
    pub(super) fn add(
        &mut self,
        name: &str,
        label: &'static str,
        input: Input,
        shape: Shape,
        must: bool,
    ) {
        let (name, part) = (name.to_owned(), self.part);
        self.fields.push(Field {
            name,
            label,
            part,
            input,
            must,
            shape,
        });
    }

    pub(super) fn line(&mut self, name: &str, label: &'static str, shape: Shape, must: bool) {
        self.add(name, label, Input::Line, shape, must);
    }

    pub(super) fn number(&mut self, name: &str, label: &'static str, must: bool) {
        self.add(name, label, Input::Number, Shape::Number, must);
    }

    /// One of several things; the first, where nothing is chosen.
    pub(super) fn one(&mut self, name: &str, label: &'static str, picks: Vec<super::Pick>) {
        let may_be_none = picks.first().is_some_and(|pick| pick.value.is_empty());
        let input = Input::One(picks);
        self.add(name, label, input, Shape::Word, !may_be_none);
    }

    /// One of several things; what was chosen then.
    pub(super) fn chosen(
        &mut self,
        name: &str,
        label: &'static str,
        picks: Vec<super::Pick>,
    ) -> String {
        self.one(name, label, picks);
        let field = self.fields.last();
        field.map_or_else(String::new, |field| field.value(self.words).to_owned())
    }

    /// The fields of each answer.
    pub(super) fn answers(&mut self, count: usize, fields: fn(&mut Self, &str)) {
        let part = self.part;
        for index in 0..count {
            self.part = Part::Answer(index);
            fields(self, &format!("{ANSWERS}[{index}]"));
        }
        self.part = part;
    }
}
