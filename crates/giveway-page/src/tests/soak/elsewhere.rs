//! Plans of elsewhere, by chance.

use std::rc::Rc;

use super::Session;
use crate::Action;
use crate::action::IntakeAction;
use crate::audit::AuditAction;
use crate::files::Opened;
use crate::intake::protocol::{Read, Task};
use crate::intake::work;

impl Session {
    /// A plan of elsewhere for the scene, of random steps.
    pub(super) fn dropped(&mut self) -> Vec<Action> {
        let scene = crate::files::scene_file(&self.state);
        let mut paths = Vec::new();
        for agent in self.state.document.draft.agents().to_vec() {
            let mut path = vec![agent.start];
            for _ in 0..self.rng.usize(0..5) {
                path.push(self.cell());
            }
            path.extend(agent.goal);
            let path: Vec<String> = path
                .iter()
                .map(|cell| format!("[{}, {}]", cell.x, cell.y))
                .collect();
            paths.push(format!("\"{}\": [{}]", agent.name, path.join(", ")));
        }
        let plan = format!("{{\"giveway\": 1, \"paths\": {{{}}}}}", paths.join(", "));
        let files = [(scene.name, scene.text), ("p.json".to_owned(), plan)];
        let files = files.map(|(name, text)| Opened {
            name,
            bytes: text.into_bytes(),
        });
        let job = self.state.intake.next_id();
        let read = Read {
            files: files.to_vec(),
            ..Read::default()
        };
        let reply = Rc::new(work(Task::Read(read)));
        vec![
            Action::Intake(IntakeAction::Read(files.to_vec())),
            Action::Intake(IntakeAction::Reply { job, reply }),
        ]
    }

    /// What is done with it.
    pub(super) fn audit(&mut self) -> AuditAction {
        let is = self.rng.bool();
        match self.rng.u8(0..9) {
            6 => AuditAction::Begin,
            7 => AuditAction::Show(self.rng.usize(0..4)),
            8 => AuditAction::Next,
            0 => AuditAction::Find,
            1 => AuditAction::Compare(is),
            2 => AuditAction::ShowOther(is),
            3 => AuditAction::Take,
            4 => AuditAction::Choose(self.rng.usize(0..2)),
            _ => AuditAction::Leave,
        }
    }
}
