//! The colours of a GIF: those of the picture, and what lies between two of them at the
//! edges of shapes. They are the same for every frame, so that nothing flickers.

use std::collections::{BTreeMap, BTreeSet};

use crate::Look;
use crate::ink::{Ink, Inks, robot};

/// The number that means: as it was.
pub(super) const UNCHANGED: u8 = 0;

/// At most 255 colours, by number from 1.
pub(super) struct Palette {
    inks: Vec<Ink>,
    /// What was looked up already.
    known: BTreeMap<[u8; 3], u8>,
}

impl Palette {
    /// The colours of a picture of so many agents.
    pub(super) fn new(look: &Look, agents: usize) -> Self {
        let inks = Inks::of(look.theme);
        let mut all: Vec<Ink> = inks.named().into_iter().map(|(_, ink)| ink).collect();
        let looks: BTreeSet<usize> = look.looks.all(agents).into_iter().collect();
        let robots = looks.into_iter();
        let robots = robots.map(|own| robot(look.theme, look.colours, own));
        let robots: Vec<(Ink, Ink)> = robots.collect();
        for &(fill, on) in &robots {
            let trail = fill.over(inks.floor, 24);
            all.extend([fill, on, trail, fill.over(on, 50)]);
            all.extend([25, 50, 75].map(|percent| fill.over(inks.floor, percent)));
            all.push(fill.over(inks.slow_tint, 24));
        }
        let on_floor = [
            inks.text,
            inks.obstacle,
            inks.obstacle_edge,
            inks.charger,
            inks.charger_edge,
            inks.bolt,
            inks.slow_edge,
            inks.rule_line,
            inks.rule_sign,
            inks.rule_hatch,
            inks.ok,
            inks.warn,
            inks.danger,
            inks.edge,
            inks.charge,
        ];
        for ink in on_floor {
            all.extend([25, 50, 75].map(|percent| ink.over(inks.floor, percent)));
        }
        for ink in [inks.soft, inks.accent, inks.edge] {
            all.extend([33, 67].map(|percent| ink.over(inks.page, percent)));
        }
        for (ink, below) in [
            (inks.slow_hatch, inks.slow_tint),
            (inks.slow_edge, inks.slow_tint),
            (inks.bolt, inks.charger),
        ] {
            all.extend([33, 67].map(|percent| ink.over(below, percent)));
        }
        // Every colour once; the picture's own ones come first.
        let mut seen = BTreeSet::new();
        all.retain(|ink| seen.insert(*ink));
        all.truncate(usize::from(u8::MAX));
        Self {
            inks: all,
            known: BTreeMap::new(),
        }
    }

    /// The table of a GIF: red, green, blue of each.
    pub(super) fn table(&self) -> Vec<u8> {
        // The number that means no change has a colour, too, which nobody sees.
        let colours = [[0; 3]]
            .into_iter()
            .chain(self.inks.iter().map(|ink| ink.0));
        colours.flatten().collect()
    }

    /// The number of the nearest colour.
    pub(super) fn nearest(&mut self, pixel: [u8; 3]) -> u8 {
        if let Some(&known) = self.known.get(&pixel) {
            return known;
        }
        let far = |ink: &Ink| {
            let parts = ink.0.iter().zip(pixel);
            // Green is seen best, blue least.
            let weighted = parts.zip([3_u32, 6, 1]);
            weighted
                .map(|((one, other), weight)| weight * u32::from(one.abs_diff(other)).pow(2))
                .sum::<u32>()
        };
        let nearest = (1..).zip(&self.inks).min_by_key(|(_, ink)| far(ink));
        let number = nearest.map_or(UNCHANGED, |(number, _): (u16, _)| number as u8);
        self.known.insert(pixel, number);
        number
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Colours, Letters, Looks, Theme};

    fn palette(theme: Theme) -> Palette {
        let look = Look {
            theme,
            cell: 20,
            letters: Letters::Text,
            looks: Looks::default(),
            colours: Colours::default(),
        };
        Palette::new(&look, 30)
    }

    #[test]
    fn the_colours_of_the_picture_are_exact() {
        for theme in [Theme::Light, Theme::Dark] {
            let mut palette = palette(theme);
            let robots = (0..12).flat_map(|agent| {
                let (fill, on) = robot(theme, Colours::default(), agent);
                [fill, on]
            });
            let own = Inks::of(theme).named().into_iter().map(|(_, ink)| ink);
            for ink in own.chain(robots) {
                let number = palette.nearest(ink.0);
                let at = 3 * usize::from(number);
                assert_eq!(palette.table().get(at..at + 3), Some(&ink.0[..]), "{ink}");
            }
        }
    }

    #[test]
    fn there_is_room_for_all() {
        for theme in [Theme::Light, Theme::Dark] {
            let count = palette(theme).inks.len();
            assert!((100..255).contains(&count), "{count}");
        }
    }
}
