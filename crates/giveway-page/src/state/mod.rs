//! The state of the page: a document, what runs in the worker, what is shown.

mod displaced;
mod hand;
mod notice;
mod offered;
mod shown;
mod world;

use std::rc::Rc;

use crate::history::Moment;
use crate::inside::Inside;
use crate::intake::Intake;
use crate::lesson::Lesson;
use crate::{Document, Draft, History, Place, Selection, Settings, View, Work};

pub use displaced::{By, Displaced};
pub use notice::{Notice, NoticeKind};

/// All that the page shows. Plain data: two equal states look the same.
#[derive(Clone, Debug, PartialEq)]
pub struct State {
    /// All that a person made or got and would miss, with what is being done
    /// with it.
    pub document: Document,
    /// What runs in the worker.
    pub work: Work,
    /// Other people's files on their way in.
    pub intake: Intake,
    /// What is looked at of how the plan was found.
    pub inside: Inside,
    /// What is shown of the document, and how.
    pub view: View,
    /// What a person set, for all scenes.
    pub settings: Settings,
    /// Undo and redo.
    pub history: History,
    /// The document that another one replaced. One press brings it back, until
    /// the new one is edited.
    pub displaced: Option<Displaced>,
    /// The lesson on the board. All else is then about its board: a person's own page
    /// is put aside in it.
    pub(crate) lesson: Option<Rc<Lesson>>,
}

impl State {
    /// A page that shows a draft and nothing else yet.
    ///
    /// ```
    /// use giveway_model::Scene;
    /// use giveway_page::{Draft, Phase, State};
    /// let scene = Scene { map: vec!["..".into()], ..Scene::default() };
    /// let state = State::new(Draft::new(scene).unwrap());
    /// assert_eq!(state.phase(), Phase::Editing);
    /// ```
    pub fn new(draft: Draft) -> Self {
        Self::of(Document::new(draft))
    }

    /// A page that shows a document.
    pub fn of(document: Document) -> Self {
        Self {
            document,
            work: Work::default(),
            intake: Intake::default(),
            inside: Inside::default(),
            view: View::default(),
            settings: Settings::default(),
            history: History::default(),
            displaced: None,
            lesson: None,
        }
    }

    /// The page as it was left.
    pub(crate) fn resumed(moment: Moment, history: History) -> Self {
        let mut state = Self::of(moment.document);
        state.view.selection = moment.selection;
        state.view.playback.stop_at(moment.time);
        state.history = history;
        crate::reduce::settle(&mut state);
        crate::reduce::go_on_auditing(&mut state);
        state
    }

    /// The document, and where it is looked at: at a time that it has by itself, as what
    /// else the board may show is not part of it.
    pub fn moment(&self) -> Moment {
        let last = if self.shows_passing() {
            let own = self.document.shown(false).filter(|own| self.plays(own));
            own.map_or(0, |own| own.makespan())
        } else {
            u32::MAX
        };
        Moment {
            document: self.own_document().clone(),
            time: self.view.playback.time.min(last),
            // Whoever comes back to a plan of their own sees the robot that they lead.
            selection: match self.document.mode.steering() {
                Some(own) => Selection::Agent(own.agent),
                None => match self.view.selection {
                    // It is not there at that time, and is not selected there either.
                    Selection::Agent(agent) if !self.is_there(agent) => Selection::Nothing,
                    selection => selection,
                },
            },
        }
    }

    /// Whether the page is inside another one.
    pub fn is_embedded(&self) -> bool {
        self.view.place == Place::Embedded
    }

    /// The agent that is selected, by its index in the scene.
    pub const fn selected_agent(&self) -> Option<usize> {
        match self.view.selection {
            Selection::Agent(agent) => Some(agent),
            Selection::Nothing | Selection::Cell(_) => None,
        }
    }

    /// The agent that the camera goes with, by its index in the scene. The board
    /// stands still under a hand that is doing something.
    pub fn followed(&self) -> Option<usize> {
        let follows = self.view.follow && !self.has_gesture();
        self.selected_agent().filter(|_| follows)
    }
}
