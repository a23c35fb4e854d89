//! How long a run of a random test is, by the environment.

/// The number that a variable sets, or the default.
pub fn number(name: &str, default: u64) -> u64 {
    match std::env::var(name) {
        Ok(value) => value
            .parse()
            .unwrap_or_else(|_| panic!("{name} is {value:?}, expected a number")),
        Err(_) => default,
    }
}
