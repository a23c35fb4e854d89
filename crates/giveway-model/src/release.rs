//! The version of Giveway itself, as the page and the command tell it.

/// The version of Giveway, and the commit it was built from where that is known:
/// `0.1.0`, or `0.1.0 (1a2b3c4)`.
///
/// The version is that of the workspace. The commit is what `GIVEWAY_COMMIT` held
/// while this was compiled; unset or empty, there is none, so that two builds of the
/// same sources are the same.
///
/// ```
/// assert!(giveway_model::release().starts_with(env!("CARGO_PKG_VERSION")));
/// ```
pub fn release() -> String {
    describe(env!("CARGO_PKG_VERSION"), option_env!("GIVEWAY_COMMIT"))
}

/// The seven letters by which people name a commit.
const SHORT: usize = 7;

fn describe(version: &str, commit: Option<&str>) -> String {
    let short: String = commit.unwrap_or_default().chars().take(SHORT).collect();
    if short.is_empty() {
        version.to_owned()
    } else {
        format!("{version} ({short})")
    }
}

#[cfg(test)]
mod tests {
    use super::describe;

    #[test]
    fn the_commit_is_told_where_it_is_known() {
        assert_eq!(describe("1.2.3", None), "1.2.3");
        assert_eq!(describe("1.2.3", Some("")), "1.2.3");
        assert_eq!(
            describe("1.2.3", Some("0123456789abcdef")),
            "1.2.3 (0123456)"
        );
    }
}
