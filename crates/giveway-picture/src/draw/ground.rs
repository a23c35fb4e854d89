//! What lies on the ground: the floor, slow zones, obstacles, chargers, zones of rules, and
//! the ways.

use std::fmt::Write as _;

use giveway_model::Cell;

use super::stage::Stage;
use crate::ink::Ink;
use crate::xml::Number;
use crate::{Area, Detail, FloorLook, Layer, Tile, Track, lines, starred};

/// Of more agents no ways are drawn: nobody could follow one.
const MOST_WAYS: usize = 64;

impl Stage {
    /// The floor.
    pub(crate) fn floor(&self) -> String {
        let (grid, inks) = (self.instance.grid(), &self.inks);
        let (width, height) = (Number(self.sheet.map.0), Number(self.sheet.map.1));
        let look = FloorLook::of(f64::from(self.look.cell));
        let area = Area {
            first: Cell::new(0, 0),
            size: (grid.width(), grid.height()),
        };
        let tile = Tile::new(grid, &starred(grid, self.instance.agents()), area, look);
        let mut svg = format!(
            "<rect width=\"{width}\" height=\"{height}\" rx=\"12\" fill=\"{}\"/>",
            inks.floor
        );
        for layer in Layer::ALL {
            if layer == Layer::Slow && look.has_lines {
                let lines = lines(grid.width(), grid.height(), 1);
                let ink = inks.line;
                push(
                    &mut svg,
                    format_args!("<path d=\"{lines}\" stroke=\"{ink}\" stroke-width=\"2\"/>"),
                );
            }
            let shape = tile.shape(layer);
            if !shape.is_empty() {
                let paint = self.paint(layer);
                push(&mut svg, format_args!("{}", paint.before));
                push(&mut svg, format_args!("<path d=\"{shape}\" {}/>", paint.of));
            }
        }
        let (ink, thin) = (inks.edge, Number(self.sheet.px * 2.0));
        push(
            &mut svg,
            format_args!(
                "<rect width=\"{width}\" height=\"{height}\" rx=\"12\" fill=\"none\" stroke=\"{ink}\" stroke-width=\"{thin}\"/>"
            ),
        );
        svg.push_str(&self.zones_and_lanes());
        svg
    }

    /// How a layer is painted.
    fn paint(&self, layer: Layer) -> Paint {
        let inks = &self.inks;
        let fill = |ink: Ink| Paint::new(format!("fill=\"{ink}\""));
        let line = |ink: Ink| {
            Paint::new(format!(
                "fill=\"none\" stroke=\"{ink}\" stroke-width=\"2.5\""
            ))
        };
        match layer {
            Layer::SlowTint => fill(inks.slow_tint),
            Layer::Slow if self.detail == Detail::Dots => {
                fill(inks.slow_hatch.over(inks.slow_tint, 30))
            }
            Layer::Slow => Paint {
                before: format!(
                    "<pattern id=\"{}-hatch\" width=\"14\" height=\"14\" patternUnits=\"userSpaceOnUse\" patternTransform=\"rotate(45)\"><path d=\"M7 0V14\" stroke=\"{}\" stroke-width=\"2.6\"/></pattern>",
                    self.prefix, inks.slow_hatch
                ),
                of: format!("fill=\"url(#{}-hatch)\"", self.prefix),
            },
            Layer::SlowEdge => line(inks.slow_edge),
            Layer::Obstacle => fill(inks.obstacle),
            Layer::ObstacleEdge => line(inks.obstacle_edge),
            Layer::Charger => Paint::new(format!(
                "fill=\"{}\" stroke=\"{}\" stroke-width=\"2.5\"",
                inks.charger, inks.charger_edge
            )),
            Layer::Bolt => Paint::new(format!(
                "fill=\"{0}\" stroke=\"{0}\" stroke-width=\"4\" stroke-linejoin=\"round\"",
                inks.bolt
            )),
        }
    }

    /// The ways of all, as pale lines.
    pub(crate) fn whole_ways(&self) -> String {
        self.each_way(|agent| {
            let way = &self.ways[agent];
            self.trail(agent, &way.behind(usize::MAX))
        })
    }

    /// The ways at a time: a pale line behind each agent, dots ahead of it.
    pub(crate) fn ways_at(&self, time: f64) -> String {
        self.each_way(|agent| {
            let way = &self.ways[agent];
            let pose = self.tracks[agent].pose(time).filter(|pose| !pose.is_gone);
            let Some(pose) = pose else {
                return String::new();
            };
            let stop = way.last_stop(time);
            let ends = way.ends(stop, pose.at);
            let mut svg = self.trail(agent, &format!("{} {}", way.behind(stop), ends.behind));
            if !ends.ahead.is_empty() {
                self.dots(
                    agent,
                    &format!("{} {}", way.ahead(stop), ends.ahead),
                    &mut svg,
                );
            }
            svg
        })
    }

    fn each_way(&self, draw: impl Fn(usize) -> String) -> String {
        let count = self.tracks.len();
        let shown = if count <= MOST_WAYS { 0..count } else { 0..0 };
        let moves = |agent: &usize| moves(&self.tracks[*agent]);
        shown.filter(moves).map(draw).collect()
    }

    fn trail(&self, agent: usize, points: &str) -> String {
        let (ink, _) = self.robot(agent);
        let width = if self.detail == Detail::Dots { 14 } else { 5 };
        format!(
            "<polyline points=\"{}\" fill=\"none\" stroke=\"{ink}\" stroke-width=\"{width}\" stroke-opacity=\"0.24\" stroke-linejoin=\"round\"/>",
            points.trim()
        )
    }

    fn dots(&self, agent: usize, points: &str, svg: &mut String) {
        let (points, (ink, _)) = (points.trim(), self.robot(agent));
        let (wide, dash) = match self.detail {
            Detail::Dots => (12.0, 31.0),
            _ => (7.0, 15.5),
        };
        let mut line = |ink: Ink, width: f64| {
            push(
                svg,
                format_args!(
                    "<polyline points=\"{points}\" fill=\"none\" stroke=\"{ink}\" stroke-width=\"{width}\" stroke-linecap=\"round\" stroke-linejoin=\"round\" stroke-dasharray=\"0 {dash}\"/>"
                ),
            );
        };
        if self.detail != Detail::Dots {
            line(self.inks.floor, wide + 3.5);
        }
        line(ink, wide);
    }
}

/// The attributes of a layer's path, and what stands before it.
struct Paint {
    before: String,
    of: String,
}

impl Paint {
    const fn new(of: String) -> Self {
        Self {
            before: String::new(),
            of,
        }
    }
}

fn moves(track: &Track) -> bool {
    let mut cells = track.path().iter().flatten();
    let first = cells.next();
    cells.any(|cell| Some(cell) != first)
}

/// Writing to a string cannot fail.
pub(super) fn push(svg: &mut String, what: std::fmt::Arguments<'_>) {
    let _ = svg.write_fmt(what);
}
