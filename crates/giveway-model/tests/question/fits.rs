//! Questions about what is not so, or does not exist.

use std::fmt::Write as _;

use giveway_model::format::native;
use giveway_model::question::fits;

use super::{instance, plan, question};

#[test]
fn what_is_so_can_be_asked() {
    for words in [
        "wait A1",
        "wait A1 --at 0,0 --from 0 --to 2 --at-least 2",
        "charge A1 --at 0,0 --time 1",
        "no-charge A1 --at 3,0",
        "visit A1 --at 3,0 --time 9",
        "no-visit A1 --at 3,1",
        "no-visit any --at 0,0",
        "move A1 --from-cell 1,0 --to-cell 2,0",
        "no-move A1 --from-cell 0,0 --to-cell 0,1",
        "slow A1",
        "order A1 --first 1,0 --second 2,0",
        "arrival A2",
        "length A1",
        "charges",
        "waits A2",
        "unsolvable",
        "plan",
    ] {
        let fit = fits(&question(words), &instance(), &plan());
        let visited = words == "no-visit any --at 0,0";
        assert_eq!(fit.is_ok(), !visited, "{words}");
    }
}

#[test]
fn what_is_least_already_cannot_be_less() {
    let instance = native::read_instance(
        r#"{ "giveway": 1, "map": ["..."], "agents": [
            { "name": "A1", "start": [0, 0], "goal": [0, 0] },
            { "name": "A2", "start": [1, 0], "goal": [2, 0] } ] }"#,
    )
    .unwrap();
    let plan = native::read_plan(
        r#"{ "giveway": 1, "paths": { "A1": [[0, 0]], "A2": [[1, 0], [2, 0]] } }"#,
    )
    .unwrap();
    for (words, is_so) in [
        ("waits A2", "A2 never waits in this plan."),
        ("charges A2", "A2 never charges in this plan."),
        ("moves A1", "A1 does not move in this plan."),
        ("length A1", "A1 does not move in this plan."),
        ("arrival A1", "A1 arrives at time 0."),
        ("waits", "No robot waits in this plan."),
        ("charges", "No robot charges in this plan."),
    ] {
        let misfit = fits(&question(words), &instance, &plan).unwrap_err();
        assert_eq!(misfit.to_string(), is_so, "{words}");
    }
    for words in [
        "moves",
        "makespan",
        "sum-of-costs",
        "moves A2",
        "arrival A2",
    ] {
        assert_eq!(fits(&question(words), &instance, &plan), Ok(()), "{words}");
    }
}

#[test]
fn sentences_that_help() {
    let mut found = String::new();
    for words in [
        "charges A2",
        "wait A9",
        "wait A1 --at 9,9",
        "wait A1 --at 3,0",
        "wait A1 --from 2 --to 2",
        "wait A1 --from 2 --to 9",
        "wait A1 --at-least 3",
        "wait A2 --at-least 0",
        "charge A1 --time 2",
        "charge A2",
        "charge A1 --at 1,0",
        "no-charge A1 --at 0,0",
        "visit A2 --at 0,0",
        "visit A2 --at 2,1 --time 3",
        "visit A1 --at 1,0 --time 4",
        "no-visit A2 --at 2,1",
        "no-visit any --at 0,0",
        "move A2 --from-cell 2,1 --to-cell 1,1 --time 1",
        "move A2 --from-cell 2,1 --to-cell 2,0",
        "move A1 --from-cell 1,0 --to-cell 3,0",
        "no-move A1 --from-cell 1,0 --to-cell 2,0",
        "slow A2",
        "order A1 --first 2,0 --second 1,0",
        "order A1 --first 2,0 --second 2,0",
        "order A2 --first 2,1 --second 2,0",
        "length A1 --fewer-than 5",
        "yield A1 A1 --at 1,0",
        "yield A1 A2 --at 1,1",
        "yield A2 A1 --at 1,1",
    ] {
        let misfit = fits(&question(words), &instance(), &plan());
        let _ = writeln!(found, "{words}\n    {}", misfit.unwrap_err());
    }
    expect_test::expect![[r#"
        charges A2
            A2 never charges in this plan.
        wait A9
            agent: found "A9", expected one of A1, A2
        wait A1 --at 9,9
            at: found (9, 9), expected a cell of the 4 x 2 map
        wait A1 --at 3,0
            A1 does not wait at (3, 0). It waits at (0, 0) from time 0 to 2. You can ask: wait A1 --at 0,0 --from 0 --to 2
        wait A1 --from 2 --to 2
            to: found time 2, expected a time after 2, since a wait takes a step
        wait A1 --from 2 --to 9
            A1 does not wait from time 2 to 9. It waits at (0, 0) from time 0 to 2. You can ask: wait A1 --at 0,0 --from 0 --to 2
        wait A1 --at-least 3
            A1 does not wait 3 steps in a row. It waits at (0, 0) from time 0 to 2. You can ask: wait A1 --at 0,0 --from 0 --to 2
        wait A2 --at-least 0
            at-least: found 0, expected at least 1 step
        charge A1 --time 2
            A1 does not charge at time 2. It charges at (0, 0) at time 1. You can ask: charge A1 --at 0,0 --time 1
        charge A2
            A2 does not charge. It has no battery.
        charge A1 --at 1,0
            at: found (1, 0), which is not a charger, expected one of the chargers: (0, 0) and (3, 0)
        no-charge A1 --at 0,0
            A1 does charge at (0, 0). It charges at (0, 0) at time 1. You can ask: charge A1 --at 0,0
        visit A2 --at 0,0
            A2 never passes (0, 0). You can ask: no-visit A2 --at 0,0
        visit A2 --at 2,1 --time 3
            A2 is not at (2, 1) at time 3. At time 3 it is at (1, 1). You can ask: visit A2 --at 2,1
        visit A1 --at 1,0 --time 4
            A1 is not at (1, 0) at time 4. At time 4 it is in transit. You can ask: visit A1 --at 1,0
        no-visit A2 --at 2,1
            A2 does pass (2, 1), at time 1. You can ask: visit A2 --at 2,1
        no-visit any --at 0,0
            A1 does pass (0, 0), at time 0. You can ask: visit A1 --at 0,0
        move A2 --from-cell 2,1 --to-cell 1,1 --time 1
            A2 does not go from (2, 1) to (1, 1) at time 1. It goes from (2, 1) to (1, 1) at time 2. You can ask: move A2 --from-cell 2,1 --to-cell 1,1
        move A2 --from-cell 2,1 --to-cell 2,0
            A2 does not go from (2, 1) to (2, 0). It goes from (2, 1) to (1, 1) at time 2. You can ask: no-move A2 --from-cell 2,1 --to-cell 2,0
        move A1 --from-cell 1,0 --to-cell 3,0
            to-cell: found (3, 0), expected a neighbour of (1, 0)
        no-move A1 --from-cell 1,0 --to-cell 2,0
            A1 does go that way. It goes from (1, 0) to (2, 0) at time 3. You can ask: move A1 --from-cell 1,0 --to-cell 2,0
        slow A2
            A2 makes no slow move.
        order A1 --first 2,0 --second 1,0
            A1 visits (1, 0) first, at time 3, and (2, 0) at time 5. You can ask: order A1 --first 1,0 --second 2,0
        order A1 --first 2,0 --second 2,0
            second: found (2, 0) again, expected another cell
        order A2 --first 2,1 --second 2,0
            A2 never visits (2, 0).
        length A1 --fewer-than 5
            A1 makes only 3 moves. You can ask: length A1
        yield A1 A1 --at 1,0
            agents: found A1 twice, expected two different robots
        yield A1 A2 --at 1,1
            A1 is never at (1, 1), so it gives way to nobody there. You can ask: no-visit A1 --at 1,1
        yield A2 A1 --at 1,1
            A1 is never at (1, 1), so A2 does not give way to it there. You can ask: no-visit A1 --at 1,1
    "#]].assert_eq(&found);
}
