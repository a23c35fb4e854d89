//! What stands on the tab of a zone, and where: both on a board and in a picture.

use super::{SignKind, ZoneShape};

/// How far apart signs stand, and how wide a letter is, in units.
const APART: f64 = 38.0;
const LETTER: f64 = 12.5;
/// The room before words and behind them, in units.
const ROOM: f64 = 12.0;

/// What stands on the tab of a zone, in units from the middle of its first sign.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TabParts {
    /// How far apart its signs stand.
    pub apart: f64,
    /// Where its last sign ends.
    pub signs_end: f64,
    /// Its name.
    pub name: TabWords,
    /// Its times, where it has some.
    pub times: Option<TabWords>,
    /// Where it ends.
    pub end: f64,
}

/// Words on a tab, in units: they are set around their middle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TabWords {
    /// Their middle.
    pub middle: f64,
    /// Their width.
    pub width: f64,
}

/// What stands on the tab of a zone: its signs, then its name and its times, with the same room on
/// both sides of each.
pub fn tab_parts(zone: &ZoneShape) -> TabParts {
    let before = zone.signs.len().saturating_sub(1);
    let signs_end = APART * before as f64 + zone.signs.last().map_or(0.0, reach);
    let words = |from: f64, text: &str| {
        let width = text.chars().count() as f64 * LETTER;
        let middle = from + ROOM + width / 2.0;
        let words = TabWords { middle, width };
        (words, from + ROOM + width)
    };
    let (name, name_end) = words(signs_end, &zone.name);
    let times = zone.times.as_deref().map(|times| words(name_end, times));
    TabParts {
        apart: APART,
        signs_end,
        name,
        times: times.map(|(words, _)| words),
        end: times.map_or(name_end, |(_, end)| end) + ROOM,
    }
}

/// How far a sign reaches from its middle, in units.
const fn reach(sign: &SignKind) -> f64 {
    match sign {
        SignKind::Ring(_) | SignKind::Bar | SignKind::Pause | SignKind::Triangle(_) => 20.0,
        SignKind::Dot => 8.0,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn zone(signs: Vec<SignKind>, times: Option<&str>) -> ZoneShape {
        ZoneShape {
            name: "aisle".to_owned(),
            signs,
            times: times.map(str::to_owned),
            ..ZoneShape::default()
        }
    }

    #[test]
    fn words_stand_in_the_middle_of_their_room() {
        let ring = || SignKind::Ring("1".to_owned());
        for signs in [
            vec![SignKind::Dot],
            vec![ring()],
            vec![SignKind::Bar, SignKind::Pause, ring()],
        ] {
            let parts = tab_parts(&zone(signs.clone(), None));
            let middle = f64::midpoint(parts.signs_end, parts.end);
            assert!((parts.name.middle - middle).abs() < 1e-9, "{signs:?}");
            let timed = tab_parts(&zone(signs, Some("2-4")));
            let times = timed.times.unwrap();
            let (left, right) = (
                times.middle - times.width / 2.0 - (timed.name.middle + timed.name.width / 2.0),
                timed.end - times.middle - times.width / 2.0,
            );
            assert!((left - right).abs() < 1e-9 && (timed.name.middle - middle).abs() < 1e-9);
        }
        let narrow = tab_parts(&zone(vec![SignKind::Dot], None));
        assert!(narrow.end < tab_parts(&zone(vec![ring()], None)).end);
    }
}
