//! The step as the learner sees it: its board, its text, what it asks.

use std::rc::Rc;

use giveway_course::lesson::{Step, Task, Text};
use giveway_model::tr;
use yew::prelude::*;

use super::super::prose::Reader;
use crate::board::ThumbProps;
use crate::board::{Film, Thumb};
use crate::icon;
use crate::part::part;

#[derive(Clone, Properties)]
pub(super) struct BoardProps {
    /// The board with its plan.
    pub(super) film: Rc<Film>,
}

impl PartialEq for BoardProps {
    fn eq(&self, other: &Self) -> bool {
        Rc::ptr_eq(&self.film, &other.film)
    }
}

/// The board; its plan plays when it is pressed.
#[component]
pub(super) fn SmallBoard(props: &BoardProps) -> Html {
    let plays = use_state_eq(|| false);
    let onclick = {
        let plays = plays.clone();
        move |_: MouseEvent| plays.set(!*plays)
    };
    let name = if *plays {
        tr!("Stop the plan")
    } else {
        tr!("Play the plan")
    };
    html! {
        <button type="button" class="thumb2 aboard" title={name} {onclick}>
            { part::<Thumb>(ThumbProps { film: Rc::clone(&props.film), plays: *plays }) }<span class="vh">{ name }</span>
        </button>
    }
}

/// Text and task. What they name lights up only when the lesson is tried.
pub(super) fn prose(step: &Step, reader: Reader<'_>) -> Html {
    html! {
        <>
            <h4>{ step.title.clone() }</h4>
            <div class="prose">{ reader.paragraphs(&step.text) }</div>
            if let Some(task) = &step.task {
                <div class="ex">
                    <p class="exk">{ icon::show("edit") }{ tr!("Your turn") }</p>
                    <p class="exq">{ reader.show(task.say()) }</p>
                    if let answers @ [_, ..] = &*answers(task) {
                        <ol class="apicks">{ for answers.iter().map(|text| html! { <li>{ reader.show(text) }</li> }) }</ol>
                    }
                </div>
            }
        </>
    }
}

fn answers(task: &Task) -> Vec<Text> {
    match task {
        Task::Choose(task) => task
            .answers
            .iter()
            .map(|answer| answer.text.clone())
            .collect(),
        Task::Predict(task) => task
            .answers
            .iter()
            .map(|answer| answer.text.clone())
            .collect(),
        _ => Vec::new(),
    }
}
