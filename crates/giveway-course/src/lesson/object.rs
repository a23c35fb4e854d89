//! Structures that are read from objects only, as those of the model are.

/// Gives a type that derives its serde code for itself (`remote = "Self"`) the two
/// traits, read from objects only: derived code would also read the list of the values.
macro_rules! object_only {
    ($type:ident) => {
        impl serde::Serialize for $type {
            fn serialize<S: serde::Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
                Self::serialize(self, serializer)
            }
        }

        impl<'de> serde::Deserialize<'de> for $type {
            fn deserialize<D: serde::Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
                Self::deserialize(giveway_model::format::ObjectOnly(deserializer))
            }
        }
    };
}
pub(crate) use object_only;
