//! What is left without a fact, against a second solve; and marks of groups that agree with what
//! is claimed of their set.

use std::collections::{BTreeMap, BTreeSet};
use std::rc::Rc;

use giveway_model::{Costs, Instance, Plan, check::costs};

use super::{handed_on::Eager, layers::questions};
use crate::{
    Limits, Request, Response, SilentHost, SolveRequest, Status,
    budget::Budget,
    explain::{
        ExplainAnswer, ExplainRequest, Fact, FactGroup, GroupMark, Helps, Layer, Verdict,
        ask::{Ask, best},
        facts_claim,
        fitting::FittingQuestion,
        group::{Group, groups, without},
        whole::WholePlan,
    },
    serve,
    tests::random,
};

/// The facts of an instance, by the facts for people.
fn group_of(instance: &Instance, fact: &Fact) -> Group {
    let mut all = groups(instance, &[], false).into_iter();
    let is_same = |group: &Group| group.fact(instance, None).text == fact.text;
    all.find(is_same).unwrap()
}

/// The least costs of the instance without some facts, with what is asked for.
fn least_without(case: &FittingQuestion, left_out: &BTreeSet<Group>) -> Option<Costs> {
    let variant = without(case.instance, left_out, None);
    let ask = |condition| {
        let ask = Ask {
            instance: &variant.instance,
            relaxed: &variant.relaxed,
            conditions: std::slice::from_ref(condition),
            objective: case.objective(),
            caps: &BTreeMap::new(),
            within: None,
            at_least_within: case.costs.makespan,
        };
        best(&ask, &Rc::new(Budget::new(&SilentHost, Limits::default())))
    };
    let found = case.conditions().filter_map(|condition| {
        let found = ask(condition);
        assert_ne!(found.status, Status::Unknown);
        found.costs
    });
    found.min_by_key(|costs| costs.vector(case.objective()))
}

fn explained(
    instance: &Instance,
    plan: &Plan,
    question: &giveway_model::Question,
) -> ExplainAnswer {
    let request = Request::Explain(ExplainRequest {
        scene: instance.to_scene(),
        plan: Some(plan.clone()),
        question: question.clone(),
        changes: None,
        at: None,
        objective: None,
        within: None,
        proved: None,
        known: None,
        layers: vec![Layer::Reason],
        limits: Limits::default(),
    });
    match serve(&request, &Eager::default()) {
        Response::Explained(answer) => *answer,
        _ => panic!("not answered"),
    }
}

#[test]
fn what_is_left_without_a_fact_is_the_optimum_without_it() {
    let (mut still, mut helped, mut claims) = (0, 0, BTreeMap::new());
    for seed in 0..60 {
        let instance = random(seed, 3 + (seed % 2) as usize);
        let request = Request::Solve(SolveRequest {
            scene: instance.to_scene(),
            ..SolveRequest::default()
        });
        let Response::Solved(solved) = serve(&request, &SilentHost) else {
            panic!("{seed}");
        };
        let Some(plan) = solved.plan.filter(|_| solved.status == Status::Optimal) else {
            continue;
        };
        for question in questions(&instance, &plan).into_iter().take(10) {
            let answer = explained(&instance, &plan, &question);
            let Some(core) = &answer.core else { continue };
            let at = format!("{seed} {question:?}");
            let before = costs(&instance, &plan).unwrap();
            let whole = WholePlan::default();
            let case = FittingQuestion::new(&instance, &question, &plan, before, None, whole);
            for price in &core.prices {
                let fact = &core.facts[price.fact as usize];
                let group = group_of(&instance, fact);
                let least = least_without(&case, &BTreeSet::from([group])).unwrap();
                let objective = instance.objective();
                let (told, least) = (price.costs.vector(objective), least.vector(objective));
                assert!(least <= told, "{at} {fact:?}");
                assert!(least == told || !price.proved, "{at} {fact:?} {price:?}");
                let is_more = told > before.vector(objective);
                let is_costly = answer.verdict == Verdict::Costly;
                let helps = fact.helps == Helps::Yes;
                assert!(is_costly || helps, "{at} {fact:?}");
                assert!(!is_costly || is_more != helps, "{at} {fact:?}");
                still += u32::from(is_costly && is_more);
                helped += u32::from(!is_more);
            }
            let marks: Vec<GroupMark> = core.groups.iter().map(FactGroup::mark).collect();
            let open = marks
                .iter()
                .filter(|&&mark| mark == GroupMark::Open)
                .count();
            let claim = facts_claim(&question, answer.verdict, core);
            let kind = match (
                claim.contains("needed for that"),
                claim.contains("may not be"),
            ) {
                (true, false) => 0,
                (true, true) if claim.contains("Each group") => 1,
                (true, true) => 2,
                (false, _) => 3,
            };
            match kind {
                0 | 1 => assert_eq!(open, 0, "{at} {claim}"),
                2 => assert!(open > 0 && open < marks.len(), "{at} {claim}"),
                _ => assert!(core.facts.len() == 1 || open == marks.len(), "{at} {claim}"),
            }
            *claims.entry(kind).or_insert(0) += 1;
        }
    }
    assert!(still > 10 && helped > 10, "{still} {helped}");
    assert!(claims.contains_key(&0), "{claims:?}");
}

/// The claim of a set says no more than the marks of its groups, and no less.
#[test]
fn a_claim_agrees_with_the_marks() {
    use crate::explain::{Core, FactGroupKind, FactKind};
    let claim = |marks: [(bool, Helps); 2]| {
        let group = |(needed, helps)| FactGroup {
            kind: FactGroupKind::Shelf,
            agents: Vec::new(),
            cells: Vec::new(),
            facts: Vec::new(),
            text: String::new(),
            needed,
            helps,
            price: None,
        };
        let fact = Fact {
            kind: FactKind::Slow,
            agents: Vec::new(),
            cell: None,
            index: None,
            time: None,
            until: None,
            text: String::new(),
            helps: Helps::Unknown,
        };
        let core = Core {
            facts: vec![fact; 4],
            groups: marks.into_iter().map(group).collect(),
            prices: Vec::new(),
            minimal: false,
            reach: None.into(),
            further: Vec::new(),
        };
        facts_claim(&giveway_model::Question::Makespan, Verdict::Costly, &core)
    };
    let (needed, helps, open) = (
        (true, Helps::No),
        (false, Helps::Yes),
        (false, Helps::Unknown),
    );
    assert!(claim([needed, helps]).contains("Each group is needed"));
    assert!(claim([needed, open]).contains("The marked groups are needed"));
    assert!(
        claim([open, open])
            .starts_with("These facts alone rule it out; some of them may not be needed.")
    );
}

/// Where no small set of agents forces an answer, edits of what the answer names are tried.
#[test]
fn repairs_are_found_without_a_small_reason() {
    use crate::explain::Edit;
    use giveway_model::question::from_words;
    let (instance, plan) = super::crossing_among_lanes();
    let request = Request::Explain(ExplainRequest {
        scene: instance.to_scene(),
        plan: Some(plan),
        question: from_words(&["visit", "a", "--at", "1,1"]).unwrap(),
        changes: None,
        at: None,
        objective: None,
        within: None,
        proved: None,
        known: None,
        layers: vec![Layer::Help],
        limits: Limits::default(),
    });
    let Response::Explained(answer) = serve(&request, &SilentHost) else {
        panic!("not answered");
    };
    assert_eq!(answer.verdict, Verdict::Costly);
    assert!(answer.core.is_none() && !answer.exhaustive);
    let leave_out = Edit::LeaveOut {
        agent: "b".to_owned(),
    };
    let edits: Vec<&[Edit]> = answer
        .repairs
        .iter()
        .map(|it| it.edits.as_slice())
        .collect();
    assert!(edits.contains(&&[leave_out][..]), "{edits:?}");
    for repair in &answer.repairs {
        let edited = crate::explain::edited_instance(&instance, &repair.edits);
        assert_eq!(costs(&edited, &repair.plan), Some(repair.costs));
        assert!(repair.costs.sum_of_costs <= 8 + 24);
    }
}
