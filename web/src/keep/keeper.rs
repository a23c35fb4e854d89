//! Keeps the page as it changes, once it is calm.

use std::cell::Cell;
use std::rc::Rc;

use giveway_model::tr;
use giveway_page::slot::Unkept;
use giveway_page::{Action, By, Moment, SlotAction, link};
use gloo::timers::callback::Timeout;
use yew::Callback;

use super::{opening, scenes, storage, tabs};
use crate::Shown;
use crate::broke;
use crate::embed::is_embedded;
use crate::held::Held;

/// Where preferences are kept.
pub(super) const PREFERENCES: &str = "preferences";
/// How long nothing must change before the page is kept, in milliseconds.
const CALM_MS: u32 = 400;

thread_local! {
    /// The last state that was shown, for the moment in which the page breaks down:
    /// in a cell, which can be emptied whatever else is borrowed then.
    static SHOWN: Cell<Option<Shown>> = const { Cell::new(None) };
}

/// Keeps the page.
#[derive(Clone, PartialEq)]
pub(super) struct Keeper(Rc<Inner>);

struct Inner {
    send: Callback<Action>,
    latest: Held<Option<Shown>>,
    /// The state since which the page is waiting to be calm, or was kept.
    since: Held<Option<Shown>>,
    waiting: Held<Option<Timeout>>,
    /// What a link took the place of, once that is among the scenes.
    displaced: Held<Option<Rc<Moment>>>,
    /// What was told last of why nothing is kept.
    told: Cell<Option<Unkept>>,
    /// Whether a person is being welcomed.
    welcomes: Cell<bool>,
}

impl PartialEq for Inner {
    fn eq(&self, other: &Self) -> bool {
        std::ptr::eq(self, other)
    }
}

impl Keeper {
    pub(super) fn new(send: Callback<Action>) -> Self {
        Self(Rc::new(Inner {
            send,
            latest: Held::default(),
            since: Held::default(),
            waiting: Held::default(),
            displaced: Held::default(),
            told: Cell::default(),
            welcomes: Cell::default(),
        }))
    }

    /// The state that is shown now.
    pub(super) fn latest(&self) -> Option<Shown> {
        self.0.latest.get()
    }

    /// A state is shown: it is kept when nothing has changed for a while.
    pub(super) fn saw(&self, state: &Shown) {
        let inner = &self.0;
        if is_embedded() {
            return;
        }
        SHOWN.set(Some(state.clone()));
        inner.latest.set(Some(state.clone()));
        self.keep_displaced(state);
        let welcomes = state.own().view.waiting.welcome;
        if inner.welcomes.replace(welcomes) && !welcomes {
            storage::welcomed();
        }
        // Where nothing that is kept has changed, the page stays as calm as it was.
        let since = inner.since.get();
        if since.is_none_or(|since| !since.is_kept_alike(state)) {
            inner.since.set(Some(state.clone()));
            let keeper = self.clone();
            let waiting = Timeout::new(CALM_MS, move || {
                keeper.keep();
                opening::went_well();
            });
            inner.waiting.set(Some(waiting));
        }
    }

    /// Keeps the page now; tells once where that fails.
    pub(super) fn keep(&self) {
        let Some(state) = self.latest().filter(|_| !broke::is_broken()) else {
            return;
        };
        let told = self.0.told.get();
        // Of what nobody touched nothing would be missed.
        let failed = store(&state).err();
        let failed = failed.filter(|_| told.is_some() || state.history.is_touched());
        if failed != told {
            self.0.told.set(failed);
            let action = failed.map_or(SlotAction::Kept, SlotAction::Unkept);
            self.0.send.emit(Action::Slot(action));
        }
    }

    /// What a link took the place of is kept under Scenes, too, at once.
    fn keep_displaced(&self, state: &Shown) {
        let displaced = state.displaced.as_ref().filter(|it| it.by == By::Link);
        let Some(moment) = displaced.map(|displaced| &displaced.moment) else {
            return;
        };
        let last = self.0.displaced.get();
        if !last.is_some_and(|last| Rc::ptr_eq(&last, moment)) {
            // Where there is no room it is still in Undo, and the slot tells of it.
            let _ = scenes::keep_beside(moment, tr!("before the link"));
            self.0.displaced.set(Some(Rc::clone(moment)));
        }
    }
}

/// Keeps the document of this tab, and preferences.
fn store(state: &Shown) -> Result<(), Unkept> {
    let preferences = storage::load(PREFERENCES);
    if !preferences.is_some_and(|text| link::are_newer(&text)) {
        // Nobody misses them as they miss a document.
        let _ = storage::store(PREFERENCES, &link::preferences(state));
    }
    let text = link::keep(state);
    if text.len() > 2 * link::LONGEST {
        return Err(Unkept::Full);
    }
    let name = tabs::own();
    while let Err(why) = storage::store(&name, &text) {
        if why == Unkept::Refused || !tabs::make_room() {
            return Err(why);
        }
    }
    tabs::was_last();
    Ok(())
}

/// What could be done for the document when the page broke down.
pub(crate) enum Rescued {
    /// It is kept.
    Kept,
    /// Nobody had touched it.
    Nothing,
    /// The browser does not keep it: this is it.
    Only(String),
}

/// Keeps the last state that was shown, as the page breaks down; at most once.
pub(crate) fn rescue() -> Rescued {
    let Some(state) = SHOWN.take() else {
        return Rescued::Nothing;
    };
    tabs::leave();
    match store(&state) {
        Ok(()) => Rescued::Kept,
        Err(_) if state.history.is_touched() => Rescued::Only(link::keep(&state)),
        Err(_) => Rescued::Nothing,
    }
}
