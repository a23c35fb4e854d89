//! The colours of a picture: those of the page, light and dark.

use std::fmt;

use borsh::{BorshDeserialize, BorshSerialize};

use crate::Colours;
use crate::form::COLOURED;

/// Whether a picture is light or dark.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, BorshSerialize, BorshDeserialize)]
pub enum Theme {
    /// Dark on white.
    #[default]
    Light,
    /// Light on dark.
    Dark,
}

/// A colour: red, green, blue; written `#rrggbb`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Ink(pub [u8; 3]);

impl fmt::Display for Ink {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self([red, green, blue]) = self;
        write!(f, "#{red:02x}{green:02x}{blue:02x}")
    }
}

impl Ink {
    const fn new(hex: u32) -> Self {
        Self([(hex >> 16) as u8, (hex >> 8) as u8, hex as u8])
    }

    /// This colour laid over another one so densely: 0 is the other, 100 this one.
    pub(crate) fn over(self, other: Self, percent: u32) -> Self {
        let mix = |top: u8, below: u8| {
            let sum = u32::from(top) * percent + u32::from(below) * (100 - percent);
            (sum / 100) as u8
        };
        let (top, below) = (self.0, other.0);
        Self(std::array::from_fn(|part| mix(top[part], below[part])))
    }
}

macro_rules! inks {
    ($($name:ident = $token:literal, $light:literal, $dark:literal;)*) => {
        /// The colours of all but the robots.
        #[derive(Clone, Copy, Debug, PartialEq, Eq)]
        pub struct Inks {
            $(#[doc = concat!("The page's `--", $token, "`.")] pub $name: Ink,)*
        }

        impl Inks {
            /// Those of a theme.
            pub const fn of(theme: Theme) -> Self {
                match theme {
                    Theme::Light => Self { $($name: Ink::new($light),)* },
                    Theme::Dark => Self { $($name: Ink::new($dark),)* },
                }
            }

            /// All, each with its name in the page's tokens.
            pub fn named(&self) -> Vec<(&'static str, Ink)> {
                vec![$(($token, self.$name),)*]
            }
        }
    };
}

inks! {
    page = "surface-page", 0xf4_f5_f3, 0x12_14_17;
    text = "text", 0x18_1d_26, 0xec_ee_f1;
    soft = "text-soft", 0x4c_54_61, 0xb3_ba_c4;
    accent = "accent-line", 0x3f_6b_e0, 0x7d_9d_f7;
    ok = "ok", 0x1c_66_36, 0x8e_d9_a4;
    warn = "warn", 0x7d_4a_00, 0xf3_c2_6b;
    danger = "danger-fill", 0xc9_25_2b, 0xff_6f_69;
    floor = "map-floor", 0xff_ff_ff, 0x23_27_2d;
    line = "map-line", 0xe4_e7_e3, 0x34_3a_42;
    edge = "map-edge", 0xc3_c9_c3, 0x4a_51_5b;
    obstacle = "map-obstacle", 0x2b_31_3b, 0x0c_0e_10;
    obstacle_edge = "map-obstacle-edge", 0x2b_31_3b, 0x78_81_8d;
    charger = "map-charger", 0xff_dc_5e, 0xe9_bd_35;
    charger_edge = "map-charger-edge", 0x99_70_00, 0xff_e0_8a;
    bolt = "map-bolt", 0x5a_40_00, 0x2e_22_00;
    slow_tint = "map-slow-tint", 0xfd_f0_ee, 0x33_23_1f;
    slow_hatch = "map-slow-hatch", 0xe9_a3_9b, 0x8e_4b_43;
    slow_edge = "map-slow-edge", 0xc2_5b_50, 0xd9_8a_80;
    rule_line = "rule-line", 0x6f_77_83, 0x93_9b_a7;
    rule_sign = "rule-sign", 0x2f_37_43, 0xd6_db_e2;
    rule_hatch = "rule-hatch", 0x9a_a2_ad, 0x69_72_7e;
    wait = "map-wait", 0x18_1d_26, 0xec_ee_f1;
    charge = "map-charge-flash", 0xf2_b7_05, 0xff_e0_8a;
}

/// The colour of each look, and the one of a name on it: light, then dark.
const ROBOTS: [[(u32, u32); 2]; COLOURED] = [
    [(0x00_5a_e6, 0xff_ff_ff), (0x00_a0_fa, 0x0d_10_15)],
    [(0x50_a0_82, 0x0d_10_15), (0x78_fa_aa, 0x0d_10_15)],
    [(0x6e_14_46, 0xff_ff_ff), (0xe6_32_8c, 0x0d_10_15)],
    [(0x8c_5a_00, 0xff_ff_ff), (0xf0_8c_1e, 0x0d_10_15)],
    [(0x8c_82_fa, 0x0d_10_15), (0xb4_c8_fa, 0x0d_10_15)],
    [(0x1e_6e_50, 0xff_ff_ff), (0x82_aa_78, 0x0d_10_15)],
    [(0xe6_00_5a, 0xff_ff_ff), (0xa0_64_5a, 0xff_ff_ff)],
    [(0xc8_78_aa, 0x0d_10_15), (0xfa_b4_c8, 0x0d_10_15)],
    [(0x50_00_a0, 0xff_ff_ff), (0x46_6e_dc, 0xff_ff_ff)],
    [(0x96_96_00, 0x0d_10_15), (0x78_78_00, 0xff_ff_ff)],
    [(0x78_5a_8c, 0xff_ff_ff), (0xa0_82_aa, 0x0d_10_15)],
    [(0x3c_3c_00, 0xff_ff_ff), (0xf0_e6_3c, 0x0d_10_15)],
];

/// The colour of an agent, by its index in the scene, and the one of a name on it.
pub fn robot(theme: Theme, colours: Colours, agent: usize) -> (Ink, Ink) {
    let (fill, on) = ROBOTS[colours.of(agent)][usize::from(theme == Theme::Dark)];
    (Ink::new(fill), Ink::new(on))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn colours_are_written_as_pages_write_them() {
        assert_eq!(Ink::new(0x0a_5a_e6).to_string(), "#0a5ae6");
        let half = Ink::new(0).over(Ink::new(0xff_ff_ff), 50);
        assert_eq!(half.to_string(), "#7f7f7f");
    }
}
