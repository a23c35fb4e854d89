//! Plans that are none, in a world that changes.

use super::super::findings::{Findings, Place};
use super::super::{Rule, sentence, shape};
use crate::Plan;
use crate::change::{Career, History};

pub(super) fn find(history: &History, plan: &Plan, findings: &mut Findings<'_>) {
    let careers = history.careers();
    for (index, career) in careers.iter().enumerate() {
        let name = career.name();
        let end = career
            .until
            .map_or(shape::End::Arrives, |_| shape::End::Gone);
        match plan.paths.get(name) {
            None => shape::push(findings, index, career.from, sentence::no_path(name)),
            Some(path) => shape::find_in_path(path, index, name, (career.from, end), findings),
        }
        shape::find_in_charges(plan.charges(name), index, name, findings);
        find_times(career, plan, index, findings);
    }
    let names = careers.iter().map(Career::name).collect();
    shape::find_strangers(names, plan, findings);
}

/// When it appears, and when it is gone.
fn find_times(career: &Career, plan: &Plan, index: usize, findings: &mut Findings<'_>) {
    let name = career.name();
    if !plan.paths.contains_key(name) {
        return; // which is told already
    }
    let from = plan.from.get(name).copied().unwrap_or(0);
    if from != career.from {
        let message = sentence::wrong_from(name, from, career.from);
        shape::push(findings, index, from, message);
    }
    let until = plan.until.get(name).copied();
    if until != career.until {
        let message = sentence::wrong_until(name, until, career.until);
        shape::push(
            findings,
            index,
            until.or(career.until).unwrap_or(0),
            message,
        );
    }
    let Some(until) = career.until else { return };
    let path = plan.path(name);
    let listed = path.len() as u32;
    let due = until.saturating_sub(career.from);
    // Whoever had arrived is known to have been there.
    let arrived = path.last().copied().flatten() == Some(career.goal());
    if listed > due || (listed < due && !(arrived && listed > 0)) {
        let last = career.from + listed.saturating_sub(1);
        let message = sentence::wrong_end(name, last, until);
        findings.push(
            Rule::Shape,
            last as usize,
            &[index],
            Place::Nowhere,
            message,
        );
    }
}
