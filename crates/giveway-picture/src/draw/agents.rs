//! The agents: form, name, battery, where they look, what they do.

use super::course::{each_step, gone, loads, middle, places, tones, turns};
use super::ground::push;
use super::label::Label;
use super::motion::When;
use super::stage::Stage;
use crate::letters::Anchor;
use crate::xml::{Escaped, Number};
use crate::{Badge, CELL, Detail, Ink, Pose, Track, TurnSide, form};

/// The least radius of a robot on a large map, in pixels: it is seen, though it is larger
/// than its cell.
const LEAST_RADIUS_PX: f64 = 3.0;
/// The circumference of a battery's ring, in units.
const RING: f64 = 226.2;

impl Stage {
    /// The capsules of slow moves, and the agents above them.
    pub(super) fn agents(&self, when: &mut When<'_>) -> String {
        let mut svg = String::new();
        for (agent, track) in self.tracks.iter().enumerate() {
            if self.detail >= Detail::Forms {
                self.capsule(agent, track, when, &mut svg);
            }
        }
        for (agent, track) in self.tracks.iter().enumerate() {
            if let Some(pose) = track.pose(when.time()) {
                self.agent(agent, track, &pose, when, &mut svg);
            }
        }
        svg
    }

    fn agent(
        &self,
        agent: usize,
        track: &Track,
        pose: &Pose,
        when: &mut When<'_>,
        svg: &mut String,
    ) {
        if pose.is_gone && !when.moves() {
            return;
        }
        let there = when.at_once(|| gone(track, self.steps), |gone| opacity(!gone));
        let moves = when.evenly(|| places(track), |[x, y]| shift(x, y));
        let (x, y) = middle(pose);
        if !there.is_empty() {
            push(svg, format_args!("<g{there}{}>", hidden(!pose.is_gone)));
        }
        push(
            svg,
            format_args!(
                "<g{moves} transform=\"translate({} {})\">",
                Number(x),
                Number(y)
            ),
        );
        let (fill, on) = self.robot(agent);
        match self.detail {
            Detail::Dots => {
                let least = CELL * LEAST_RADIUS_PX / f64::from(self.look.cell.max(1));
                let radius = Number(least.max(38.0));
                push(
                    svg,
                    format_args!("<circle r=\"{radius}\" fill=\"{fill}\"/>"),
                );
            }
            Detail::Forms | Detail::Numbers => {
                svg.push_str("<g transform=\"scale(1.35)\">");
                shape(self.looks[agent], [fill, on, self.inks.floor], svg);
                svg.push_str("</g>");
            }
            Detail::Plain | Detail::All => {
                self.fine(agent, track, pose, when, svg);
            }
        }
        svg.push_str("</g>");
        if !there.is_empty() {
            svg.push_str("</g>");
        }
    }

    /// An agent that is large enough for all of it.
    fn fine(
        &self,
        agent: usize,
        track: &Track,
        pose: &Pose,
        when: &mut When<'_>,
        svg: &mut String,
    ) {
        let (fill, on) = self.robot(agent);
        let inks = &self.inks;
        let (floor, edge) = (inks.floor, inks.edge);
        push(
            svg,
            format_args!("<circle r=\"41\" fill=\"{floor}\" fill-opacity=\"0.96\"/>"),
        );
        if let Some(heading) = pose.heading {
            let turns = when.evenly(
                || turns(track, self.steps),
                |[to]| format!("transform:rotate({}deg)", Number(to)),
            );
            let aims = when.at_once(
                || each_step(track, self.steps, 0.0, |pose| pose.heading.is_some()),
                |aims| opacity(*aims),
            );
            if !aims.is_empty() {
                push(svg, format_args!("<g{aims}>"));
            }
            push(
                svg,
                format_args!(
                    "<path{turns} transform=\"rotate({})\" d=\"M38-9.5 49 0 38 9.5Z\" fill=\"{fill}\" stroke=\"{fill}\" stroke-width=\"4\" stroke-linejoin=\"round\"/>",
                    Number(heading)
                ),
            );
            if !aims.is_empty() {
                svg.push_str("</g>");
            }
        }
        if let Some(charge) = pose.charge {
            let offset = |share: f64| RING * (1.0 - share);
            let tones = when.at_once(
                || tones(track, self.steps),
                |tone| format!("stroke:{}", self.tone(tone)),
            );
            let level = when.evenly(
                || loads(track, self.steps),
                |[share]| format!("stroke-dashoffset:{}", Number(offset(share))),
            );
            let tone = self.tone(charge.class());
            push(
                svg,
                format_args!(
                    "<circle r=\"36\" fill=\"none\" stroke=\"{edge}\" stroke-width=\"6\"/>\
                     <g{tones} stroke=\"{tone}\"><circle{level} r=\"36\" transform=\"rotate(-90)\" fill=\"none\" stroke-width=\"6\" stroke-dasharray=\"{RING}\" stroke-dashoffset=\"{}\"/></g>",
                    Number(offset(charge.share))
                ),
            );
        }
        let scale = if pose.charge.is_some() { 1.0 } else { 1.2 };
        push(svg, format_args!("<g transform=\"scale({scale})\">"));
        let own = &self.instance.agents()[agent];
        push(svg, format_args!("<title>{}</title>", Escaped(&own.name)));
        shape(self.looks[agent], [fill, on, self.inks.floor], svg);
        let short = &self.badges[agent];
        let is_long = form::is_long(short);
        let (y, size) = if is_long { (6.5, 18.0) } else { (8.6, 24.0) };
        let label = Label {
            word: short,
            at: (0.0, y),
            size,
            anchor: Anchor::Middle,
            ink: on,
            is_strong: true,
            halo: None,
            class: "",
        };
        label.draw(self.look.letters, svg);
        svg.push_str("</g>");
        self.badge(Badge::Charges, track, pose, when, svg);
        self.badge(Badge::Waits, track, pose, when, svg);
        for side in TurnSide::ALL {
            self.badge(Badge::Turns(side), track, pose, when, svg);
        }
        self.badge(Badge::Broken, track, pose, when, svg);
    }

    /// The capsule over both cells of a slow move.
    fn capsule(&self, agent: usize, track: &Track, when: &mut When<'_>, svg: &mut String) {
        let over = |pose: &Pose| {
            let (from, to) = pose.transit?;
            let middle = |one: u32, other: u32| {
                let sum = f64::from(one.cast_signed()) + f64::from(other.cast_signed());
                (sum / 2.0 + 0.5) * CELL
            };
            let turn = if from.x == to.x { 90 } else { 0 };
            Some((middle(from.x, to.x), middle(from.y, to.y), turn))
        };
        let style = |over: &Option<(f64, f64, i32)>| match over {
            None => "opacity:0".to_owned(),
            Some((x, y, turn)) => {
                format!("opacity:1;{} rotate({turn}deg)", shift(*x, *y))
            }
        };
        let class = when.at_once(|| each_step(track, self.steps, 0.5, over), style);
        let now = track.pose(when.time()).filter(|pose| !pose.is_gone);
        let now = now.and_then(|pose| over(&pose));
        if now.is_none() && class.is_empty() {
            return;
        }
        let (x, y, turn) = now.unwrap_or_default();
        let (ink, _) = self.robot(agent);
        push(
            svg,
            format_args!(
                "<rect{class}{} transform=\"translate({} {}) rotate({turn})\" x=\"-92\" y=\"-42\" width=\"184\" height=\"84\" rx=\"42\" fill=\"none\" stroke=\"{ink}\" stroke-width=\"4\" stroke-dasharray=\"12 9\" stroke-linecap=\"round\"/>",
                hidden(now.is_some()),
                Number(x),
                Number(y)
            ),
        );
    }

    fn tone(&self, class: &str) -> Ink {
        match class {
            "low" => self.inks.danger,
            "mid" => self.inks.warn,
            _ => self.inks.ok,
        }
    }
}

/// The form, with its rim and its cut in the colour of the floor.
fn shape(look: usize, [fill, on, floor]: [Ink; 3], svg: &mut String) {
    let form = form::of(look);
    let body = form.body;
    if form.is_padded {
        push(
            svg,
            format_args!(
                "<path d=\"{body}\" fill=\"{fill}\" stroke=\"{fill}\" stroke-width=\"6.5\" stroke-linejoin=\"round\"/>"
            ),
        );
    } else {
        push(svg, format_args!("<path d=\"{body}\" fill=\"{fill}\"/>"));
    }
    if let Some(rim) = form.rim {
        push(
            svg,
            format_args!(
                "<path d=\"{rim}\" fill=\"none\" stroke=\"{on}\" stroke-width=\"2.2\" stroke-linejoin=\"round\"/>"
            ),
        );
    }
    if let Some(cut) = form.cut {
        push(
            svg,
            format_args!(
                "<path d=\"{cut}\" fill=\"none\" stroke=\"{floor}\" stroke-width=\"6.5\"/>"
            ),
        );
    }
}

fn shift(x: f64, y: f64) -> String {
    format!("transform:translate({}px,{}px)", Number(x), Number(y))
}

pub(super) fn opacity(is_shown: bool) -> String {
    format!("opacity:{}", u8::from(is_shown))
}

pub(super) const fn hidden(is_shown: bool) -> &'static str {
    if is_shown { "" } else { " opacity=\"0\"" }
}
