//! The costs of one agent, as literals of which so many hold.

use giveway_model::Cost;

use super::{Cnf, Lit, Name, Walker};

impl Walker<'_> {
    /// The literals of which as many hold as it has of a cost.
    pub(in crate::plain) fn counted(&self, cnf: &mut Cnf, cost: Cost) -> Vec<Lit> {
        match cost {
            Cost::Makespan | Cost::SumOfCosts => self.not_done(),
            Cost::Charges => self.charges(),
            Cost::Moves => self.moves(cnf),
            Cost::Waits => self.waits(cnf),
            // It has weights (`constraints/penalty.rs`).
            Cost::Penalty => Vec::new(),
        }
    }

    /// As many of these hold as its arrival is late, the first ones.
    fn not_done(&self) -> Vec<Lit> {
        let last = self.world.last as usize;
        self.done.iter().take(last).map(|done| -done).collect()
    }

    /// Whether it charges, at each time.
    fn charges(&self) -> Vec<Lit> {
        self.charge.iter().flatten().copied().collect()
    }

    /// Whether it begins a move, at each time: it is somewhere else next, and
    /// has not vanished.
    fn moves(&self, cnf: &mut Cnf) -> Vec<Lit> {
        let mut moves = Vec::new();
        for time in 0..self.world.last {
            let begins = cnf.variable(Name::Move(self.world.index, time));
            for (&u, &here) in &self.at[time as usize] {
                let stays = self.at(u, time + 1).into_iter().chain(self.gone(time + 1));
                cnf.implies(&[here], stays.chain([begins]));
            }
            moves.push(begins);
        }
        moves
    }

    /// Whether it waits before its arrival, at each time.
    fn waits(&self, cnf: &mut Cnf) -> Vec<Lit> {
        let mut waits = Vec::new();
        for time in 0..self.world.last {
            let waits_now = cnf.variable(Name::Wait(self.world.index, time));
            for (&u, &here) in &self.at[time as usize] {
                if let Some(still) = self.at(u, time + 1) {
                    cnf.implies(&[here, still], [self.done[time as usize], waits_now]);
                }
            }
            waits.push(waits_now);
        }
        waits
    }
}
