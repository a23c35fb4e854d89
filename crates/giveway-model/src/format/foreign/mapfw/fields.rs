//! The keys of problems and solutions, as they are written.

use std::borrow::Cow;
use std::fmt;

use serde::de::value::MapAccessDeserializer;
use serde::de::{self, IgnoredAny, MapAccess, SeqAccess, Visitor};
use serde::{Deserialize, Deserializer};

use crate::format::foreign::Pair;
use crate::tr;

/// A problem. Other keys are passed over.
#[derive(Deserialize)]
pub(super) struct Problem {
    pub(super) grid: Vec<Vec<u32>>,
    pub(super) width: Option<Side>,
    pub(super) height: Option<Side>,
    pub(super) starts: Vec<Place>,
    pub(super) goals: Vec<Place>,
    #[serde(default)]
    pub(super) waypoints: Vec<Vec<Place>>,
    solution: Option<Paths>,
}

impl Problem {
    /// The solution, and the problem without it.
    pub(super) fn split(mut self) -> (Option<Paths>, Self) {
        (self.solution.take(), self)
    }
}

/// What the server sends.
#[derive(Deserialize)]
pub(super) struct Download<'a> {
    #[serde(borrow)]
    pub(super) problems: Vec<Sent<'a>>,
}

/// A problem as a text.
#[derive(Deserialize)]
pub(super) struct Sent<'a> {
    #[serde(borrow)]
    pub(super) problem: Text<'a>,
}

/// A text that points into the file where it holds no escapes.
#[derive(Deserialize)]
pub(super) struct Text<'a>(#[serde(borrow)] pub(super) Cow<'a, str>);

/// What a client sends back.
#[derive(Deserialize)]
pub(super) struct Upload {
    pub(super) solutions: Vec<Solved>,
}

/// The paths for a problem.
#[derive(Deserialize)]
pub(super) struct Solved {
    pub(super) solution: Paths,
}

/// A width or a height: a number, or a text with one.
#[derive(Clone, Copy)]
pub(super) struct Side(pub(super) u64);

impl<'de> Deserialize<'de> for Side {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct Either;

        impl Visitor<'_> for Either {
            type Value = Side;

            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str(tr!("a whole number from 1"))
            }

            fn visit_u64<E: de::Error>(self, number: u64) -> Result<Side, E> {
                Ok(Side(number))
            }

            fn visit_str<E: de::Error>(self, text: &str) -> Result<Side, E> {
                let number = text.trim().parse();
                number
                    .map(Side)
                    .map_err(|_| E::invalid_value(de::Unexpected::Str(text), &self))
            }
        }

        deserializer.deserialize_any(Either)
    }
}

/// A cell, and its colour where it has one.
#[derive(Clone, Copy)]
pub(super) struct Place {
    pub(super) x: i32,
    pub(super) y: i32,
    pub(super) color: Option<i64>,
}

#[derive(Deserialize)]
struct Marked {
    x: i32,
    y: i32,
    color: Option<i64>,
}

impl<'de> Deserialize<'de> for Place {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct Either;

        impl<'de> Visitor<'de> for Either {
            type Value = Place;

            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str(tr!("a cell [x, y]"))
            }

            fn visit_seq<A: SeqAccess<'de>>(self, mut list: A) -> Result<Place, A::Error> {
                let x = list.next_element()?;
                let y = list.next_element()?;
                let (Some(x), Some(y)) = (x, y) else {
                    return Err(de::Error::invalid_length(usize::from(x.is_some()), &self));
                };
                let mut length = 2;
                while list.next_element::<IgnoredAny>()?.is_some() {
                    length += 1;
                }
                if length > 2 {
                    return Err(de::Error::invalid_length(length, &self));
                }
                Ok(Place { x, y, color: None })
            }

            fn visit_map<A: MapAccess<'de>>(self, map: A) -> Result<Place, A::Error> {
                let Marked { x, y, color } = Marked::deserialize(MapAccessDeserializer::new(map))?;
                Ok(Place { x, y, color })
            }
        }

        deserializer.deserialize_any(Either)
    }
}

/// Paths, a list for each robot.
pub(super) struct Paths(pub(super) Vec<Route>);

/// The cells of a path.
pub(super) struct Route(pub(super) Vec<Pair>);

#[derive(Deserialize)]
struct InPaths {
    paths: Paths,
}

#[derive(Deserialize)]
struct InRoute {
    route: Route,
}

impl<'de> Deserialize<'de> for Paths {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct Either;

        impl<'de> Visitor<'de> for Either {
            type Value = Paths;

            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str(tr!("a list of paths"))
            }

            fn visit_seq<A: SeqAccess<'de>>(self, mut list: A) -> Result<Paths, A::Error> {
                let mut paths = Vec::new();
                while let Some(route) = list.next_element()? {
                    paths.push(route);
                }
                Ok(Paths(paths))
            }

            fn visit_map<A: MapAccess<'de>>(self, map: A) -> Result<Paths, A::Error> {
                InPaths::deserialize(MapAccessDeserializer::new(map)).map(|it| it.paths)
            }
        }

        deserializer.deserialize_any(Either)
    }
}

impl<'de> Deserialize<'de> for Route {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct Either;

        impl<'de> Visitor<'de> for Either {
            type Value = Route;

            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str(tr!("a path, a list of cells"))
            }

            fn visit_seq<A: SeqAccess<'de>>(self, mut list: A) -> Result<Route, A::Error> {
                let mut cells = Vec::new();
                while let Some(Place { x, y, .. }) = list.next_element()? {
                    cells.push(Pair::new(x, y));
                }
                Ok(Route(cells))
            }

            fn visit_map<A: MapAccess<'de>>(self, map: A) -> Result<Route, A::Error> {
                InRoute::deserialize(MapAccessDeserializer::new(map)).map(|it| it.route)
            }
        }

        deserializer.deserialize_any(Either)
    }
}
