//! Command lines that are wrong: exit status 2.

use expect_test::{Expect, expect};

use crate::run::{Folder, WAREHOUSE, WAREHOUSE_PLAN};

/// The first line of what is said, and the exit status.
fn check(line: &str, expect: &Expect) {
    let folder = Folder::with(&[("warehouse.json", WAREHOUSE), ("plan.json", WAREHOUSE_PLAN)]);
    let run = folder.run(line);
    assert_eq!(run.out, "");
    let refusal = run.refusal();
    let lines: Vec<&str> = refusal.lines().take(2).collect();
    expect.assert_eq(&lines.join("\n"));
}

#[test]
fn objectives() {
    check(
        "solve warehouse.json --objective speed",
        &expect![[r#"
        exit 2
        error: invalid value 'speed' for '--objective <LIST>': found "speed", expected makespan, sum-of-costs, charges, moves, waits or penalty"#]],
    );
    check(
        "solve warehouse.json --objective makespan,moves,makespan",
        &expect![[r#"
            exit 2
            error: invalid value 'makespan,moves,makespan' for '--objective <LIST>': found makespan twice, expected each cost once"#]],
    );
    check(
        "solve warehouse.json --objective ,",
        &expect![[r#"
        exit 2
        error: invalid value ',' for '--objective <LIST>': found no cost, expected at least one"#]],
    );
    check(
        "solve warehouse.json --objective Makespan",
        &expect![[r#"
            exit 2
            error: invalid value 'Makespan' for '--objective <LIST>': found "Makespan", expected makespan, sum-of-costs, charges, moves, waits or penalty"#]],
    );
}

#[test]
fn fronts_are_of_two_or_three_costs() {
    check(
        "solve warehouse.json --pareto --objective charges",
        &expect![[r#"
            exit 2
            error: found the objective charges, expected two or three costs for --pareto"#]],
    );
    check(
        "solve warehouse.json --pareto --objective charges,moves,waits,makespan",
        &expect![[r#"
            exit 2
            error: found the objective charges,moves,waits,makespan, expected two or three costs for --pareto"#]],
    );
}

#[test]
fn the_command_line_is_judged_before_files_are_read() {
    check(
        "solve nowhere.json --pareto --objective charges",
        &expect![[r#"
            exit 2
            error: found the objective charges, expected two or three costs for --pareto"#]],
    );
}

#[test]
fn a_front_of_the_instances_own_objective() {
    let one = WAREHOUSE.replacen("\"map\"", "\"objective\": [\"charges\"], \"map\"", 1);
    Folder::scene(one).refuses(
        "solve scene.json --pareto",
        &expect![[r#"
        exit 2
        error: found the objective charges, expected two or three costs for --pareto

        Usage: giveway [OPTIONS] <COMMAND>

        For more information, try '--help'.
    "#]],
    );
}

#[test]
fn numbers() {
    check(
        "solve warehouse.json --within -1",
        &expect![[r#"
            exit 2
            error: invalid value '-1' for '--within <N>': found "-1", expected a whole number from 0"#]],
    );
    check(
        "solve warehouse.json --within many",
        &expect![[r#"
            exit 2
            error: invalid value 'many' for '--within <N>': found "many", expected a whole number from 0"#]],
    );
    check(
        "solve warehouse.json --agents 1.5",
        &expect![[r#"
            exit 2
            error: invalid value '1.5' for '--agents <N>': found "1.5", expected a whole number from 0"#]],
    );
    check(
        "solve warehouse.json --within 5000000000",
        &expect![[r#"
            exit 2
            error: invalid value '5000000000' for '--within <N>': found "5000000000", expected a smaller one"#]],
    );
    check(
        "solve warehouse.json --time-limit -3",
        &expect![[r#"
        exit 2
        error: invalid value '-3' for '--time-limit <SECONDS>': found "-3", expected a number of seconds above 0"#]],
    );
    check(
        "solve warehouse.json --time-limit 0",
        &expect![[r#"
        exit 2
        error: invalid value '0' for '--time-limit <SECONDS>': found "0", expected a number of seconds above 0"#]],
    );
    check(
        "solve warehouse.json --time-limit inf",
        &expect![[r#"
        exit 2
        error: invalid value 'inf' for '--time-limit <SECONDS>': found "inf", expected a number of seconds above 0"#]],
    );
}

#[test]
fn words() {
    check(
        "solve",
        &expect![[r#"
        exit 2
        error: the following required arguments were not provided:"#]],
    );
    check(
        "solv warehouse.json",
        &expect![[r#"
        exit 2
        error: unrecognized subcommand 'solv'"#]],
    );
    check(
        "solve warehouse.json --format xml",
        &expect![[r#"
        exit 2
        error: invalid value 'xml' for '--format <FORMAT>'"#]],
    );
    check(
        "solve warehouse.json plan.json",
        &expect![[r#"
        exit 2
        error: unexpected argument 'plan.json' found"#]],
    );
    check(
        "convert warehouse.json",
        &expect![[r#"
        exit 2
        error: the following required arguments were not provided:"#]],
    );
    check(
        "man fly",
        &expect![[r#"
        exit 2
        error: found "fly", expected a command of giveway"#]],
    );
}

#[test]
fn what_is_not_built_is_not_offered() {
    check(
        "convert warehouse.json --to tar",
        &expect![[r#"
        exit 2
        error: invalid value 'tar' for '--to <FORMAT>'"#]],
    );
}

#[test]
fn standard_input_is_read_once() {
    check(
        "check - -",
        &expect![[r#"
        exit 2
        error: found - for two files, expected it for one of them"#]],
    );
}

#[test]
fn a_map_for_an_instance_that_has_one() {
    check(
        "solve warehouse.json --map plan.json",
        &expect![[r#"
            exit 2
            error: --map is for a scenario, and warehouse.json is not one"#]],
    );
}

#[test]
fn a_bare_giveway_shows_the_help() {
    let run = Folder::scene("").run("");
    assert_eq!(run.exit, Some(2));
    assert!(run.err.contains("Usage: giveway"), "{}", run.err);
}
