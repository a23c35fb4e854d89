//! Goals and waypoints. Where an agent stands on them they shrink into corners.

use super::ground::push;
use super::keys::changes;
use super::label::Label;
use super::motion::When;
use super::stage::Stage;
use crate::letters::Anchor;
use crate::xml::Number;
use crate::{CELL, Detail, Ink, Mark, MarkKind, Occupied, corner};

const POLE: &str = "M66 46V14";
const CLOTH: &str = "M66 14h24l-7 9 7 9H66Z";
const FLAG: &str = "M66 46V14h24l-7 9 7 9H66";
const STAR: &str = "M0-25 7.4-8.5 25-6.5 11.9 5.4 15.6 23 0 14.2-15.6 23-11.9 5.4-25-6.5-7.4-8.5Z";

/// How long it takes to shrink, in steps: as on the page.
const SHRINKS: f64 = 0.33;
/// It is looked at so often in a step, since agents come and leave within.
const LOOKS: u32 = 4;

impl Stage {
    /// All flags and stars.
    pub(super) fn flags(&self, when: &mut When<'_>) -> String {
        let mut now = Occupied::default();
        now.see(&self.tracks, when.time());
        let over_time = if when.moves() && self.detail > Detail::Dots {
            self.occupied()
        } else {
            Vec::new()
        };
        let mut svg = String::new();
        for (index, mark) in self.marks.iter().enumerate() {
            let stands = Stands {
                mark,
                is_occupied: now.has(mark.cell),
                changes: over_time.get(index).map_or(&[], Vec::as_slice),
            };
            self.mark(&stands, when, &mut svg);
        }
        svg
    }

    /// When each mark is occupied.
    fn occupied(&self) -> Vec<Vec<(f64, bool)>> {
        let mut seen = vec![Vec::new(); self.marks.len()];
        let mut now = Occupied::default();
        for part in 0..=LOOKS * self.steps + 1 {
            let time = f64::from(part) / f64::from(LOOKS);
            // Who comes at that very time is there a moment later.
            now.see(&self.tracks, time + 0.01);
            for (seen, mark) in seen.iter_mut().zip(&self.marks) {
                seen.push((time, now.has(mark.cell)));
            }
        }
        seen.into_iter().map(changes).collect()
    }

    fn mark(&self, stands: &Stands<'_>, when: &mut When<'_>, svg: &mut String) {
        let mark = stands.mark;
        let (ink, _) = self.robot(mark.agent);
        let (x, y) = (f64::from(mark.cell.x) * CELL, f64::from(mark.cell.y) * CELL);
        if self.detail == Detail::Dots {
            if mark.kind == MarkKind::Goal {
                let (x, y) = (Number(x + 50.0 + mark.shift.0), Number(y + 50.0));
                push(
                    svg,
                    format_args!(
                        "<circle cx=\"{x}\" cy=\"{y}\" r=\"28\" fill=\"none\" stroke=\"{ink}\" stroke-width=\"16\"/>"
                    ),
                );
            }
            return;
        }
        let place = |is_occupied: bool| place(mark, is_occupied);
        let shrinks = when.evenly(
            || stands.keys(place),
            |[x, y, scale]| {
                let (x, y, scale) = (Number(x), Number(y), Number(scale));
                format!("transform:translate({x}px,{y}px) scale({scale})")
            },
        );
        let [dx, dy, scale] = place(stands.is_occupied).map(Number);
        push(
            svg,
            format_args!(
                "<g transform=\"translate({} {})\"><g{shrinks} transform=\"translate({dx} {dy}) scale({scale})\">",
                Number(x),
                Number(y)
            ),
        );
        match mark.kind {
            MarkKind::Goal => self.flag(ink, svg),
            MarkKind::Waypoint => self.star(ink, mark, when, svg),
        }
        self.tag(stands, when, svg);
        svg.push_str("</g></g>");
    }

    fn flag(&self, ink: Ink, svg: &mut String) {
        self.halo(FLAG, svg);
        push(
            svg,
            format_args!(
                "<path d=\"{POLE}\" fill=\"none\" stroke=\"{ink}\" stroke-width=\"5\" stroke-linecap=\"round\"/>\
                 <path d=\"{CLOTH}\" fill=\"{ink}\" stroke=\"{ink}\" stroke-width=\"3\" stroke-linejoin=\"round\"/>"
            ),
        );
    }

    fn star(&self, ink: Ink, mark: &Mark, when: &mut When<'_>, svg: &mut String) {
        self.halo(STAR, svg);
        let floor = self.inks.floor;
        let fill = |is_visited: bool| if is_visited { ink } else { floor };
        let visits = when.at_once(
            || match mark.visited {
                Some(time) if time > 0 => vec![(0.0, false), (f64::from(time), true)],
                _ => Vec::new(),
            },
            |is_visited| format!("fill:{}", fill(*is_visited)),
        );
        let is_visited = mark.visited.is_some_and(|at| f64::from(at) <= when.time());
        let fill = fill(is_visited);
        push(
            svg,
            format_args!(
                "<path{visits} d=\"{STAR}\" fill=\"{fill}\" stroke=\"{ink}\" stroke-width=\"4.5\" stroke-linejoin=\"round\"/>"
            ),
        );
    }

    fn halo(&self, shape: &str, svg: &mut String) {
        let floor = self.inks.floor;
        push(
            svg,
            format_args!(
                "<path d=\"{shape}\" fill=\"{floor}\" stroke=\"{floor}\" stroke-width=\"9\" stroke-linejoin=\"round\"/>"
            ),
        );
    }

    /// The names written at a mark; they are hidden while it is small.
    fn tag(&self, stands: &Stands<'_>, when: &mut When<'_>, svg: &mut String) {
        let Some(word) = &stands.mark.label else {
            return;
        };
        if self.detail < Detail::All {
            return;
        }
        let share = |is_occupied: bool| [f64::from(u8::from(!is_occupied))];
        let class = when.evenly(
            || stands.keys(share),
            |[shown]| format!("opacity:{}", Number(shown)),
        );
        if class.is_empty() && stands.is_occupied {
            return;
        }
        let (at, anchor) = match stands.mark.kind {
            MarkKind::Goal => ((61.0, 30.0), Anchor::End),
            MarkKind::Waypoint => ((0.0, 46.0), Anchor::Middle),
        };
        let label = Label {
            word,
            at,
            size: 18.0,
            anchor,
            ink: self.inks.text,
            is_strong: true,
            halo: Some((self.inks.floor, 6.0)),
            class: &class,
        };
        label.draw(self.look.letters, svg);
    }
}

/// A mark as it stands.
struct Stands<'a> {
    mark: &'a Mark,
    is_occupied: bool,
    /// When that changes.
    changes: &'a [(f64, bool)],
}

impl Stands<'_> {
    /// The keys of what depends on whether it is occupied.
    fn keys<const N: usize>(&self, value: impl Fn(bool) -> [f64; N]) -> Vec<(f64, [f64; N])> {
        let mut keys: Vec<(f64, [f64; N])> = Vec::new();
        for (time, is_occupied) in self.changes {
            if let Some(&(before, last)) = keys.last() {
                // It may still be on its way from the change before.
                keys.push((time.max(before), last));
                keys.push((time.max(before) + SHRINKS, value(*is_occupied)));
            } else {
                keys.push((*time, value(*is_occupied)));
            }
        }
        keys
    }
}

/// Where a mark stands in its cell, and how large: in a corner, where it is occupied.
fn place(mark: &Mark, is_occupied: bool) -> [f64; 3] {
    let (dx, dy) = mark.shift;
    match (mark.kind, is_occupied) {
        (MarkKind::Goal, false) => [dx, dy, 1.0],
        (kind, true) => corner::of_mark(kind, mark.place, mark.shift),
        (MarkKind::Waypoint, false) => [50.0 + dx, 42.0 + dy, 1.0],
    }
}
