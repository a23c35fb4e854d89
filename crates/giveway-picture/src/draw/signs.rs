//! The signs of zones, and the tags of deadlines, starts and stops.

use super::ground::push;
use super::label::Label;
use super::stage::Stage;
use crate::letters::Anchor;
use crate::rules::{SignKind, TagShape};
use crate::xml::Number;
use crate::{Detail, Ink};

impl Stage {
    /// A word of a rule, in ink.
    pub(super) const fn word_of_rule<'a>(
        &self,
        word: &'a str,
        at: (f64, f64),
        size: f64,
        anchor: Anchor,
    ) -> Label<'a> {
        Label {
            word,
            at,
            size,
            anchor,
            ink: self.inks.text,
            is_strong: true,
            halo: None,
            class: "",
        }
    }

    /// A sign: its ground, and the ink that it is drawn in.
    pub(super) fn sign(&self, sign: &SignKind, [ground, ink]: [Ink; 2], svg: &mut String) {
        let edge = self.inks.rule_sign;
        let frame = |shape: &str, svg: &mut String| {
            push(
                svg,
                format_args!(
                    "<{shape} fill=\"{ground}\" stroke=\"{edge}\" stroke-width=\"5\" stroke-linejoin=\"round\"/>"
                ),
            );
        };
        let stroke = |d: &str, width: u32, svg: &mut String| {
            push(
                svg,
                format_args!(
                    "<path d=\"{d}\" fill=\"none\" stroke=\"{ink}\" stroke-width=\"{width}\" stroke-linecap=\"round\"/>"
                ),
            );
        };
        let number = |number: &str, y: f64, size: f64, svg: &mut String| {
            let label = Label {
                ink,
                ..self.word_of_rule(number, (0.0, y), size, Anchor::Middle)
            };
            label.draw(self.look.letters, svg);
        };
        let ring = "circle r=\"17\"";
        match sign {
            SignKind::Ring(most) => {
                frame(ring, svg);
                number(most, 7.5, 21.0, svg);
            }
            SignKind::Bar => {
                frame(ring, svg);
                stroke("M-8 0H8", 6, svg);
            }
            SignKind::Pause => {
                frame(ring, svg);
                stroke("M-4-6V6M4-6V6M-12 12 12-12", 4, svg);
            }
            SignKind::Triangle(weight) => {
                frame("path d=\"M-20-16H20L0 18Z\"", svg);
                number(weight, 0.0, 17.0, svg);
            }
            SignKind::Dot => push(
                svg,
                format_args!(
                    "<circle r=\"6\" fill=\"{ink}\" stroke=\"{ground}\" stroke-width=\"4\"/>"
                ),
            ),
        }
    }

    /// The tags of deadlines, starts, stops, above all robots.
    pub(super) fn rule_tags(&self) -> String {
        let mut svg = String::new();
        if self.detail > Detail::Dots {
            for tag in &self.rules().tags {
                self.rule_tag(tag, &mut svg);
            }
        }
        svg
    }

    fn rule_tag(&self, tag: &TagShape, svg: &mut String) {
        let (dx, dy) = tag.place();
        let x = f64::from(tag.cell.x) * 100.0 + dx;
        let y = f64::from(tag.cell.y) * 100.0 + dy;
        let width = tag.words_width() + 12.0;
        let scale = match self.detail {
            Detail::All | Detail::Dots => 1.0,
            Detail::Plain => 1.25,
            Detail::Forms | Detail::Numbers => 1.65,
        };
        let (floor, line) = (self.inks.floor, self.inks.rule_line);
        let (x, y, left, across) = (Number(x), Number(y), Number(-width / 2.0), Number(width));
        push(
            svg,
            format_args!(
                "<g transform=\"translate({x} {y}) scale({})\"><rect x=\"{left}\" y=\"-14\" width=\"{across}\" height=\"28\" rx=\"6\" fill=\"{floor}\" stroke=\"{line}\" stroke-width=\"2\"/>",
                Number(scale)
            ),
        );
        let label = self.word_of_rule(&tag.text, (0.0, 6.5), 19.0, Anchor::Middle);
        label.draw(self.look.letters, svg);
        let bar = match tag.class {
            "late" => Some(width / 2.0),
            "early" => Some(-width / 2.0),
            _ => None,
        };
        if let Some(bar) = bar {
            let (x, ink) = (Number(bar), self.inks.rule_sign);
            push(
                svg,
                format_args!(
                    "<path d=\"M{x} -15V15\" fill=\"none\" stroke=\"{ink}\" stroke-width=\"5\" stroke-linecap=\"round\"/>"
                ),
            );
        }
        svg.push_str("</g>");
    }
}
