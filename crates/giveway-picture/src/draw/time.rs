//! The time below the map: the number of the step, and how far the plan is.

use super::ground::push;
use super::label::Label;
use super::motion::When;
use super::stage::Stage;
use crate::letters::Anchor;
use crate::whole;
use crate::xml::Number;

/// The size of the letters, the width of a figure and of a blank, in pixels.
const FONT: f64 = 13.0;
const FIGURE: f64 = 7.6;
const BLANK: f64 = 6.0;
/// The width of the words before and after the number.
const STEP: f64 = 31.0;
const OF: f64 = 15.0;
/// The least room for the line, and the gap before it, in pixels.
const LINE: (f64, f64) = (48.0, 16.0);

impl Stage {
    /// `Step 3 of 9`, and a line up to there; nothing where nothing moves.
    pub(super) fn time(&self, when: &mut When<'_>) -> String {
        let mut svg = String::new();
        if self.steps == 0 {
            return svg;
        }
        let px = self.sheet.px;
        let room = self.sheet.map.0 / px;
        let figures = FIGURE * self.steps.to_string().len() as f64;
        let before = STEP + BLANK;
        let after = BLANK + OF + BLANK + figures;
        if room < before + figures + after {
            // No room but for the number.
            self.number(Anchor::Start, 0.0, figures, when, &mut svg);
            return svg;
        }
        let number = before + figures;
        self.word("Step", Anchor::Start, 0.0, &mut svg);
        self.number(Anchor::End, number, figures, when, &mut svg);
        let of = format!("of {}", self.steps);
        self.word(&of, Anchor::Start, number + BLANK, &mut svg);
        let left = number + after + LINE.1;
        if room - left >= LINE.0 {
            self.line((left * px, room * px), when, &mut svg);
        }
        svg
    }

    fn word(&self, word: &str, anchor: Anchor, at: f64, svg: &mut String) {
        self.label(word, anchor, at, 0.0)
            .draw(self.look.letters, svg);
    }

    /// A word of the strip: at pixels from the left, and so many units further down.
    fn label<'a>(&self, word: &'a str, anchor: Anchor, at: f64, down: f64) -> Label<'a> {
        let px = self.sheet.px;
        Label {
            word,
            at: (at * px, self.sheet.strip() + 0.36 * FONT * px + down),
            size: FONT * px,
            anchor,
            ink: self.inks.soft,
            is_strong: false,
            halo: None,
            class: "",
        }
    }

    /// The number of the step: while it moves, a column of all of them that is seen
    /// through a window.
    fn number(&self, anchor: Anchor, at: f64, width: f64, when: &mut When<'_>, svg: &mut String) {
        let px = self.sheet.px;
        let time = when.time();
        let When::Moving(motion) = when else {
            let step = whole(time).min(self.steps).to_string();
            self.label(&step, anchor, at, 0.0)
                .draw(self.look.letters, svg);
            return;
        };
        let apart = 2.0 * FONT * px;
        let class = motion.counting(apart);
        let left = if anchor == Anchor::End {
            at - width
        } else {
            at
        };
        let (x, y) = ((left - 2.0) * px, self.sheet.strip() - apart / 2.0);
        push(
            svg,
            format_args!(
                "<clipPath id=\"{0}-time\"><rect x=\"{1}\" y=\"{2}\" width=\"{3}\" height=\"{4}\"/></clipPath>\
                 <g clip-path=\"url(#{0}-time)\"><g{class}>",
                self.prefix,
                Number(x),
                Number(y),
                Number((width + 4.0) * px),
                Number(apart),
            ),
        );
        let first = self.label("0", anchor, at, 0.0);
        first.column(self.look.letters, self.steps, apart, svg);
        svg.push_str("</g></g>");
    }

    /// The line from the start to the end, both in units.
    fn line(&self, (left, right): (f64, f64), when: &mut When<'_>, svg: &mut String) {
        let (steps, width) = (f64::from(self.steps), right - left);
        let (y, px) = (self.sheet.strip(), self.sheet.px);
        let share = (when.time() / steps).clamp(0.0, 1.0);
        let keys = || vec![(0.0, [0.0]), (steps, [1.0])];
        let grows = when.evenly(keys, |[share]| {
            format!("stroke-dashoffset:{}", Number(width * (1.0 - share)))
        });
        let goes = when.evenly(keys, |[share]| {
            format!("transform:translate({}px)", Number(width * share))
        });
        let (edge, accent) = (self.inks.edge, self.inks.accent);
        let d = format!("M{} {}H{}", Number(left), Number(y), Number(right));
        let (length, thick) = (Number(width), Number(3.0 * px));
        push(
            svg,
            format_args!(
                "<g fill=\"none\" stroke-width=\"{thick}\"><path d=\"{d}\" stroke=\"{edge}\" stroke-linecap=\"round\"/>\
                 <path{grows} d=\"{d}\" stroke=\"{accent}\" stroke-dasharray=\"{length}\" stroke-dashoffset=\"{}\"/></g>\
                 <circle{goes} transform=\"translate({} 0)\" cx=\"{}\" cy=\"{}\" r=\"{}\" fill=\"{accent}\"/>",
                Number(width * (1.0 - share)),
                Number(width * share),
                Number(left),
                Number(y),
                Number(5.0 * px),
            ),
        );
    }
}
