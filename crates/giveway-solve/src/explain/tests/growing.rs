//! Smallest sets of agents that force an answer, against all subsets; what is left of them,
//! against a second solve.

use std::collections::{BTreeMap, BTreeSet};
use std::rc::Rc;

use giveway_model::{
    Costs, Instance, Plan, Question,
    question::{fits, from_words},
};

use crate::{
    Limits, SilentHost,
    budget::Budget,
    explain::{
        Verdict,
        alone::subset_bounds,
        ask::{Ask, best},
        causes::Refuted,
        contrasted::ContrastSearch,
        explanation::ExplainAnswer,
        fact_groups::MOST_GROUPS,
        fitting::FittingQuestion,
        group::{groups, without},
        group_mus::{Inquiry, Tried, group_mus_of_agents},
        growing::{Extending, only, smallest_set},
        verdict::compare,
        whole::WholePlan,
    },
    problem::Relaxed,
    tests::random,
};

pub(super) fn budget() -> Rc<Budget<'static>> {
    Rc::new(Budget::new(&SilentHost, Limits::default()))
}

pub(super) fn solved(instance: &Instance) -> Option<(Plan, Costs)> {
    solved_within(instance, None)
}

fn solved_within(instance: &Instance, within: Option<u32>) -> Option<(Plan, Costs)> {
    let ask = Ask {
        instance,
        relaxed: &Relaxed::default(),
        conditions: &[],
        objective: instance.objective(),
        caps: &BTreeMap::new(),
        within,
        at_least_within: 0,
    };
    let found = best(&ask, &budget());
    found.plan.zip(found.costs)
}

/// The size of the smallest set of agents without a plan as asked for, those asked about
/// apart, by trying every set.
fn by_brute_force(refuted: &Refuted, inquiry: &mut dyn Inquiry) -> Option<usize> {
    let count = refuted.instance.agents().len();
    let mut smallest: Option<usize> = None;
    for bits in 0..1_u32 << count {
        let mut agents: BTreeSet<usize> = (0..count).filter(|it| bits & (1 << it) != 0).collect();
        agents.extend(refuted.asked);
        let size = agents.len() - refuted.asked.len();
        if smallest.is_some_and(|smallest| smallest <= size) {
            continue;
        }
        let variant = only(refuted, &agents);
        let tried = inquiry.search(&variant).reaching(&variant, refuted.reach);
        if matches!(tried, Tried::None { .. }) {
            smallest = Some(size);
        }
    }
    smallest
}

/// Questions whose contrast takes away some plans of any few agents.
fn questions(instance: &Instance) -> Vec<Question> {
    let mut words = vec!["makespan".to_owned(), "sum-of-costs".to_owned()];
    for agent in instance.agents() {
        words.push(format!("arrival {}", agent.name));
        words.push(format!("wait {}", agent.name));
    }
    let question = |words: &String| {
        let words: Vec<&str> = words.split(' ').collect();
        from_words(&words).unwrap()
    };
    words.iter().map(question).collect()
}

#[test]
fn no_smaller_set_of_agents_forces_the_answer() {
    let mut sizes: BTreeMap<(usize, Verdict), u32> = BTreeMap::new();
    for seed in 0..60 {
        let instance = random(seed, 3 + (seed % 2) as usize);
        let Some((plan, costs)) = solved(&instance) else {
            continue;
        };
        for question in &questions(&instance) {
            let whole = WholePlan::default();
            if fits(question, &instance, &plan).is_err() {
                continue;
            }
            let case = FittingQuestion::new(&instance, question, &plan, costs, None, whole);
            let compared = compare(&case, None, &budget());
            let verdict = compared.verdict;
            let Some(reach) = compared.reach else {
                continue;
            };
            if !matches!(verdict, Verdict::Necessary | Verdict::Costly) {
                continue;
            }
            let searching = || ContrastSearch {
                case: &case,
                most: (verdict == Verdict::Costly).then(|| costs.vector(case.objective())),
                near: None,
                horizon: costs.makespan,
                budget: budget(),
            };
            let asked: Vec<usize> = (0..instance.agents().len())
                .filter(|&i| question.agent() == Some(instance.agents()[i].name.as_str()))
                .collect();
            let refuted = Refuted {
                instance: &instance,
                asked: &asked,
                deadline: None,
                reach,
            };
            let known = std::iter::once(plan.clone());
            let known = known.chain(compared.other.map(|(plan, _)| plan));
            let own = budget();
            let mut extending = Extending::new(&instance, known.collect(), costs.makespan, &own);
            let found = smallest_set(&refuted, &mut extending, &mut searching());
            let smallest = by_brute_force(&refuted, &mut searching());
            let at = format!("{seed} {question:?}");
            let found = found.unwrap_or_else(|| panic!("{at}: none, expected {smallest:?}"));
            assert!(found.is_smallest, "{at}");
            let size = found.agents.len() - asked.len();
            assert_eq!(Some(size), smallest, "{at}: {:?}", found.agents);
            *sizes.entry((size, verdict)).or_default() += 1;

            let core = group_mus_of_agents(&refuted, found, &mut searching());
            let mut left_out: BTreeSet<_> = groups(&instance, &asked, false).into_iter().collect();
            left_out.retain(|group| !core.groups.contains(group));
            let tried = searching().search(&without(&instance, &left_out, None));
            assert!(
                matches!(tried, Tried::None { .. }),
                "{at}: {:?}",
                core.groups
            );
            for &group in &core.groups {
                let mut less = left_out.clone();
                less.insert(group);
                let tried = searching().search(&without(&instance, &less, None));
                assert!(
                    matches!(tried, Tried::Plan(_)) || !core.minimal,
                    "{at}: {group:?}"
                );
            }
            let told = core.core(&instance, None);
            assert!(told.groups.len() <= MOST_GROUPS, "{at}");
            let mut facts: Vec<u32> = told.groups.iter().flat_map(|it| it.facts.clone()).collect();
            facts.sort_unstable();
            let all: Vec<u32> = (0..told.facts.len() as u32).collect();
            assert!(
                facts == all || (told.groups.is_empty() && all.len() <= 3),
                "{at}"
            );
        }
    }
    let of_size = |size| sizes.iter().filter(|((it, _), _)| *it == size).count();
    assert!(
        of_size(0) > 0 && of_size(1) > 0 && of_size(2) > 0,
        "{sizes:?}"
    );
}

#[test]
fn what_a_set_alone_needs_is_its_own_optimum() {
    let mut lost = 0;
    for seed in 0..40 {
        let instance = random(seed, 3);
        let Some((plan, costs)) = solved(&instance) else {
            continue;
        };
        for words in ["makespan", "sum-of-costs"] {
            let question = from_words(&[words]).unwrap();
            let whole = WholePlan::default();
            let case = FittingQuestion::new(&instance, &question, &plan, costs, None, whole);
            let compared = compare(&case, None, &budget());
            let Some(reach) = compared.reach else {
                continue;
            };
            let refuted = Refuted {
                instance: &instance,
                asked: &[],
                deadline: None,
                reach,
            };
            let answer = ExplainAnswer {
                verdict: compared.verdict,
                ..ExplainAnswer::empty(&question)
            };
            for bound in subset_bounds(&case, refuted, &answer, None, &budget()) {
                let mut alone = instance.clone();
                alone.retain_agents(|agent| bound.agents.contains(&agent.name));
                let alone = alone.with_objective(words.parse().unwrap());
                let (_, least) = solved_within(&alone, Some(costs.makespan)).unwrap();
                assert_eq!(least.get(bound.cost), bound.least, "{seed} {bound:?}");
                assert!(
                    bound.own <= bound.least && bound.least <= bound.here,
                    "{seed} {bound:?}"
                );
                lost += bound.lost();
            }
        }
    }
    assert!(lost > 5, "{lost}");
}
