//! The rules of the scene's own: zones with their tabs, lanes.

use giveway_model::constraint::ConstraintKind;

use super::ground::push;
use super::keys::changes;
use super::motion::When;
use super::stage::Stage;
use crate::letters::Anchor;
use crate::rules::{
    LaneShape, LitRule, RuleShapes, RuledMap, RulesNow, SignKind, TabParts, TabWords, ZoneShape,
    in_force, rule_shapes, tab_parts, zone_of,
};
use crate::xml::Number;
use crate::{Detail, Ink, whole};

impl Stage {
    /// The shapes of the rules, whatever the time is.
    pub(super) fn rules(&self) -> RuleShapes {
        let map = RuledMap::of(&self.instance);
        rule_shapes(map, &RulesNow::default(), LitRule::default())
    }

    /// What lies on the floor at all times: the outlines of zones, and lanes.
    pub(super) fn zones_and_lanes(&self) -> String {
        let shapes = self.rules();
        let mut svg = String::new();
        let inks = &self.inks;
        for zone in &shapes.zones {
            outline(zone, inks.floor, 8.0, &mut svg);
            outline(zone, inks.rule_line, self.thickness(), &mut svg);
        }
        for lane in &shapes.lanes {
            self.lane(lane, &mut svg);
        }
        svg
    }

    /// How thick the outline of a zone is, in units.
    const fn thickness(&self) -> f64 {
        match self.detail {
            Detail::All => 3.0,
            Detail::Plain => 4.5,
            Detail::Numbers | Detail::Forms | Detail::Dots => 7.0,
        }
    }

    fn lane(&self, lane: &LaneShape, svg: &mut String) {
        for &(x, y, degrees) in &lane.borders {
            push(
                svg,
                format_args!("<g transform=\"translate({x} {y}) rotate({degrees})\">"),
            );
            for (ink, width) in [(self.inks.floor, 12), (self.inks.rule_line, 6)] {
                push(
                    svg,
                    format_args!(
                        "<path d=\"M-15-39 9-11M-15 39 9 11\" fill=\"none\" stroke=\"{ink}\" stroke-width=\"{width}\" stroke-linecap=\"round\"/>"
                    ),
                );
            }
            svg.push_str("</g>");
        }
    }

    /// Whether a zone is closed at a time.
    fn is_closed(&self, zone: &ZoneShape, time: u32) -> bool {
        let rules = self.instance.constraints();
        let held = in_force(rules, time);
        let mut held = rules.iter().zip(held);
        held.any(|(rule, is_held)| {
            let is_it = matches!(rule.kind, ConstraintKind::Closed { .. });
            is_held && is_it && zone_of(&rule.kind) == Some(&zone.name)
        })
    }

    /// The class of what is only seen while a zone is closed.
    fn while_closed(&self, zone: &ZoneShape, when: &mut When<'_>) -> String {
        let times = || {
            let times = 0..=self.steps;
            let state = |time| (f64::from(time), self.is_closed(zone, time));
            changes(times.map(state))
        };
        when.at_once(times, |is_now| format!("opacity:{}", u8::from(*is_now)))
    }

    /// The zones that are closed, hatched, and the tabs of all zones with their signs.
    pub(super) fn zones_at(&self, when: &mut When<'_>) -> String {
        let shapes = self.rules();
        let mut svg = String::new();
        let (ink, id) = (self.inks.rule_hatch, &self.prefix);
        let closes = |rule: &giveway_model::Constraint| {
            !rule.off && matches!(rule.kind, ConstraintKind::Closed { .. })
        };
        if self.instance.constraints().iter().any(closes) {
            push(
                &mut svg,
                format_args!(
                    "<pattern id=\"{id}-shut\" width=\"18\" height=\"18\" patternUnits=\"userSpaceOnUse\" patternTransform=\"rotate(-45)\"><path d=\"M9 0V18\" stroke=\"{ink}\" stroke-width=\"4.5\"/></pattern>"
                ),
            );
        }
        for zone in &shapes.zones {
            let class = self.while_closed(zone, when);
            if !class.is_empty() || self.is_closed(zone, whole(when.time())) {
                let opacity = self.opacity(zone, when);
                let (path, sign) = (&zone.path, self.inks.rule_sign);
                push(
                    &mut svg,
                    format_args!(
                        "<path{class}{opacity} d=\"{path}\" fill=\"url(#{id}-shut)\" stroke=\"{sign}\" stroke-width=\"5\" stroke-linejoin=\"round\"/>"
                    ),
                );
            }
        }
        for zone in &shapes.zones {
            self.tab(zone, when, &mut svg);
        }
        svg
    }

    /// The opacity at the first time of what is only seen while a zone is closed.
    fn opacity(&self, zone: &ZoneShape, when: &When<'_>) -> &'static str {
        if self.is_closed(zone, whole(when.time())) {
            ""
        } else {
            " opacity=\"0\""
        }
    }

    fn tab(&self, zone: &ZoneShape, when: &mut When<'_>, svg: &mut String) {
        let (x, y) = (Number(zone.tab.0), Number(zone.tab.1));
        let scale = match self.detail {
            Detail::All => 1.0,
            Detail::Plain => 1.2,
            Detail::Forms | Detail::Numbers => 1.75,
            Detail::Dots => 3.0,
        };
        push(
            svg,
            format_args!(
                "<g transform=\"translate({x} {y}) scale({})\">",
                Number(scale)
            ),
        );
        let parts = tab_parts(zone);
        if self.detail == Detail::All {
            self.name(zone, &parts, svg);
        }
        for (index, sign) in zone.signs.iter().enumerate() {
            let x = Number(parts.apart * index as f64);
            push(svg, format_args!("<g transform=\"translate({x} 0)\">"));
            self.sign(sign, [self.inks.floor, self.inks.rule_sign], svg);
            if *sign == SignKind::Bar {
                let class = self.while_closed(zone, when);
                let opacity = self.opacity(zone, when);
                if !class.is_empty() || opacity.is_empty() {
                    push(svg, format_args!("<g{class}{opacity}>"));
                    self.sign(sign, [self.inks.rule_sign, self.inks.floor], svg);
                    svg.push_str("</g>");
                }
            }
            svg.push_str("</g>");
        }
        svg.push_str("</g>");
    }

    /// The name of a zone on its tab, and its times.
    fn name(&self, zone: &ZoneShape, parts: &TabParts, svg: &mut String) {
        let width = Number(parts.end);
        let (floor, line) = (self.inks.floor, self.inks.rule_line);
        push(
            svg,
            format_args!(
                "<rect x=\"0\" y=\"-19.5\" width=\"{width}\" height=\"39\" rx=\"12\" fill=\"{floor}\" stroke=\"{line}\" stroke-width=\"2\"/>"
            ),
        );
        let mut word = |word: &str, at: TabWords| {
            let label = self.word_of_rule(word, (at.middle, 8.5), 22.0, Anchor::Middle);
            label.draw(self.look.letters, svg);
        };
        word(&zone.name, parts.name);
        if let Some((times, at)) = zone.times.as_deref().zip(parts.times) {
            word(&times.replace('\u{2013}', "-"), at);
        }
    }
}

fn outline(zone: &ZoneShape, ink: Ink, width: f64, svg: &mut String) {
    let (path, width) = (&zone.path, Number(width));
    push(
        svg,
        format_args!(
            "<path d=\"{path}\" fill=\"none\" stroke=\"{ink}\" stroke-width=\"{width}\" stroke-linejoin=\"round\"/>"
        ),
    );
}
