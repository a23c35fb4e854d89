//! Limits of a part are those of the whole.

use super::*;
use crate::SilentHost;

#[test]
fn a_part_counts_the_memory_and_the_clauses_of_the_whole() {
    let limits = Limits {
        memory_bytes: Some(1_000),
        ..Limits::default()
    };
    let whole = Budget::new(&SilentHost, limits).with_clauses(2);
    let mut held = MemoryUse::default();
    whole.hold_more(&mut held, 900);
    whole.count_clause();
    let part = whole.part(Limits::default());
    assert_eq!(part.clauses_left(), 1);
    assert_eq!(part.check(), Ok(()));
    let mut more = MemoryUse::default();
    part.hold_more(&mut more, 200);
    assert_eq!(part.check(), Err(Stop::Memory));
    assert_eq!(whole.check(), Err(Stop::Memory));
}

/// What one of many searches holds does not end the others.
#[test]
fn a_part_may_hold_less_than_the_whole() {
    let whole = Budget::new(&SilentHost, Limits::default());
    let mut held = MemoryUse::default();
    whole.hold_more(&mut held, 900);
    let part = whole.part(Limits::default()).with_held(100);
    {
        let mut more = MemoryUse::default();
        part.hold_more(&mut more, 100);
        assert_eq!(part.check(), Ok(()));
        part.hold_more(&mut more, 1);
        assert_eq!(part.check(), Err(Stop::Memory));
        assert_eq!(
            part.part(Limits::default()).check(),
            Err(Stop::Memory),
            "nor may a part of it"
        );
    }
    assert_eq!(whole.check(), Ok(()));
    assert_eq!(whole.part(Limits::default()).with_held(100).check(), Ok(()));
}

#[test]
fn after_a_stop_no_state_is_looked_at() {
    let budget = Budget::new(&SilentHost, Limits::default()).with_clauses(0);
    assert_eq!(budget.tick(), Ok(()));
    budget.count_clause();
    assert_eq!(budget.check(), Err(Stop::Conflicts));
    assert_eq!(budget.tick(), Err(Stop::Conflicts));
}
