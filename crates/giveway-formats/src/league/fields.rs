//! The keys of a result that are looked at, as they are written.

use std::borrow::Cow;

use serde::Deserialize;
use serde::de::{self, IgnoredAny, SeqAccess};

use crate::shapes::{Text, entries, left, shapes};
use giveway_model::tr;

/// A result. Other keys are passed over.
#[derive(Deserialize)]
#[serde(rename_all = "camelCase")]
pub(super) struct Fields<'a> {
    #[serde(borrow)]
    pub(super) action_model: Text<'a>,
    #[serde(borrow)]
    pub(super) version: Option<Text<'a>>,
    #[serde(borrow, rename = "AllValid")]
    pub(super) all_valid: Option<Text<'a>>,
    #[serde(borrow)]
    pub(super) start: Vec<Start<'a>>,
    #[serde(borrow)]
    pub(super) actual_paths: Vec<Text<'a>>,
    pub(super) team_size: Option<usize>,
    pub(super) agent_max_counter: Option<u32>,
    pub(super) sum_of_cost: Option<u64>,
    pub(super) makespan: Option<u64>,
    #[serde(default)]
    pub(super) errors: Vec<IgnoredAny>,
    #[serde(borrow, default)]
    pub(super) events: Vec<Vec<Event<'a>>>,
    #[serde(default)]
    pub(super) tasks: Vec<Vec<Part>>,
}

/// A start: row, column, and where the robot looks if it does.
pub(super) struct Start<'a> {
    pub(super) row: i32,
    pub(super) column: i32,
    pub(super) heading: Option<Cow<'a, str>>,
}

shapes!(<'de: 'a, 'a> Start<'a> as Start<'de>, tr!("a start [row, column, heading]"), {
    fn visit_seq<A: SeqAccess<'de>>(self, mut list: A) -> Result<Start<'de>, A::Error> {
        let row = list.next_element()?;
        let column = list.next_element()?;
        let (Some(row), Some(column)) = (row, column) else {
            return Err(de::Error::invalid_length(usize::from(row.is_some()), &self));
        };
        let heading = list.next_element::<Text<'de>>()?;
        // The makers' own program writes both letters of a robot that looks to the south.
        let second = list.next_element::<Text<'de>>()?;
        let is_letter = |Text(text): &Text<'_>| matches!(&**text, "E" | "S" | "W" | "N");
        let more = left(list)?;
        if more > 0 || second.is_some_and(|second| !is_letter(&second)) {
            return Err(de::Error::invalid_length(4, &self));
        }
        Ok(Start {
            row,
            column,
            heading: heading.map(|Text(text)| text),
        })
    }
});

/// A number of an event, or an event of a robot's own list.
pub(super) enum Event<'a> {
    Number(i64),
    /// Task, time, and what happened.
    OfTask(i64, Cow<'a, str>),
}

shapes!(
    <'de: 'a, 'a> Event<'a> as Event<'de>,
    tr!("a whole number, or a list of task, time and what happened"),
    {
    fn visit_i64<E: de::Error>(self, number: i64) -> Result<Event<'de>, E> {
        Ok(Event::Number(number))
    }

    fn visit_u64<E: de::Error>(self, number: u64) -> Result<Event<'de>, E> {
        Ok(Event::Number(i64::try_from(number).unwrap_or(i64::MAX)))
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut list: A) -> Result<Event<'de>, A::Error> {
        let task = list.next_element()?;
        let _time: Option<i64> = list.next_element()?;
        let what = list.next_element::<Text<'de>>()?;
        let (Some(task), Some(Text(what))) = (task, what) else {
            let length = usize::from(task.is_some());
            return Err(de::Error::invalid_length(length, &self));
        };
        match left(list)? {
            0 => Ok(Event::OfTask(task, what)),
            _ => Err(de::Error::invalid_length(4, &self)),
        }
    }
});

/// A number of a task, or the rows and columns of its errands.
pub(super) enum Part {
    Number(i64),
    Errands(Vec<i32>),
}

shapes!(<'de> Part as Part, tr!("a whole number, or a list of rows and columns"), {
    fn visit_i64<E: de::Error>(self, number: i64) -> Result<Part, E> {
        Ok(Part::Number(number))
    }

    fn visit_u64<E: de::Error>(self, number: u64) -> Result<Part, E> {
        Ok(Part::Number(i64::try_from(number).unwrap_or(i64::MAX)))
    }

    fn visit_seq<A: SeqAccess<'de>>(self, list: A) -> Result<Part, A::Error> {
        entries(list).map(Part::Errands)
    }
});
