//! The keys of a result that are looked at, as they are written.

use std::borrow::Cow;
use std::fmt;

use serde::de::{self, IgnoredAny, SeqAccess, Visitor};
use serde::{Deserialize, Deserializer};

use crate::tr;

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

/// A text that points into the file where it holds no escapes.
#[derive(Deserialize)]
pub(super) struct Text<'a>(#[serde(borrow)] pub(super) Cow<'a, str>);

/// A start: row, column, and where the robot looks if it does.
pub(super) struct Start<'a> {
    pub(super) row: i32,
    pub(super) column: i32,
    pub(super) heading: Option<Cow<'a, str>>,
}

impl<'de: 'a, 'a> Deserialize<'de> for Start<'a> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct List;

        impl<'de> Visitor<'de> for List {
            type Value = Start<'de>;

            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str(tr!("a start [row, column, heading]"))
            }

            fn visit_seq<A: SeqAccess<'de>>(self, mut list: A) -> Result<Self::Value, A::Error> {
                let row = list.next_element()?;
                let column = list.next_element()?;
                let (Some(row), Some(column)) = (row, column) else {
                    return Err(de::Error::invalid_length(usize::from(row.is_some()), &self));
                };
                let heading = list.next_element::<Text<'de>>()?;
                while list.next_element::<IgnoredAny>()?.is_some() {}
                Ok(Start {
                    row,
                    column,
                    heading: heading.map(|Text(text)| text),
                })
            }
        }

        deserializer.deserialize_seq(List)
    }
}

/// A number of an event, or an event of a robot's own list.
pub(super) enum Event<'a> {
    Number(i64),
    /// Task, time, and what happened.
    OfTask(i64, Cow<'a, str>),
}

impl<'de: 'a, 'a> Deserialize<'de> for Event<'a> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct Either;

        impl<'de> Visitor<'de> for Either {
            type Value = Event<'de>;

            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str(tr!(
                    "a whole number, or a list of task, time and what happened"
                ))
            }

            fn visit_i64<E: de::Error>(self, number: i64) -> Result<Self::Value, E> {
                Ok(Event::Number(number))
            }

            fn visit_u64<E: de::Error>(self, number: u64) -> Result<Self::Value, E> {
                Ok(Event::Number(i64::try_from(number).unwrap_or(i64::MAX)))
            }

            fn visit_seq<A: SeqAccess<'de>>(self, mut list: A) -> Result<Self::Value, A::Error> {
                let task = list.next_element()?;
                let _time: Option<i64> = list.next_element()?;
                let what = list.next_element::<Text<'de>>()?;
                let (Some(task), Some(Text(what))) = (task, what) else {
                    return Err(de::Error::invalid_length(
                        usize::from(task.is_some()),
                        &self,
                    ));
                };
                while list.next_element::<IgnoredAny>()?.is_some() {}
                Ok(Event::OfTask(task, what))
            }
        }

        deserializer.deserialize_any(Either)
    }
}

/// A number of a task, or the rows and columns of its errands.
pub(super) enum Part {
    Number(i64),
    Errands(Vec<i32>),
}

impl<'de> Deserialize<'de> for Part {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct Either;

        impl<'de> Visitor<'de> for Either {
            type Value = Part;

            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str(tr!("a whole number, or a list of rows and columns"))
            }

            fn visit_i64<E: de::Error>(self, number: i64) -> Result<Part, E> {
                Ok(Part::Number(number))
            }

            fn visit_u64<E: de::Error>(self, number: u64) -> Result<Part, E> {
                Ok(Part::Number(i64::try_from(number).unwrap_or(i64::MAX)))
            }

            fn visit_seq<A: SeqAccess<'de>>(self, mut list: A) -> Result<Part, A::Error> {
                let mut numbers = Vec::new();
                while let Some(number) = list.next_element()? {
                    numbers.push(number);
                }
                Ok(Part::Errands(numbers))
            }
        }

        deserializer.deserialize_any(Either)
    }
}
