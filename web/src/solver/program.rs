//! The Wasm of a worker: fetched and compiled once, for all workers.

use std::rc::Rc;

use js_sys::{Promise, WebAssembly};
use wasm_bindgen::{JsCast as _, JsValue};
use wasm_bindgen_futures::{JsFuture, future_to_promise};
use web_sys::Response;

use super::worker::written;
use crate::held::Held;

/// What a host must call Wasm for a browser to compile it while it arrives.
const TYPE: &str = "application/wasm";

/// The program, or the way to it.
pub(crate) struct Program {
    name: &'static str,
    promise: Held<Option<Rc<Promise>>>,
}

impl Program {
    /// A program by the name that the page's HTML has for it.
    pub(crate) fn new(name: &'static str) -> Self {
        Self {
            name,
            promise: Held::default(),
        }
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
            format!("The browser could not load the {}: {error}", self.name)
        })
    }
}

async fn compile(name: &'static str) -> Result<JsValue, JsValue> {
    let refuse = |sentence: String| JsValue::from(js_sys::Error::new(&sentence));
    let address = written(&format!("giveway-{name}")).map_err(refuse)?;
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
