//! Numbers and sentences as the command writes them.

/// How far a bound is below a value, in percent of the value. It never rounds
/// to nothing.
pub(crate) fn gap(bound: u32, value: u32) -> String {
    let percent = 100.0 * f64::from(value.saturating_sub(bound)) / f64::from(value.max(1));
    if percent == 0.0 || percent >= 0.95 {
        format!("{percent:.0} %")
    } else if percent >= 0.1 {
        format!("{percent:.1} %")
    } else {
        "below 0.1 %".to_owned()
    }
}

/// The sentence with one full stop at its end, safe for a terminal.
pub(crate) fn sentence(text: &str) -> String {
    giveway_model::words::sentence(&super::plain::text(text.trim()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn gaps() {
        let check = |bound, value, expect: &str| assert_eq!(gap(bound, value), expect);
        check(22, 23, "4 %");
        check(23, 23, "0 %");
        check(0, 0, "0 %");
        check(995, 1000, "0.5 %");
        check(9999, 10000, "below 0.1 %");
    }
}
