//! The scene as the board shows it: the world at the time shown, and who is where in it.

use std::rc::Rc;

use giveway_model::{Agent, Cell};

use crate::course::World;
use crate::gesture::Canvas;
use crate::{Draft, State};

impl State {
    /// The agent that is shown on a cell at the time shown: where the plan has
    /// it then (in transit it is on both cells), or at its start without a plan.
    pub fn agent_at(&self, cell: Cell) -> Option<usize> {
        self.agents_at(cell).next()
    }

    /// All agents that are shown there: in a plan that breaks rules there may be several.
    pub(crate) fn agents_at(&self, cell: Cell) -> impl Iterator<Item = usize> + '_ {
        let draft = self.world();
        let is_on = move |&(index, agent): &(usize, &Agent)| {
            if !self.is_there(index) {
                return false;
            }
            let (name, start) = (agent.name.as_str(), agent.start);
            let plan = self
                .shown()
                .filter(|answer| answer.agent(draft, index).is_some());
            let plan = plan.and_then(|answer| answer.plan());
            let path = plan.map_or(&[][..], |plan| plan.path(name));
            let from = plan.and_then(|plan| plan.from.get(name)).copied();
            let time = self.view.playback.time.saturating_sub(from.unwrap_or(0)) as usize;
            match path.get(time) {
                None => path.last().copied().flatten().unwrap_or(start) == cell,
                Some(Some(at)) => *at == cell,
                Some(None) => [time.wrapping_sub(1), time + 1]
                    .iter()
                    .any(|&t| path.get(t) == Some(&Some(cell))),
            }
        };
        let agents = draft.agents().iter().enumerate();
        agents.filter(is_on).map(|(index, _)| index)
    }

    /// The scene as the board shows it: with the stroke that is not finished,
    /// and as the world has it at the time shown. Its agents are all that there
    /// ever are.
    pub fn world(&self) -> &Rc<Draft> {
        match self.stroke().map(|stroke| &stroke.canvas) {
            Some(Canvas::Scene { shown, .. }) => shown,
            Some(Canvas::World { after, .. }) => after.draft(),
            None => self
                .changed()
                .map_or(&self.document.draft, |world| &world.draft),
        }
    }

    /// The look of each agent of [`State::world`], and of the next one that comes: one of
    /// the scene has its own, those that join have the next ones.
    pub fn looks(&self) -> Vec<usize> {
        let (own, world) = (self.document.draft.agents(), self.world().agents());
        let document = &self.document;
        if own.len() == world.len() {
            return document.looks.all(world.len() + 1);
        }
        document.looks.after(own, world).all(world.len() + 1)
    }

    /// Whether an agent of [`State::world`] is there at the time shown.
    pub fn is_there(&self, agent: usize) -> bool {
        let world = match self.stroke().map(|stroke| &stroke.canvas) {
            Some(Canvas::World { after, .. }) => Some(&after.world),
            Some(Canvas::Scene { .. }) => None,
            None => self.changed(),
        };
        match world {
            Some(world) => world.is_there.get(agent).copied().unwrap_or(false),
            None => agent < self.world().agents().len(),
        }
    }

    /// The world at the time shown, where it is another than the draft.
    fn changed(&self) -> Option<&World> {
        self.document.changed(self.view.playback.time)
    }
}
