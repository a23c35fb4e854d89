//! The keys of problems and solutions, as they are written.

use serde::Deserialize;
use serde::de::value::MapAccessDeserializer;
use serde::de::{self, MapAccess, SeqAccess};

use crate::Pair;
use crate::shapes::{Text, entries, left, shapes};
use giveway_model::tr;

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

/// The problem as the server sends it.
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

/// The solution as a client sends it back.
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

shapes!(<'de> Side as Side, tr!("a whole number from 1"), {
    fn visit_u64<E: de::Error>(self, number: u64) -> Result<Side, E> {
        Ok(Side(number))
    }

    fn visit_str<E: de::Error>(self, text: &str) -> Result<Side, E> {
        let number = text.trim().parse();
        number
            .map(Side)
            .map_err(|_| E::invalid_value(de::Unexpected::Str(text), &self))
    }
});

/// A cell, and its colour where it has one.
#[derive(Clone, Copy)]
pub(super) struct Place {
    pub(super) x: i32,
    pub(super) y: i32,
    pub(super) color: Option<i64>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Marked {
    x: i32,
    y: i32,
    color: Option<i64>,
}

shapes!(<'de> Place as Place, tr!("a cell [x, y]"), {
    fn visit_seq<A: SeqAccess<'de>>(self, mut list: A) -> Result<Place, A::Error> {
        let x = list.next_element()?;
        let y = list.next_element()?;
        let (Some(x), Some(y)) = (x, y) else {
            return Err(de::Error::invalid_length(usize::from(x.is_some()), &self));
        };
        match left(list)? {
            0 => Ok(Place { x, y, color: None }),
            more => Err(de::Error::invalid_length(2 + more, &self)),
        }
    }

    fn visit_map<A: MapAccess<'de>>(self, map: A) -> Result<Place, A::Error> {
        let Marked { x, y, color } = Marked::deserialize(MapAccessDeserializer::new(map))?;
        Ok(Place { x, y, color })
    }
});

/// Paths, a list for each robot.
pub(super) struct Paths(pub(super) Vec<Route>);

/// The cells of a path.
pub(super) struct Route(pub(super) Vec<Pair>);

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct InPaths {
    paths: Paths,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct InRoute {
    route: Route,
}

shapes!(<'de> Paths as Paths, tr!("a list of paths"), {
    fn visit_seq<A: SeqAccess<'de>>(self, list: A) -> Result<Paths, A::Error> {
        entries(list).map(Paths)
    }

    fn visit_map<A: MapAccess<'de>>(self, map: A) -> Result<Paths, A::Error> {
        InPaths::deserialize(MapAccessDeserializer::new(map)).map(|it| it.paths)
    }
});

shapes!(<'de> Route as Route, tr!("a path, a list of cells"), {
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
});
