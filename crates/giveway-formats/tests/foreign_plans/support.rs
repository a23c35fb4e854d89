//! Files of the tests' data, read together.

use std::path::PathBuf;

use giveway_formats::{
    Combined, ForeignPlan, Format, Held, Options, Source, WrittenAt, WrittenPlan, combine,
};
use giveway_model::Fault;
use giveway_model::check::{Rule, check};

/// The text of a file of the tests' data.
pub(crate) fn data(path: &str) -> String {
    let path = PathBuf::from(env!("CARGO_MANIFEST_DIR"))
        .join("tests/data")
        .join(path);
    std::fs::read_to_string(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

/// Gathers files given as name and text.
pub(crate) fn opened(files: &[(&str, &str)]) -> Combined {
    let sources = files.iter().map(|&(name, text)| Source { name, text });
    let sources: Vec<Source<'_>> = sources.collect();
    combine(&sources, &Options::default()).unwrap_or_else(|refused| panic!("{refused:?}"))
}

/// A plan with the small map and its scenario.
pub(crate) fn with_small(name: &str, text: &str) -> Combined {
    let (map, scenario) = (data("plans/small.map"), data("plans/small.scen"));
    opened(&[(name, text), ("small.map", &map), ("small.scen", &scenario)])
}

/// A plan as it is written, wherever that is in its file.
pub(crate) fn anywhere(mut plan: WrittenPlan) -> WrittenPlan {
    for agent in &mut plan.agents {
        agent.at = WrittenAt::Whole;
        let cells = agent.waypoints.iter_mut();
        for cell in cells.chain(&mut agent.start).chain(&mut agent.goal) {
            cell.at = WrittenAt::Whole;
        }
    }
    plan
}

/// The one plan of some files.
pub(crate) fn one(combined: &Combined) -> &ForeignPlan {
    assert_eq!(combined.plans.len(), 1);
    &combined.plans[0]
}

/// The rule, the agents and the time of every violation.
pub(crate) fn violations(combined: &Combined) -> Vec<(Rule, Vec<String>, u32)> {
    let report = check(&combined.instance, &one(combined).plan);
    let found = report.violations.into_iter();
    found.map(|v| (v.rule, v.agents, v.time)).collect()
}

/// The violations of the faulty plans: a robot in the obstacle, and a swap.
pub(crate) fn faulty() -> Vec<(Rule, Vec<String>, u32)> {
    let names = |names: &[&str]| names.iter().map(|&name| name.to_owned()).collect();
    vec![
        (Rule::Obstacle, names(&["A1"]), 2),
        (Rule::Swap, names(&["A2", "A3"]), 2),
    ]
}

/// Writes a scene and its plan, reads the files again, and compares.
pub(crate) fn assert_comes_back(format: Format, combined: &Combined) {
    let plan = &combined.plans[0].plan;
    let stem = combined.instance.name();
    let written =
        giveway_formats::write(format, stem, Some(&combined.instance), Some(plan)).unwrap();
    let files: Vec<(&str, &str)> = written
        .files
        .iter()
        .map(|(name, text)| (&**name, &**text))
        .collect();
    let again = opened(&files);
    assert_eq!(again.instance, combined.instance, "{format}");
    assert!(!again.plans.is_empty());
    for again in &again.plans {
        assert_eq!(again.format, format);
        assert_eq!(&again.plan, plan, "{format}");
        assert!(again.fit.is_perfect(), "{format}: {:?}", again.fit);
    }
}

/// The plan that a text holds.
pub(crate) fn plan(text: &str) -> WrittenPlan {
    match giveway_formats::read(text) {
        Ok((_, Held::Plan(plan))) => plan,
        other => panic!("{other:?}"),
    }
}

/// The only fault of a text.
pub(crate) fn fault(text: &str) -> Fault {
    match giveway_formats::read(text) {
        Err(faults) if faults.len() == 1 => faults[0].clone(),
        other => panic!("{other:?}"),
    }
}

/// Asserts where the fault of a text is, what was found and what was expected.
#[track_caller]
pub(crate) fn assert_fault(text: &str, at: (usize, usize), found: &str, expected: &str) {
    let fault = fault(text);
    assert_eq!(
        (fault.line, fault.column),
        (Some(at.0), Some(at.1)),
        "{fault}"
    );
    assert_eq!((&*fault.found, &*fault.expected), (found, expected));
}
