//! A lesson in the contents: its board, its title, how far it has come.

use std::rc::Rc;

use giveway_course::learner::Stage;
use giveway_course::lesson::Entry;
use giveway_model::tr;
use yew::prelude::*;

use super::place::Place;
use super::sight::once;
use super::tutor::Msg;
use crate::board::ThumbProps;
use crate::board::{Film, Thumb};
use crate::icon;
use crate::part::part;
use crate::theme::wants_less_motion;

/// The most that a bar shows, in parts.
const WHOLE: u64 = 100;

#[derive(Clone, Properties)]
pub(super) struct CardProps {
    /// The lesson.
    pub(super) entry: Entry,
    /// Its board.
    pub(super) film: Option<Rc<Film>>,
    /// How far it has come.
    pub(super) stage: Stage,
    /// Whether it is the one to go on with.
    pub(super) is_next: bool,
    /// Takes the choice.
    pub(super) send: Callback<Msg>,
}

impl PartialEq for CardProps {
    /// The board comes with the lesson, and is made anew with its words.
    fn eq(&self, other: &Self) -> bool {
        self.entry.lesson == other.entry.lesson
            && self.film.as_ref().map(Rc::as_ptr) == other.film.as_ref().map(Rc::as_ptr)
            && self.stage == other.stage
            && self.is_next == other.is_next
            && self.send == other.send
    }
}

/// A button that opens the lesson where it was left.
#[component]
pub(super) fn Card(props: &CardProps) -> Html {
    let CardProps {
        entry, film, stage, ..
    } = props;
    let points = use_state_eq(|| false);
    let set = |to: bool| {
        let points = points.setter();
        move || points.set(to && !wants_less_motion())
    };
    let (enter, leave, focus, blur) = (set(true), set(false), set(true), set(false));
    let place = Place {
        lesson: entry.lesson.clone(),
        step: None,
    };
    let onclick = once(&props.send, move || Msg::Enter(place.clone()));
    let is_now = props.is_next && matches!(stage, Stage::Begun(_) | Stage::Seen { .. });
    html! {
        <button type="button" class={classes!("lc", is_now.then_some("now"))} aria-current={is_now.then_some("step")} {onclick}
            onmouseenter={move |_| enter()} onmouseleave={move |_| leave()} onfocus={move |_| focus()} onblur={move |_| blur()}>
            <span class="thumb2">
                if let Some(film) = film { { part::<Thumb>(ThumbProps { film: Rc::clone(film), plays: *points }) } }
            </span>
            <span class="lt"><b>{ entry.title.clone() }</b>{ reached(entry, *stage) }</span>
        </button>
    }
}

fn reached(entry: &Entry, stage: Stage) -> Html {
    match stage {
        Stage::New => html! { <small>{ tr!("{n} min", n = entry.minutes) }</small> },
        Stage::Begun(step) => {
            let step = u64::try_from(step).unwrap_or(0) + 1;
            let steps = u64::from(entry.steps);
            html! {
                <><small class="acc">{ tr!("Step {step} of {steps}", step, steps) }</small>{ bar(step, steps) }</>
            }
        }
        Stage::Seen { solved, tasks, .. } => {
            let words = tr!(
                "{solved} of {n} task" | "{solved} of {n} tasks" % tasks,
                solved
            );
            html! { <><small class="acc">{ words }</small>{ bar(solved as u64, tasks as u64) }</> }
        }
        Stage::Done => {
            html! { <small class="okk">{ icon::show("check") }{ tr!("of a lesson" => "Done") }</small> }
        }
    }
}

/// A bar; its words stand beside it.
pub(super) fn bar(done: u64, of: u64) -> Html {
    let share = (done.min(of) * WHOLE).checked_div(of).unwrap_or(0);
    html! {
        <svg class="pb" width="100%" height="100%" aria-hidden="true"><rect width={format!("{share}%")} height="100%" /></svg>
    }
}
