//! Changes of the files beside the manifest, and of what it says of them.

use std::path::Path;

use giveway_model::{Cell, Cost, Instance, Objective, Plan, check, format::native};
use rand::RngExt;
use rand::seq::IndexedRandom;
use rand_chacha::ChaCha8Rng;
use serde_json::json;

use super::Folder;
use crate::oracle::{Question, Verdict};
use crate::random;

/// A line less, or one twice, of a file whose name ends so.
pub(super) fn lines(folder: &mut Folder, ending: &str, random: &mut ChaCha8Rng) -> Option<()> {
    let names: Vec<String> = folder.files.keys().cloned().collect();
    let names: Vec<String> = names.into_iter().filter(|n| n.ends_with(ending)).collect();
    let file = folder.files.get_mut(names.choose(random)?)?;
    let text = String::from_utf8(file.clone()).ok()?;
    let mut lines: Vec<&str> = text.lines().collect();
    let some = random.random_range(0..lines.len());
    if random.random_bool(0.5) {
        lines.remove(some);
    } else {
        lines.insert(some, lines[some]);
    }
    *file = format!("{}\n", lines.join("\n")).into_bytes();
    Some(())
}

pub(super) fn proof(folder: &mut Folder, other: &Folder, random: &mut ChaCha8Rng) -> Option<()> {
    let drats = |folder: &Folder| -> Vec<String> {
        let names = folder
            .files
            .keys()
            .filter(|name| Path::new(name).extension() == Some("drat".as_ref()));
        names.cloned().collect()
    };
    let name = drats(folder).choose(random)?.clone();
    let lent = drats(other)
        .choose(random)
        .and_then(|name| other.files.get(name).cloned());
    let file = folder.files.get_mut(&name)?;
    *file = match random.random_range(0..4) {
        0 => Vec::new(),
        1 => b"0\n".to_vec(),
        2 => lent?,
        _ => {
            let cut = random.random_range(0..=file.len());
            file[..cut].to_vec()
        }
    };
    Some(())
}

/// Another plan, with what it costs.
pub(super) fn plan(folder: &mut Folder, random: &mut ChaCha8Rng) -> Option<()> {
    let instance = folder.instance()?;
    let mut plan = folder.plan()?;
    let names: Vec<String> = plan.paths.keys().cloned().collect();
    let name = names.choose(random)?;
    let path = plan.paths.get_mut(name)?;
    let some = random.random_range(0..path.len());
    match random.random_range(0..9) {
        0 => path[some] = Some(Cell::new(0, 0)),
        1 => path.insert(some, path[some]),
        2 => drop(path.remove(some)),
        3 => plan
            .charges
            .entry(name.clone())
            .or_default()
            .push(some as u32),
        4 => drop(plan.charges.remove(name)?),
        // What is said of plans in a world that changes.
        5 => drop(plan.from.insert(name.clone(), some as u32)),
        6 => drop(plan.slept.insert(name.clone(), vec![[0, some as u32]])),
        7 => {
            plan.until.insert(name.clone(), some as u32);
            plan.knows = Some(some as u32);
        }
        _ => plan = worse(&instance, random)?,
    }
    put_plan(folder, &instance, &plan);
    Some(())
}

/// A plan that is best by another objective.
fn worse(instance: &Instance, random: &mut ChaCha8Rng) -> Option<Plan> {
    let objective = Objective::new(vec![*Cost::USUAL.choose(random)?]).ok()?;
    let instance = instance.clone().with_objective(objective);
    let question = Question {
        instance: &instance,
        within: None,
        cap: 200_000,
    };
    match question.best() {
        Verdict::Best(point) => Some(point.plan),
        Verdict::Impossible | Verdict::Capped => None,
    }
}

fn put_plan(folder: &mut Folder, instance: &Instance, plan: &Plan) {
    let text = native::write_plan(plan).into_bytes();
    folder.files.insert("plan.json".to_owned(), text);
    folder.manifest["costs"] = json!(check::costs(instance, plan));
}

/// Another instance; in half of the cases its best plan takes the place of the
/// old one.
pub(super) fn instance(folder: &mut Folder, random: &mut ChaCha8Rng) -> Option<()> {
    let old = folder.instance()?;
    let mut scene = old.to_scene();
    let cells: Vec<Cell> = old.grid().cells().map(|(cell, _)| cell).collect();
    let mut put = |cell: Cell, c: &str| {
        let (x, y) = (cell.x as usize, cell.y as usize);
        scene.map[y].replace_range(x..=x, c);
    };
    match random.random_range(0..5) {
        0 => put(random::spare_cell(&old, random.random())?, "#"),
        1 | 2 => {
            let obstacles: Vec<Cell> = cells
                .into_iter()
                .filter(|&cell| old.grid().ground(cell).is_some_and(|g| !g.is_vertex()))
                .collect();
            put(*obstacles.choose(random)?, ".");
        }
        3 => put(random::spare_cell(&old, random.random())?, "+"),
        _ => {
            let agent = scene.agents.first_mut()?;
            agent.battery = None;
            agent.waypoints.pop();
        }
    }
    let new = Instance::new(scene).ok()?;
    let text = native::write_scene(&new.to_scene()).into_bytes();
    folder.files.insert("instance.json".to_owned(), text);
    if random.random_bool(0.5)
        && let Some(plan) = worse(&new, random)
        && folder.plan().is_some()
    {
        put_plan(folder, &new, &plan);
    }
    Some(())
}

pub(super) fn objective(folder: &mut Folder, random: &mut ChaCha8Rng) -> Option<()> {
    let count = random.random_range(1..=2);
    let costs: Vec<Cost> = Cost::USUAL.sample(random, count).copied().collect();
    let objective = Objective::new(costs).ok()?;
    folder.manifest["objective"] = json!(objective);
    if random.random_bool(0.7) {
        let new = folder.instance()?.with_objective(objective);
        let text = native::write_scene(&new.to_scene()).into_bytes();
        folder.files.insert("instance.json".to_owned(), text);
    }
    Some(())
}

/// Names that lead elsewhere, or to nothing.
pub(super) fn name(folder: &mut Folder, random: &mut ChaCha8Rng) -> Option<()> {
    const NAMES: [&str; 7] = [
        "../makespan",
        "/etc/passwd",
        "",
        ".",
        "a/b",
        "makespan\0",
        "con\u{202e}",
    ];
    let new = *NAMES.choose(random)?;
    let claims = folder.manifest["claims"].as_array_mut()?;
    let mut proofs = claims.iter_mut().filter(|claim| claim["kind"] == "proof");
    if let Some(proof) = proofs.next()
        && random.random_bool(0.6)
    {
        let old = proof["name"].as_str()?.to_owned();
        proof["name"] = json!(new);
        for ending in ["cnf", "drat", "names.txt"] {
            let file = folder.files.remove(&format!("{old}.{ending}"))?;
            folder.files.insert(format!("{new}.{ending}"), file);
        }
    } else if random.random_bool(0.5) {
        folder.files.insert(new.to_owned(), b"more".to_vec());
    } else {
        let names: Vec<String> = folder.files.keys().cloned().collect();
        folder.files.remove(names.choose(random)?);
    }
    Some(())
}
