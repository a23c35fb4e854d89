//! A Web Worker that solves.

use std::cell::Cell;

use giveway_solve::{Host, Progress, Request, Response, serve, serve_basic};
use js_sys::Uint8Array;
use wasm_bindgen::{JsCast as _, closure::Closure};
use web_sys::{DedicatedWorkerGlobalScope, MessageEvent};

use crate::{
    budget::within_budget,
    host::WebHost,
    language,
    protocol::{Ask, Message},
};

thread_local! {
    /// What the worker is at.
    static AT: Cell<Option<u32>> = const { Cell::new(None) };
}

/// What answers a request; `None` where the program is not the one for it.
type Serve = fn(&Request, &dyn Host) -> Option<Response>;

/// Answers the messages of [`protocol`](crate::protocol) from now on, in the
/// worker that it is called in. This is all that a worker's `main` has to do.
pub fn serve_messages() {
    listen(|request, host| Some(serve(request, host)), language::hear);
}

/// Answers those messages whose request is [basic](Request::basic), and fails on others.
/// A program with this `main` is a third smaller.
pub fn serve_basic_messages() {
    // It speaks English: all that it says of an answer is said anew where it is shown.
    listen(
        |request, host| request.basic().map(|basic| serve_basic(basic, host)),
        |_| (),
    );
}

fn listen(serve: Serve, hear: fn(&str)) {
    std::panic::set_hook(Box::new(|panic| {
        post(&Message::Failed {
            id: AT.get(),
            sentence: format!("The solver broke down, which is a fault of this program: {panic}"),
        });
    }));
    let listen = Closure::<dyn Fn(MessageEvent)>::new(move |event: MessageEvent| {
        // A text tells the language; all else comes as bytes.
        if let Some(told) = event.data().as_string() {
            hear(&told);
            return;
        }
        let bytes = event.data().dyn_ref().map(Uint8Array::to_vec);
        answer(&bytes.unwrap_or_default(), serve, &post);
    });
    scope().set_onmessage(Some(listen.as_ref().unchecked_ref()));
    listen.forget(); // it listens as long as the worker lives
    post(&Message::Ready);
}

/// Answers one message.
fn answer(bytes: &[u8], serve: Serve, post: &dyn Fn(&Message)) {
    match Ask::from_bytes(bytes) {
        Ok(Ask { id, request }) => {
            AT.set(Some(id));
            let listen = |event: &Progress| {
                let event = event.clone();
                post(&Message::Progress { id, event });
            };
            let host = WebHost::new(&listen, None);
            let response = serve(&within_budget(request), &host as &dyn Host);
            AT.set(None);
            post(&match response {
                Some(response) => Message::Answer {
                    id,
                    response: Box::new(response),
                },
                None => Message::Failed {
                    id: Some(id),
                    sentence: "This program only finds plans and follows changes.".to_owned(),
                },
            });
        }
        Err(sentence) => post(&Message::Failed { id: None, sentence }),
    }
}

fn scope() -> DedicatedWorkerGlobalScope {
    js_sys::global().unchecked_into()
}

fn post(message: &Message) {
    // Bytes can always be posted.
    let _ = scope().post_message(&Uint8Array::from(message.to_bytes().as_slice()));
}
