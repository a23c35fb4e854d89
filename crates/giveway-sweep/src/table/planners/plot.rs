//! The two plots: how many were solved within a time, and how far plans are from the best.

use std::fmt::Write as _;

use super::Comparison;
use super::line::Line;
use super::looks::{look_of, width};
use super::scale::{few, from_zero, number, powers, spread};
use crate::table::html::escaped;

/// The edges of the axes, in the units of the drawing.
const LEFT: f64 = 44.0;
const RIGHT: f64 = 408.0;
const TOP: f64 = 10.0;
const BOTTOM: f64 = 216.0;
const HEIGHT: f64 = 256.0;
/// Where names begin, and how wide a letter of one is at most.
const NAMES: f64 = 433.0;
const LETTER: f64 = 6.6;
/// Names are so far apart.
const APART: f64 = 15.0;
/// What took less is drawn here on the scale of powers of ten.
const LEAST_SECONDS: f64 = 0.01;
/// A curve has no more points than this.
const POINTS: usize = 200;

/// The width of a plot: that of the axes, and of the longest name.
fn full_width(lines: &[Line]) -> f64 {
    let longest = lines.iter().map(|line| line.name.chars().count()).max();
    NAMES + LETTER * longest.unwrap_or(0).max(10) as f64
}

/// A plot as a drawing of its own.
struct Plot {
    svg: String,
}

impl Plot {
    fn new(lines: &[Line], told: &str) -> Self {
        let width = number(full_width(lines));
        let svg = format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" class=\"pplot\" viewBox=\"0 0 {width} {HEIGHT}\" font-family=\"system-ui, sans-serif\" font-size=\"11\" role=\"img\" aria-label=\"{}\">\n",
            escaped(told)
        );
        Self { svg }
    }

    /// A line across with its number at the left edge.
    fn across(&mut self, y: f64, label: &str) {
        let (at, below) = (number(y), number(y + 4.0));
        let _ = writeln!(
            self.svg,
            "<path d=\"M{LEFT} {at}H{RIGHT}\" stroke=\"#ddd\" fill=\"none\"/><text x=\"36\" y=\"{below}\" text-anchor=\"end\" fill=\"#444\">{label}</text>"
        );
    }

    /// A number at the lower edge, with a line up where `is_line`.
    fn up(&mut self, x: f64, label: &str, is_line: bool) {
        let at = number(x);
        if is_line {
            let _ = writeln!(
                self.svg,
                "<path d=\"M{at} {TOP}V{BOTTOM}\" stroke=\"#eee\" fill=\"none\"/>"
            );
        }
        self.text(&at, "233", label);
    }

    /// What the lower edge is of.
    fn edge(&mut self, label: &str) {
        self.text("226", "251", label);
    }

    fn text(&mut self, x: &str, y: &str, label: &str) {
        let _ = writeln!(
            self.svg,
            "<text x=\"{x}\" y=\"{y}\" text-anchor=\"middle\" fill=\"#444\">{label}</text>"
        );
    }

    /// The names of curves at their ends, with what leads to them.
    fn names(&mut self, lines: &[Line], ends: &[Option<(f64, f64)>], has_marks: bool) {
        let named: Vec<(usize, (f64, f64))> = ends
            .iter()
            .enumerate()
            .filter_map(|(index, end)| Some((index, (*end)?)))
            .collect();
        let wanted: Vec<f64> = named.iter().map(|(_, (_, y))| *y).collect();
        let heights = spread(&wanted, APART, TOP, BOTTOM);
        for ((index, (x, y)), height) in named.into_iter().zip(heights) {
            let (from, y) = (number(x + 3.0), number(y));
            let (at, below) = (number(height), number(height + 4.0));
            let _ = writeln!(
                self.svg,
                "<path d=\"M{from} {y}L415 {at}\" stroke=\"#777\" fill=\"none\"/>"
            );
            if has_marks {
                look_of(index).mark(&mut self.svg, (424.0, height), 3.6);
            }
            let x = if has_marks { NAMES } else { NAMES - 13.0 };
            let name = lines.get(index).map_or("", |line| line.name.as_str());
            let _ = writeln!(
                self.svg,
                "<text x=\"{x}\" y=\"{below}\" font-weight=\"600\" fill=\"#111\">{}</text>",
                escaped(name)
            );
        }
    }

    fn done(self) -> String {
        self.svg + "</svg>\n"
    }
}

/// The height of a value on an axis up to a last one.
fn height(value: f64, last: f64) -> f64 {
    BOTTOM - (BOTTOM - TOP) * (value / last).min(1.0)
}

/// How many instances each planner solved within a time.
pub(super) fn solved(comparison: &Comparison) -> String {
    let lines = &comparison.lines;
    let all = comparison.instances;
    let longest = lines.iter().filter_map(|line| line.seconds.last()).copied();
    let longest = longest.chain(comparison.limits.seconds).fold(0.1, f64::max);
    let told = format!(
        "Instances solved within a time, of {all}: {} to {} CPU seconds",
        LEAST_SECONDS,
        number(longest)
    );
    let mut plot = Plot::new(lines, &told);
    let ticks = from_zero(all as f64, 1.0);
    let last = (all as f64).max(1.0);
    for tick in ticks.iter().filter(|tick| **tick <= last) {
        plot.across(height(*tick, last), &number(*tick));
    }
    let x = |seconds: f64| {
        let share =
            (seconds.max(LEAST_SECONDS) / LEAST_SECONDS).ln() / (longest / LEAST_SECONDS).ln();
        LEFT + (RIGHT - LEFT) * share.min(1.0)
    };
    for power in powers(LEAST_SECONDS, longest) {
        plot.up(x(power), &number(power), true);
    }
    plot.up(RIGHT, &format!("{} s", number(longest)), true);
    let mut ends = Vec::new();
    for (index, line) in lines.iter().enumerate() {
        let y = |count: usize| height(count as f64, last);
        let count = line.seconds.len();
        let every = count.div_ceil(POINTS).max(1);
        let point = |index: usize| Some((x(*line.seconds.get(index)?), y(index + 1)));
        let first = line.seconds.first().map_or(LEFT, |&seconds| x(seconds));
        let mut points = vec![(first, y(0))];
        points.extend(
            (0..count)
                .filter(|index| index % every == 0 || index + 1 == count)
                .filter_map(point),
        );
        points.push((RIGHT, y(count)));
        look_of(index).path(&mut plot.svg, &points, width(line.is_reference));
        for quarter in 1..=3 {
            if let Some(point) =
                point((count * quarter / 4).saturating_sub(1)).filter(|_| count > 3)
            {
                look_of(index).mark(&mut plot.svg, point, 3.6);
            }
        }
        ends.push(Some((RIGHT - 1.0, y(count))));
    }
    plot.names(lines, &ends, true);
    plot.edge("CPU seconds, logarithmic");
    plot.done()
}

/// The median gap of each planner by the number of robots.
pub(super) fn gaps(comparison: &Comparison) -> String {
    let lines = &comparison.lines;
    let mut plot = Plot::new(lines, "Median gap to what is proved, by number of robots");
    let points = || lines.iter().flat_map(|line| &line.by_agents);
    let most = points().map(|(_, gap)| gap.percent()).fold(1.0, f64::max);
    let ticks = from_zero(most, 1.0);
    let last = ticks.last().copied().unwrap_or(1.0);
    for tick in ticks {
        plot.across(height(tick, last), &format!("{} %", number(tick)));
    }
    let mut numbers: Vec<usize> = points().map(|(agents, _)| *agents).collect();
    numbers.sort_unstable();
    numbers.dedup();
    let least = numbers.first().copied().unwrap_or_default() as f64;
    let range = numbers.last().copied().unwrap_or_default() as f64 - least;
    let x = |agents: usize| match range {
        none if none <= 0.0 => f64::midpoint(LEFT, RIGHT),
        range => LEFT + 12.0 + (RIGHT - LEFT - 24.0) * (agents as f64 - least) / range,
    };
    for agents in few(&numbers) {
        plot.up(x(agents), &agents.to_string(), false);
    }
    let mut ends = Vec::new();
    for (index, line) in lines.iter().enumerate() {
        let points = line.by_agents.iter();
        let points: Vec<(f64, f64)> = points
            .map(|(agents, gap)| (x(*agents), height(gap.percent(), last)))
            .collect();
        if !points.is_empty() {
            look_of(index).path(&mut plot.svg, &points, width(line.is_reference));
        }
        for point in &points {
            look_of(index).mark(&mut plot.svg, *point, 3.6);
        }
        ends.push(points.last().map(|(x, y)| (x + 4.0, *y)));
    }
    plot.names(lines, &ends, false);
    plot.edge("robots");
    plot.done()
}

/// Both plots of each comparison as one drawing, below each other where there are several.
pub(in crate::table) fn both(comparisons: &[Comparison]) -> String {
    let mut svg = String::new();
    let (mut top, mut right) = (0.0, 0.0_f64);
    for comparison in comparisons {
        let width = full_width(&comparison.lines);
        for (x, plot) in [(0.0, solved(comparison)), (width, gaps(comparison))] {
            let size = format!("<svg x=\"{x}\" y=\"{top}\" width=\"{width}\" height=\"{HEIGHT}\"");
            svg.push_str(&plot.replacen("<svg", &size, 1));
            right = right.max(x + width);
        }
        top += HEIGHT;
    }
    let (right, top) = (number(right), number(top));
    format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{right}\" height=\"{top}\" viewBox=\"0 0 {right} {top}\">\n<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n{svg}</svg>\n"
    )
}
