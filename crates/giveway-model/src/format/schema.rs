//! The JSON Schema of the project's own format.

/// The JSON Schema (draft 2020-12) of instances, plans, changes and all
/// results. The whole accepts any of them; each has a definition of its own,
/// such as `#/$defs/plan`.
///
/// [`Instance::new`](crate::Instance::new) and the judge check the rest, which no schema can: that names
/// differ, that cells lie on the map.
///
/// ```
/// let schema: serde_json::Value =
///     serde_json::from_str(giveway_model::format::schema()).unwrap();
/// assert!(schema["$defs"]["plan"].is_object());
/// ```
pub const fn schema() -> &'static str {
    include_str!("../../schema/giveway.schema.json")
}
