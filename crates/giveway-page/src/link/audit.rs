//! A plan of elsewhere in a text, judged anew when it is read.

use std::rc::Rc;

use giveway_formats::link::audit::{self, AuditedPlans};
use giveway_model::Plan;

use crate::audit::{Audit, Beside, Dropped};
use crate::{Answer, Draft};

/// The audit as text.
pub(super) fn write(about: &Audit, own: Option<&Plan>) -> String {
    let plans = about.plans.iter();
    let chosen = plans.clone().position(|one| Rc::ptr_eq(one, &about.plan));
    let audited = AuditedPlans {
        files: plans.map(|dropped| dropped.file.clone()).collect(),
        notes: about.notes.clone(),
        chosen: chosen.and_then(|at| u32::try_from(at).ok()).unwrap_or(0),
        beside: match about.beside {
            Beside::Nothing => 0,
            Beside::Other => 1,
            Beside::InPlace => 2,
        },
    };
    audit::write(about.plan.answer.draft.agents(), audited, own)
}

/// The audit that a text tells; `None` where it is broken.
pub(super) fn read(draft: &Rc<Draft>, own: Option<&Rc<Answer>>, text: &str) -> Option<Audit> {
    let own = own.and_then(|own| own.plan());
    let audited = audit::read(draft.agents(), own, text)?;
    let plans = audited.files.into_iter();
    let plans = plans.map(|file| Dropped::new(draft, file).map(Rc::new));
    let plans: Vec<Rc<Dropped>> = plans.collect::<Option<_>>()?;
    let plan = plans.get(audited.chosen as usize).cloned()?;
    let audit = Audit::new(plans, audited.notes, Rc::default())?;
    Some(Audit {
        plan,
        beside: match audited.beside {
            1 => Beside::Other,
            2 => Beside::InPlace,
            _ => Beside::Nothing,
        },
        ..audit
    })
}
