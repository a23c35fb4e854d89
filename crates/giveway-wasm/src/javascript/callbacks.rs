//! The functions that a caller hands in.

use std::cell::RefCell;

use giveway_solve::Progress;
use js_sys::{Function, Reflect};
use wasm_bindgen::{JsCast as _, JsValue};

use super::objects::{self, bad, kind};

const ON_PROGRESS: &str = "onProgress";
const SHOULD_STOP: &str = "shouldStop";

/// The callbacks, and what one of them threw.
#[derive(Default)]
pub(super) struct Callbacks {
    on_progress: Option<Function>,
    should_stop: Option<Function>,
    thrown: RefCell<Option<JsValue>>,
}

impl Callbacks {
    /// Those of an object of options.
    ///
    /// # Errors
    /// An `Error` when it is no object, has a key that is unknown, or something
    /// that is no function.
    pub(super) fn new(options: &JsValue) -> Result<Self, JsValue> {
        if options.is_undefined() {
            return Ok(Self::default());
        }
        if !options.is_object() || options.is_array() {
            return Err(bad("options", kind(options), "an object"));
        }
        let known = [ON_PROGRESS, SHOULD_STOP];
        for key in Reflect::own_keys(options)?.iter() {
            let key = key.as_string().unwrap_or_default();
            if !known.contains(&key.as_str()) {
                let found = format!("the unknown key \"{key}\"");
                return Err(bad(
                    "options",
                    found,
                    format!("one of {}", known.join(", ")),
                ));
            }
        }
        Ok(Self {
            on_progress: function(options, ON_PROGRESS)?,
            should_stop: function(options, SHOULD_STOP)?,
            thrown: RefCell::default(),
        })
    }

    /// Hands an event on.
    pub(super) fn hear(&self, event: &Progress) {
        if let (Some(hear), false) = (&self.on_progress, self.has_thrown()) {
            let heard = objects::write(event).and_then(|event| hear.call1(&JsValue::NULL, &event));
            if let Err(thrown) = heard {
                self.keep(thrown);
            }
        }
    }

    /// Asks whether to stop; it stops where a callback has thrown.
    pub(super) fn say_stop(&self) -> bool {
        let Some(ask) = &self.should_stop else {
            return self.has_thrown();
        };
        if self.has_thrown() {
            return true;
        }
        let said = ask.call0(&JsValue::NULL).and_then(|said| {
            if said.is_undefined() {
                return Ok(false);
            }
            // A promise would be true for all others, whatever it promises.
            said.as_bool()
                .ok_or_else(|| bad("options.shouldStop", kind(&said), "true or false at once"))
        });
        said.unwrap_or_else(|thrown| {
            self.keep(thrown);
            true
        })
    }

    /// What a callback threw.
    pub(super) fn thrown(&self) -> Option<JsValue> {
        self.thrown.borrow_mut().take()
    }

    fn has_thrown(&self) -> bool {
        self.thrown.borrow().is_some()
    }

    fn keep(&self, thrown: JsValue) {
        self.thrown.borrow_mut().get_or_insert(thrown);
    }
}

fn function(options: &JsValue, key: &str) -> Result<Option<Function>, JsValue> {
    let value = Reflect::get(options, &key.into())?;
    if value.is_undefined() {
        return Ok(None);
    }
    let found = kind(&value);
    let function = value.dyn_into::<Function>();
    function
        .map(Some)
        .map_err(|_| bad(&format!("options.{key}"), found, "a function"))
}
