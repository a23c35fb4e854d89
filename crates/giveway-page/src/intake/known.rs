//! The maps of the standard benchmark that come with the page, found by name.

/// The maps in `static/maps`, without their ending.
const MAPS: [&str; 9] = [
    "empty-16-16",
    "empty-32-32",
    "empty-8-8",
    "maze-32-32-2",
    "maze-32-32-4",
    "random-32-32-10",
    "random-32-32-20",
    "room-32-32-4",
    "warehouse-10-20-10-2-1",
];

/// The scenarios of each.
const SCENARIOS: [&str; 2] = ["even-1", "random-1"];

/// Which of the page's own files may be what is missing: the map of this name,
/// and the scenario that a file's name tells, such as
/// `random-32-32-20_random-1_300.tracker.csv`. None where there is none.
///
/// ```
/// use giveway_page::intake::beside;
/// let file = "random-32-32-20_random-1_300.tracker.csv";
/// let names = ["random-32-32-20.map", "random-32-32-20-random-1.scen"];
/// assert_eq!(beside(None, &[file]), names);
/// assert_eq!(beside(Some("empty-8-8.map"), &["paths.txt"]), ["empty-8-8.map"]);
/// assert!(beside(Some("lak303d"), &["paths.txt"]).is_empty());
/// ```
pub fn beside(map: Option<&str>, files: &[&str]) -> Vec<String> {
    let stem = |name: &str| name.strip_suffix(".map").unwrap_or(name).to_owned();
    let named = map.map(stem);
    let mut found = Vec::new();
    // The longest name first: no map is taken for another whose name it begins with.
    let begins = |known: &&&str| files.iter().any(|file| is_named(file, known));
    let told = match &named {
        Some(name) => MAPS.iter().find(|known| *known == name),
        None => MAPS.iter().filter(begins).max_by_key(|known| known.len()),
    };
    let Some(map) = told else { return found };
    found.push(format!("{map}.map"));
    let scenario = SCENARIOS.iter().find(|kind| {
        let with = |gap| format!("{map}{gap}{kind}");
        let (one, other) = (with('-'), with('_'));
        files
            .iter()
            .any(|file| is_named(file, &one) || is_named(file, &other))
    });
    found.extend(scenario.map(|kind| format!("{map}-{kind}.scen")));
    found
}

/// Whether a file's name begins with a name that ends there.
fn is_named(file: &str, name: &str) -> bool {
    let rest = file.strip_prefix(name);
    rest.is_some_and(|rest| !rest.starts_with(|c: char| c.is_ascii_digit()))
}
