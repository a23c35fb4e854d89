//! Repairs of instances without a plan against the oracle, which tries every edit and
//! many pairs of edits by itself: a repair that is told helps, at the costs that it is
//! told with (the least ones where all were tried to the end), and nothing less of its
//! kind does; where the answer says that all were
//! tried, no other edit helps, and no other pair of edits of which neither does alone.
//!
//! `GIVEWAY_RANDOM_REPAIRS` sets how many instances are looked at (30 by default),
//! `GIVEWAY_RANDOM_SEED` the seed. The long run:
//!
//! ```text
//! GIVEWAY_RANDOM_REPAIRS=2000 GIVEWAY_RANDOM_SEED=7 \
//!     cargo test --release -p giveway-tests --test repairs_oracle -- --nocapture
//! ```
#![allow(
    clippy::unwrap_used,
    clippy::print_stdout,
    reason = "a test that cannot go on ends with a panic"
)]

use std::collections::{BTreeMap, BTreeSet};

use giveway_model::{AtGoal, Instance};
use giveway_solve::explain::{Edit, ExplainAnswer, Repair, edited_instance};
use giveway_tests::oracle::{self, Verdict};
use giveway_tests::{ask, environment, random};

/// Labels that the oracle may make for one question.
const CAP: usize = 100_000;
/// Pairs that are not told, and that the oracle tries, of one instance.
const MOST_PAIRS: usize = 40;
/// A battery that lasts longer than any plan that these instances need.
const LARGE_BATTERY: u32 = 60;

fn best(instance: &Instance) -> Verdict {
    let question = oracle::Question {
        instance,
        within: None,
        cap: CAP,
    };
    question.best()
}

/// Whether there is a plan after some edits; `None` where that is too large.
fn helps(instance: &Instance, edits: &[Edit]) -> Option<bool> {
    match best(&edited_instance(instance, edits)) {
        Verdict::Best(_) => Some(true),
        Verdict::Impossible => Some(false),
        Verdict::Capped => None,
    }
}

/// An edit without how far it goes: the same for any battery of one agent, and for any
/// battery floor.
fn kind(edit: &Edit) -> Edit {
    match edit {
        Edit::Battery { agent, .. } => Edit::Battery {
            agent: agent.clone(),
            capacity: LARGE_BATTERY,
            initial: LARGE_BATTERY,
        },
        Edit::BatteryFloor { .. } => Edit::BatteryFloor { floor: 0 },
        edit => edit.clone(),
    }
}

fn kinds(edits: &[Edit]) -> BTreeSet<Edit> {
    edits.iter().map(kind).collect()
}

/// Every edit of an instance, each as far-reaching as it can be.
fn all_edits(instance: &Instance) -> Vec<Edit> {
    let mut edits = Vec::new();
    let agents = instance.agents();
    let has_battery = agents.iter().any(|agent| agent.battery.is_some());
    for (cell, ground) in instance.grid().cells() {
        if !ground.is_vertex() {
            edits.push(Edit::RemoveObstacle { cell });
        }
        if ground.is_slow() {
            edits.push(Edit::MakeNormal { cell });
        }
        if has_battery && ground.is_vertex() && !ground.is_charger() {
            edits.push(Edit::AddCharger { cell });
        }
    }
    if has_battery && instance.rules().battery_floor > 0 {
        edits.push(Edit::BatteryFloor { floor: 0 });
    }
    if instance.rules().at_goal == AtGoal::Stay {
        edits.push(Edit::Vanish);
    }
    for agent in agents {
        let name = || agent.name.clone();
        if agents.len() > 1 {
            edits.push(Edit::LeaveOut { agent: name() });
        }
        if agent.battery.is_some() {
            edits.push(Edit::Battery {
                agent: name(),
                capacity: LARGE_BATTERY,
                initial: LARGE_BATTERY,
            });
        }
        edits.extend(agent.waypoints.iter().map(|&cell| Edit::DropWaypoint {
            agent: name(),
            cell,
        }));
    }
    edits
}

/// Edits that ask for a little less than one of a battery or a floor.
fn less(instance: &Instance, edit: &Edit) -> Vec<Edit> {
    let mut less = Vec::new();
    match edit {
        Edit::Battery {
            agent,
            capacity,
            initial,
        } => {
            let of = |capacity, initial| Edit::Battery {
                agent: agent.clone(),
                capacity,
                initial,
            };
            let agents = instance.agents().iter();
            let today = agents.filter(|a| a.name == *agent).find_map(|a| a.battery);
            let today = today.unwrap();
            if *capacity > today.capacity {
                less.push(of(capacity - 1, capacity - 1));
            }
            if *initial > today.initial {
                less.push(of(*capacity, initial - 1));
            }
        }
        Edit::BatteryFloor { floor } => less.push(Edit::BatteryFloor { floor: floor + 1 }),
        Edit::RemoveObstacle { .. }
        | Edit::AddCharger { .. }
        | Edit::Deadline { .. }
        | Edit::MakeNormal { .. }
        | Edit::DropWaypoint { .. }
        | Edit::Vanish
        | Edit::LeaveOut { .. }
        // No instance here has rules of its own.
        | Edit::SwitchOff { .. }
        | Edit::AllowMore { .. }
        | Edit::GiveUntil { .. } => {}
    }
    less
}

/// What was looked at.
#[derive(Debug, Default)]
struct Seen {
    instances: u64,
    /// Repairs that are told, by their number of edits and the kind of the first.
    told: BTreeMap<(usize, String), u64>,
    /// Batteries and floors of which a little less does not help.
    least: u64,
    useless_singles: u64,
    useless_pairs: u64,
    /// Answers that say that all repairs were tried.
    exhaustive: u64,
    too_large: u64,
}

impl Seen {
    /// Looks at the repairs of an answer; tells what is wrong with them.
    fn look(&mut self, number: u64, instance: &Instance, answer: &ExplainAnswer) -> Vec<String> {
        self.instances += 1;
        let mut faults = Vec::new();
        for repair in &answer.repairs {
            self.look_at_repair(instance, repair, answer.exhaustive, &mut faults);
        }
        if answer.exhaustive && answer.further_repairs == 0 {
            self.exhaustive += 1;
            self.look_for_others(number, instance, answer, &mut faults);
        }
        faults
    }

    fn look_at_repair(
        &mut self,
        instance: &Instance,
        repair: &Repair,
        is_proved: bool,
        faults: &mut Vec<String>,
    ) {
        let name = format!("{:?}", repair.edits[0]);
        let name = name.split([' ', '{']).next().unwrap().to_owned();
        *self.told.entry((repair.edits.len(), name)).or_default() += 1;
        match best(&edited_instance(instance, &repair.edits)) {
            Verdict::Best(point) => {
                let told = repair.costs.vector(instance.objective());
                let is_proved = is_proved || repair.proved;
                let is_right = told == point.vector || (!is_proved && told > point.vector);
                if !is_right {
                    faults.push(format!("costs {:?}: {}", point.vector, repair.text));
                }
            }
            Verdict::Impossible => faults.push(format!("does not help: {}", repair.text)),
            Verdict::Capped => self.too_large += 1,
        }
        for (index, edit) in repair.edits.iter().enumerate().filter(|_| repair.least) {
            for less in less(instance, edit) {
                let mut edits = repair.edits.clone();
                edits[index] = less;
                match helps(instance, &edits) {
                    Some(true) => faults.push(format!("{edits:?} would do: {}", repair.text)),
                    Some(false) => self.least += 1,
                    None => self.too_large += 1,
                }
            }
        }
        let is_pair = repair.edits.len() > 1;
        for edit in repair.edits.iter().filter(|_| is_pair) {
            if helps(instance, &[kind(edit)]) == Some(true) {
                faults.push(format!("{edit:?} would do: {}", repair.text));
            }
        }
    }

    /// Every edit alone, and pairs of those that do not help alone.
    fn look_for_others(
        &mut self,
        number: u64,
        instance: &Instance,
        answer: &ExplainAnswer,
        faults: &mut Vec<String>,
    ) {
        let told: BTreeSet<_> = answer.repairs.iter().map(|r| kinds(&r.edits)).collect();
        let is_told = |edits: &[Edit]| told.contains(&kinds(edits));
        let mut useless = Vec::new();
        for edit in all_edits(instance) {
            let edits = std::slice::from_ref(&edit);
            match helps(instance, edits) {
                Some(true) if is_told(edits) => {}
                Some(true) => faults.push(format!("{edit:?} would help, too")),
                Some(false) => useless.push(edit),
                None => self.too_large += 1,
            }
        }
        self.useless_singles += useless.len() as u64;
        for pair in random::pairs(&useless, number, MOST_PAIRS) {
            if is_told(&pair) || leaves_nobody(instance, &pair) {
                continue;
            }
            match helps(instance, &pair) {
                Some(true) => faults.push(format!("{pair:?} would help, too")),
                Some(false) => self.useless_pairs += 1,
                None => self.too_large += 1,
            }
        }
    }
}

fn leaves_nobody(instance: &Instance, edits: &[Edit]) -> bool {
    edited_instance(instance, edits).agents().is_empty()
}

#[test]
fn repairs_are_those_that_help() {
    let seed = environment::number("GIVEWAY_RANDOM_SEED", 11);
    let count = environment::number("GIVEWAY_RANDOM_REPAIRS", 30);
    let (mut seen, mut wrong) = (Seen::default(), 0);
    for number in 0.. {
        if seen.instances >= count {
            break;
        }
        let instance = random::with_floor(random::small(seed, number), number);
        let Some(answer) = ask::unsolvable(&instance) else {
            continue;
        };
        let faults = seen.look(number, &instance, &answer);
        if !faults.is_empty() {
            wrong += 1;
            let scene = serde_json::to_string(&instance.to_scene()).unwrap();
            println!("{number}: {scene}");
            println!(
                "{:?}",
                answer.repairs.iter().map(|r| &r.text).collect::<Vec<_>>()
            );
            for fault in &faults {
                println!("  {fault}");
            }
        }
    }
    println!("{seen:?}");
    assert_eq!(wrong, 0, "they are printed above");
    assert!(seen.told.keys().any(|(edits, _)| *edits == 2), "{seen:?}");
    assert!(seen.exhaustive * 4 >= count, "{seen:?}");
    assert!(seen.least > 0 && seen.useless_singles > 0 && seen.useless_pairs > 0);
}
