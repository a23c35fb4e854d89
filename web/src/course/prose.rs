//! Paragraphs: what they name lights up on the board, opens, or is gone to.

use std::rc::Rc;

use giveway_course::learner::Action;
use giveway_course::lesson::{Span, Target, Text};
use giveway_course::port::Lit;
use giveway_model::{Agent, tr};
use yew::prelude::*;

use super::shelf::Shelf;
use super::term::TermLink;
use super::tutor::Msg;
use crate::glyph;

/// What does not begin a line.
const ENDS: &str = ".,:;?!)";

/// What paragraphs need to be shown.
#[derive(Clone, Copy)]
pub(super) struct Reader<'a> {
    /// The robots on the board.
    pub(super) agents: &'a [Agent],
    /// The terms.
    pub(super) shelf: &'a Rc<Shelf>,
    /// Takes what is done with a link.
    pub(super) send: &'a Callback<Msg>,
}

impl Reader<'_> {
    /// The parts of a paragraph. What ends a sentence stays with the link before it.
    pub(super) fn show(&self, text: &Text) -> Html {
        let mut parts = Vec::new();
        let mut spans = text.spans().iter().peekable();
        let mut held = false;
        while let Some(span) = spans.next() {
            let after = spans.peek().and_then(|after| match (span, after) {
                (Span::Link { .. }, Span::Plain(words)) => words.chars().next(),
                _ => None,
            });
            let mark = after.filter(|mark| ENDS.contains(*mark));
            parts.push(match (span, mark) {
                (Span::Plain(words), _) if held => {
                    let rest = words.trim_start_matches(|first| ENDS.contains(first));
                    html! { { rest.to_owned() } }
                }
                (span, None) => self.span(span),
                (span, Some(_)) => {
                    let marks = spans.peek().map_or("", |after| after.words());
                    let marks: String = marks.chars().take_while(|c| ENDS.contains(*c)).collect();
                    html! { <span class="with-end">{ self.span(span) }{ marks }</span> }
                }
            });
            held = mark.is_some();
        }
        html! { { for parts } }
    }

    /// Paragraphs.
    pub(super) fn paragraphs(&self, texts: &[Text]) -> Html {
        html! { { for texts.iter().map(|text| html! { <p>{ self.show(text) }</p> }) } }
    }

    fn span(&self, span: &Span) -> Html {
        match span {
            Span::Plain(words) => html! { { words.clone() } },
            Span::Emphasis(words) => html! { <em>{ words.clone() }</em> },
            Span::Link { label, target } => self.link(label, target),
        }
    }

    fn link(&self, label: &str, target: &Target) -> Html {
        match target {
            Target::Robot(name) => {
                let index = self.index(name);
                let class = classes!("aw", index.map(glyph::class));
                self.lights(class, label, &Lit::Robot(name.clone()), index)
            }
            Target::Cell(cell) => self.lights(classes!("cw"), label, &Lit::Cell(*cell), None),
            Target::Time(time) => {
                let time = *time;
                let onclick = self.send.reform(move |_| Msg::Do(Action::Time(time)));
                html! {
                    <button type="button" class="cw" aria-label={tr!("{label}, go there", label)} {onclick}>{ label.to_owned() }</button>
                }
            }
            Target::Term(id) => match self.shelf.term(id) {
                Some(_) => html! {
                    <TermLink id={id.clone()} label={label.to_owned()} shelf={Rc::clone(self.shelf)} send={self.send.clone()} />
                },
                None => html! { { label.to_owned() } },
            },
        }
    }

    /// Words that light something as long as they are pointed at.
    fn lights(&self, class: Classes, label: &str, lit: &Lit, robot: Option<usize>) -> Html {
        let on = || {
            let lit = lit.clone();
            self.send
                .reform(move |()| Msg::Do(Action::Light(Some(lit.clone()))))
        };
        let off = || self.send.reform(|()| Msg::Do(Action::Light(None)));
        html! {
            <button type="button" {class} aria-label={tr!("{label}, show on the board", label)}
                onmouseenter={on().reform(|_: MouseEvent| ())} onmouseleave={off().reform(|_: MouseEvent| ())}
                onfocus={on().reform(|_: FocusEvent| ())} onblur={off().reform(|_: FocusEvent| ())}
                onclick={on().reform(|_: MouseEvent| ())}>
                if let Some(robot) = robot { { glyph::show(robot, "aw-glyph") } }
                { label.to_owned() }
            </button>
        }
    }

    /// A robot, by its index on the board.
    pub(super) fn index(&self, name: &str) -> Option<usize> {
        self.agents.iter().position(|agent| agent.name == name)
    }

    /// The name of a robot with its form, to be read only.
    pub(super) fn robot(&self, name: &str) -> Html {
        let index = self.index(name);
        html! {
            <span class={classes!("aw", index.map(glyph::class))}>
                if let Some(index) = index { { glyph::show(index, "aw-glyph") } }
                { name.to_owned() }
            </span>
        }
    }

    /// The same words without anything to press, for the inside of a button.
    pub(super) fn still(&self, spans: &[Span]) -> Html {
        let one = |span: &Span| match span {
            Span::Link {
                label,
                target: Target::Robot(name),
            } if label == name => self.robot(name),
            Span::Link {
                label,
                target: Target::Cell(_) | Target::Time(_),
            } => html! { <span class="cw">{ label.clone() }</span> },
            span => html! { { span.words().to_owned() } },
        };
        html! { { for spans.iter().map(one) } }
    }
}

/// The first sentence of a text that begins with plain words, and what follows it;
/// nothing follows where there is one sentence only.
pub(super) fn first_sentence(text: &Text) -> (Vec<Span>, Vec<Span>) {
    let spans = text.spans();
    if let Some((Span::Plain(words), after)) = spans.split_first()
        && let Some((first, rest)) = words.split_once(". ")
    {
        let rest = Span::Plain(rest.to_owned());
        let rest = std::iter::once(rest).chain(after.iter().cloned());
        return (vec![Span::Plain(first.to_owned())], rest.collect());
    }
    (spans.to_vec(), Vec::new())
}
