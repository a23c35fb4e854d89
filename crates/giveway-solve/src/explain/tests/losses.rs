//! Who arrives last, or loses most, against each agent solved alone.

use giveway_model::question::from_words;

use super::growing::{budget, solved};
use crate::{
    explain::{fitting::FittingQuestion, here::here, losses::loss, whole::WholePlan},
    tests::random,
};

#[test]
fn it_is_the_last_to_arrive_or_who_loses_most_beside_its_optimum_alone() {
    let (mut last, mut lost) = (0, 0);
    for seed in 0..40 {
        let instance = random(seed, 3);
        let Some((plan, costs)) = solved(&instance) else {
            continue;
        };
        let arrivals = giveway_model::check::arrivals(&instance, &plan);
        let mut rows = Vec::new();
        for (agent, arrival) in instance.agents().iter().zip(arrivals) {
            let mut alone = instance.clone();
            alone.retain_agents(|it| it.name == agent.name);
            let (_, least) = solved(&alone).unwrap();
            rows.push((arrival.unwrap(), least.makespan, agent.name.clone()));
        }
        for words in ["makespan", "sum-of-costs"] {
            let question = from_words(&[words]).unwrap();
            let whole = WholePlan::default();
            let case = FittingQuestion::new(&instance, &question, &plan, costs, None, whole);
            let told = loss(&case, &budget()).unwrap();
            let row = (told.arrival, told.alone, told.agent);
            assert!(rows.contains(&row), "{seed}: {row:?} of {rows:?}");
            let here = here(&case, &budget()).unwrap();
            if words == "makespan" {
                assert_eq!(row.0, costs.makespan, "{seed}");
                let begins = format!("{} arrives last, at {}; alone it", row.2, row.0);
                assert!(here.words.starts_with(&begins), "{seed}: {}", here.words);
                last += u32::from(row.1 < row.0);
            } else {
                let most = rows.iter().map(|it| it.0 - it.1).max();
                assert_eq!(Some(row.0 - row.1), most, "{seed}");
                let begins = if most > Some(0) {
                    format!("{} loses most: it arrives at {}", row.2, row.0)
                } else {
                    "Each robot arrives as soon".to_owned()
                };
                assert!(here.words.starts_with(&begins), "{seed}: {}", here.words);
                lost += row.0 - row.1;
            }
        }
    }
    assert!(last > 2 && lost > 5, "{last} {lost}");
}
