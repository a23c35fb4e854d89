//! The reader's Wasm: what reads and writes other people's files, and pictures that
//! move, in a worker.
//!
//! A program of its own, loaded when such a file is opened or saved first: most people
//! never need it, and neither page nor solver grows by the readers of all formats.

use std::cell::Cell;

use giveway_model::tr;
use giveway_page::intake::Reader;
use giveway_page::intake::protocol::{Ask, Message, Task};
use js_sys::Uint8Array;
use wasm_bindgen::JsCast as _;
use wasm_bindgen::closure::Closure;
use web_sys::{DedicatedWorkerGlobalScope, MessageEvent};

/// From this size on it is said how much there is to read, in bytes.
const LARGE: usize = 1_000_000;

fn main() {
    std::panic::set_hook(Box::new(|panic| {
        post(&Message::Failed(tr!(
            "The reader broke down, which is a fault of this program: {panic}",
            panic
        )));
    }));
    let reader = Cell::new(Reader::default());
    let listen = Closure::<dyn Fn(MessageEvent)>::new(move |event: MessageEvent| {
        if let Some(told) = event.data().as_string() {
            giveway_wasm::language::hear(&told);
            return;
        }
        let bytes = event.data().dyn_ref().map(Uint8Array::to_vec);
        let mut busy = reader.take();
        answer(&mut busy, &bytes.unwrap_or_default());
        reader.set(busy);
    });
    scope().set_onmessage(Some(listen.as_ref().unchecked_ref()));
    listen.forget(); // it listens as long as the worker lives
    post(&Message::Ready);
}

/// Answers one message.
fn answer(reader: &mut Reader, bytes: &[u8]) {
    match borsh::from_slice::<Ask>(bytes) {
        Ok(ask) => {
            if let Some(sentence) = large(&ask.task) {
                let id = ask.id;
                post(&Message::Progress { id, sentence });
            }
            reader.answer(ask, &mut |message| post(&message));
        }
        Err(error) => post(&Message::Failed(tr!(
            "The reader was asked what it does not understand: {error}",
            error
        ))),
    }
}

/// What there is to be said of large files before they are read.
fn large(task: &Task) -> Option<String> {
    let Task::Read(read) = task else { return None };
    let bytes: usize = read.files.iter().map(|file| file.bytes.len()).sum();
    (bytes >= LARGE).then(|| {
        let name = read.files.first().map_or("", |file| file.name.as_str());
        tr!(
            "Reading and judging {name}, {size} MB …",
            name,
            size = bytes.div_ceil(LARGE)
        )
    })
}

fn scope() -> DedicatedWorkerGlobalScope {
    js_sys::global().unchecked_into()
}

fn post(message: &Message) {
    // Memory is all that could run out, and bytes can always be posted.
    let bytes = borsh::to_vec(message).unwrap_or_default();
    let _ = scope().post_message(&Uint8Array::from(bytes.as_slice()));
}
