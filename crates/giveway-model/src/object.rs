//! Structures that are read from objects only.

use std::borrow::Cow;

use serde::de::{self, Deserialize, Deserializer, Visitor};

use crate::tr;

/// Reads a structure from an object only: for `deserialize_with`.
///
/// # Errors
/// As the structure's own reader, and when it stands as a list of its fields'
/// values.
///
/// ```
/// use giveway_model::format::from_object;
/// #[derive(serde::Deserialize)]
/// struct One { value: u32 }
/// let mut list = serde_json::Deserializer::from_str("[1]");
/// assert!(from_object::<One, _>(&mut list).is_err());
/// let mut object = serde_json::Deserializer::from_str(r#"{ "value": 1 }"#);
/// assert_eq!(from_object::<One, _>(&mut object).unwrap().value, 1);
/// ```
pub fn from_object<'de, T, D>(deserializer: D) -> Result<T, D::Error>
where
    T: Deserialize<'de>,
    D: Deserializer<'de>,
{
    T::deserialize(ObjectOnly(deserializer))
}

/// Reads `null` as a value that was left out: for `deserialize_with`, beside `default`.
///
/// # Errors
/// As the value's own reader.
pub(crate) fn null_is_default<'de, T, D>(deserializer: D) -> Result<T, D::Error>
where
    T: Deserialize<'de> + Default,
    D: Deserializer<'de>,
{
    Ok(Option::deserialize(deserializer)?.unwrap_or_default())
}

/// Reads one of some words. (Derived code also takes `{"word": null}`.)
///
/// # Errors
/// When it is another word, or none.
pub(crate) fn one_of<'de, T, D>(deserializer: D, words: &[(&str, T)]) -> Result<T, D::Error>
where
    T: Copy,
    D: Deserializer<'de>,
{
    let word = Cow::<str>::deserialize(deserializer)?;
    let found = words.iter().find(|(name, _)| *name == word);
    found.map(|&(_, value)| value).ok_or_else(|| {
        let names: Vec<&str> = words.iter().map(|(name, _)| *name).collect();
        de::Error::custom(format!(
            "unknown variant `{word}`, expected one of {}",
            names.join(" ")
        ))
    })
}

/// That a key is not one of those of a kind, in the JSON library's own words.
pub(crate) fn unknown_key(key: &str, kind: &str) -> String {
    let expected = tr!("the keys of {name}", name = kind);
    format!("unknown field `{key}`, expected {expected}")
}

/// A deserializer that asks for an object where a structure is wanted.
///
/// Derived code also reads a structure from the list of its fields' values,
/// such as `[10, 10]` for a battery; the format has no such thing.
pub struct ObjectOnly<D>(pub D);

impl<'de, D: Deserializer<'de>> Deserializer<'de> for ObjectOnly<D> {
    type Error = D::Error;

    fn deserialize_struct<V: Visitor<'de>>(
        self,
        _: &'static str,
        _: &'static [&'static str],
        visitor: V,
    ) -> Result<V::Value, D::Error> {
        self.0.deserialize_map(visitor)
    }

    fn deserialize_any<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, D::Error> {
        self.0.deserialize_map(visitor)
    }

    serde::forward_to_deserialize_any! {
        bool i8 i16 i32 i64 i128 u8 u16 u32 u64 u128 f32 f64 char str string bytes
        byte_buf option unit unit_struct newtype_struct seq tuple tuple_struct map
        enum identifier ignored_any
    }
}

/// Gives a type that derives its serde code for itself (`remote = "Self"`) the
/// two traits, read from objects only.
///
/// ```
/// #[derive(serde::Serialize, serde::Deserialize)]
/// #[serde(remote = "Self")]
/// struct One { value: u32 }
/// giveway_model::object_only!(One);
/// assert!(serde_json::from_str::<One>("[1]").is_err());
/// assert_eq!(serde_json::from_str::<One>(r#"{ "value": 1 }"#).unwrap().value, 1);
/// ```
#[macro_export]
macro_rules! object_only {
    ($type:ident) => {
        impl serde::Serialize for $type {
            fn serialize<S: serde::Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
                Self::serialize(self, serializer)
            }
        }

        impl<'de> serde::Deserialize<'de> for $type {
            fn deserialize<D: serde::Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
                Self::deserialize($crate::format::ObjectOnly(deserializer))
            }
        }
    };
}
