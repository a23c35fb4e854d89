//! Writes floors, plans and questions to a file: the package is asked the same.

use std::error::Error;
use std::fs;

use super::Floor;

/// Read by tests/package/floor.mjs.
const FILE: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../../target/floors.json");

pub(super) fn write(floors: &[Floor]) -> Result<(), Box<dyn Error>> {
    let floors = floors.iter().map(|floor| {
        let asked = floor.asked.iter().map(|one| {
            serde_json::json!({
                "question": one.question,
                "verdict": one.answer.verdict,
                "seconds": [one.here, one.near, one.verdict],
            })
        });
        serde_json::json!({
            "name": floor.name,
            "scene": floor.instance.to_scene(),
            "plan": floor.plan,
            "best": floor.is_best,
            "seconds": floor.seconds,
            "asked": asked.collect::<Vec<_>>(),
        })
    });
    let text = serde_json::to_string(&floors.collect::<Vec<_>>())?;
    Ok(fs::write(FILE, text)?)
}
