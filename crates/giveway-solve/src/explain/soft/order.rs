//! Of plans that are equally good the one with the earliest breaches.

use giveway_model::sorting::sort;

use super::{Breach, SoftRules};
use crate::{
    budget::Stop,
    sat::{Clauses, Lit, Outcome},
    search::Team,
};

impl SoftRules<'_, '_, '_> {
    /// Of all that is equally good, that with the earliest breaches.
    pub(super) fn order_breaches(
        &mut self,
        mut breaches: Vec<Breach>,
        mut fixed: Vec<Lit>,
    ) -> Result<(), Stop> {
        sort(&mut breaches);
        let Some(count) = self.best.as_ref().map(|(best, _)| best.count) else {
            return Ok(());
        };
        if matches!(self.team.solve(&fixed)?, Outcome::Unsat(_)) {
            return Err(Stop::Contradiction);
        }
        let mut from = 0;
        for _ in 0..count {
            let holds = |team: &Team, from: usize| {
                let mut rest = breaches.iter().enumerate().skip(from);
                rest.find(|(_, (_, lit))| team.is_true(*lit))
                    .map(|(i, _)| i)
            };
            let Some(mut first) = holds(&self.team, from) else {
                break;
            };
            self.keep_model();
            while first > from {
                let sooner = self.team.clauses().fresh();
                let mut clause = vec![!sooner];
                clause.extend(breaches[from..first].iter().map(|&(_, lit)| lit));
                self.team.clauses().clause(&clause);
                let mut assumptions = fixed.clone();
                assumptions.push(sooner);
                if matches!(self.team.solve(&assumptions)?, Outcome::Unsat(_)) {
                    break;
                }
                let Some(found) = holds(&self.team, from) else {
                    break;
                };
                first = found;
                self.keep_model();
            }
            fixed.push(breaches[first].1);
            from = first + 1;
            if matches!(self.team.solve(&fixed)?, Outcome::Unsat(_)) {
                return Err(Stop::Contradiction);
            }
        }
        self.keep_model();
        Ok(())
    }
}
