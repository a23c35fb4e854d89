//! The request for new plans after changes, and the methods to make them.

use std::borrow::Cow;
use std::fmt;
use std::str::FromStr;

use giveway_model::{Objective, Plan, Scene, change::Changes, format::from_object};
use serde::{Deserialize, Deserializer, Serialize, Serializer, de};

use crate::Limits;

/// A way to go on with a plan.
///
/// ```
/// use giveway_solve::change::Method;
/// assert_eq!("tunnel=2".parse(), Ok(Method::Tunnel(2)));
/// assert_eq!(Method::Replan.to_string(), "replan");
/// ```
#[derive(
    Clone,
    Copy,
    Debug,
    PartialEq,
    Eq,
    PartialOrd,
    Ord,
    borsh::BorshSerialize,
    borsh::BorshDeserialize,
)]
pub enum Method {
    /// Old agents keep their sequence of cells.
    Revise,
    /// Old agents keep within so many steps of the rest of their paths.
    Tunnel(u32),
    /// Everyone plans freely.
    Replan,
}

/// A word that names no method.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct UnknownMethod(pub String);

impl fmt::Display for UnknownMethod {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let word = &self.0;
        write!(f, "found \"{word}\", expected revise, tunnel=W or replan")
    }
}

impl std::error::Error for UnknownMethod {}

impl fmt::Display for Method {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Revise => f.write_str("revise"),
            Self::Tunnel(width) => write!(f, "tunnel={width}"),
            Self::Replan => f.write_str("replan"),
        }
    }
}

impl FromStr for Method {
    type Err = UnknownMethod;

    fn from_str(word: &str) -> Result<Self, UnknownMethod> {
        let width = || word.strip_prefix("tunnel=")?.parse().ok();
        match word {
            "revise" => Ok(Self::Revise),
            "replan" => Ok(Self::Replan),
            _ => match width() {
                Some(width) => Ok(Self::Tunnel(width)),
                None => Err(UnknownMethod(word.to_owned())),
            },
        }
    }
}

impl Serialize for Method {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_str(self)
    }
}

impl<'de> Deserialize<'de> for Method {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let word = Cow::<str>::deserialize(deserializer)?;
        word.parse().map_err(de::Error::custom)
    }
}

/// Go on with a plan around which the world changes.
#[derive(
    Clone, Debug, PartialEq, Serialize, Deserialize, borsh::BorshSerialize, borsh::BorshDeserialize,
)]
#[serde(deny_unknown_fields)]
pub struct ChangeRequest {
    /// The instance, unchecked.
    pub scene: Scene,
    /// The plan. It may be one that was adopted after some of the changes; then
    /// the later ones are looked at.
    pub plan: Plan,
    /// The changes.
    pub changes: Changes,
    /// The first time whose changes are new to the plan: it was adopted after
    /// those before. Without it the plan itself says what it knows
    /// ([`Plan::knows`]); a plan that does not knows as few times as make it
    /// valid.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub since: Option<u32>,
    /// The methods, tried and compared at each time; the first that has a plan
    /// is adopted.
    #[serde(default = "default_methods")]
    pub methods: Vec<Method>,
    /// The objective, where it is not the scene's own. The makespan counts
    /// first, wherever it stands.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub objective: Option<Objective>,
    /// The horizon, in time steps from 0: only plans of at most this makespan
    /// count.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub within: Option<u32>,
    /// The budget for each method at each time.
    #[serde(default, deserialize_with = "from_object")]
    pub limits: Limits,
}

fn default_methods() -> Vec<Method> {
    vec![Method::Revise, Method::Replan]
}
