//! By hand against the planner: the same tree by its rule, the same optimum by any choices.

use fastrand::Rng;

use super::{Choice, Hand, HandError, Standing};
use crate::{
    budget::{CountedBudget, Unlimited},
    cbs::{CbsCost, Ended, Fate, Outcome, Party, Tree, search},
    problem::Problem,
    tests::instance,
};

const HORIZON: u32 = 40;
/// That of random instances.
const SHORT: u32 = 24;
/// Random instances that take more states are left out.
const MOST_STATES: u64 = 1_500;
/// A search by random choices may get lost: it is left then.
const PATIENCE: usize = 40;

fn problem(picture: &str) -> Problem {
    Problem::new(&instance(picture), &Unlimited::default())
        .ok()
        .unwrap()
}

fn hand(problem: &Problem) -> Hand<'_> {
    Hand::new(problem, CbsCost::SumOfCosts, HORIZON, &Unlimited::default()).unwrap()
}

/// Robots on a small floor, with hardly any room, made by chance.
fn crowd(seed: u64) -> Option<Problem> {
    let mut rng = Rng::with_seed(seed);
    let mut cells: Vec<usize> = (0..12).collect();
    rng.shuffle(&mut cells);
    let mut places = vec![String::new(); 12];
    places[cells[0]] = "#".to_owned();
    let mut cells = cells.into_iter().skip(1);
    for (mark, goal) in [('a', 'A'), ('b', 'B'), ('c', 'C')] {
        for mark in [mark, goal] {
            places[cells.next()?].push(mark);
        }
    }
    let ground = |place: &String| {
        if place.is_empty() {
            ".".to_owned()
        } else {
            place.clone()
        }
    };
    let rows: Vec<String> = places
        .chunks(4)
        .map(|row| row.iter().map(ground).collect::<Vec<_>>().join(" "))
        .collect();
    Problem::new(&instance(&rows.join("\n")), &Unlimited::default()).ok()
}

/// Those that CBS finishes soon, after it had something to split, each with how it did.
fn finished() -> impl Iterator<Item = (u64, Problem, Outcome)> {
    let problems = (0..120).filter_map(|seed| Some((seed, crowd(seed)?)));
    problems.filter_map(|(seed, problem)| {
        let unlimited = Unlimited::default();
        let budget = CountedBudget::new(&unlimited, MOST_STATES);
        let outcome = search(&problem, CbsCost::SumOfCosts, SHORT, true, &budget);
        let is_best = matches!(outcome.ended, Ended::Best { .. }) && outcome.taken > 1;
        is_best.then_some((seed, problem, outcome))
    })
}

fn has_bypass(tree: &Tree) -> bool {
    tree.nodes.iter().any(|node| match node.fate {
        Fate::Split { bypassed, .. } | Fate::Best { bypassed, .. } => bypassed > 0,
        Fate::Open | Fate::Dead => false,
    })
}

#[test]
fn by_the_planners_choices_it_is_the_planners_tree() {
    let budget = Unlimited::default();
    let mut compared = 0;
    for (seed, problem, outcome) in finished() {
        let tree = outcome.tree.unwrap();
        if has_bypass(&tree) {
            continue;
        }
        let mut hand = Hand::new(&problem, CbsCost::SumOfCosts, SHORT, &budget).unwrap();
        // The planner opens the cheapest node, of these the calmest, of these the newest.
        while !matches!(hand.standing(), Standing::Proved { .. }) || is_to_be_opened(&hand) {
            let open = hand.open();
            let next = open.min_by_key(|&node| key(&hand, node)).unwrap();
            let rule = hand.rule(next).unwrap();
            hand.split(rule, &budget).unwrap();
        }
        let own = hand.tree();
        let told = |tree: &Tree| -> Vec<String> {
            let nodes = tree.nodes.iter().map(|node| {
                let is_split = matches!(node.fate, Fate::Split { .. });
                let (parent, walks) = (node.parent, &node.walks);
                let (asked, cost) = (node.constraint, node.cost);
                format!(
                    "{parent:?} {asked:?} {cost:?} {} {walks:?} {is_split}",
                    node.conflicts
                )
            });
            nodes.collect()
        };
        assert_eq!(told(&own), told(&tree), "seed {seed}");
        compared += 1;
    }
    assert!(compared > 15, "only {compared}");
}

/// The order in which the planner opens nodes.
fn key(hand: &Hand, node: usize) -> (u32, usize, std::cmp::Reverse<usize>) {
    let own = &hand.nodes[node];
    (
        own.cost.unwrap(),
        own.conflicts.len(),
        std::cmp::Reverse(node),
    )
}

/// The planner takes a plan out in its turn: of nodes as dear, those without a conflict come first.
fn is_to_be_opened(hand: &Hand) -> bool {
    let Some(plan) = hand.plan() else { return true };
    hand.open().any(|node| key(hand, node) < key(hand, plan))
}

#[test]
fn whatever_is_chosen_what_is_proved_is_the_optimum() {
    let budget = Unlimited::default();
    let mut proved = 0;
    for (seed, problem, outcome) in finished() {
        let Ended::Best { proved: best, .. } = outcome.ended else {
            continue;
        };
        let mut rng = Rng::with_seed(seed);
        let mut hand = Hand::new(&problem, CbsCost::SumOfCosts, SHORT, &budget).unwrap();
        let cost = loop {
            let standing = hand.standing();
            if let Standing::Proved { cost, .. } = standing {
                break Some(cost);
            }
            if hand.splits().len() > PATIENCE {
                break None;
            }
            let open: Vec<usize> = hand.open().collect();
            let node = open[rng.usize(..open.len())];
            let choice = Choice {
                node,
                conflict: rng.usize(..hand.conflicts(node).len()),
                party: [Party::First, Party::Second][rng.usize(..2)],
            };
            let told = hand.preview(choice, &budget).unwrap();
            match hand.split(choice, &budget) {
                Ok(made) => {
                    let made = made.map(|node| (hand.nodes[node].cost, hand.conflicts(node).len()));
                    assert_eq!(made, told.map(|branch| (branch.cost, branch.conflicts)));
                }
                Err(other) => panic!("seed {seed}: {other:?}"),
            }
        };
        let Some(cost) = cost else { continue };
        assert_eq!(cost, least(best, &problem), "seed {seed}");
        proved += 1;
    }
    assert!(proved > 10, "only {proved}");
}

/// The cost of the best plan by the planner, where its bound reaches it.
fn least(proved: crate::cbs::Proved, problem: &Problem) -> u32 {
    assert_eq!(proved.within(), None, "{}", problem.agents());
    proved.bound().at_least()
}

#[test]
fn what_is_taken_back_is_as_before() {
    let budget = Unlimited::default();
    for (seed, problem, _) in finished().take(30) {
        let mut hand = Hand::new(&problem, CbsCost::SumOfCosts, SHORT, &budget).unwrap();
        let mut before = vec![(hand.tree(), hand.standing())];
        while let Some(node) = hand.open().last().filter(|_| before.len() < 6) {
            let choice = Choice {
                node,
                conflict: 0,
                party: Party::Second,
            };
            hand.split(choice, &budget).unwrap();
            before.push((hand.tree(), hand.standing()));
        }
        while let Some((tree, standing)) = before.pop() {
            assert_eq!(
                (hand.tree(), hand.standing()),
                (tree, standing),
                "seed {seed}"
            );
            assert_eq!(hand.take_back().is_some(), !before.is_empty());
        }
    }
}

#[test]
fn what_cannot_be_split_says_why() {
    let budget = Unlimited::default();
    let problem = problem(
        "# b #
         a . A
         # B #",
    );
    let mut hand = hand(&problem);
    let choice = |node, conflict| Choice {
        node,
        conflict,
        party: Party::First,
    };
    let split = |hand: &mut Hand, choice| hand.split(choice, &budget);
    assert_eq!(split(&mut hand, choice(1, 0)), Err(HandError::NotOpen));
    let none = Err(HandError::NoConflict { of: 1 });
    assert_eq!(split(&mut hand, choice(0, 1)), none);
    assert_eq!(split(&mut hand, choice(0, 0)), Ok([1, 2]));
    assert_eq!(split(&mut hand, choice(0, 0)), Err(HandError::NotOpen));
    // Both branches are plans of 5.
    assert_eq!(hand.open().count(), 0);
    assert_eq!(hand.plan(), Some(1));
    assert!(matches!(hand.standing(), Standing::Proved { cost: 5, .. }));
    assert_eq!(hand.walks(1).map(|walks| walks.len()), Some(2));
    // What was split can be looked at still.
    assert!(hand.preview(choice(0, 0), &budget).is_ok());
}

#[test]
fn a_plan_is_not_proved_while_a_cheaper_branch_is_open() {
    let budget = Unlimited::default();
    let problem = problem(LANES);
    let mut hand = hand(&problem);
    let split = |hand: &mut Hand, node, pair| {
        let conflicts = hand.conflicts(node).iter();
        let mut pairs = conflicts.map(|one| (one.first, one.second));
        let conflict = pairs.position(|other| other == pair).unwrap();
        let party = Party::First;
        let choice = Choice {
            node,
            conflict,
            party,
        };
        hand.split(choice, &budget).unwrap();
    };
    // b arrives after c has passed (17), or before (15): then it waits for a, which is a plan.
    split(&mut hand, 0, (1, 2));
    split(&mut hand, 2, (1, 0));
    let Standing::Found {
        cost, least_open, ..
    } = hand.standing()
    else {
        panic!("{:?}", hand.standing());
    };
    assert_eq!((cost, least_open), (18, 17));
    split(&mut hand, 1, (0, 2));
    assert!(matches!(hand.standing(), Standing::Proved { cost: 18, .. }));
    assert_eq!((hand.count(), hand.plan()), (7, Some(3)));
}

/// A plan comes in the second split, while another branch is cheaper.
const LANES: &str = "
    . . A . c .
    # . . # # .
    . # B b # .
    aC . . . . .";

#[test]
fn a_tree_without_an_end_ends_at_the_most_splits() {
    let budget = Unlimited::default();
    let problem = problem("aB . . . bA");
    let mut hand = hand(&problem);
    let ended = loop {
        let Some(node) = hand.open().next() else {
            break None;
        };
        let choice = hand.rule(node).unwrap();
        if let Err(why) = hand.split(choice, &budget) {
            break Some(why);
        }
    };
    match ended {
        Some(why) => assert_eq!(why, HandError::Full),
        None => assert!(matches!(hand.standing(), Standing::Exhausted { .. })),
    }
}
