//! What opens over the page.

mod agents;
mod examples;
mod frame;
mod help;
mod new_scene;
mod popover;
mod report;
mod save_as;
mod scenes;
mod share;

use std::rc::Rc;

use giveway_page::files::Choice;

pub(crate) use agents::{Agents, AgentsProps};
pub(crate) use examples::{Examples, ExamplesProps};
pub(crate) use frame::Frame;
pub(crate) use help::help;
pub(crate) use new_scene::{NewScene, NewSceneProps};
pub(crate) use popover::use_dismiss;
pub(crate) use report::{Report, ReportProps, sheet as report_sheet};
pub(crate) use save_as::{SaveAs, SaveAsProps};
pub(crate) use scenes::{Scenes, ScenesProps};
pub(crate) use share::{Share, ShareProps};

/// What is open: at most one thing at a time.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) enum Panel {
    /// Nothing.
    #[default]
    Nothing,
    /// The menu of a phone.
    Menu,
    /// From where a scene can come.
    Open,
    /// What can be saved.
    Save,
    /// The settings.
    Settings,
    /// Planners of the textbook.
    Planners,
    /// The examples.
    Examples,
    /// How many agents of a scenario are wanted.
    Agents(Rc<Choice>),
    /// The size and name of a new scene.
    New,
    /// The report of the plan.
    Report,
    /// Formats of other makers, to save in.
    SaveAs,
    /// The scenes that are kept.
    Scenes,
    /// The link, to be copied.
    Share(yew::AttrValue),
    /// Something of the course: a lesson, or what its address says.
    Course(String),
    /// The keys.
    Help,
}
