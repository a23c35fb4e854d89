//! Plans that are no plans.

use giveway_model::check::check as judge;
use giveway_model::{Instance, Plan};

use crate::picture::{check, line, read};

/// Spoils a valid plan of two agents and compares the violations.
#[track_caller]
fn check_spoilt(spoil: impl Fn(&mut Plan), expected: &[&str]) {
    let (instance, mut plan) = read(
        "
        +..
        ...
        ",
        "
        A 00+ 10 | battery 9/9
        B 01 11 21
        ",
    );
    assert_eq!(lines(&instance, &plan), [""; 0]);
    spoil(&mut plan);
    assert_eq!(lines(&instance, &plan), expected);
}

fn lines(instance: &Instance, plan: &Plan) -> Vec<String> {
    judge(instance, plan).violations.iter().map(line).collect()
}

fn charges(times: &[u32]) -> impl Fn(&mut Plan) {
    let times = times.to_vec();
    move |plan| {
        plan.charges.insert("A".into(), times.clone());
    }
}

#[test]
fn an_agent_without_a_path() {
    check_spoilt(
        |plan| {
            plan.paths.remove("A");
        },
        &["0 shape A"],
    );
}

#[test]
fn an_agent_that_the_instance_has_not() {
    let path = |plan: &mut Plan| {
        plan.paths.insert("Z".into(), Vec::new());
    };
    check_spoilt(path, &["0 shape Z"]);
    let charge = |plan: &mut Plan| {
        plan.charges.insert("Z".into(), vec![1]);
    };
    check_spoilt(charge, &["0 shape Z"]);
}

#[test]
fn an_empty_path() {
    check_spoilt(
        |plan| {
            plan.paths.insert("A".into(), Vec::new());
        },
        &["0 shape A"],
    );
}

#[test]
fn a_path_in_transit_from_beginning_to_end() {
    check_spoilt(
        |plan| {
            plan.paths.insert("A".into(), vec![None, None]);
        },
        &["0 shape A"],
    );
}

#[test]
fn a_path_that_begins_in_transit() {
    check("~~", "A .. 10 | from 00", "0 shape A");
}

#[test]
fn a_path_that_ends_in_transit() {
    check("~~", "A 00 .. | to 00", "1 shape A");
    check("~~", "A 00 00 .. .. | to 00", "3 shape A");
}

#[test]
fn charges_out_of_order() {
    check_spoilt(charges(&[1, 0]), &["0 shape A", "1 charge A"]);
}

#[test]
fn charges_listed_twice() {
    check_spoilt(charges(&[0, 0]), &["0 shape A"]);
}

#[test]
fn charges_far_after_the_path() {
    check_spoilt(charges(&[0, u32::MAX]), &["4294967295 charge A"]);
}

#[test]
fn a_plan_whose_world_changed_needs_its_changes() {
    check_spoilt(
        |plan| {
            plan.from.insert("A".into(), 1);
            plan.until.insert("B".into(), 1);
        },
        &["0 shape A", "0 shape B"],
    );
}

#[test]
fn a_first_entry_at_time_0_is_the_default() {
    check_spoilt(
        |plan| {
            plan.from.insert("A".into(), 0);
        },
        &[],
    );
}

#[test]
fn a_stranger_among_the_times_of_entry() {
    check_spoilt(
        |plan| {
            plan.from.insert("Z".into(), 0);
            plan.until.insert("Z".into(), 0);
        },
        &["0 shape Z", "0 shape Z"],
    );
}
