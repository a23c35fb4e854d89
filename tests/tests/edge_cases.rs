//! The edge cases of the problem, each with its own small picture of a map
//! (the notation is explained in `src/picture.rs`).
//!
//! Every answer is asked twice: of the solver and of the oracle.
#![allow(
    clippy::unwrap_used,
    clippy::panic,
    reason = "a test that cannot go on ends with a panic"
)]

use giveway_model::{Costs, Instance, check};
use giveway_solve::{SolveAnswer, Status};
use giveway_tests::oracle::{Question, Verdict};
use giveway_tests::{ask, picture, recount};

/// Expects an answer such as `optimal: makespan 2, charges 0; complete`,
/// `impossible; complete` or `impossible; within 3`. Without the part after the
/// semicolon, the claim may reach as far as it likes.
#[track_caller]
fn check(picture: &str, expect: &str) {
    check_horizon(picture, None, expect);
}

/// The same, where only plans of at most this makespan count.
#[track_caller]
fn check_within(picture: &str, within: u32, expect: &str) {
    check_horizon(picture, Some(within), expect);
}

#[track_caller]
fn check_horizon(picture: &str, within: Option<u32>, expect: &str) {
    let instance = picture::instance(picture);
    let claim = expect.split(';').next().unwrap_or_default();
    let oracle = said_by_oracle(&instance, within);
    assert_eq!(oracle, claim, "the oracle, in\n{picture}");
    let answer = ask::best(&instance, within);
    let mut solver = said_by_solver(&instance, &answer);
    if expect == claim {
        solver.truncate(solver.find(';').unwrap_or(solver.len()));
    }
    assert_eq!(solver, expect, "the solver, in\n{picture}");
    if let Some(plan) = answer.plan {
        let violations = check::check(&instance, &plan).violations;
        assert!(violations.is_empty(), "{violations:?} in\n{picture}");
        assert_eq!(Some(recount::costs(&plan)), answer.costs, "in\n{picture}");
    }
}

fn said_by_oracle(instance: &Instance, within: Option<u32>) -> String {
    let question = Question {
        instance,
        within,
        cap: 1_000_000,
    };
    match question.best() {
        Verdict::Best(point) => optimal(instance, &recount::costs(&point.plan)),
        Verdict::Impossible => "impossible".to_owned(),
        Verdict::Capped => "too large for the oracle".to_owned(),
    }
}

fn said_by_solver(instance: &Instance, answer: &SolveAnswer) -> String {
    let claim = match (answer.status, &answer.costs) {
        (Status::Optimal, Some(costs)) => optimal(instance, costs),
        (Status::Impossible, None) => "impossible".to_owned(),
        other => format!("{other:?}"),
    };
    let reach = match (answer.reach.is_complete(), answer.reach.within()) {
        (true, None) => "complete".to_owned(),
        (false, Some(within)) => format!("within {within}"),
        other => format!("{other:?}"),
    };
    format!("{claim}; {reach}")
}

fn optimal(instance: &Instance, costs: &Costs) -> String {
    let values = instance.objective().costs().iter();
    let values: Vec<String> = values.map(|&c| format!("{c} {}", costs.get(c))).collect();
    format!("optimal: {}", values.join(", "))
}

mod instances {
    use super::{check, check_within, picture};
    use giveway_model::Instance;

    #[test]
    fn no_agents_at_all_is_fine() {
        check(
            ". #",
            "optimal: makespan 0, sum-of-costs 0, charges 0; complete",
        );
        check(
            ". # \n minimise waits,moves",
            "optimal: waits 0, moves 0; complete",
        );
    }

    #[test]
    fn no_agents_and_horizon_0() {
        check_within(
            ".",
            0,
            "optimal: makespan 0, sum-of-costs 0, charges 0; complete",
        );
    }

    #[test]
    fn an_agent_alone_on_the_only_cell() {
        check(
            "aA",
            "optimal: makespan 0, sum-of-costs 0, charges 0; complete",
        );
    }

    #[test]
    fn a_goal_behind_obstacles() {
        check("a # A", "impossible; complete");
    }

    #[test]
    fn a_waypoint_behind_obstacles() {
        check("a A # a!", "impossible; complete");
    }

    #[test]
    fn two_goals_on_one_cell_are_an_error_where_agents_stay() {
        let shared = "a AB b";
        let faults = Instance::new(picture::scene(shared)).unwrap_err();
        assert_eq!(faults.len(), 1, "{faults:?}");
        assert_eq!(faults[0].place, "agents[1].goal");
    }
}

mod moves {
    use super::{check, check_within};

    #[test]
    fn an_edge_with_one_end_in_the_zone_is_not_slow() {
        check(
            "a ~ A",
            "optimal: makespan 2, sum-of-costs 2, charges 0; complete",
        );
    }

    #[test]
    fn a_slow_move_takes_two_steps_and_is_one_move() {
        check(
            "~a ~A \n minimise makespan,moves,waits",
            "optimal: makespan 2, moves 1, waits 0; complete",
        );
    }

    #[test]
    fn a_short_zone_is_crossed() {
        check(
            "a ~ ~ A
             . . . .
             minimise makespan,moves",
            "optimal: makespan 4, moves 3; complete",
        );
    }

    #[test]
    fn a_long_zone_is_gone_around() {
        check(
            "a ~ ~ ~ ~ A
             . . . . . .
             minimise makespan,moves",
            "optimal: makespan 7, moves 7; complete",
        );
    }

    #[test]
    fn fewest_moves_go_through_the_long_zone() {
        check(
            "a ~ ~ ~ ~ A
             . . . . . .
             minimise moves,makespan",
            "optimal: moves 5, makespan 8; complete",
        );
    }

    #[test]
    fn a_slow_move_that_cannot_end_by_the_horizon_is_not_begun() {
        check_within("~a ~A", 1, "impossible; within 1");
        check_within(
            "~a ~A",
            2,
            "optimal: makespan 2, sum-of-costs 2, charges 0; complete",
        );
    }

    #[test]
    fn waiting_in_the_zone_is_waiting_as_anywhere() {
        check(
            "#  b  #
             ~a .  A
             #  B  #
             battery b 2/2
             minimise makespan,sum-of-costs,moves,waits",
            "optimal: makespan 3, sum-of-costs 5, moves 4, waits 1; complete",
        );
    }
}

mod collisions {
    use super::check;

    #[test]
    fn one_of_two_that_cross_waits() {
        check(
            "#  b  #
             a  .  A
             #  B  #
             minimise makespan,sum-of-costs,waits",
            "optimal: makespan 3, sum-of-costs 5, waits 1; complete",
        );
    }

    #[test]
    fn a_swap_in_a_corridor() {
        check("aB bA", "impossible; complete");
        check("aB . bA", "impossible; complete");
        check("aB . . bA", "impossible; complete");
    }

    #[test]
    fn a_swap_with_a_bay() {
        check(
            "aB .  bA
             #  .  #",
            "optimal: makespan 4, sum-of-costs 7, charges 0; complete",
        );
    }

    #[test]
    fn a_swap_on_a_ring() {
        check(
            "aB bA
             .  .",
            "optimal: makespan 3, sum-of-costs 4, charges 0; complete",
        );
    }

    #[test]
    fn following_is_allowed() {
        check(
            "a bA B",
            "optimal: makespan 1, sum-of-costs 2, charges 0; complete",
        );
    }

    #[test]
    fn a_chain_of_three_is_allowed() {
        check(
            "a bA cB C",
            "optimal: makespan 1, sum-of-costs 3, charges 0; complete",
        );
    }

    #[test]
    fn three_on_a_square_go_around() {
        check(
            "aC bA
             .  cB",
            "optimal: makespan 2, sum-of-costs 4, charges 0; complete",
        );
    }

    #[test]
    fn four_on_a_square_turn_in_place() {
        check(
            "aD bA
             dC cB",
            "optimal: makespan 1, sum-of-costs 4, charges 0; complete",
        );
    }

    #[test]
    fn six_on_a_ring_turn_in_place() {
        check(
            "aF bA cB
             fE eD dC",
            "optimal: makespan 1, sum-of-costs 6, charges 0; complete",
        );
    }

    #[test]
    fn four_on_a_slow_square_turn_in_place() {
        check(
            "~aD ~bA
             ~dC ~cB
             minimise makespan,sum-of-costs,moves",
            "optimal: makespan 2, sum-of-costs 8, moves 4; complete",
        );
    }

    #[test]
    fn a_slow_swap() {
        // One step apart would be a way, if it were none: b would be in transit
        // when a comes to where b was.
        check("~aB ~bA", "impossible; complete");
        check("aB ~ ~ bA", "impossible; complete");
    }

    #[test]
    fn a_slow_swap_of_agents_that_vanish() {
        check("~aB ~bA \n vanish", "impossible; complete");
    }

    #[test]
    fn following_into_a_slow_edge_one_step_behind() {
        check(
            "a ~b ~ A B",
            "optimal: makespan 4, sum-of-costs 8, charges 0; complete",
        );
    }

    #[test]
    fn entering_a_slow_edge_at_whose_end_another_still_stands() {
        // b must let c pass, and stands at (1, 1) for one step while a is on its
        // way there.
        check(
            "#  #   c
             ~a ~bA B
             #  #   C
             minimise makespan,sum-of-costs,waits",
            "optimal: makespan 2, sum-of-costs 6, waits 1; complete",
        );
    }

    #[test]
    fn a_slow_chain() {
        check(
            "~a ~bA ~B",
            "optimal: makespan 2, sum-of-costs 4, charges 0; complete",
        );
    }
}

mod arrivals {
    use super::{check, check_within};

    #[test]
    fn a_start_that_is_the_goal() {
        check(
            "aA .",
            "optimal: makespan 0, sum-of-costs 0, charges 0; complete",
        );
        check_within(
            "aA .",
            0,
            "optimal: makespan 0, sum-of-costs 0, charges 0; complete",
        );
    }

    #[test]
    fn an_agent_at_its_goal_steps_aside_and_comes_back() {
        check(
            "b aA B
             # .  #
             minimise makespan,sum-of-costs,moves",
            "optimal: makespan 2, sum-of-costs 4, moves 4; complete",
        );
    }

    #[test]
    fn a_wait_at_the_goal_counts_if_the_agent_leaves_it_again() {
        check(
            "b . aA B
             # # .  #
             minimise makespan,sum-of-costs,moves,waits",
            "optimal: makespan 3, sum-of-costs 6, moves 5, waits 1; complete",
        );
    }

    #[test]
    fn an_agent_that_stays_blocks_its_goal() {
        check("b aA B", "impossible; complete");
    }

    #[test]
    fn passing_over_the_goal_does_not_force_arrival() {
        check(
            "a A a!",
            "optimal: makespan 3, sum-of-costs 3, charges 0; complete",
        );
    }

    #[test]
    fn a_start_or_a_goal_may_be_a_waypoint() {
        check(
            "aa! . Aa!",
            "optimal: makespan 2, sum-of-costs 2, charges 0; complete",
        );
        check(
            "aAa!",
            "optimal: makespan 0, sum-of-costs 0, charges 0; complete",
        );
    }

    #[test]
    fn a_start_that_is_the_goal_with_a_waypoint_elsewhere() {
        check(
            "aA a!",
            "optimal: makespan 2, sum-of-costs 2, charges 0; complete",
        );
    }

    #[test]
    fn waypoints_are_visited_in_any_order() {
        check(
            "a! . a . a! A",
            "optimal: makespan 7, sum-of-costs 7, charges 0; complete",
        );
    }

    #[test]
    fn a_waypoint_is_not_visited_in_transit() {
        // The way through the zone passes no vertex but its ends.
        check(
            "~a ~a! ~A",
            "optimal: makespan 4, sum-of-costs 4, charges 0; complete",
        );
    }

    #[test]
    fn agents_that_vanish_may_share_a_goal_one_after_the_other() {
        check(
            "a AB b
             vanish",
            "optimal: makespan 2, sum-of-costs 3, charges 0; complete",
        );
    }

    #[test]
    fn an_agent_that_vanishes_holds_its_goal_at_its_arrival() {
        // Two agents that could both be there at time 1, and a third.
        check(
            "a ABC b
             #  c  #
             vanish",
            "optimal: makespan 3, sum-of-costs 6, charges 0; complete",
        );
    }

    #[test]
    fn an_agent_that_vanished_is_in_nobodys_way() {
        check(
            "b aA B
             vanish",
            "optimal: makespan 2, sum-of-costs 2, charges 0; complete",
        );
    }

    #[test]
    fn an_agent_that_vanishes_does_not_swap_before() {
        check("aB bA \n vanish", "impossible; complete");
    }

    #[test]
    fn an_agent_that_would_vanish_may_step_aside_first() {
        // a has a waypoint behind b: it cannot be gone before b has passed.
        check(
            "b aA B a!
             # .  # #
             vanish",
            "optimal: makespan 4, sum-of-costs 6, charges 0; complete",
        );
    }
}

mod batteries {
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
}

mod claims {
    use super::{check, check_within};

    #[test]
    fn horizon_0() {
        check_within("a A", 0, "impossible; within 0");
    }

    #[test]
    fn a_horizon_that_is_too_small() {
        check_within("a . . A", 2, "impossible; within 2");
    }

    #[test]
    fn a_horizon_that_just_suffices() {
        check_within(
            "a . . A",
            3,
            "optimal: makespan 3, sum-of-costs 3, charges 0; complete",
        );
    }

    #[test]
    fn impossible_at_every_horizon_is_complete_within_a_horizon_too() {
        check_within("a # A", 5, "impossible; complete");
    }

    #[test]
    fn charges_first_are_complete_at_the_sum_of_the_minima() {
        check(
            "a + . . A \n battery a 1/9 \n minimise charges",
            "optimal: charges 1; complete",
        );
    }

    #[test]
    fn waits_first_are_complete_at_zero() {
        check("a . A \n minimise waits", "optimal: waits 0; complete");
    }

    #[test]
    fn charges_decide_who_waits() {
        let crossing = "#  b  #
             +a .  A
             #  B  #
             battery a 0/1";
        check(
            &format!("{crossing} \n minimise makespan,charges,waits"),
            "optimal: makespan 3, charges 1, waits 1; complete",
        );
        // Here b cannot be the one that waits. No agent needs two charges alone,
        // so the reach of the claim is left to the solver.
        check(
            &format!("{crossing} \n battery b 2/2 \n minimise charges,makespan"),
            "optimal: charges 2, makespan 3",
        );
    }

    #[test]
    fn all_five_costs() {
        check(
            "aB .  bA
             #  .  #
             minimise waits,charges,moves,sum-of-costs,makespan",
            "optimal: waits 1, charges 0, moves 6, sum-of-costs 7, makespan 4",
        );
        check(
            "aB bA
             .  .
             minimise sum-of-costs,waits,charges,moves,makespan",
            "optimal: sum-of-costs 4, waits 0, charges 0, moves 4, makespan 3; complete",
        );
    }

    /// SAT finds these hard, so that their few joint states are exhausted. Standing at
    /// the goal is free there, and must not be told as going on.
    #[test]
    fn time_that_costs_nothing() {
        check(
            "~c  ~aA
             ~bC ~Bc!
             minimise moves",
            "optimal: moves 8; complete",
        );
        check(
            "#    #  .   ~C
             ~bc! .B ~a  ~cA
             minimise charges,moves",
            "optimal: charges 0, moves 17; complete",
        );
    }

    /// The same, where already a first plan is hard to find among so many steps.
    #[test]
    fn far_more_time_than_is_needed() {
        check_within(
            "~c ~a ~  ~Ab
             ~  .C #  .Ba!
             minimise sum-of-costs,moves,charges",
            1000,
            "optimal: sum-of-costs 59, moves 21, charges 0; complete",
        );
    }
}
