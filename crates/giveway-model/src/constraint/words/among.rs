//! A constraint of many robots in few words: those that it leaves out, or how many it binds.

use super::list;
use crate::words::and;
use crate::{Agent, Constraint, tr};

/// Of more robots not all are named.
const MOST_NAMED: usize = 4;

/// Names that stand for all robots of a rule while its sentence is made: no name has them.
const STAND_INS: [&str; 2] = ["\u{e000}", "\u{e001}"];

impl Constraint {
    /// The robots that it binds in few words, where they are many among these: `all robots but
    /// A17`, or `A1, A2, A3 and 12 more`. `all` is how a sentence calls all of them.
    pub fn who_among(&self, agents: &[Agent], all: &str) -> Option<String> {
        let names = self.agents.as_deref()?;
        if names.len() <= MOST_NAMED {
            return None;
        }
        let others = agents.iter().map(|agent| &agent.name);
        let others: Vec<&String> = others.filter(|name| !names.contains(name)).collect();
        if (1..MOST_NAMED).contains(&others.len()) {
            return Some(tr!("{all} but {robots}", all, robots = and(&others)));
        }
        let (first, more) = names.split_at(MOST_NAMED - 1);
        Some(tr!(
            "{robots} and {n} more" | "{robots} and {n} more" % more.len(),
            robots = first.join(", ")
        ))
    }

    /// The constraint by its name, or else by its sentence, with few words for many robots. No
    /// reader takes such a sentence: it is for a person.
    ///
    /// ```
    /// use giveway_model::{Agent, Cell, Constraint};
    /// let text = r#"{ "kind": "capacity", "zone": "dock", "most": 1,
    ///     "agents": ["A1", "A2", "A3", "A4", "A5"] }"#;
    /// let rule: Constraint = serde_json::from_str(text).unwrap();
    /// let agents = ["A1", "A2", "A3", "A4", "A5", "A6"].map(|name| Agent::new(name, Cell::new(0, 0), None));
    /// assert_eq!(rule.called_among(&agents), r#"the rule "At most 1 of all robots but A6 in 'dock'""#);
    /// ```
    pub fn called_among(&self, agents: &[Agent]) -> String {
        let all = tr!("at most 1, each or none of" => "all robots");
        match self.who_among(agents, all) {
            Some(who) if self.name.is_none() => {
                let stand_ins = STAND_INS.map(str::to_owned);
                let robots = list(&stand_ins);
                let brief = Self {
                    agents: Some(stand_ins.to_vec()),
                    ..self.clone()
                };
                brief.called().replace(&robots, &who)
            }
            Some(_) | None => self.called(),
        }
    }
}
