//! Time stamps of messages, in UTC.

/// A time stamp so many seconds after the begin of 1970.
pub(super) fn stamp(seconds: f64) -> String {
    #[expect(clippy::cast_sign_loss, reason = "times begin at 0")]
    let millis = (seconds * 1000.0).round() as u64;
    let (day, rest) = (millis / 86_400_000, millis % 86_400_000);
    let (year, month, day) = date(day);
    let (hour, minute) = (rest / 3_600_000, rest / 60_000 % 60);
    let (second, milli) = (rest / 1000 % 60, rest % 1000);
    format!("{year:04}-{month:02}-{day:02}T{hour:02}:{minute:02}:{second:02}.{milli:03}Z")
}

/// Year, month and day of a day from 1970 on (Gregorian calendar).
const fn date(day: u64) -> (u64, u64, u64) {
    let shifted = day + 719_468;
    let (era, of_era) = (shifted / 146_097, shifted % 146_097);
    let year_of_era = (of_era - of_era / 1460 + of_era / 36_524 - of_era / 146_096) / 365;
    let of_year = of_era - (365 * year_of_era + year_of_era / 4 - year_of_era / 100);
    let month = (5 * of_year + 2) / 153;
    let day = of_year - (153 * month + 2) / 5 + 1;
    let month = if month < 10 { month + 3 } else { month - 9 };
    let year = era * 400 + year_of_era + if month <= 2 { 1 } else { 0 };
    (year, month, day)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn time_stamps_count_from_the_begin_of_1970() {
        assert_eq!(stamp(0.0), "1970-01-01T00:00:00.000Z");
        assert_eq!(stamp(3661.5), "1970-01-01T01:01:01.500Z");
        assert_eq!(stamp(86_400.0 * 59.0), "1970-03-01T00:00:00.000Z");
        assert_eq!(stamp(951_782_400.0), "2000-02-29T00:00:00.000Z");
        assert_eq!(stamp(1_709_251_199.999), "2024-02-29T23:59:59.999Z");
    }
}
