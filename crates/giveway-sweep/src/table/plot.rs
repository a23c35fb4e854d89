//! Curves drawn, as SVG, with their names beside them.

use std::ops::Range;

use plotters::coord::Shift;
use plotters::coord::ranged1d::{DefaultFormatting, KeyPointHint, Ranged};
use plotters::element::DashedPathElement;
use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, Pos, VPos};

use super::Curve;

/// What a plot is of.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Axes {
    /// The success rate against agents.
    Success,
    /// CPU seconds, on a scale of powers of ten, against tasks that succeeded.
    Cactus,
}

/// The width of the axes, and the least height, in pixels.
const CHART: u32 = 720;
const HEIGHT: u32 = 480;
/// The height of a name, and the width of one of its letters at most.
const LINE: i32 = 22;
const LETTER: u32 = 8;
/// Where the names begin, after the pieces of their curves.
const NAMES: i32 = 52;
const FONT: (&str, u32) = ("sans-serif", 15);
/// Colours that stay apart for eyes that see few of them (Okabe and Ito 2008).
const COLOURS: [RGBColor; 7] = [
    RGBColor(0, 114, 178),
    RGBColor(213, 94, 0),
    RGBColor(0, 158, 115),
    RGBColor(204, 121, 167),
    RGBColor(86, 180, 233),
    RGBColor(230, 159, 0),
    RGBColor(0, 0, 0),
];
/// Dashes and gaps, in pixels, of those that have a colour again.
const DASHES: [(u32, u32); 3] = [(8, 4), (2, 4), (14, 7)];
/// What took less is drawn here on the scale of powers of ten, and what took more than the
/// other one, some thirty years, there.
const LEAST_SECONDS: f64 = 0.01;
const MOST_SECONDS: f64 = 1e9;
/// So many steps an axis of whole numbers has at most.
const STEPS: u32 = 12;

/// Draws curves.
///
/// # Errors
/// Why it cannot be drawn, as a sentence.
pub fn plot(curves: &[Curve], axes: Axes) -> Result<String, String> {
    let mut svg = String::new();
    draw(&mut svg, curves, axes).map_err(|error| format!("The plot cannot be drawn: {error}"))?;
    Ok(svg)
}

type Drawn = Result<(), Box<dyn std::error::Error>>;
type Area<'a> = DrawingArea<SVGBackend<'a>, Shift>;

fn draw(svg: &mut String, curves: &[Curve], axes: Axes) -> Drawn {
    let longest = curves.iter().map(|curve| curve.name.chars().count()).max();
    let names = NAMES.unsigned_abs() + LETTER * longest.unwrap_or(0) as u32;
    let size = (
        CHART + names,
        HEIGHT.max(LINE.unsigned_abs() * (curves.len() as u32 + 2)),
    );
    let root = SVGBackend::with_string(svg, size).into_drawing_area();
    root.fill(&WHITE)?;
    let (chart, beside) = root.split_horizontally(CHART);
    match axes {
        Axes::Success => success(&chart, curves)?,
        Axes::Cactus => cactus(&chart, curves)?,
    }
    legend(&beside, curves)?;
    root.present()?;
    Ok(())
}

fn success(area: &Area<'_>, curves: &[Curve]) -> Drawn {
    let points = || curves.iter().flat_map(|curve| &curve.points);
    let right = points().map(|point| point.0).fold(1.0, f64::max);
    let left = points().map(|point| point.0).fold(right, f64::min);
    let edge = (0.03 * (right - left)).max(0.5);
    let x = Axis::new(left - edge..right + edge, ticks(left, right));
    let tenths = (0..=10).map(|tenth| f64::from(tenth) / 10.0).collect();
    let y = Axis::new(-0.03..1.05, tenths);
    let mut chart = builder(area).build_cartesian_2d(x, y)?;
    chart
        .configure_mesh()
        .light_line_style(TRANSPARENT)
        .x_desc("robots")
        .y_desc("success rate")
        .x_label_formatter(&|agents| format!("{agents:.0}"))
        .y_label_formatter(&|share| format!("{:.0} %", 100.0 * share))
        .label_style(FONT)
        .draw()?;
    for (index, curve) in curves.iter().enumerate() {
        line(&mut chart, index, &curve.points, &curve.points)?;
    }
    Ok(())
}

fn cactus(area: &Area<'_>, curves: &[Curve]) -> Drawn {
    let seconds = |seconds: f64| seconds.clamp(LEAST_SECONDS, MOST_SECONDS);
    let points = || curves.iter().flat_map(|curve| &curve.points);
    let right = points().map(|point| point.0).fold(1.0, f64::max);
    let top = points().map(|point| seconds(point.1)).fold(1.0, f64::max);
    let x = Axis::new(0.0..1.02 * right, ticks(0.0, right));
    let y = (0.8 * LEAST_SECONDS..1.2 * top).log_scale();
    let mut chart = builder(area).build_cartesian_2d(x, y)?;
    chart
        .configure_mesh()
        .light_line_style(TRANSPARENT)
        .x_desc("successful tasks")
        .y_desc("CPU seconds each")
        .x_label_formatter(&|tasks| format!("{tasks:.0}"))
        .y_label_formatter(&|&seconds| match seconds {
            least if least < 1.5 * LEAST_SECONDS => format!("≤ {LEAST_SECONDS}"),
            seconds => format!("{}", (100.0 * seconds).round() / 100.0),
        })
        .label_style(FONT)
        .draw()?;
    for (index, curve) in curves.iter().enumerate() {
        let points = curve.points.iter().map(|&(x, y)| (x, seconds(y)));
        let points: Vec<(f64, f64)> = points.collect();
        // A dot where it ends: so many succeeded.
        line(
            &mut chart,
            index,
            &points,
            &points[points.len().saturating_sub(1)..],
        )?;
    }
    Ok(())
}

fn builder<'a, 'b>(area: &'b Area<'a>) -> ChartBuilder<'b, 'b, SVGBackend<'a>> {
    let mut builder = ChartBuilder::on(area);
    builder
        .margin(16)
        .x_label_area_size(48)
        .y_label_area_size(64);
    builder
}

/// An axis with the numbers that are written at it.
struct Axis {
    range: Range<f64>,
    ticks: Vec<f64>,
}

impl Axis {
    const fn new(range: Range<f64>, ticks: Vec<f64>) -> Self {
        Self { range, ticks }
    }
}

impl Ranged for Axis {
    type FormatOption = DefaultFormatting;
    type ValueType = f64;

    fn map(&self, value: &f64, (from, to): (i32, i32)) -> i32 {
        let share = (value - self.range.start) / (self.range.end - self.range.start);
        from + (share * f64::from(to - from)).round() as i32
    }

    fn key_points<Hint: KeyPointHint>(&self, _: Hint) -> Vec<f64> {
        self.ticks.clone()
    }

    fn range(&self) -> Range<f64> {
        self.range.clone()
    }
}

/// Whole numbers between two numbers, at distances of 1, 2, 5, 10, 20 and so on.
fn ticks(left: f64, right: f64) -> Vec<f64> {
    let mut step = 1.0;
    for factor in [2.0, 2.5, 2.0].iter().cycle() {
        if (right - left) / step <= f64::from(STEPS) {
            break;
        }
        step *= factor;
    }
    let first = (left / step).ceil();
    let ticks = (0..=STEPS).map(|index| (first + f64::from(index)) * step);
    ticks.take_while(|&tick| tick <= right).collect()
}

/// A curve with dots: where a curve has one point, there is no line.
fn line<X: Ranged<ValueType = f64>, Y: Ranged<ValueType = f64>>(
    chart: &mut ChartContext<'_, SVGBackend<'_>, Cartesian2d<X, Y>>,
    index: usize,
    points: &[(f64, f64)],
    dots: &[(f64, f64)],
) -> Drawn {
    let (colour, dash) = look(index);
    let points = points.to_vec();
    match dash {
        None => chart.draw_series(LineSeries::new(points, colour.stroke_width(2)))?,
        Some((dash, gap)) => {
            let style = colour.stroke_width(2);
            chart.draw_series(DashedLineSeries::new(points, dash, gap, style))?
        }
    };
    let dots = dots.iter().map(|&dot| Circle::new(dot, 3, colour.filled()));
    chart.draw_series(dots)?;
    Ok(())
}

/// The names of curves, each with a piece of it.
fn legend(area: &Area<'_>, curves: &[Curve]) -> Drawn {
    let mut y = 4;
    for (index, curve) in curves.iter().enumerate() {
        let (colour, dash) = look(index);
        let style = colour.stroke_width(2);
        y += LINE;
        let piece = [(8, y), (44, y)];
        match dash {
            None => area.draw(&PathElement::new(piece, style))?,
            Some((dash, gap)) => area.draw(&DashedPathElement::new(piece, dash, gap, style))?,
        }
        let middle = FONT
            .into_text_style(area)
            .pos(Pos::new(HPos::Left, VPos::Center));
        area.draw(&Text::new(curve.name.as_str(), (NAMES, y), middle))?;
    }
    Ok(())
}

/// The colour of a curve, and its dashes: no two of the first 28 look alike.
fn look(index: usize) -> (RGBColor, Option<(u32, u32)>) {
    let colour = COLOURS[index % COLOURS.len()];
    let round = index / COLOURS.len() % (DASHES.len() + 1);
    let dash = round.checked_sub(1).map(|round| DASHES[round]);
    (colour, dash)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_first_curves_look_different() {
        for index in 1..COLOURS.len() * (DASHES.len() + 1) {
            assert!(
                (0..index).all(|other| look(other) != look(index)),
                "{index}"
            );
        }
    }

    #[test]
    fn ticks_are_few_whole_numbers() {
        assert_eq!(ticks(0.0, 1.0), [0.0, 1.0]);
        assert_eq!(ticks(4.0, 4.0), [4.0]);
        assert_eq!(ticks(4.0, 32.0), [5.0, 10.0, 15.0, 20.0, 25.0, 30.0]);
        assert_eq!(ticks(5.0, 1000.0).last(), Some(&1000.0));
        assert!(ticks(0.0, 1e19).len() > 5);
    }
}
