//! Curves drawn, as SVG.

use plotters::prelude::*;

use super::Curve;

/// What a plot is of.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Axes {
    /// The success rate against agents.
    Success,
    /// CPU seconds, on a scale of powers of ten, against tasks that succeeded.
    Cactus,
}

/// Its size in pixels.
const SIZE: (u32, u32) = (800, 480);
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
/// What took less is drawn here on the scale of powers of ten.
const LEAST_SECONDS: f64 = 0.01;

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

fn draw(svg: &mut String, curves: &[Curve], axes: Axes) -> Drawn {
    let root = SVGBackend::with_string(svg, SIZE).into_drawing_area();
    root.fill(&WHITE)?;
    let points = || curves.iter().flat_map(|curve| &curve.points);
    let right = points().map(|point| point.0).fold(1.0, f64::max);
    let mut builder = ChartBuilder::on(&root);
    builder
        .margin(16)
        .x_label_area_size(48)
        .y_label_area_size(64);
    match axes {
        Axes::Success => {
            let left = points().map(|point| point.0).fold(right, f64::min);
            let left = if left < right { left } else { 0.0 };
            let mut chart = builder.build_cartesian_2d(left..right, 0.0..1.05)?;
            chart
                .configure_mesh()
                .light_line_style(TRANSPARENT)
                .x_desc("agents")
                .y_desc("success rate")
                .y_label_formatter(&|share| format!("{:.0} %", 100.0 * share))
                .x_label_formatter(&|agents| format!("{agents:.0}"))
                .label_style(FONT)
                .draw()?;
            for (curve, style) in styled(curves) {
                let line = LineSeries::new(curve.points.iter().copied(), style);
                let drawn = chart.draw_series(line)?.label(&curve.name);
                drawn.legend(move |(x, y)| PathElement::new([(x, y), (x + 24, y)], style));
            }
            let labels = &mut chart.configure_series_labels();
            labels
                .position(SeriesLabelPosition::LowerLeft)
                .label_font(FONT);
            labels
                .background_style(WHITE.mix(0.8))
                .border_style(TRANSPARENT)
                .draw()?;
        }
        Axes::Cactus => {
            let top = points().map(|point| point.1).fold(1.0, f64::max) * 1.2;
            let mut chart =
                builder.build_cartesian_2d(0.0..right, (LEAST_SECONDS..top).log_scale())?;
            chart
                .configure_mesh()
                .light_line_style(TRANSPARENT)
                .x_desc("successful tasks")
                .y_desc("CPU seconds each")
                .x_label_formatter(&|tasks| format!("{tasks:.0}"))
                .y_label_formatter(&|seconds| seconds.to_string())
                .label_style(FONT)
                .draw()?;
            for (curve, style) in styled(curves) {
                let points = curve.points.iter().map(|&(x, y)| (x, y.max(LEAST_SECONDS)));
                let drawn = chart
                    .draw_series(LineSeries::new(points, style))?
                    .label(&curve.name);
                drawn.legend(move |(x, y)| PathElement::new([(x, y), (x + 24, y)], style));
            }
            let labels = &mut chart.configure_series_labels();
            labels
                .position(SeriesLabelPosition::UpperLeft)
                .label_font(FONT);
            labels
                .background_style(WHITE.mix(0.8))
                .border_style(TRANSPARENT)
                .draw()?;
        }
    }
    root.present()?;
    Ok(())
}

/// Curves with a colour each, in turn.
fn styled(curves: &[Curve]) -> impl Iterator<Item = (&Curve, ShapeStyle)> {
    let colours = COLOURS.iter().cycle();
    curves
        .iter()
        .zip(colours)
        .map(|(curve, colour)| (curve, colour.stroke_width(2)))
}
