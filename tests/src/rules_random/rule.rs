//! A random rule of each kind.

use rand::RngExt;
use rand::seq::{IndexedRandom, SliceRandom};
use serde_json::{Value, json};

use super::{Spot, World};

impl World<'_> {
    fn zone(&mut self) -> Value {
        let count = self.random.random_range(1..=self.free.len().min(4));
        let mut cells = self.free.clone();
        cells.shuffle(self.random);
        cells.truncate(count);
        let name = format!("zone {}", self.zones.len());
        self.zones.push(json!({ "name": name, "cells": cells }));
        json!(name)
    }

    fn times(&mut self, rule: &mut Value) {
        let from = self.random.random_range(0..=5);
        match self.random.random_range(0..4) {
            0 => rule["from"] = json!(from),
            1 => rule["to"] = json!(from),
            2 => {
                rule["from"] = json!(from);
                rule["to"] = json!(from + self.random.random_range(0..=4));
            }
            _ => {}
        }
    }

    fn at(&mut self) -> Value {
        let agent = self.random.random_range(0..self.agents);
        json!({ "agent": format!("A{agent}"), "cell": self.cell() })
    }

    /// A rule of a kind; `null` where the map has none.
    pub(super) fn rule(&mut self, kind: &str) -> Value {
        let mut rule = json!({ "kind": kind });
        match kind {
            "capacity" => {
                rule["zone"] = self.zone();
                rule["most"] = json!(self.random.random_range(0..=2));
                self.times(&mut rule);
            }
            "closed" => {
                rule["zone"] = self.zone();
                self.times(&mut rule);
            }
            "one-way" => {
                let mut lane = vec![self.cell()];
                for _ in 0..self.random.random_range(1..=3) {
                    let (x, y) = lane[lane.len() - 1];
                    let next = |&&(a, b): &&Spot| a.abs_diff(x) + b.abs_diff(y) == 1;
                    let next: Vec<&Spot> = self.free.iter().filter(next).collect();
                    let next = next.into_iter().filter(|spot| !lane.contains(spot));
                    let next: Vec<&Spot> = next.collect();
                    let Some(&&next) = next.choose(self.random) else {
                        break;
                    };
                    lane.push(next);
                }
                if lane.len() < 2 {
                    return Value::Null;
                }
                rule["lane"] = json!(lane);
            }
            "gap" => rule["steps"] = json!(self.random.random_range(1..=3)),
            "apart" => {
                rule["distance"] = json!(self.random.random_range(2..=3));
                self.times(&mut rule);
            }
            "sequence" => {
                let cells = (0..self.random.random_range(1..=3)).map(|_| self.cell());
                let cells: Vec<Spot> = cells.collect();
                rule["cells"] = json!(cells);
                rule["agent"] = json!(format!("A{}", self.random.random_range(0..self.agents)));
                return rule;
            }
            "visit" => {
                rule["cell"] = json!(self.cell());
                let stay = self.random.random_range(0..=2);
                rule["stay"] = json!(stay);
                self.times(&mut rule);
                if let Some(to) = rule["to"].as_u64() {
                    rule["to"] = json!(to + stay + 2);
                }
            }
            "arrive" => {
                let by = self.random.random_range(2..=9);
                if self.random.random_bool(0.6) {
                    rule["from"] = json!(self.random.random_range(0..=by));
                }
                if rule["from"].is_null() || self.random.random_bool(0.4) {
                    rule["by"] = json!(by);
                }
            }
            "late" => {
                rule["kind"] = json!("arrive");
                rule["by"] = json!(self.random.random_range(0..=5));
                rule["weight"] = json!(self.random.random_range(1..=5));
            }
            "depart" => rule["from"] = json!(self.random.random_range(0..=4)),
            "before" => {
                rule["first"] = self.at();
                rule["second"] = self.at();
                return rule;
            }
            "no-waiting" => {
                rule["zone"] = self.zone();
                rule["most"] = json!(self.random.random_range(0..=2));
            }
            "turns" => rule["quarter"] = json!(self.random.random_range(1..=2)),
            _ => {
                rule["zone"] = self.zone();
                rule["weight"] = json!(self.random.random_range(1..=5));
            }
        }
        if self.random.random_bool(0.4) {
            let mut names: Vec<String> = (0..self.agents).map(|i| format!("A{i}")).collect();
            names.shuffle(self.random);
            names.truncate(self.random.random_range(1..=self.agents));
            rule["agents"] = json!(names);
        }
        rule
    }
}
