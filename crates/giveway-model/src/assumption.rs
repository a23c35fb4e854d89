//! The assumptions of a scene: parts of the problem that its file leaves open, or states beyond what a scene
//! can hold.

use borsh::{BorshDeserialize, BorshSerialize};
use serde::{Deserialize, Serialize};

use crate::words::and;
use crate::{Cell, tr};

/// The most assumptions of a scene.
pub const MAX_ASSUMPTIONS: usize = 4096;

/// Something that a scene takes for granted. Whatever is said of the scene is said under it.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, BorshSerialize, BorshDeserialize)]
#[serde(tag = "assumes", rename_all = "kebab-case", deny_unknown_fields)]
pub enum Assumption {
    /// Agents may choose from several goals or tasks; those of the scene were chosen. A plan
    /// for the scene is one for the file, but another choice may have a better one.
    GoalsChosen,
    /// An obstacle that moves: no agent is where it is, or exchanges cells with it.
    MovingObstacle {
        /// Its name.
        name: String,
        /// Its cell at each time from 0; it stays at the last one. It may leave the map.
        path: Vec<Cell>,
        /// Whether rules of the scene close the cells where it is. Exchanges of cells, which
        /// no such rule can forbid, are then all that is looked at here.
        #[serde(default, skip_serializing_if = "std::ops::Not::not")]
        closed: bool,
    },
    /// A rule of the problem in the file that scenes do not have. It forbids plans and allows
    /// none: bounds hold with the rule, too, but a plan that is found need not keep it.
    RuleLeftOut {
        /// The rule.
        rule: LeftOutRule,
    },
    /// A key whose meaning is not known, or which is not heeded: it may change the problem.
    UnknownKey {
        /// The keys on the way to it, such as `agents.speed`.
        key: String,
    },
}

impl Assumption {
    /// The same in times that begin at a later time.
    #[must_use]
    pub fn from_time_on(&self, time: u32) -> Self {
        match self {
            Self::MovingObstacle { name, path, closed } => Self::MovingObstacle {
                name: name.clone(),
                path: {
                    let past = (time as usize).min(path.len().saturating_sub(1));
                    path.get(past..).unwrap_or_default().to_vec()
                },
                closed: *closed,
            },
            Self::GoalsChosen | Self::RuleLeftOut { .. } | Self::UnknownKey { .. } => self.clone(),
        }
    }
}

/// A rule of other problems that scenes do not have. A plan that keeps it is also a plan of the
/// scene and costs the same.
#[derive(
    Clone,
    Copy,
    Debug,
    PartialEq,
    Eq,
    PartialOrd,
    Ord,
    Serialize,
    Deserialize,
    BorshSerialize,
    BorshDeserialize,
)]
#[serde(rename_all = "kebab-case")]
pub enum LeftOutRule {
    /// A robot turns before it goes another way, and a turn takes a step (`MAPF_T`).
    Turning,
    /// A move takes several steps (the ticks of the League of 2026).
    LongMoves,
    /// The errands of a task are done in their order.
    ErrandOrder,
    /// Shelves are lifted, carried and put down, and goods are delivered (asprilo).
    Handling,
}

impl LeftOutRule {
    /// All rules.
    pub const ALL: [Self; 4] = [
        Self::Turning,
        Self::LongMoves,
        Self::ErrandOrder,
        Self::Handling,
    ];

    /// The rule in a few words.
    fn words(self) -> &'static str {
        match self {
            Self::Turning => tr!("a rule" => "a turn takes a step"),
            Self::LongMoves => tr!("a rule" => "a move takes several steps"),
            Self::ErrandOrder => tr!("a rule" => "errands are done in their order"),
            Self::Handling => {
                tr!("a rule" => "shelves are lifted, carried and put down, and goods are delivered")
            }
        }
    }
}

/// The rules that are left out, in words; `None` where there is none.
pub fn left_out(assumptions: &[Assumption]) -> Option<String> {
    let rules = assumptions.iter().filter_map(|one| match one {
        Assumption::RuleLeftOut { rule } => Some(rule.words().to_owned()),
        Assumption::GoalsChosen
        | Assumption::MovingObstacle { .. }
        | Assumption::UnknownKey { .. } => None,
    });
    let rules: Vec<String> = rules.collect();
    (!rules.is_empty()).then(|| rules.join("; "))
}

/// Assumptions in sentences, those of one kind together.
pub fn sentences(assumptions: &[Assumption]) -> Vec<String> {
    let mut sentences = Vec::new();
    let (mut moving, mut keys, mut chosen) = (Vec::new(), Vec::new(), false);
    for assumption in assumptions {
        match assumption {
            Assumption::GoalsChosen => chosen = true,
            Assumption::MovingObstacle { name, .. } => moving.push(name.clone()),
            Assumption::UnknownKey { key } => keys.push(key.clone()),
            Assumption::RuleLeftOut { .. } => {}
        }
    }
    if chosen {
        sentences.push(tr!("The file leaves goals or tasks open. Whatever is said here is said for those that were chosen.").to_owned());
    }
    if !moving.is_empty() {
        sentences.push(tr!("The file has obstacles that move: {names}. No robot may be where one is, or exchange cells with one.", names = and(&moving)));
    }
    if let Some(rules) = left_out(assumptions) {
        sentences.push(tr!("Rules of the file's problem that are left out here: {rules}. Whatever is said here is said without them: a plan may break them. What every plan costs at least holds with them, too.", rules));
    }
    if !keys.is_empty() {
        sentences.push(tr!("The file has keys that are not heeded and may change the problem: {keys}. Whatever is said here is said for the scene without them.", keys = and(&keys)));
    }
    sentences
}
