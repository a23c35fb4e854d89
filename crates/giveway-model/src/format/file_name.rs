//! Names of files: without folders, without their ending.

/// A name without the folders before it.
///
/// ```
/// use giveway_model::format::base_name;
/// assert_eq!(base_name("maps/small.map"), "small.map");
/// assert_eq!(base_name("C:\\maps\\small.map"), "small.map");
/// ```
pub fn base_name(path: &str) -> &str {
    path.rsplit(['/', '\\']).next().unwrap_or(path)
}

/// A file's name without folders and without its ending.
///
/// ```
/// use giveway_model::format::stem;
/// assert_eq!(stem("maps/small.v2.map"), "small.v2");
/// assert_eq!(stem(".map"), ".map");
/// ```
pub fn stem(path: &str) -> &str {
    let name = base_name(path);
    match name.rsplit_once('.') {
        Some((stem, _)) if !stem.is_empty() => stem,
        _ => name,
    }
}
