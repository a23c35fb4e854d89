//! Numbers with decimals, read in little code: the standard library's reader is exact to the
//! last bit, for some ten kilobytes of a page that is loaded over a network.

/// The most digits before and behind the point.
const DIGITS: usize = 15;

/// A number with or without decimals and a sign; `None` where it is none, or where it has more
/// than fifteen digits on a side of its point. It is as near as a sum and a division are.
///
/// ```
/// use giveway_model::decimal;
/// assert_eq!(decimal("0.05"), Some(0.05));
/// assert_eq!((decimal("-12"), decimal(".5"), decimal("3.")), (Some(-12.0), Some(0.5), Some(3.0)));
/// for none in ["", "-", ".", "1e9", "NaN", "1.2.3", "1 2", "1234567890123456"] {
///     assert_eq!(decimal(none), None, "{none}");
/// }
/// ```
pub fn decimal(text: &str) -> Option<f64> {
    let (is_negative, text) = match text.strip_prefix('-') {
        Some(rest) => (true, rest),
        None => (false, text),
    };
    let (whole, part) = text.split_once('.').unwrap_or((text, ""));
    let digits = |text: &str| {
        let is_number = text.len() <= DIGITS && text.bytes().all(|byte| byte.is_ascii_digit());
        is_number.then(|| {
            text.bytes()
                .fold(0_u64, |sum, byte| 10 * sum + u64::from(byte - b'0'))
        })
    };
    if whole.is_empty() && part.is_empty() {
        return None;
    }
    let tens = part.bytes().fold(1.0, |tens, _| 10.0 * tens);
    let number = digits(whole)? as f64 + digits(part)? as f64 / tens;
    Some(if is_negative { -number } else { number })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_written_with_two_decimals_is_read_as_the_standard_library_reads_it() {
        for hundredths in 0..20_000 {
            let number = f64::from(hundredths) / 100.0;
            let read = decimal(&format!("{number}")).unwrap();
            assert!((read - number).abs() <= f64::EPSILON * number, "{number}");
        }
    }
}
