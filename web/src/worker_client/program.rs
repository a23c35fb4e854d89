//! The Wasm program of workers: fetched and compiled once for all of them.

use std::rc::Rc;

use giveway_model::tr;
use js_sys::{Promise, WebAssembly};
use wasm_bindgen::{JsCast as _, JsValue};
use wasm_bindgen_futures::{JsFuture, future_to_promise};
use web_sys::Response;

use super::handle::written;
use crate::held::Held;

/// What a host must call Wasm for a browser to compile it while it arrives.
const TYPE: &str = "application/wasm";

/// The programs, by what they are for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Name {
    /// Finds plans, and follows changes.
    Solver,
    /// All that can be asked.
    Analyst,
    /// Reads and writes files of other programs.
    Reader,
}

impl Name {
    /// What the page's HTML calls it.
    pub(super) const fn key(self) -> &'static str {
        match self {
            Self::Solver => "solver",
            Self::Analyst => "analyst",
            Self::Reader => "reader",
        }
    }

    /// What a person calls it: the program that answers questions is the solver, too.
    pub(super) fn word(self) -> &'static str {
        match self {
            Self::Solver | Self::Analyst => tr!("solver"),
            Self::Reader => tr!("reader"),
        }
    }
}

/// The program, or the way to it.
pub(crate) struct Program {
    name: Name,
    promise: Held<Option<Rc<Promise>>>,
}

impl Program {
    /// A program that nobody has fetched yet.
    pub(crate) fn new(name: Name) -> Self {
        Self {
            name,
            promise: Held::default(),
        }
    }

    /// Which it is.
    pub(super) const fn name(&self) -> Name {
        self.name
    }

    /// The compiled module, fetched at the first call; at the next one, too,
    /// where that failed.
    ///
    /// # Errors
    /// Why it is not there, as a sentence.
    pub(super) async fn module(&self) -> Result<JsValue, String> {
        let promise = self.promise.get().unwrap_or_else(|| {
            let promise = Rc::new(future_to_promise(compile(self.name)));
            self.promise.set(Some(Rc::clone(&promise)));
            promise
        });
        let module = JsFuture::from(Promise::clone(&promise)).await;
        module.map_err(|error| {
            self.promise.set(None);
            let error = js_sys::Error::from(error).message();
            tr!(
                "The browser could not load the {word}: {error}",
                word = self.name.word(),
                error
            )
        })
    }
}

async fn compile(name: Name) -> Result<JsValue, JsValue> {
    let refuse = |sentence: String| JsValue::from(js_sys::Error::new(&sentence));
    let address = written(&format!("giveway-{}", name.key())).map_err(refuse)?;
    let fetched = JsFuture::from(gloo::utils::window().fetch_with_str(&address)).await?;
    let response: Response = fetched.unchecked_into();
    if !response.ok() {
        return Err(refuse(format!("{address}: {}", response.status())));
    }
    let kind = response.headers().get("Content-Type")?;
    let module = if kind.is_some_and(|kind| kind.starts_with(TYPE)) {
        WebAssembly::compile_streaming(&Promise::resolve(&JsValue::from(response)))
    } else {
        WebAssembly::compile(&JsFuture::from(response.array_buffer()?).await?)
    };
    JsFuture::from(module).await
}
