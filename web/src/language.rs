//! The language of the page: the one that was chosen here, else that of the link, else the
//! one that was chosen at an earlier visit, else the browser's first one that the page
//! speaks. English is in the program; each other one is fetched when it is
//! asked for, and until it is there the page speaks English.

use std::cell::Cell;

use giveway_model::words::{Catalogue, speak};
use giveway_model::{tr, tr_data};
use giveway_page::{Action, FileAction, Notice};
use giveway_wasm::language;
use web_sys::HtmlElement;
use yew::platform::spawn_local;
use yew::prelude::*;

use crate::held::Held;
use crate::{files, keep};

/// The languages beside English, a line each: the tag, which names the PO file, and
/// what the language calls itself.
const LIST: &str = include_str!("../../static/languages/list.txt");
/// English by its tag.
const ENGLISH: &str = "en";

/// A language that was fetched.
#[derive(Clone)]
struct Fetched {
    tag: &'static str,
    catalogue: &'static Catalogue,
    /// What workers are told.
    told: String,
}

thread_local! {
    static FETCHED: Held<Vec<Fetched>> = Held::default();
    /// What was chosen while the page is open: a browser may keep nothing.
    static CHOSEN: Held<Option<String>> = Held::default();
    static SPOKEN: Cell<&'static str> = const { Cell::new(ENGLISH) };
    /// Whether the button was pressed that turns to another language: it is built anew
    /// then, and takes the focus again.
    static PRESSED: Cell<bool> = const { Cell::new(false) };
    /// What workers and the course are told; empty where English is spoken.
    static TOLD: Held<String> = Held::default();
    /// Says on the page that another language is spoken.
    static CHANGED: Held<Option<Callback<&'static str>>> = Held::default();
    /// What workers and the course do not know yet is told to them by these.
    static WORKERS: Held<Vec<Callback<String>>> = Held::default();
}

/// The languages: their tags, and their names in themselves.
pub(crate) fn all() -> impl Iterator<Item = (&'static str, &'static str)> + Clone {
    let others = LIST.lines().filter_map(|line| line.split_once(' '));
    [(ENGLISH, "English")].into_iter().chain(others)
}

/// What was chosen, by a person or by the link; empty, if the browser decides.
pub(crate) fn choice() -> String {
    let chosen = CHOSEN.with(Held::get).or_else(linked);
    chosen.or_else(keep::language).unwrap_or_default()
}

/// The language of the link, by its tag. One that the page does not speak is ignored.
pub(crate) fn linked() -> Option<String> {
    let tag = keep::linked_language()?;
    known(&tag).map(str::to_owned)
}

/// The language that one press turns to, by its tag and its own name: the one after the
/// language that is spoken. `spoken` is the tag of that; empty for English.
pub(crate) fn next(spoken: &str) -> (&'static str, &'static str) {
    let spoken = if spoken.is_empty() { ENGLISH } else { spoken };
    let mut after = all().cycle().skip_while(|(tag, _)| *tag != spoken);
    after.nth(1).unwrap_or((ENGLISH, "English"))
}

/// The button that turns to the next language, which it is named in.
pub(crate) fn button(
    spoken: &str,
    class: &'static str,
    node: NodeRef,
    choose: Callback<&'static str>,
) -> Html {
    let (tag, name) = next(spoken);
    let code = tag.to_uppercase();
    // Whoever speaks to the page says what is seen.
    let label = format!("{code}: {name}");
    let onclick = move |_: MouseEvent| choose.emit(tag);
    html! {
        <button type="button" ref={node} {class} lang={tag} title={name} aria-label={label} {onclick}>
            { code }
        </button>
    }
}

/// What a worker is to be told; empty where English is spoken.
pub(crate) fn told() -> String {
    TOLD.with(Held::get)
}

/// The tag of the language that is spoken.
pub(crate) fn spoken() -> &'static str {
    SPOKEN.get()
}

/// Tells all who want to be told.
pub(crate) fn tell(told: &str) {
    TOLD.with(|known| known.set(told.to_owned()));
    for tell in WORKERS.with(Held::get) {
        tell.emit(told.to_owned());
    }
}

/// The language that is spoken, by its tag.
#[hook]
pub(crate) fn use_language() -> &'static str {
    let spoken = use_state_eq(|| ENGLISH);
    {
        let setter = spoken.setter();
        use_effect_with((), move |()| {
            CHANGED.with(|changed| changed.set(Some(Callback::from(move |tag| setter.set(tag)))));
            spawn_local(async {
                // Nobody asked for it: without it the page speaks English.
                let _ = turn_to(wanted()).await;
            });
            || CHANGED.with(|changed| changed.set(None))
        });
    }
    *spoken
}

/// The button of the top bar that turns the page to the next language.
#[component]
pub(crate) fn LanguageButton(props: &LanguageButtonProps) -> Html {
    let node = use_node_ref();
    {
        let node = node.clone();
        use_effect_with((), move |()| {
            if PRESSED.take()
                && let Some(button) = node.cast::<HtmlElement>()
            {
                // Without the focus a person who uses the keyboard begins at the top.
                let _ = button.focus();
            }
        });
    }
    let choose_it = props.send.clone();
    let choose_it = Callback::from(move |tag| {
        PRESSED.set(true);
        choose(tag, &choose_it);
    });
    button(SPOKEN.get(), "btn ghost ph", node, choose_it)
}

#[derive(Clone, PartialEq, Properties)]
pub(crate) struct LanguageButtonProps {
    /// Takes the notice that a language did not arrive.
    pub(crate) send: Callback<Action>,
}

/// Has somebody told the language that is spoken, whenever that changes.
pub(crate) fn tell_workers(tell: Callback<String>) {
    WORKERS.with(|workers| {
        let mut all = workers.get();
        all.push(tell);
        workers.set(all);
    });
}

/// Speaks a language from now on, and keeps the choice; an empty tag leaves it to the
/// browser.
pub(crate) fn choose(tag: &str, send: &Callback<Action>) {
    keep::keep_language(tag);
    keep::forget_linked_language();
    CHOSEN.with(|chosen| chosen.set(Some(tag.to_owned())));
    let send = send.clone();
    spawn_local(async move {
        if let Err(error) = turn_to(wanted()).await {
            send.emit(Action::File(FileAction::Tell(
                Notice::refusal(tr_data!(
                    "The language did not arrive; the page stays as it is."
                ))
                .with([error]),
            )));
        }
    });
}

/// The tag of a language that the page speaks, of a tag that may name a region, too.
fn known(tag: &str) -> Option<&'static str> {
    let own = tag.split('-').next()?.to_lowercase();
    all().map(|(tag, _)| tag).find(|known| *known == own)
}

/// The language to speak.
fn wanted() -> &'static str {
    if let Some(chosen) = known(&choice()) {
        return chosen;
    }
    let languages = gloo::utils::window().navigator().languages();
    let mut asked = languages.iter().filter_map(|tag| tag.as_string());
    asked.find_map(|tag| known(&tag)).unwrap_or(ENGLISH)
}

async fn turn_to(tag: &'static str) -> Result<(), String> {
    if tag == SPOKEN.get() {
        return Ok(());
    }
    let mut all = FETCHED.with(Held::get).into_iter();
    let fetched = match all.find(|fetched| fetched.tag == tag) {
        _ if tag == ENGLISH => None,
        Some(fetched) => Some(fetched),
        None => Some(fetch(tag).await?),
    };
    // Another one may have been chosen while it was on its way.
    if wanted() != tag {
        return Ok(());
    }
    speak(fetched.as_ref().map(|fetched| fetched.catalogue));
    SPOKEN.set(tag);
    let document = gloo::utils::document();
    document.set_title(tr!("Giveway: plans for several robots, proved best"));
    if let Some(root) = document.document_element() {
        // The name of the attribute is valid.
        let _ = root.set_attribute("lang", tag);
    }
    // The page first: the course is moved while that is made anew.
    if let Some(changed) = CHANGED.with(Held::get) {
        changed.emit(tag);
    }
    tell(fetched.as_ref().map_or("", |fetched| &fetched.told));
    Ok(())
}

async fn fetch(tag: &'static str) -> Result<Fetched, String> {
    let po = files::fetch_language(tag).await?;
    let catalogue = language::catalogue(tag, &po).map_err(|fault| format!("{tag}.po, {fault}"))?;
    let told = language::told(tag, &po);
    let new = Fetched {
        tag,
        catalogue,
        told,
    };
    FETCHED.with(|fetched| {
        let mut all = fetched.get();
        all.push(new.clone());
        fetched.set(all);
    });
    Ok(new)
}
