//! A spent budget stops a call, with the right reason, and for good.

use std::cell::Cell;
use std::rc::Rc;

use crate::{
    Host, Limits, Progress, SilentHost,
    budget::{Budget, Stop},
    sat::{Clauses, Lit, Outcome, Sat},
};

/// A hole less than pigeons: unsatisfiable, and hard to prove for more than nine.
fn add_pigeons(sat: &mut Sat, pigeons: usize) {
    let holes = pigeons - 1;
    let nests: Vec<Vec<Lit>> = (0..pigeons)
        .map(|_| (0..holes).map(|_| sat.fresh()).collect())
        .collect();
    for (i, nest) in nests.iter().enumerate() {
        sat.clause(nest);
        for other in &nests[..i] {
            for (&here, &there) in nest.iter().zip(other) {
                sat.clause(&[!here, !there]);
            }
        }
    }
}

/// Solves eleven pigeons, expects the stop, and tries what may come after it.
#[track_caller]
fn check_stop(host: &dyn Host, limits: Limits, expect: Stop) -> Rc<Budget<'_>> {
    let budget = Rc::new(Budget::new(host, limits));
    let mut sat = Sat::new(Rc::clone(&budget));
    let early = sat.fresh();
    add_pigeons(&mut sat, 11);
    for _ in 0..3 {
        let stop = sat.solve(&[early]).unwrap_err();
        assert_eq!(stop, expect);
        let late = sat.fresh();
        sat.clause(&[!early, late]);
        let stop = sat.solve(&[!late]).unwrap_err();
        assert_eq!(stop, expect);
    }
    assert!(!sat.is_true(Lit::positive(1_000_000)));
    budget
}

#[test]
fn conflicts_stop_a_hard_formula() {
    let limits = Limits {
        conflicts: Some(2_000),
        ..Limits::default()
    };
    let budget = check_stop(&SilentHost, limits, Stop::Conflicts);
    let spent = budget.stats().conflicts;
    // Proofs are written, and so read, some kilobytes at a time.
    assert!((2_001..2_500).contains(&spent), "{spent} conflicts");
}

#[test]
fn derived_clauses_stop_it_too() {
    let budget = Rc::new(Budget::new(&SilentHost, Limits::default()).with_derived(500));
    let mut sat = Sat::new(Rc::clone(&budget));
    add_pigeons(&mut sat, 11);
    assert_eq!(sat.solve(&[]).unwrap_err(), Stop::Conflicts);
    assert!((501..1_000).contains(&budget.derived()));
    let part = budget.part(Limits::default());
    part.count_derived(1);
    assert_eq!(part.check(), Err(Stop::Conflicts), "nothing is left");
}

#[test]
fn clauses_that_are_only_rewritten_are_no_conflicts() {
    let budget = Rc::new(Budget::new(&SilentHost, Limits::default()));
    let mut sat = Sat::new(Rc::clone(&budget));
    let shared = sat.fresh();
    for _ in 0..100 {
        let [a, b, c] = [sat.fresh(), sat.fresh(), sat.fresh()];
        sat.clause(&[shared, a, b, c]);
    }
    assert!(matches!(sat.solve(&[]), Ok(Outcome::Sat)));
    sat.clause(&[!shared]);
    assert!(matches!(sat.solve(&[]), Ok(Outcome::Sat)));
    assert_eq!(budget.stats().conflicts, 0);
    assert!(budget.derived() >= 100, "the clauses were rewritten");
}

#[test]
fn a_limit_that_is_just_enough_does_not_stop() {
    let solve = |conflicts| {
        let limits = Limits {
            conflicts,
            ..Limits::default()
        };
        let budget = Rc::new(Budget::new(&SilentHost, limits));
        let mut sat = Sat::new(Rc::clone(&budget));
        add_pigeons(&mut sat, 7);
        (sat.solve(&[]), budget.stats().conflicts)
    };
    let (outcome, needed) = solve(None);
    assert!(matches!(outcome, Ok(Outcome::Unsat(core)) if core.is_empty()));
    assert!(needed > 100, "{needed} conflicts");
    let (outcome, again) = solve(Some(needed));
    assert!(matches!(outcome, Ok(Outcome::Unsat(_))));
    assert_eq!(again, needed, "the same work needs the same conflicts");
    let (outcome, _) = solve(Some(needed / 2));
    assert_eq!(outcome.unwrap_err(), Stop::Conflicts);
}

#[test]
fn memory_stops_before_the_call() {
    let limits = Limits {
        memory_bytes: Some(10_000),
        ..Limits::default()
    };
    let budget = check_stop(&SilentHost, limits, Stop::Memory);
    assert_eq!(budget.stats().solver_calls, 0);
}

#[test]
fn a_dropped_solver_gives_its_memory_back() {
    let limits = Limits {
        memory_bytes: Some(10_000),
        ..Limits::default()
    };
    let budget = Rc::new(Budget::new(&SilentHost, limits));
    let fill = || {
        let mut sat = Sat::new(Rc::clone(&budget));
        add_pigeons(&mut sat, 4);
        sat
    };
    for _ in 0..10 {
        let mut sat = fill();
        assert!(matches!(sat.solve(&[]), Ok(Outcome::Unsat(_))));
    }
    // Many at once do not fit, so there was something to give back.
    let mut alive: Vec<Sat> = (0..10).map(|_| fill()).collect();
    assert_eq!(alive[0].solve(&[]).unwrap_err(), Stop::Memory);
}

/// A host whose clock goes on by a second, and who may cancel, as it is asked.
struct Patience {
    asked: Cell<u32>,
    cancels_at: u32,
}

impl Patience {
    const fn until(cancels_at: u32) -> Self {
        Self {
            asked: Cell::new(0),
            cancels_at,
        }
    }
}

impl Host for Patience {
    fn wall_seconds(&self) -> f64 {
        f64::from(self.asked.get())
    }

    fn cancelled(&self) -> bool {
        self.asked.set(self.asked.get() + 1);
        self.asked.get() >= self.cancels_at
    }

    fn progress(&self, _: &Progress) {}
}

#[test]
fn cancelling_stops_at_once_and_is_asked_once() {
    for cancels_at in [1, 2, 10] {
        let host = Patience::until(cancels_at);
        check_stop(&host, Limits::default(), Stop::Cancelled);
        assert_eq!(host.asked.get(), cancels_at);
    }
}

#[test]
fn the_host_is_asked_often() {
    let host = Patience::until(u32::MAX);
    let limits = Limits {
        conflicts: Some(2_000),
        ..Limits::default()
    };
    let budget = check_stop(&host, limits, Stop::Conflicts);
    let each = budget.stats().conflicts / u64::from(host.asked.get());
    assert!(each < 200, "once in {each} conflicts");
}

#[test]
fn seconds_are_those_of_the_host() {
    let host = Patience::until(u32::MAX);
    let limits = Limits {
        seconds: Some(7.0),
        ..Limits::default()
    };
    check_stop(&host, limits, Stop::Time);
    assert_eq!(host.asked.get(), 7);
}

#[test]
fn the_first_reason_stays() {
    let host = Patience::until(5);
    let limits = Limits {
        seconds: Some(3.0),
        ..Limits::default()
    };
    check_stop(&host, limits, Stop::Time);
}
