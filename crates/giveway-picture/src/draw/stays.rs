//! Stays that rules ask for: while one is made, a dark tag at its cell counts down.

use super::ground::push;
use super::label::Label;
use super::motion::When;
use super::stage::Stage;
use crate::letters::Anchor;
use crate::rules::Stay;
use crate::xml::Number;
use crate::{Detail, whole};

/// At most so many numbers of a stay are drawn where a picture moves; of a longer one the last.
const NUMBERS: u32 = 60;

impl Stage {
    /// The tags of the stays that are made.
    pub(super) fn stays_at(&self, when: &mut When<'_>) -> String {
        let mut svg = String::new();
        if self.detail <= Detail::Dots {
            return svg;
        }
        let shown = whole(when.time());
        for stay in &self.stays {
            let now = stay.left_at(shown);
            let numbers: Vec<u32> = if when.moves() {
                (1..=(stay.to - stay.from).min(NUMBERS)).collect()
            } else {
                now.into_iter().collect()
            };
            for left in numbers {
                let at = f64::from(stay.to - left);
                let times = || {
                    let before = (at > 0.0).then_some((0.0, false));
                    let during = [(at, true), (at + 1.0, false)];
                    before.into_iter().chain(during).collect()
                };
                let class = when.at_once(times, |is_now| format!("opacity:{}", u8::from(*is_now)));
                let hidden = if now == Some(left) {
                    ""
                } else {
                    " opacity=\"0\""
                };
                self.stay(*stay, left, &format!("{class}{hidden}"), &mut svg);
            }
        }
        svg
    }

    fn stay(&self, stay: Stay, left: u32, attributes: &str, svg: &mut String) {
        // In the place of the tag that says what is asked for, and as wide.
        let x = Number(f64::from(stay.cell.x) * 100.0 + 50.0);
        let y = Number(f64::from(stay.cell.y) * 100.0 + 14.0);
        let scale = match self.detail {
            Detail::All | Detail::Dots => 1.0,
            Detail::Plain => 1.25,
            Detail::Forms | Detail::Numbers => 1.65,
        };
        let word = left.to_string();
        let asked = (stay.to - stay.from).to_string().len() as f64 + 5.0;
        let width = (word.len() as f64 + 3.0).max(asked) * 11.0 + 12.0;
        let (from, across, scale) = (Number(-width / 2.0), Number(width), Number(scale));
        let (floor, sign) = (self.inks.floor, self.inks.rule_sign);
        push(
            svg,
            format_args!(
                "<g{attributes}><g transform=\"translate({x} {y}) scale({scale})\">\
                 <rect x=\"{from}\" y=\"-15\" width=\"{across}\" height=\"30\" rx=\"6\" fill=\"{sign}\"/>\
                 <path d=\"M-12-8a8 8 0 1 0 .01 0M-12-4V0l3 2\" fill=\"none\" stroke=\"{floor}\" stroke-width=\"2.5\" stroke-linecap=\"round\" stroke-linejoin=\"round\"/>"
            ),
        );
        let label = Label {
            ink: floor,
            ..self.word_of_rule(&word, (12.0, 6.5), 19.0, Anchor::Middle)
        };
        label.draw(self.look.letters, svg);
        svg.push_str("</g></g>");
    }
}
