//! JSON values that makers write in several shapes.

use std::borrow::Cow;

use serde::Deserialize;
use serde::de::{IgnoredAny, SeqAccess};

/// Reads a type by methods of serde's `Visitor`, one for each shape; any other shape is a fault
/// that expects the given phrase. A type that borrows from the text is written
/// `<'de: 'a, 'a> Type<'a> as Type<'de>`.
macro_rules! shapes {
    (<$de:lifetime $(: $a:lifetime, $same:lifetime)?> $type:ty as $value:ty, $expected:expr, { $($visit:item)* }) => {
        impl<$de $(: $a, $same)?> serde::Deserialize<$de> for $type {
            fn deserialize<D: serde::Deserializer<$de>>(deserializer: D) -> Result<Self, D::Error> {
                struct Shapes;

                impl<$de> serde::de::Visitor<$de> for Shapes {
                    type Value = $value;

                    fn expecting(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
                        f.write_str($expected)
                    }

                    $($visit)*
                }

                deserializer.deserialize_any(Shapes)
            }
        }
    };
}
pub(crate) use shapes;

/// A text that points into the file where it holds no escapes.
#[derive(Deserialize)]
pub(crate) struct Text<'a>(#[serde(borrow)] pub(crate) Cow<'a, str>);

/// All entries of a list.
pub(crate) fn entries<'de, T, A>(mut list: A) -> Result<Vec<T>, A::Error>
where
    T: Deserialize<'de>,
    A: SeqAccess<'de>,
{
    let mut entries = Vec::new();
    while let Some(entry) = list.next_element()? {
        entries.push(entry);
    }
    Ok(entries)
}

/// How many entries of a list are left.
pub(crate) fn left<'de, A: SeqAccess<'de>>(list: A) -> Result<usize, A::Error> {
    entries::<IgnoredAny, A>(list).map(|left| left.len())
}
