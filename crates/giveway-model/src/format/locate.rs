//! Finds the place of a value in the text of a JSON file.

use std::borrow::Cow;
use std::collections::BTreeMap;
use std::collections::btree_map::Entry;
use std::fmt;

use serde::de::{MapAccess, Visitor};
use serde::{Deserialize, Deserializer};
use serde_json::value::RawValue;

/// One step of a way into a JSON value.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Segment {
    /// Into an object, by key.
    Key(String),
    /// Into a list or a text, from 0.
    Index(usize),
}

/// Reads a place such as `agents[1].goal`, as faults of an instance have it.
pub fn segments(place: &str) -> Vec<Segment> {
    place
        .split(['.', '[', ']'])
        .filter(|part| !part.is_empty())
        .map(|part| match part.parse() {
            Ok(index) => Segment::Index(index),
            Err(_) => Segment::Key(part.to_owned()),
        })
        .collect()
}

/// Finds places in one text. Objects and lists that were looked into are kept
/// by where they begin, so that each is read once however many faults it has.
pub struct Locator<'a> {
    text: &'a str,
    root: Option<&'a RawValue>,
    objects: BTreeMap<usize, Vec<Field<'a>>>,
    lists: BTreeMap<usize, Vec<&'a RawValue>>,
}

impl<'a> Locator<'a> {
    /// A locator for a text; it finds nothing where the text is no JSON.
    pub fn new(text: &'a str) -> Self {
        Self {
            text,
            root: serde_json::from_str(text).ok(),
            objects: BTreeMap::new(),
            lists: BTreeMap::new(),
        }
    }

    /// The byte at which a value begins, or the closest of those around it
    /// that exists; a key's value is meant unless `key` asks for the last key
    /// itself. `None` where the text is no JSON at all.
    pub fn find(&mut self, way: &[Segment], key: bool) -> Option<usize> {
        let mut value = self.root?;
        for (depth, segment) in way.iter().enumerate() {
            let last = depth + 1 == way.len();
            let next = match segment {
                Segment::Key(name) => {
                    let field = self.field(value, name);
                    if let Some((Cow::Borrowed(name), _)) = &field
                        && key
                        && last
                    {
                        return self.offset(name).map(|offset| offset.saturating_sub(1));
                    }
                    field.map(|(_, value)| value)
                }
                Segment::Index(index) if value.get().starts_with('"') => {
                    return self.character(value, *index);
                }
                Segment::Index(index) => self.entry(value, *index),
            };
            match next {
                Some(next) => value = next,
                None => break,
            }
        }
        self.offset(value.get())
    }

    /// The byte of a character of a text value; its beginning where escapes
    /// make counting vain.
    fn character(&self, value: &'a RawValue, index: usize) -> Option<usize> {
        let start = self.offset(value.get())?;
        let within = value.get().char_indices().nth(index + 1);
        match within {
            Some((offset, _)) if !value.get().contains('\\') => Some(start + offset),
            _ => Some(start),
        }
    }

    /// The last value of a key, as written, and the key.
    fn field(&mut self, object: &'a RawValue, name: &str) -> Option<Field<'a>> {
        let begin = self.offset(object.get())?;
        let fields = match self.objects.entry(begin) {
            Entry::Occupied(entry) => entry.into_mut(),
            Entry::Vacant(entry) => {
                let fields: Fields<'a> = serde_json::from_str(object.get()).ok()?;
                entry.insert(fields.0)
            }
        };
        fields.iter().rev().find(|(key, _)| key == name).cloned()
    }

    fn entry(&mut self, list: &'a RawValue, index: usize) -> Option<&'a RawValue> {
        let begin = self.offset(list.get())?;
        let entries = match self.lists.entry(begin) {
            Entry::Occupied(entry) => entry.into_mut(),
            Entry::Vacant(entry) => entry.insert(serde_json::from_str(list.get()).ok()?),
        };
        entries.get(index).copied()
    }

    /// Where a part of the text begins in it.
    fn offset(&self, part: &str) -> Option<usize> {
        let offset = part
            .as_ptr()
            .addr()
            .checked_sub(self.text.as_ptr().addr())?;
        (offset <= self.text.len()).then_some(offset)
    }
}

/// The fields of an object as written, repeats included.
pub struct Fields<'a>(Vec<Field<'a>>);

impl Fields<'_> {
    /// The keys, in the order of the text.
    pub fn names(&self) -> impl Iterator<Item = &str> {
        self.0.iter().map(|(key, _)| &**key)
    }

    /// Whether there is such a key.
    pub fn has(&self, name: &str) -> bool {
        self.0.iter().any(|(key, _)| key == name)
    }
}

/// A key and its value as written.
type Field<'a> = (Cow<'a, str>, &'a RawValue);

impl<'de> Deserialize<'de> for Fields<'de> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct All;

        impl<'de> Visitor<'de> for All {
            type Value = Fields<'de>;

            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str("an object")
            }

            fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<Self::Value, A::Error> {
                let mut fields = Vec::new();
                while let Some(Key(key)) = map.next_key()? {
                    fields.push((key, map.next_value()?));
                }
                Ok(Fields(fields))
            }
        }

        deserializer.deserialize_map(All)
    }
}

/// A key that points into the text where it holds no escapes.
#[derive(Deserialize)]
struct Key<'a>(#[serde(borrow)] Cow<'a, str>);
