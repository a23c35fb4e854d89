//! The module that Python loads: one function, which lets other threads run while it works.

use std::sync::Mutex;

use giveway_solve::Progress;
use pyo3::prelude::*;

use crate::{Asked, NativeHost, call};

/// The module `giveway._native`.
#[pymodule]
mod _native {
    #[pymodule_export]
    use super::call_native;

    /// The version of the program.
    #[pymodule_export]
    const VERSION: &str = env!("CARGO_PKG_VERSION");
}

/// Calls a function by its name. The answer is JSON: of what was asked for, or, where the
/// first value is `False`, of why there is none.
///
/// Events are handed as JSON to `on_progress`. With `signals` Python's handlers of signals
/// run meanwhile, as they do in the main thread. What a callback or a handler raises ends
/// the work and is raised.
#[pyfunction]
#[pyo3(name = "call")]
fn call_native(
    py: Python<'_>,
    function: &str,
    request: &str,
    on_progress: Option<Py<PyAny>>,
    should_stop: Option<Py<PyAny>>,
    signals: bool,
) -> PyResult<(bool, String)> {
    let callbacks = Callbacks {
        on_progress,
        should_stop,
        signals,
        raised: Mutex::new(None),
    };
    let answer = py.detach(|| call(function, request, &NativeHost::new(&callbacks)));
    if let Some(raised) = callbacks.take() {
        return Err(raised);
    }
    Ok(match answer {
        Ok(answer) => (true, answer),
        Err(failure) => (false, serde_json::to_string(&failure).unwrap_or_default()),
    })
}

/// What the caller wants to be asked and told, and what that raised.
struct Callbacks {
    on_progress: Option<Py<PyAny>>,
    should_stop: Option<Py<PyAny>>,
    signals: bool,
    raised: Mutex<Option<PyErr>>,
}

impl Callbacks {
    fn take(&self) -> Option<PyErr> {
        self.raised.lock().ok().and_then(|mut raised| raised.take())
    }

    fn has_raised(&self) -> bool {
        self.raised.lock().is_ok_and(|raised| raised.is_some())
    }

    /// Keeps the first of what was raised.
    fn keep(&self, error: PyErr) {
        if let Ok(mut raised) = self.raised.lock() {
            raised.get_or_insert(error);
        }
    }
}

impl Asked for Callbacks {
    fn hear(&self, event: &Progress) {
        let (Some(hear), false) = (&self.on_progress, self.has_raised()) else {
            return;
        };
        let Ok(text) = serde_json::to_string(event) else {
            return;
        };
        let heard = Python::attach(|py| hear.call1(py, (text,)).map(drop));
        if let Err(error) = heard {
            self.keep(error);
        }
    }

    fn should_stop(&self) -> bool {
        if self.has_raised() {
            return true;
        }
        if !self.signals && self.should_stop.is_none() {
            return false;
        }
        let said = Python::attach(|py| {
            if self.signals {
                py.check_signals()?;
            }
            match &self.should_stop {
                Some(ask) => ask.call0(py)?.is_truthy(py),
                None => Ok(false),
            }
        });
        said.unwrap_or_else(|error| {
            self.keep(error);
            true
        })
    }
}
