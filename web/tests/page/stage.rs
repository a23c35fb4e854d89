//! A place in the document with the components in it, and what they send.

use std::cell::RefCell;
use std::rc::Rc;

use giveway_model::format::native;
use giveway_page::{Action, Draft, SolveAction, State, ViewAction, WorkerAction, reduce};
use giveway_solve::{Request, SilentHost, SolveRequest, serve};
use giveway_web::{Board, Clock, Dock, Inspector, Shown, Tools};
use gloo::timers::future::TimeoutFuture;
use wasm_bindgen::JsCast as _;
use web_sys::{Element, HtmlElement, KeyboardEvent, KeyboardEventInit};
use yew::prelude::*;

/// How often it is looked whether something is so, and how often at most.
const PAUSE_MS: u32 = 20;
const TRIES: u32 = 500;

/// A state of a scene, without a plan.
pub(crate) fn drafted(scene: &str) -> State {
    let scene = native::read_scene(scene).expect("a scene of the tests is valid");
    State::new(Draft::new(scene).expect("a scene of the tests can be drawn"))
}

/// The warehouse, solved here and now, playing.
pub(crate) fn solved() -> State {
    let state = drafted(include_str!("../../../static/examples/warehouse.json"));
    let request = SolveRequest {
        scene: state.document.draft.scene().clone(),
        ..SolveRequest::default()
    };
    let response = serve(&Request::Solve(request), &SilentHost);
    let state = reduce(&state, Action::Solve(SolveAction::Solve));
    let response = Box::new(response);
    reduce(
        &state,
        Action::Worker(WorkerAction::Respond { job: 1, response }),
    )
}

#[derive(Clone, PartialEq, Properties)]
struct StageProps {
    state: Shown,
    send: Callback<Action>,
    clock: Clock,
}

/// All places that the library offers.
#[component]
fn Places(props: &StageProps) -> Html {
    let StageProps { state, send, clock } = props.clone();
    html! {
        <ContextProvider<Clock> context={clock}>
            <Tools tool={state.view.tool} send={send.clone()} />
            <Board state={state.clone()} send={send.clone()} />
            <Inspector state={state.clone()} send={send.clone()} />
            <Dock {state} {send} />
        </ContextProvider<Clock>>
    }
}

/// The places of a state in the document; gone when it is dropped.
pub(crate) struct Stage {
    pub(crate) place: Element,
    pub(crate) clock: Clock,
    props: StageProps,
    sent: Rc<RefCell<Vec<Action>>>,
    app: Option<yew::AppHandle<Places>>,
}

impl Drop for Stage {
    fn drop(&mut self) {
        if let Some(app) = self.app.take() {
            app.destroy();
        }
        self.place.remove();
    }
}

impl Stage {
    pub(crate) async fn of(state: State) -> Self {
        let place = place();
        let sent = Rc::new(RefCell::new(Vec::new()));
        let send = {
            let sent = Rc::clone(&sent);
            Callback::from(move |action| sent.borrow_mut().push(action))
        };
        let clock = Clock::new(send.clone(), false);
        let props = StageProps {
            state: Shown::new(state),
            send,
            clock: clock.clone(),
        };
        let app =
            yew::Renderer::<Places>::with_root_and_props(place.clone(), props.clone()).render();
        let stage = Self {
            place,
            clock,
            props,
            sent,
            app: Some(app),
        };
        stage.find("[role=grid]").await;
        // What listens to keys begins after the first rendering.
        TimeoutFuture::new(PAUSE_MS).await;
        stage
    }

    /// Goes on to another state.
    pub(crate) fn show(&mut self, state: State) {
        self.props.state = Shown::new(state);
        if let Some(app) = &mut self.app {
            app.update(self.props.clone());
        }
    }

    /// What a person sent since the last time: the dock itself opens and closes
    /// the table by the room that there is.
    pub(crate) fn sent(&self) -> Vec<Action> {
        let mut sent = self.sent.take();
        sent.retain(|action| !matches!(action, Action::View(ViewAction::ShowTable(_))));
        sent
    }

    /// The first element that a selector fits, once it is there.
    pub(crate) async fn find(&self, selector: &str) -> Element {
        find(&self.place, selector).await
    }

    /// What the selected elements have as an attribute.
    pub(crate) fn all(&self, selector: &str, attribute: &str) -> Vec<String> {
        let found = self.place.query_selector_all(selector).expect("a selector");
        let elements = (0..found.length()).filter_map(|n| found.item(n)?.dyn_into().ok());
        let value = |element: Element| element.get_attribute(attribute);
        elements.filter_map(value).collect()
    }
}

/// An empty place in the document.
pub(crate) fn place() -> Element {
    let document = gloo::utils::document();
    let place = document.create_element("div").expect("a name of HTML");
    gloo::utils::body()
        .append_child(&place)
        .expect("it is nowhere yet");
    place
}

/// The first element in a place that a selector fits, once it is there.
pub(crate) async fn find(place: &Element, selector: &str) -> Element {
    for _ in 0..TRIES {
        if let Some(found) = place.query_selector(selector).expect("a selector") {
            return found;
        }
        TimeoutFuture::new(PAUSE_MS).await;
    }
    panic!("found no {selector} in {}", place.inner_html());
}

/// Waits until something is so.
pub(crate) async fn until(what: &str, mut is_so: impl FnMut() -> bool) {
    for _ in 0..TRIES {
        if is_so() {
            return;
        }
        TimeoutFuture::new(PAUSE_MS).await;
    }
    panic!("waited for {what}");
}

/// Presses a button.
pub(crate) fn click(element: &Element) {
    element.unchecked_ref::<HtmlElement>().click();
}

/// Presses a key on an element.
pub(crate) fn press(element: &Element, key: &str) {
    let init = KeyboardEventInit::new();
    init.set_key(key);
    init.set_bubbles(true);
    init.set_cancelable(true);
    let event = KeyboardEvent::new_with_keyboard_event_init_dict("keydown", &init);
    let event = event.expect("a name of an event");
    element.dispatch_event(&event).expect("a new event");
}
