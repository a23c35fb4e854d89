//! The tracker's solutions in JSON: an object, or a list of them.

use std::borrow::Cow;

use serde::Deserialize;
use serde::de::{Error, SeqAccess};
use serde_json::value::RawValue;

use super::{Paths, Solution, Spot, plan};
use crate::limits::robots;
use crate::shapes::{Text, shapes};
use crate::unknown_keys::UnknownKeys;
use crate::{Up, WrittenPlan};
use giveway_model::compare::ClaimedBounds;
use giveway_model::format::json;
use giveway_model::format::locate::{Locator, segments};
use giveway_model::format::text::at_byte;
use giveway_model::{Fault, tr};

/// The keys of a solution that are read; all others are named in a note.
#[derive(Deserialize)]
struct Entry<'a> {
    map_name: Option<String>,
    scen_type: Option<String>,
    type_id: Option<u64>,
    agents: Option<u32>,
    solution_cost: Option<u32>,
    lower_cost: Option<u32>,
    flip_up_down: Option<bool>,
    #[serde(borrow)]
    solution_plan: Option<Paths<'a>>,
}

pub(super) fn read(text: &str) -> Result<WrittenPlan, Fault> {
    let is_list = text.trim_start().starts_with('[');
    let entries: Vec<Entry<'_>> = if is_list {
        json::read::<Entries<'_>>(text)?.0
    } else {
        vec![json::read(text)?]
    };
    let unknown = unknown_keys_of(text, is_list);
    let solutions = entries.into_iter().enumerate().map(|(i, entry)| Solution {
        place: if is_list {
            format!("[{i}].solution_plan")
        } else {
            "solution_plan".to_owned()
        },
        map: entry.map_name,
        scenario: (entry.scen_type, entry.type_id.map(|id| id.to_string())),
        agents: entry.agents.map(|agents| agents as usize),
        cost: entry.solution_cost.map(u64::from),
        bounds: ClaimedBounds {
            sum_of_costs: entry.lower_cost.map(u64::from),
            ..ClaimedBounds::default()
        },
        unknown: unknown.get(i).cloned().unwrap_or_default(),
        up: if entry.flip_up_down == Some(true) {
            Up::Raises
        } else {
            Up::Lowers
        },
        paths: entry.solution_plan,
    });
    plan(solutions.collect(), |place, spot, fault| {
        at(text, place, spot, fault)
    })
}

/// The keys that are read.
const KEYS: [&str; 8] = [
    "map_name",
    "scen_type",
    "type_id",
    "agents",
    "solution_cost",
    "lower_cost",
    "flip_up_down",
    "solution_plan",
];

/// The keys of each solution that are not read.
fn unknown_keys_of(text: &str, is_list: bool) -> Vec<UnknownKeys> {
    let all: Vec<&RawValue> = if is_list {
        serde_json::from_str(text).unwrap_or_default()
    } else {
        serde_json::from_str(text).into_iter().collect()
    };
    let is_known = |key: &str| KEYS.contains(&key) || super::ABOUT.contains(&key);
    all.iter()
        .map(|one| UnknownKeys::in_object(one.get(), is_known))
        .collect()
}

/// Solutions, no more than there may be.
struct Entries<'a>(Vec<Entry<'a>>);

// By hand, so that the list is counted while it grows.
shapes!(<'de: 'a, 'a> Entries<'a> as Entries<'de>, tr!("a list of solutions"), {
    fn visit_seq<A: SeqAccess<'de>>(self, mut list: A) -> Result<Entries<'de>, A::Error> {
        let mut entries = Vec::new();
        while let Some(entry) = list.next_element()? {
            super::solutions(entries.len() + 1).map_err(|many| in_words(&many))?;
            entries.push(entry);
        }
        Ok(Entries(entries))
    }
});

/// A fault as an error of the JSON library; its message is split into found and expected again.
fn in_words<E: Error>(fault: &Fault) -> E {
    E::custom(format!(
        "found {}, expected {}",
        fault.found, fault.expected
    ))
}

/// Gives a fault its place.
fn at(text: &str, place: &str, spot: Option<Spot>, fault: Fault) -> Fault {
    let place = match spot.and_then(|spot| spot.text) {
        Some(index) => format!("{place}[{index}]"),
        None => place.to_owned(),
    };
    let mut offset = Locator::new(text)
        .find(&segments(&place), false)
        .unwrap_or_default();
    if text.get(offset..).is_some_and(|rest| rest.starts_with('"')) {
        offset += 1 + raw(
            text.get(offset + 1..).unwrap_or(""),
            spot.map_or(0, |spot| spot.byte),
        );
    }
    at_byte(text, offset, Fault { place, ..fault })
}

/// The byte of a text as it is written, with escapes, at which a byte of what it
/// says stands.
fn raw(written: &str, byte: usize) -> usize {
    let mut said = 0;
    let mut rest = written.char_indices();
    while let Some((at, letter)) = rest.next() {
        if said >= byte {
            return at;
        }
        said += match letter {
            '\\' => match rest.next() {
                Some((_, 'u')) => {
                    let code: String = rest.by_ref().take(4).map(|(_, digit)| digit).collect();
                    let letter = u32::from_str_radix(&code, 16).ok();
                    letter.and_then(char::from_u32).map_or(2, char::len_utf8)
                }
                _ => 1,
            },
            letter => letter.len_utf8(),
        };
    }
    written.len()
}

shapes!(
    <'de: 'a, 'a> Paths<'a> as Paths<'de>,
    tr!("a text with a line for each robot, or a list of texts"),
    {
    // By hand, so that long texts are not copied.
    fn visit_borrowed_str<E: Error>(self, text: &'de str) -> Result<Paths<'de>, E> {
        Ok(Paths::Lines(Cow::Borrowed(text)))
    }

    fn visit_str<E: Error>(self, text: &str) -> Result<Paths<'de>, E> {
        Ok(Paths::Lines(Cow::Owned(text.to_owned())))
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut list: A) -> Result<Paths<'de>, A::Error> {
        let mut texts = Vec::new();
        while let Some(Text(text)) = list.next_element()? {
            robots(texts.len() + 1).map_err(|many| in_words(&many))?;
            texts.push(text);
        }
        Ok(Paths::List(texts))
    }
});

#[cfg(test)]
mod tests {
    use super::raw;

    #[test]
    fn escapes_are_counted_as_what_they_say() {
        assert_eq!(raw(r"uu\nxd", 3), 4);
        assert_eq!(raw(r"\u0075x", 1), 6);
        assert_eq!(raw("ux", 1), 1);
        assert_eq!(raw("u", 7), 1);
    }
}
