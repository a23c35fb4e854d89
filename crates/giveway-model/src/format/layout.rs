//! Writes instances, plans and changes for people: the map as a picture, an agent a line.

use serde::Serialize;

use crate::change::Changes;
use crate::{Agent, Objective, Plan, Rules, Scene, Version};

/// Writes an instance: a map row a line, an agent a line. What is as the
/// format's defaults have it is left out. Ends with a line break.
///
/// ```
/// use giveway_model::{Scene, format::native};
/// let scene = Scene { map: vec!["..".into(), ".#".into()], ..Scene::default() };
/// let text = native::write_scene(&scene);
/// assert_eq!(text, r#"{
///   "giveway": 1,
///   "map": ["..",
///           ".#"],
///   "agents": []
/// }
/// "#);
/// assert_eq!(native::read_scene(&text), Ok(scene));
/// ```
pub fn write_scene(scene: &Scene) -> String {
    let mut fields = vec![field("giveway", &Version::NUMBER.to_string())];
    if !scene.name.is_empty() {
        fields.push(field("name", &json(&scene.name)));
    }
    let rows: Vec<String> = scene.map.iter().map(json).collect();
    fields.push(field("map", &format!("[{}]", rows.join(",\n          "))));
    if scene.rules != Rules::default() {
        fields.push(field("rules", &spaced(&scene.rules)));
    }
    if scene.objective != Objective::default() {
        fields.push(field("objective", &spaced(&scene.objective)));
    }
    let agents: Vec<String> = scene.agents.iter().map(agent).collect();
    fields.push(field("agents", &block('[', &agents, ']')));
    if !scene.assumptions.is_empty() {
        let assumptions: Vec<String> = scene.assumptions.iter().map(spaced).collect();
        fields.push(field("assumptions", &block('[', &assumptions, ']')));
    }
    if !scene.zones.is_empty() {
        let zones: Vec<String> = scene.zones.iter().map(spaced).collect();
        fields.push(field("zones", &block('[', &zones, ']')));
    }
    if !scene.constraints.is_empty() {
        let constraints: Vec<String> = scene.constraints.iter().map(spaced).collect();
        fields.push(field("constraints", &block('[', &constraints, ']')));
    }
    if let Some(units) = &scene.units {
        fields.push(field("units", &spaced(units)));
    }
    format!("{{\n{}\n}}\n", fields.join(",\n"))
}

/// Writes a plan: an agent's path a line, and its charges, where it has any, a
/// line further down. Ends with a line break.
pub fn write_plan(plan: &Plan) -> String {
    let mut fields = vec![
        field("giveway", &Version::NUMBER.to_string()),
        field("paths", &by_name(plan.paths.iter())),
        field("charges", &by_name(plan.charges.iter())),
    ];
    if !plan.from.is_empty() {
        fields.push(field("from", &by_name(plan.from.iter())));
    }
    if !plan.until.is_empty() {
        fields.push(field("until", &by_name(plan.until.iter())));
    }
    if let Some(knows) = plan.knows {
        fields.push(field("knows", &knows.to_string()));
    }
    if !plan.slept.is_empty() {
        fields.push(field("slept", &by_name(plan.slept.iter())));
    }
    format!("{{\n{}\n}}\n", fields.join(",\n"))
}

/// Writes changes, one a line. Ends with a line break.
///
/// ```
/// use giveway_model::format::native;
/// let text = r#"{
///   "giveway": 1,
///   "changes": [
///     {"at":2,"change":"add-obstacle","cell":[1,0]}
///   ]
/// }
/// "#;
/// assert_eq!(native::write_changes(&native::read_changes(text).unwrap()), text);
/// ```
pub fn write_changes(changes: &Changes) -> String {
    let lines: Vec<String> = changes.changes.iter().map(json).collect();
    let fields = [
        field("giveway", &Version::NUMBER.to_string()),
        field("changes", &block('[', &lines, ']')),
    ];
    format!("{{\n{}\n}}\n", fields.join(",\n"))
}

fn agent(agent: &Agent) -> String {
    let mut parts = vec![
        format!("\"name\": {}", json(&agent.name)),
        format!("\"start\": {}", spaced(&agent.start)),
    ];
    if let Some(goal) = &agent.goal {
        parts.push(format!("\"goal\": {}", spaced(goal)));
    }
    if !agent.waypoints.is_empty() {
        parts.push(format!("\"waypoints\": {}", spaced(&agent.waypoints)));
    }
    if let Some(battery) = &agent.battery {
        parts.push(format!("\"battery\": {}", spaced(battery)));
    }
    if let Some(heading) = &agent.heading {
        parts.push(format!("\"heading\": {}", json(heading)));
    }
    format!("{{ {} }}", parts.join(", "))
}

fn by_name<'a, T: Serialize + 'a>(entries: impl Iterator<Item = (&'a String, &'a T)>) -> String {
    let lines: Vec<String> = entries
        .map(|(name, value)| format!("{}: {}", json(name), spaced(value)))
        .collect();
    block('{', &lines, '}')
}

fn field(key: &str, value: &str) -> String {
    format!("  \"{key}\": {value}")
}

/// One entry a line, or the two brackets alone.
fn block(open: char, lines: &[String], close: char) -> String {
    if lines.is_empty() {
        return format!("{open}{close}");
    }
    format!("{open}\n    {}\n  {close}", lines.join(",\n    "))
}

/// JSON on one line.
fn json<T: Serialize>(value: &T) -> String {
    // Text, numbers and lists of them always have a JSON form.
    serde_json::to_string(value).unwrap_or_default()
}

/// JSON on one line with blanks where a person would put them.
fn spaced<T: Serialize>(value: &T) -> String {
    let dense = json(value);
    let mut text = String::with_capacity(dense.len() * 5 / 4);
    let (mut is_quoted, mut is_escaped) = (false, false);
    for c in dense.chars() {
        is_quoted ^= c == '"' && !is_escaped;
        is_escaped = c == '\\' && !is_escaped;
        match c {
            ',' | ':' if !is_quoted => {
                text.push(c);
                text.push(' ');
            }
            '{' if !is_quoted => text.push_str("{ "),
            '}' if !is_quoted => text.push_str(" }"),
            c => text.push(c),
        }
    }
    text
}
