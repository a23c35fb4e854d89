//! An agent that helps by doing less helps by doing nothing: the plan without it costs no more.

use super::{
    super::{
        answer::{Edit, Repair},
        edits::edited,
    },
    EditedPlan,
    candidate::Candidate,
    search::RepairSearch,
};

impl RepairSearch<'_> {
    /// Of each edit that helps and is about one agent: that leaving the agent out helps, too, with a plan
    /// that is at least as good.
    pub(super) fn leave_out_who_helps(&mut self) {
        for (agent, repair) in self.of_one_agent() {
            let edits = vec![Edit::LeaveOut { agent }];
            let broken = self.broken;
            let variant = edited(broken.instance, &edits, broken.within, broken.whole);
            if let Some(rest) = self.rest_of(&repair.plan, &variant) {
                self.improve(edits, rest);
            }
        }
    }

    /// Repairs of one edit that lets an agent do less, or gives it more, with that agent; never one that
    /// is asked about.
    fn of_one_agent(&self) -> Vec<(String, Repair)> {
        let agents = self.broken.instance.agents();
        let asked = self.broken.asked.iter().filter_map(|&it| agents.get(it));
        let asked: Vec<&String> = asked.map(|agent| &agent.name).collect();
        let of_one = |repair: &Repair| match &repair.edits[..] {
            [Edit::DropWaypoint { agent, .. } | Edit::Battery { agent, .. }] => (agents.len() > 1
                && !asked.contains(&agent))
            .then(|| (agent.clone(), repair.clone())),
            _ => None,
        };
        self.tried.found.iter().filter_map(of_one).collect()
    }

    /// Keeps a plan after some edits, where none as good is known.
    fn improve(&mut self, edits: Vec<Edit>, rest: EditedPlan) {
        let mut known = self.tried.found.iter();
        let known = known.position(|repair| repair.edits == edits);
        let is_better =
            |it: &Repair| !it.proved && self.vector(&rest.costs) < self.vector(&it.costs);
        let place = match known {
            Some(place) if is_better(&self.tried.found[place]) => place,
            Some(_) => return,
            None => self.tried.found.len(),
        };
        let edit = edits.first().cloned().map(Candidate::Edit);
        let repair = self.repair(edits, true, rest);
        if let Some(known) = self.tried.found.get_mut(place) {
            *known = repair;
        } else {
            self.tried.found.push(repair);
        }
        self.tried
            .outcomes
            .extend(edit.map(|edit| (edit, Some(true))));
    }
}
