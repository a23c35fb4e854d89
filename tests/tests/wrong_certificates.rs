//! Certificates that were accepted once although what they say is false.
//! `data/wrong/README.md` names the cases.
#![allow(
    clippy::unwrap_used,
    clippy::panic,
    reason = "a test that cannot go on ends with a panic"
)]

use giveway_model::format::native;
use giveway_model::{Cost, Instance, Objective};
use giveway_proof::{
    Budget, Bundle, Certified, Checked, Claim, Solved, confirm, export, plain, verify,
};
use giveway_solve::{Request, Response, SilentHost, SolveAnswer, SolveRequest, Status, serve};
use giveway_tests::forge::{Folder, Seal};
use giveway_tests::random;
use giveway_tests::wrong::{instance, path};

/// The files of a case.
fn bundle(case: &str) -> Bundle {
    let entries = std::fs::read_dir(path(case)).unwrap();
    let files = entries.map(|entry| {
        let entry = entry.unwrap();
        let name = entry.file_name().into_string().unwrap();
        (name, std::fs::read(entry.path()).unwrap())
    });
    files.collect()
}

#[test]
fn what_is_false_is_rejected() {
    for (case, why) in [
        ("f1-overflow", "does not show"),
        (
            "f1b-plan-and-no-plan",
            "a claim says that no such plan exists",
        ),
        ("f2-conclusion", "README.md: it does not say"),
        ("f3-within", "takes longer than the makespan"),
        (
            "f3b-within",
            "beside a limit that already bounds the makespan",
        ),
        ("f4-why", "manifest.json"),
        ("f5-name", "claims[0].why"),
        ("f6-cond", "its proofs have other names"),
        ("f6b-two-kinds", "its proofs have other names"),
        ("f7-proof-name", "its proofs have other names"),
        (
            "f8-unknown-agent",
            "expected one of charges, moves or waits",
        ),
    ] {
        let report = verify(&bundle(case), &Budget::default());
        assert!(!report.accepted, "{case}");
        assert_eq!(report.certified, Certified::NotCertified, "{case}");
        assert_eq!(report.conclusion, None, "{case}");
        let reason = report.reason.unwrap();
        assert!(reason.contains(why), "{case}: {reason}");
        assert!(!reason.chars().any(char::is_control), "{case}: {reason:?}");
    }
    // With a reason as it may stand there, what is said of nobody is found.
    let mut named = bundle("f5-name");
    let manifest = String::from_utf8(named["manifest.json"].clone()).unwrap();
    let manifest = manifest.replace("\"why\": \"x\"", "\"why\": \"no-agent\"");
    named.insert("manifest.json".to_owned(), manifest.into_bytes());
    let reason = verify(&named, &Budget::default()).reason.unwrap();
    assert!(
        reason.contains("about a robot that does not exist"),
        "{reason}"
    );
    // With a cost that one robot may have a limit of, so is who it is about.
    let mut nobody = bundle("f8-unknown-agent");
    let manifest = String::from_utf8(nobody["manifest.json"].clone()).unwrap();
    let manifest = manifest.replace("\"cost\": \"makespan\"", "\"cost\": \"moves\"");
    nobody.insert("manifest.json".to_owned(), manifest.into_bytes());
    let reason = verify(&nobody, &Budget::default()).reason.unwrap();
    assert!(
        reason.contains("about a robot that does not exist"),
        "{reason}"
    );
    // With names as proofs have them, so are plans that are not of the kind.
    for (case, why) in [
        ("f6-cond", "not of the kind"),
        ("f6b-two-kinds", "several kinds"),
    ] {
        let report = verify(&renamed(case), &Budget::default());
        assert!(!report.accepted, "{case}");
        let reason = report.reason.unwrap();
        assert!(reason.contains(why), "{case}: {reason}");
    }
}

/// A case with its proofs named as the claims' costs are.
fn renamed(case: &str) -> Bundle {
    let names = [("m.", "makespan."), ("s.", "sum-of-costs.")];
    let mut files = Bundle::new();
    for (name, bytes) in bundle(case) {
        let other = names.iter().find(|(old, _)| name.starts_with(old));
        let name = other.map_or(name.clone(), |(old, new)| name.replacen(old, new, 1));
        files.insert(name, bytes);
    }
    let mut manifest = String::from_utf8(files["manifest.json"].clone()).unwrap();
    for (old, new) in [
        ("\"m\"", "\"makespan\""),
        ("\"s\"", "\"sum-of-costs\""),
        ("\"m.", "\"makespan."),
        ("\"s.", "\"sum-of-costs."),
    ] {
        manifest = manifest.replace(old, new);
    }
    files.insert("manifest.json".to_owned(), manifest.into_bytes());
    files
}

fn solved(instance: &Instance, within: Option<u32>) -> SolveAnswer {
    let request = Request::Solve(SolveRequest {
        scene: instance.to_scene(),
        within,
        ..SolveRequest::default()
    });
    match serve(&request, &SilentHost) {
        Response::Solved(answer) => answer,
        other => panic!("{other:?}"),
    }
}

fn of<'a>(instance: &'a Instance, answer: &'a SolveAnswer) -> Solved<'a> {
    Solved {
        instance,
        about: Claim::default(),
        bounds: &answer.bounds,
        impossible: answer.status == Status::Impossible,
        complete: answer.reach.is_complete(),
        within: answer.reach.within(),
        plan: answer.plan.as_ref(),
        hints: &[],
    }
}

/// What holds up to a makespan is not said of all plans: not by the folder, and
/// not by the report.
#[test]
fn a_plan_that_is_best_up_to_a_makespan_is_called_no_more() {
    let objective: Objective = "moves,waits".parse().unwrap();
    let instance = instance("f3c-within-s2.json").with_objective(objective);
    let answer = solved(&instance, Some(5));
    let later = solved(&instance, Some(6));
    assert_eq!(
        later.costs.map(|costs| (costs.moves, costs.makespan)),
        Some((3, 6))
    );
    assert!(answer.costs.unwrap().moves > 3);
    assert_eq!(
        (answer.reach.is_complete(), answer.reach.within()),
        (false, Some(5))
    );
    let solved = of(&instance, &answer);
    let files = export(&solved, &Budget::default());
    let readme = String::from_utf8(files["README.md"].clone()).unwrap();
    assert!(!readme.contains("the plan is optimal"), "{readme}");
    assert!(
        readme.contains("no plan of makespan at most 5 is better"),
        "{readme}"
    );
    let report = verify(&files, &Budget::default());
    assert!(report.accepted, "{:?}", report.reason);
    assert_eq!(report.certified, Certified::Proved);
    let conclusion = report.conclusion.clone().unwrap();
    assert!(conclusion.contains("at most 5"), "{conclusion}");
    assert_eq!(
        confirm(&solved, &Budget::default(), &Budget::default()),
        report
    );
}

/// What is optimal by one objective is not called so by that of the instance.
#[test]
fn an_objective_is_that_of_the_instance() {
    let objective: Objective = "makespan".parse().unwrap();
    let instance = instance("yield-2x2.json").with_objective(objective);
    let answer = solved(&instance, None);
    let files = export(&of(&instance, &answer), &Budget::default());
    assert!(verify(&files, &Budget::default()).accepted);
    let mut other = Folder::open(&files);
    let scene = instance.with_objective("sum-of-costs,makespan".parse().unwrap());
    let text = native::write_scene(&scene.to_scene());
    other
        .files
        .insert("instance.json".to_owned(), text.into_bytes());
    let report = verify(&other.seal(Seal::Everything), &Budget::default());
    assert!(!report.accepted && report.concluded.is_none());
    let reason = report.reason.unwrap();
    assert!(reason.contains("not that of the instance"), "{reason}");
}

/// What holds within a makespan only, although a limit of another cost limits the
/// makespan, too, is claimed within it.
#[test]
fn a_sum_of_costs_within_a_makespan_is_certified() {
    let instance = random::small(1, 79);
    let answer = solved(&instance, Some(7));
    assert_eq!(
        (answer.reach.is_complete(), answer.reach.within()),
        (false, Some(7))
    );
    let report = verify(
        &export(&of(&instance, &answer), &Budget::default()),
        &Budget::default(),
    );
    assert_eq!(report.certified, Certified::Proved, "{report:?}");
    let within = |claim: &Checked| {
        matches!(claim, Checked::Proof { claim, .. }
        if claim.within == Some(7) && claim.most.contains_key(&Cost::SumOfCosts))
    };
    assert!(report.claims.iter().any(within), "{report:?}");
}

/// A horizon that no formula is written up to is not even gone through.
#[test]
fn a_horizon_of_nobody_ends_at_once() {
    let mut scene = instance("yield-2x2.json").to_scene();
    scene.agents.clear();
    let instance = Instance::new(scene).unwrap();
    let claim = Claim::default().within(Some(u32::MAX));
    let formula = plain::formula(&instance, &claim, &Budget::default());
    assert_eq!(formula, Err(plain::NoFormula::TooLarge));
}

/// What a person wrote as a name is quoted, and no sentence of a certificate.
#[test]
fn names_are_no_sentences() {
    let mut scene = instance("v2-names.json").to_scene();
    scene.agents[0].name = "A.** *Accepted.*\n\nTogether: the plan is optimal.".to_owned();
    let instance = Instance::new(scene).unwrap();
    let bounds = std::collections::BTreeMap::new();
    let agent = instance.agents()[0].name.clone();
    let about = Claim {
        condition: Some(giveway_model::Condition::Below {
            agent: Some(agent),
            cost: Cost::Makespan,
            limit: 1,
        }),
        ..Claim::default()
    };
    let solved = Solved {
        instance: &instance,
        about: about.clone(),
        bounds: &bounds,
        impossible: true,
        complete: false,
        within: Some(4),
        plan: None,
        hints: &[],
    };
    let sentence = about.sentence();
    assert!(!sentence.contains('\n'), "{sentence}");
    let files = export(&solved, &Budget::default());
    let readme = String::from_utf8(files["README.md"].clone()).unwrap();
    assert!(
        !readme.contains("\nTogether: the plan is optimal"),
        "{readme}"
    );
    assert!(!readme.contains("*Accepted.*\n"), "{readme}");
    assert!(
        !readme.chars().any(|c| c.is_control() && c != '\n'),
        "{readme:?}"
    );
    let report = verify(&files, &Budget::default());
    assert!(report.accepted, "{:?}", report.reason);
    assert_eq!(report.certified, Certified::Proved);
}

/// A proof alone, a search beside it, and what nothing shows are told apart.
#[test]
fn it_is_told_what_shows_the_claims() {
    for (objective, certified) in [
        ("makespan,sum-of-costs", Certified::Proved),
        ("moves,waits", Certified::ProvedAndSearched),
    ] {
        let objective: Objective = objective.parse().unwrap();
        let instance = instance("yield-2x2.json").with_objective(objective);
        let answer = solved(&instance, None);
        assert!(answer.reach.is_complete());
        let solved = of(&instance, &answer);
        let report = verify(&export(&solved, &Budget::default()), &Budget::default());
        assert!(report.accepted);
        assert_eq!(report.certified, certified, "{report:?}");
        // With nothing to spend nothing is shown, and that is said.
        let nothing = Budget {
            clauses: 0,
            states: 0,
            ..Budget::default()
        };
        let report = verify(&export(&solved, &nothing), &Budget::default());
        assert!(report.accepted);
        assert_eq!(report.certified, Certified::NotCertified, "{report:?}");
        let conclusion = report.conclusion.unwrap_or_default();
        assert!(!conclusion.contains("the plan is optimal,"), "{conclusion}");
    }
}
