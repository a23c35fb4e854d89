//! A scene as changes leave it.

use serde_json::{Value, json};

use crate::rules_oracle::scene::spot;

/// A scene after some changes, and whom they are about.
pub(super) struct Edited {
    /// The scene; the rules that are removed are still in it.
    pub(super) json: Value,
    /// The numbers of the rules that are removed.
    pub(super) removed: Vec<usize>,
    /// The agents that are removed.
    pub(super) gone: Vec<String>,
    /// The agents that join.
    pub(super) added: Vec<String>,
    /// Breakdowns, in steps.
    pub(super) delays: Vec<(String, i64)>,
}

pub(super) fn edited(scene: &Value, changes: &[Value]) -> Edited {
    let mut json = scene.clone();
    let mut removed = Vec::new();
    let mut gone: Vec<String> = Vec::new();
    let mut added: Vec<String> = Vec::new();
    let mut delays: Vec<(String, i64)> = Vec::new();
    for change in changes {
        let name = || change["agent"].as_str().unwrap().to_owned();
        match change["change"].as_str().unwrap() {
            "add-constraint" => {
                let rules = json["constraints"].as_array_mut().unwrap();
                rules.push(change["constraint"].clone());
            }
            "remove-constraint" => {
                let index = change["index"].as_u64().unwrap();
                removed.push(usize::try_from(index).unwrap());
            }
            "delay-agent" => delays.push((name(), change["steps"].as_i64().unwrap())),
            "remove-agent" => gone.push(name()),
            "add-agent" => {
                added.push(change["agent"]["name"].as_str().unwrap().to_owned());
                let agents = json["agents"].as_array_mut().unwrap();
                agents.push(change["agent"].clone());
            }
            "set-goal" => {
                let mut agents = json["agents"].as_array_mut().unwrap().iter_mut();
                let agent = agents.find(|agent| agent["name"] == change["agent"]);
                agent.unwrap()["goal"] = change["cell"].clone();
            }
            "add-obstacle" => {
                let (x, y) = spot(&change["cell"]);
                let (x, y) = (usize::try_from(x).unwrap(), usize::try_from(y).unwrap());
                let mut row: Vec<char> = json["map"][y].as_str().unwrap().chars().collect();
                row[x] = '#';
                json["map"][y] = json!(row.into_iter().collect::<String>());
            }
            other => panic!("no change is called {other}"),
        }
    }
    Edited {
        json,
        removed,
        gone,
        added,
        delays,
    }
}
