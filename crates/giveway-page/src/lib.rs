//! The playground's page as plain data.
//!
//! A [`State`] and an [`Action`] give the next state ([`reduce()`]); what each
//! place of the page shows is a function of the state. Nothing here draws,
//! waits, or knows that there is a browser: the page (`web/`) shows the state,
//! sends actions, and runs what [`State::work`] says should run.

#![cfg_attr(
    test,
    allow(
        clippy::float_cmp,
        reason = "what is drawn is compared with what is exact in binary"
    )
)]

mod action;
mod answer;
pub mod area;
pub mod ask;
mod asking;
pub mod audit;
pub mod beside;
pub mod board;
pub mod certificate;
pub mod changing;
pub mod course;
mod document;
mod draft;
pub mod draw;
mod edit;
pub mod examples;
pub mod files;
pub mod find;
pub mod fleet;
pub mod floor_plan;
pub mod freedom;
pub mod front;
mod gesture;
pub mod grow;
mod history;
pub mod inside;
pub mod inspect;
pub mod intake;
mod kept;
pub mod keys;
mod known;
pub mod ledger;
pub mod lesson;
mod line;
pub mod link;
mod mode;
pub mod number;
pub mod objective;
pub mod opening;
pub mod order;
mod phase;
pub mod planners;
mod playback;
pub mod present;
mod problems;
pub mod proof;
mod reduce;
pub mod report;
mod reserve;
pub mod robots;
pub mod rules;
#[cfg(test)]
mod sample;
mod settings;
pub mod sheet;
pub mod sizing;
pub mod slot;
mod state;
pub mod steering;
pub mod table;
#[cfg(test)]
mod tests;
pub mod timeline;
mod tool;
mod view;
pub mod words;
mod work;

pub use action::{
    Action, AskAction, BoardAction, ChangeAction, FileAction, IntakeAction, PlayAction,
    SolveAction, ViewAction, WorkerAction,
};
pub use answer::Answer;
pub use asking::{Asking, Lit, found_better};
pub use document::Document;
pub use draft::{Draft, MAX_AGENTS, MAX_SIDE};
pub use edit::{AreaEdit, Axis, DENSEST, Edit, Fill, Lines, Lost, Paint, Reshape, RuleEdit, Sides};
pub use gesture::Placing;
pub use giveway_picture::gif::Shot;
pub use giveway_picture::{COLOURS, Colours, Looks, Point, Theme as DrawnTheme, form, position};
pub use history::{History, Moment};
pub use intake::Save;
pub use mode::{Activity, Mode};
pub use phase::Phase;
pub use playback::{Playback, Speed};
pub use problems::Problem;
pub use reduce::reduce;
pub use reserve::Reserve;
pub use settings::{Settings, Theme};
pub use slot::SlotAction;
pub use state::{By, Displaced, Notice, NoticeKind, State};
pub use tool::Tool;
pub use view::{ComparedLanes, Fold, Folds, Layers, Place, Selection, Sought, Tab, View};
pub use work::{Adapting, Arrival, Certifies, Certifying, Job, Size, Solving, Task, Work};
