//! What is saved: texts, and names for their files.

use std::rc::Rc;

use giveway_model::format::native;

use crate::{State, link};

/// A file to be saved.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Saved {
    /// Its name.
    pub name: String,
    /// What is in it.
    pub text: String,
}

/// The scene on the board, in the project's own JSON.
///
/// ```
/// use giveway_page::{Draft, State, files};
/// let saved = files::scene_file(&State::new(Draft::default()));
/// assert_eq!(saved.name, "scene.json");
/// ```
pub fn scene_file(state: &State) -> Saved {
    let scene = state.document.draft.scene();
    Saved {
        name: format!("{}.json", file_stem(&scene.name, "scene")),
        text: native::write_scene(scene),
    }
}

/// The plan of the scene, or that of one's own where one is led; `None` without one, and where it is stale, since it
/// would not fit the scene that is saved.
pub fn plan_file(state: &State) -> Option<Saved> {
    let mode = &state.document.mode;
    let own = mode.steering().map(|own| &*own.answer);
    // A plan of elsewhere is saved as it was read.
    let plan = match mode.audit() {
        Some(audit) => &audit.plan.file.plan,
        None => own
            .or(state.document.fresh_answer().map(Rc::as_ref))?
            .plan()?,
    };
    let stem = file_stem(&state.document.draft.scene().name, "scene");
    Some(Saved {
        name: format!("{stem}-plan.json"),
        text: native::write_plan(plan),
    })
}

/// The robots of the scene as a table for spreadsheets; `None` without any.
///
/// ```
/// use giveway_page::{Draft, State, files};
/// assert_eq!(files::robots_file(&State::new(Draft::default())), None);
/// ```
pub fn robots_file(state: &State) -> Option<Saved> {
    let scene = state.document.draft.scene();
    (!scene.agents.is_empty()).then(|| Saved {
        name: format!("{}-robots.csv", file_stem(&scene.name, "scene")),
        text: crate::robots::csv(state),
    })
}

/// How many robots the floor bears, as a table; `None` before that is known.
pub fn sizing_file(state: &State) -> Option<Saved> {
    let name = &state.own_document().draft.scene().name;
    Some(Saved {
        name: format!("{}-how-many.csv", file_stem(name, "scene")),
        text: crate::sizing::table(state)?,
    })
}

/// How the plan was found and proved; `None` where no record was kept.
pub fn trace_file(state: &State) -> Option<Saved> {
    let trace = crate::inside::record(state)?;
    let stem = file_stem(&state.document.draft.scene().name, "scene");
    Some(Saved {
        name: format!("{stem}-trace.json"),
        text: serde_json::to_string_pretty(trace).ok()?,
    })
}

/// What changed while the plan ran; `None` where nothing did, and where the plan
/// is stale.
pub fn changes_file(state: &State) -> Option<Saved> {
    let course = state.document.fresh_answer()?.course.as_deref()?;
    let stem = file_stem(&state.document.draft.scene().name, "scene");
    Some(Saved {
        name: format!("{stem}-changes.json"),
        text: native::write_changes(&course.changes),
    })
}

/// The name of the file with what must be so in every best plan. The reader writes it:
/// the code for that is large.
pub(crate) fn freedom_name(state: &State) -> String {
    let stem = file_stem(&state.document.draft.scene().name, "scene");
    format!("{stem}-freedom.json")
}

/// All that the browser keeps of the page, to be kept elsewhere.
///
/// ```
/// use giveway_page::{Draft, State, files};
/// let saved = files::kept_file(&State::new(Draft::default()));
/// assert_eq!(saved.name, "scene.giveway");
/// ```
pub fn kept_file(state: &State) -> Saved {
    let stem = file_stem(&state.document.draft.scene().name, "scene");
    Saved {
        name: format!("{stem}.giveway"),
        text: link::keep(state),
    }
}

/// The name of a file about the scene, such as `depot-report.html`.
pub(crate) fn name_of(state: &State, what: &str) -> String {
    let stem = file_stem(&state.document.draft.scene().name, "scene");
    format!("{stem}-{what}")
}

/// The name of an archive of certificates.
pub(crate) fn certificate_name(state: &State) -> String {
    let stem = file_stem(&state.document.draft.scene().name, "scene");
    format!("{stem}-certificate.zip")
}

/// The name of a picture of the board at the time shown, with its ending.
///
/// ```
/// use giveway_page::{Draft, State, files};
/// let state = State::new(Draft::default());
/// assert_eq!(files::picture_name(&state, "svg"), "scene-0.svg");
/// ```
pub fn picture_name(state: &State, ending: &str) -> String {
    let stem = file_stem(&state.document.draft.scene().name, "scene");
    format!("{stem}-{}.{ending}", state.view.playback.time)
}

/// The longest name that is made, in characters.
const LONGEST: usize = 60;

/// A scene's name as a file's: letters, figures, `-`, `_`; all else is one `-`.
fn file_stem(name: &str, otherwise: &str) -> String {
    let keeps = |c: char| c.is_alphanumeric() || c == '_';
    let words = name.split(|c| !keeps(c)).filter(|word| !word.is_empty());
    let stem: String = words.collect::<Vec<_>>().join("-");
    match stem.chars().take(LONGEST).collect::<String>() {
        stem if stem.is_empty() => otherwise.to_owned(),
        stem => stem,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_of_files() {
        let check = |name, expect: &str| assert_eq!(file_stem(name, "scene"), expect);
        check("warehouse", "warehouse");
        check("scenario 6", "scenario-6");
        check("../../etc/passwd", "etc-passwd");
        check("Größe_2", "Größe_2");
        check("", "scene");
        check("...", "scene");
        assert_eq!(file_stem(&"x".repeat(100), "scene").len(), LONGEST);
    }
}
