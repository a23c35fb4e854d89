//! Questions about rules, reasons with rules in them, and repairs of rules.

use giveway_model::format::native;
use giveway_model::{Constraint, Instance, Question};
use giveway_solve::explain::{
    Edit, ExplainAnswer, ExplainRequest, FactKind, Helps, Verdict, edited_instance,
};
use giveway_solve::{Refusal, Request, Response, SilentHost, serve};
use giveway_tests::rules_random::{KINDS, scene_with_rules};

use super::{optimum, padded, scenes};

fn ask(instance: &Instance, question: Question) -> Result<ExplainAnswer, Refusal> {
    let request = ExplainRequest {
        scene: instance.to_scene(),
        plan: None,
        changes: None,
        at: None,
        question,
        objective: None,
        within: None,
        proved: None,
        known: None,
        layers: Vec::new(),
        limits: giveway_solve::Limits::default(),
    };
    match serve(&Request::Explain(request), &SilentHost) {
        Response::Explained(answer) => Ok(*answer),
        Response::Refused(refusal) => Err(refusal),
        other => panic!("{other:?}"),
    }
}

/// Repairs are plans of the edited scene, and best ones.
fn compare_repairs(instance: &Instance, answer: &ExplainAnswer, what: &str) -> usize {
    let mut compared = 0;
    for repair in &answer.repairs {
        let edited = edited_instance(instance, &repair.edits);
        let text = native::write_scene(&edited.to_scene());
        let report = giveway_model::check::check(&edited, &repair.plan);
        assert!(
            report.is_valid(),
            "{what}: {repair:?} {:?}",
            report.violations
        );
        let objective = edited.in_force(edited.objective().clone());
        let told: Vec<i64> = repair
            .costs
            .vector(&objective)
            .into_iter()
            .map(i64::from)
            .collect();
        match optimum(&text, &[]) {
            None => continue,
            Some(None) => panic!("{what}: {repair:?}"),
            Some(Some(costs)) if answer.exhaustive => {
                assert_eq!(told, padded(costs, told.len()), "{what}: {repair:?}");
            }
            Some(Some(costs)) => assert!(told >= padded(costs, told.len()), "{what}"),
        }
        // One less does not help.
        if let ([edit], true) = (repair.edits.as_slice(), repair.least)
            && let Some(less) = one_less(edit, instance)
        {
            let text = native::write_scene(&edited_instance(instance, &[less]).to_scene());
            assert_eq!(optimum(&text, &[]).flatten(), None, "{what}: {repair:?}");
        }
        compared += 1;
    }
    compared
}

/// An edit of a rule that asks for one less, where that is more than today.
fn one_less(edit: &Edit, instance: &Instance) -> Option<Edit> {
    let today = |index: u32| &instance.constraints()[index as usize].kind;
    match edit {
        Edit::AllowMore { index, rule, most } => {
            (most - 1 > today(*index).most()?).then(|| Edit::AllowMore {
                index: *index,
                rule: rule.clone(),
                most: most - 1,
            })
        }
        Edit::GiveUntil { index, rule, to } => {
            (to - 1 > today(*index).last_chance()?).then(|| Edit::GiveUntil {
                index: *index,
                rule: rule.clone(),
                to: to - 1,
            })
        }
        Edit::RemoveObstacle { .. }
        | Edit::AddCharger { .. }
        | Edit::Battery { .. }
        | Edit::BatteryFloor { .. }
        | Edit::Deadline { .. }
        | Edit::MakeNormal { .. }
        | Edit::DropWaypoint { .. }
        | Edit::Vanish
        | Edit::LeaveOut { .. }
        | Edit::SwitchOff { .. } => None,
    }
}

#[test]
fn questions_about_rules_have_the_verdict_of_the_oracle() {
    let mut seen = std::collections::BTreeMap::new();
    for number in 0..scenes(150) {
        // Rules that cost only are not asked about.
        let kinds = [
            KINDS[number as usize % 14],
            KINDS[number as usize / 14 % 12],
        ];
        let mut scene = scene_with_rules(78, number, &kinds);
        let text = scene.to_string();
        let Some(rule) = scene["constraints"].as_array_mut().unwrap().pop() else {
            continue;
        };
        let what = format!("scene {number}, {kinds:?}\n{text}");
        let without = scene.to_string();
        let instance = native::read_instance(&without).unwrap();
        let rule: Constraint = serde_json::from_value(rule).unwrap();
        let (Some(Some(own)), Some(other)) = (optimum(&without, &[]), optimum(&text, &[])) else {
            continue;
        };
        let question = Question::Rule {
            rule: Box::new(rule),
        };
        let answer = match ask(&instance, question) {
            Ok(answer) => answer,
            Err(Refusal::Question { misfit }) => {
                assert_eq!(
                    other.map(|it| padded(it, own.len())),
                    Some(own),
                    "{what}: {misfit}"
                );
                *seen.entry("it is so").or_insert(0) += 1;
                continue;
            }
            Err(refusal) => panic!("{what}: {refusal:?}"),
        };
        let expected = match &other {
            None => Verdict::Necessary,
            Some(costs) if *costs == own => Verdict::Needless,
            Some(_) => Verdict::Costly,
        };
        assert_eq!(answer.verdict, expected, "{what}");
        if let (Some(costs), Some(found)) = (&other, answer.costs) {
            let objective = instance.in_force(instance.objective().clone());
            let found: Vec<i64> = found
                .vector(&objective)
                .into_iter()
                .map(i64::from)
                .collect();
            assert_eq!(found, *costs, "{what}");
        }
        let word = match expected {
            Verdict::Necessary => "necessary",
            Verdict::Needless => "needless",
            _ => "costly",
        };
        *seen.entry(word).or_insert(0) += 1;
    }
    assert_eq!(seen.len(), 4, "{seen:?}");
    assert!(seen.values().all(|&n| n > 5), "{seen:?}");
}

#[test]
fn without_a_plan_rules_are_facts_and_repairs() {
    let (mut facts, mut repairs) = (0, 0);
    for number in 0..scenes(150) {
        let kinds = [
            KINDS[number as usize % 14],
            KINDS[number as usize / 14 % 14],
        ];
        let scene = scene_with_rules(79, number, &kinds);
        let text = scene.to_string();
        if optimum(&text, &[]) != Some(None) {
            continue;
        }
        let what = format!("scene {number}, {kinds:?}\n{text}");
        let instance = native::read_instance(&text).unwrap();
        let answer = ask(&instance, Question::Unsolvable).unwrap();
        assert_eq!(answer.verdict, Verdict::Necessary, "{what}");
        let core = answer.core.as_ref().unwrap_or_else(|| panic!("{what}"));
        for fact in core
            .facts
            .iter()
            .filter(|fact| fact.kind == FactKind::Constraint)
        {
            let rule = fact.index.unwrap() as usize;
            let Some(found) = optimum(&text, &[rule]) else {
                continue;
            };
            let helps = Helps::from(Some(found.is_some()));
            assert!(
                [helps, Helps::Unknown].contains(&fact.helps),
                "{what}: {fact:?}"
            );
            facts += 1;
        }
        repairs += compare_repairs(&instance, &answer, &what);
    }
    assert!(
        facts > 10 && repairs > 30,
        "{facts} facts, {repairs} repairs"
    );
}
