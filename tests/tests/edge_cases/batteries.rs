//! Batteries: levels, chargers, floors.

use super::check;

#[test]
fn an_initial_level_below_the_floor() {
    check("a A \n battery a 1/9 \n floor 2", "impossible; complete");
    check("aA \n battery a 1/9 \n floor 2", "impossible; complete");
    check("+aA \n battery a 1/9 \n floor 2", "impossible; complete");
}

#[test]
fn a_level_may_equal_the_floor() {
    check(
        "a . A \n battery a 3/9 \n floor 1",
        "optimal: makespan 2, sum-of-costs 2, charges 0; complete",
    );
    check("a . A \n battery a 2/9 \n floor 1", "impossible; complete");
}

#[test]
fn an_empty_battery_at_the_goal() {
    check(
        "aA \n battery a 0/0",
        "optimal: makespan 0, sum-of-costs 0, charges 0; complete",
    );
}

#[test]
fn each_half_of_a_slow_move_takes_one() {
    check(
        "~a ~A \n battery a 2/2",
        "optimal: makespan 2, sum-of-costs 2, charges 0; complete",
    );
    check("~a ~A \n battery a 1/2", "impossible; complete");
}

#[test]
fn waiting_takes_one_as_well() {
    // One of the two must wait, and neither can.
    check(
        "#  b  #
         a  .  A
         #  B  #
         battery a 2/2
         battery b 2/2",
        "impossible; complete",
    );
    check(
        "#  b  #
         a  .  A
         #  B  #
         battery a 2/3
         battery b 3/3",
        "optimal: makespan 3, sum-of-costs 5, charges 0; complete",
    );
}

#[test]
fn a_battery_that_cannot_reach_any_charger() {
    check("+ . . a . . . A \n battery a 2/9", "impossible; complete");
}

#[test]
fn a_battery_that_needs_a_charger_on_the_other_side() {
    check(
        "+ a . A \n battery a 1/9",
        "optimal: makespan 4, sum-of-costs 4, charges 1; complete",
    );
}

#[test]
fn charging_at_the_start_at_time_0() {
    // Levels 0, 2, 1, 0: a charge takes no extra time, and the level after
    // its step is the capacity.
    check(
        "+a . . A \n battery a 0/2",
        "optimal: makespan 3, sum-of-costs 3, charges 1; complete",
    );
    check("+a . . A \n battery a 0/1", "impossible; complete");
}

#[test]
fn charging_on_the_way() {
    // Levels 1, 0, 2, 1, 0.
    check(
        "a + . . A \n battery a 1/2",
        "optimal: makespan 4, sum-of-costs 4, charges 1; complete",
    );
    check("a + . . A \n battery a 1/1", "impossible; complete");
}

#[test]
fn charging_and_leaving_by_a_slow_move() {
    // Levels 0, 2 in transit, 1, 0.
    check(
        "*a ~ A \n battery a 0/2",
        "optimal: makespan 3, sum-of-costs 3, charges 1; complete",
    );
    check("*a ~ A \n battery a 0/1", "impossible; complete");
}

#[test]
fn no_charge_in_transit() {
    check("~a *A . \n battery a 1/9", "impossible; complete");
}

#[test]
fn consecutive_charges_count_each() {
    check(
        "+a + . A \n battery a 0/1",
        "optimal: makespan 3, sum-of-costs 3, charges 2; complete",
    );
}

#[test]
fn waiting_at_a_charger_with_a_charge_in_each_step() {
    // b cannot wait; a can, on the charger, where its small battery needs a
    // charge in both steps.
    check(
        "#  b  #
         +a .  A
         #  B  #
         battery a 0/1
         battery b 2/2",
        "optimal: makespan 3, sum-of-costs 5, charges 2; complete",
    );
}

#[test]
fn charging_is_chosen_not_forced() {
    check(
        "a + A \n battery a 9/9 \n minimise charges,makespan",
        "optimal: charges 0, makespan 2; complete",
    );
}

#[test]
fn an_agent_that_has_arrived_uses_nothing() {
    check(
        "a A . .
         b . . B
         battery a 1/1",
        "optimal: makespan 3, sum-of-costs 4, charges 0; complete",
    );
}

#[test]
fn an_agent_that_leaves_its_goal_again_uses_its_battery_there() {
    check(
        "b . aA B
         # # .  #
         battery a 3/3",
        "optimal: makespan 3, sum-of-costs 6, charges 0; complete",
    );
    check(
        "b . aA B
         # # .  #
         battery a 1/3",
        "impossible; complete",
    );
}
