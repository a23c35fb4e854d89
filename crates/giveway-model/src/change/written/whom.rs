//! An agent of a change as it is written.

use std::fmt;

use serde::de::value::MapAccessDeserializer;
use serde::de::{self, MapAccess, Visitor};
use serde::{Deserialize, Deserializer, Serialize};

use crate::{Agent, tr};

/// An agent as a whole, or its name.
#[derive(Clone, Debug, Serialize)]
#[serde(untagged)]
pub(super) enum Whom {
    Agent(Agent),
    Name(String),
}

impl<'de> Deserialize<'de> for Whom {
    /// By hand, so that a fault inside of an agent keeps its place.
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct Either;

        impl<'de> Visitor<'de> for Either {
            type Value = Whom;

            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str(tr!("the name of a robot, or a robot"))
            }

            fn visit_str<E: de::Error>(self, name: &str) -> Result<Whom, E> {
                Ok(Whom::Name(name.to_owned()))
            }

            fn visit_map<A: MapAccess<'de>>(self, map: A) -> Result<Whom, A::Error> {
                Agent::deserialize(MapAccessDeserializer::new(map)).map(Whom::Agent)
            }
        }

        deserializer.deserialize_any(Either)
    }
}
