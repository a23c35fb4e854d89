//! A plan that is one of several to choose from, on a small board of its own, in step
//! with the others; who is elsewhere than by the plan before is marked.

use giveway_model::words::Later;
use std::rc::Rc;

use giveway_page::Answer;
use giveway_page::board::Camera;
use yew::prelude::*;

use super::beside::Beside;
use super::casts::renewed;
use crate::Shown;
use crate::board::beside::BesideProps;
use crate::held::use_held;
use crate::part::part;

/// Which plan, and which one was before it.
#[derive(Clone, PartialEq, Properties)]
pub(crate) struct PreviewProps {
    /// The name of its grid; no two on the page have the same.
    pub(crate) name: Later,
    /// The map and the time.
    pub(crate) state: Shown,
    /// The plan; without one the robots stand where they are when the world changes.
    pub(crate) answer: Option<Rc<Answer>>,
    /// The plan before.
    pub(crate) before: Rc<Answer>,
}

/// The board of that plan, all of the map in sight.
#[component]
pub(crate) fn Preview(props: &PreviewProps) -> Html {
    let kept = use_held(<[Option<Rc<_>>; 2]>::default);
    let [mut this, mut other] = kept.take();
    let before = renewed(&mut other, &props.state, Some(&props.before));
    let (cast, versus) = match &props.answer {
        Some(answer) => (renewed(&mut this, &props.state, Some(answer)), Some(before)),
        None => (before, None),
    };
    kept.set([this, other]);
    html! { { part::<Beside>(BesideProps { name: props.name, state: props.state.clone(), cast, versus, camera: Camera::default(), onkeydown: Callback::noop() }) } }
}
