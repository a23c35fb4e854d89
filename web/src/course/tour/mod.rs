//! The tour: a card that points at a thing of the page, and a ring round it. What it
//! says, and when a step is done, is decided in `giveway_course::tour`.

mod follow;
mod keys;
mod target;
mod way;

use giveway_course::tour::{Action, Step, Tour};
use giveway_model::tr;
use yew::prelude::*;

use super::tutor::Msg;
use follow::Follow;

pub(super) use target::find;

#[derive(Clone, PartialEq, Properties)]
pub(super) struct GuideProps {
    /// The tour.
    pub(super) tour: Tour,
    /// The language that is spoken: in another one it says all of it anew.
    pub(super) spoken: String,
    /// Takes what happens.
    pub(super) send: Callback<Msg>,
}

/// The card of the step. It takes the focus when the tour begins, and gives it back.
#[component]
pub(super) fn Guide(props: &GuideProps) -> Html {
    let GuideProps { tour, send, .. } = props;
    let (card, ring) = (use_node_ref(), use_node_ref());
    {
        let (card, send) = (card.clone(), send.clone());
        use_effect_with((), move |()| {
            let back = keys::enter(&card);
            let listening = keys::listen(move || send.emit(Msg::Tour(Action::End)));
            move || {
                drop(listening);
                back.give(&card);
            }
        });
    }
    let (step, target) = (tour.step(), tour.target());
    {
        let (card, ring) = (card.clone(), ring.clone());
        use_effect_with((step, target), move |&(_, target)| {
            let following = Follow::begin(card, ring, target);
            move || following.end()
        });
    }
    let act = |action: Action| send.reform(move |_: MouseEvent| Msg::Tour(action.clone()));
    let (number, all) = (step.index() + 1, Step::ALL.len());
    html! {
        <>
            <i class="coach-ring" key={step.index()} ref={ring} aria-hidden="true"></i>
            <section class="coach" key="coach" ref={card} role="dialog" tabindex="-1"
                aria-labelledby="coach-title" aria-describedby="coach-text">
                <i class="tip"></i>
                // What is to be done next is read aloud wherever the focus is.
                <div aria-live="polite">
                    <div class="coach-words" key={step.index()}>
                        <h2 id="coach-title">{ step.title() }</h2>
                        <p id="coach-text">{ step.text() }</p>
                    </div>
                </div>
                <footer>
                    <ol class="dots" aria-label={tr!("Step {number} of {all}", number, all)}>
                        { for Step::ALL.into_iter().map(|other| dot(other, step)) }
                    </ol>
                    <span class="num">{ tr!("{number} of {all}", number, all) }</span>
                    <span class="grow"></span>
                    <button type="button" class="btn ghost" onclick={act(Action::End)}>{ tr!("End tour") }</button>
                    <button type="button" class="btn outline" onclick={act(Action::Show)}>{ tr!("Show me") }</button>
                </footer>
            </section>
        </>
    }
}

fn dot(one: Step, current: Step) -> Html {
    let class = match one.index().cmp(&current.index()) {
        std::cmp::Ordering::Less => "did",
        std::cmp::Ordering::Equal => "cur",
        std::cmp::Ordering::Greater => "",
    };
    html! { <li {class}></li> }
}
