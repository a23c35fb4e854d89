//! Core-guided minimisation: OLL (Andres et al. 2012; Morgado, Dodaro and
//! Marques-Silva 2014), with the rounds of RC2 (Ignatiev, Morgado and Marques-Silva
//! 2019).
//!
//! A *soft* is something to be kept if that can be; its literal is assumed. A core names
//! softs that cannot all be kept: at least one is violated, so the sum of violations is
//! at least one more than was known. Each soft of the core is *raised*, which means that
//! its next level is kept instead, if it has one; and a totalizer counts the violations
//! of the core, of which the core pays for one: that there is no second one is a soft,
//! too, and is raised in turn. When all that is assumed holds together, there are no more
//! violations than cores.
//!
//! Cores that share nothing are collected first: what a core sets free waits, and is not
//! assumed before the next round.
//!
//! Each level costs one. What weighs more has a level for each unit of its weight.

use std::collections::BTreeMap;

use giveway_model::sorting::sort_by_key;

use crate::{
    budget::Stop,
    encode::totalizer::totalizer,
    sat::{Clauses, Lit},
};

/// The formula over which softs are stated; it grows.
pub(super) trait Formula {
    /// The collector of its clauses.
    type Out: Clauses;

    /// The collector of its clauses.
    fn clauses(&mut self) -> &mut Self::Out;
}

/// A level of something that is better the lower it is.
pub(super) trait Level: Copy {
    /// The level that costs so much more; `None` where nothing is beyond.
    fn raised(self, by: u32) -> Option<Self>;
}

/// A level that a formula can keep.
pub(super) trait Kept<F>: Level {
    /// The literal that says it is kept; `None` where it is kept anyway.
    fn literal(self, formula: &mut F) -> Result<Option<Lit>, Stop>;

    /// The literal that says it is violated, where a core names it for the first time.
    fn violation(self, kept: Lit, _: &mut F) -> Result<Option<Lit>, Stop> {
        Ok(Some(!kept))
    }
}

/// A soft constraint.
#[derive(Clone, Copy, Debug)]
pub(super) enum Soft<L> {
    /// A level is kept.
    Level(L),
    /// At most `k` violations of a core.
    Total { totalizer: usize, k: usize },
}

impl<L: Level> Soft<L> {
    /// The same at a level that costs so much more.
    pub(super) fn raised(self, by: u32) -> Option<Self> {
        match self {
            Self::Level(level) => level.raised(by).map(Self::Level),
            Self::Total { totalizer, k } => Some(Self::Total {
                totalizer,
                k: k + by as usize,
            }),
        }
    }

    /// The level, if it is one.
    pub(super) fn level(self) -> Option<L> {
        match self {
            Self::Level(level) => Some(level),
            Self::Total { .. } => None,
        }
    }
}

/// The violations of a core, not counted yet.
pub(super) struct Paid {
    /// The number of the core.
    number: usize,
    violations: Vec<Lit>,
}

/// The count of a core's violations.
struct Total {
    /// The number of the core.
    core: usize,
    /// Literals for "more than so many", in order.
    more_than: Vec<Lit>,
}

/// A core-guided search under way.
pub(super) struct Oll<L> {
    /// The assumed softs, by literal.
    pub(super) assumed: BTreeMap<Lit, Soft<L>>,
    /// Softs relaxed by cores, to be assumed in the next round.
    pub(super) waiting: Vec<Soft<L>>,
    /// Cores of this round, to be counted with the next one.
    pub(super) uncounted: Vec<Paid>,
    totals: Vec<Total>,
    /// How many cores have paid.
    cores: usize,
}

impl<L> Oll<L> {
    /// Nothing is assumed yet.
    pub(super) const fn new() -> Self {
        Self {
            assumed: BTreeMap::new(),
            waiting: Vec::new(),
            uncounted: Vec::new(),
            totals: Vec::new(),
            cores: 0,
        }
    }
}

impl<L: Level> Oll<L> {
    /// Assumes a soft, or nothing where it holds anyway.
    pub(super) fn assume<F>(&mut self, formula: &mut F, soft: Soft<L>) -> Result<(), Stop>
    where
        L: Kept<F>,
    {
        if let Some(lit) = self.literal(formula, soft)? {
            self.assumed.insert(lit, soft);
        }
        Ok(())
    }

    /// The literal of a soft; `None` where it holds anyway.
    pub(super) fn literal<F>(&self, formula: &mut F, soft: Soft<L>) -> Result<Option<Lit>, Stop>
    where
        L: Kept<F>,
    {
        match soft {
            Soft::Level(level) => level.literal(formula),
            Soft::Total { totalizer, k } => Ok(self.more_than(totalizer, k).map(|more| !more)),
        }
    }

    /// The literal "more than `k`" violations of a core; `None` where it has no more.
    pub(super) fn more_than(&self, totalizer: usize, k: usize) -> Option<Lit> {
        self.totals.get(totalizer)?.more_than.get(k).copied()
    }

    /// The number of the core whose violations a totalizer counts.
    pub(super) fn core_of(&self, totalizer: usize) -> Option<usize> {
        self.totals.get(totalizer).map(|total| total.core)
    }

    /// All that is assumed, in the order of assumptions: by literal, or what many softs
    /// share first.
    pub(super) fn assumptions(&self, totals_first: bool) -> Vec<Lit> {
        let mut softs: Vec<(Lit, Soft<L>)> = self.assumed.iter().map(|(&l, &s)| (l, s)).collect();
        if totals_first {
            sort_by_key(&mut softs, |(_, soft)| matches!(soft, Soft::Level(_)));
        }
        softs.into_iter().map(|(lit, _)| lit).collect()
    }

    /// Whether anything waits for the next round.
    pub(super) fn is_waiting(&self) -> bool {
        !self.waiting.is_empty() || !self.uncounted.is_empty()
    }

    /// The softs of a core, which are not assumed any more.
    pub(super) fn take(&mut self, core: &[Lit]) -> Vec<Soft<L>> {
        let softs = core.iter().filter_map(|lit| self.assumed.remove(lit));
        softs.collect()
    }

    /// A core of these violations pays for one: a single one is certain, further ones
    /// are to be counted.
    pub(super) fn record_core(&mut self, formula: &mut impl Formula, violations: Vec<Lit>) {
        if let [violation] = *violations {
            formula.clauses().clause(&[violation]);
        } else {
            let number = self.cores;
            self.uncounted.push(Paid { number, violations });
        }
        self.cores += 1;
    }

    /// Takes a core in: it pays, and its softs wait at their next levels.
    pub(super) fn add_core<F: Formula>(&mut self, formula: &mut F, core: &[Lit]) -> Result<(), Stop>
    where
        L: Kept<F>,
    {
        let mut violations = Vec::new();
        for lit in core {
            let Some(soft) = self.assumed.remove(lit) else {
                continue;
            };
            violations.extend(match soft {
                Soft::Level(level) => level.violation(*lit, formula)?,
                Soft::Total { .. } => Some(!*lit),
            });
            self.waiting.extend(soft.raised(1));
        }
        self.record_core(formula, violations);
        Ok(())
    }

    /// Begins a round: all that cores set free is assumed again. Whether a core had to be
    /// counted for that.
    pub(super) fn begin_round<F: Formula>(&mut self, formula: &mut F) -> Result<bool, Stop>
    where
        L: Kept<F>,
    {
        for soft in std::mem::take(&mut self.waiting) {
            self.assume(formula, soft)?;
        }
        let counts = !self.uncounted.is_empty();
        for total in self.count_from(formula, 0)? {
            self.assume(formula, total)?;
        }
        Ok(counts)
    }

    /// Counts the violations of the cores of this round, from the `first` on: that no
    /// more than one of each are violated.
    pub(super) fn count_from(
        &mut self,
        formula: &mut impl Formula,
        first: usize,
    ) -> Result<Vec<Soft<L>>, Stop> {
        let mut softs = Vec::new();
        for Paid { number, violations } in self.uncounted.split_off(first) {
            self.totals.push(Total {
                core: number,
                more_than: totalizer(&violations, formula.clauses())?,
            });
            let totalizer = self.totals.len() - 1;
            softs.push(Soft::Total { totalizer, k: 1 });
        }
        Ok(softs)
    }

    /// Makes all that is assumed hold for good.
    pub(super) fn harden(&self, formula: &mut impl Formula) {
        for &lit in self.assumed.keys() {
            formula.clauses().clause(&[lit]);
        }
    }
}
