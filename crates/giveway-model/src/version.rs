//! The version of the project's own JSON.

use serde::{Deserialize, Deserializer, Serialize, Serializer, de};

/// The version that every object of the project's own format carries in its
/// key `giveway`. It is written as the number 1, and reading any other number
/// is an error that names it.
///
/// ```
/// use giveway_model::Version;
/// assert_eq!(serde_json::to_string(&Version).unwrap(), "1");
/// let error = serde_json::from_str::<Version>("2").unwrap_err();
/// assert!(error.to_string().contains("version 2"));
/// ```
#[derive(
    Clone, Copy, Debug, Default, PartialEq, Eq, borsh::BorshSerialize, borsh::BorshDeserialize,
)]
pub struct Version;

impl Version {
    /// The number that is written, and the newest that is read.
    pub const NUMBER: u32 = 1;
}

impl Serialize for Version {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.serialize_u32(Self::NUMBER)
    }
}

impl<'de> Deserialize<'de> for Version {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        match u64::deserialize(deserializer)? {
            1 => Ok(Self),
            other => Err(de::Error::custom(format!(
                "found version {other} of the format, expected version 1, the only one known here"
            ))),
        }
    }
}
