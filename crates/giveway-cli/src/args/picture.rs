//! The arguments of `giveway picture`.

use std::path::PathBuf;

use clap::{Args as ClapArgs, ValueEnum};
use giveway_picture::{CELL_PX, Theme};

use super::Source;

/// A plan to be drawn.
#[derive(Debug, ClapArgs)]
#[command(after_help = "\
The ending of the file says what is written: .svg, .png or .gif. A picture that moves is an .svg,
which plays in browsers and wherever they are built in, or a .gif; it goes on again and again, with
a rest at the end. Pixels are drawn without the system's fonts, so that they are the same
everywhere: names have letters of English and figures there, and others are left out. The plan may
break rules; it is drawn as it is.

Examples
  giveway picture warehouse.json warehouse.plan.json > start.svg
  giveway picture warehouse.json warehouse.plan.json --at 4 --output step-4.png
  giveway picture warehouse.json warehouse.plan.json --animate --look dark -o warehouse.svg
  giveway solve warehouse.json --format json | giveway picture warehouse.json - --animate -o w.gif")]
pub(crate) struct Picture {
    #[command(flatten)]
    pub(crate) source: Source,
    /// A plan in any format, or a result of solve with a plan in it; or - for standard input
    #[arg(value_name = "PLAN")]
    pub(crate) plan: PathBuf,
    /// The time to show, in steps; between two steps robots are on their way
    #[arg(long, value_name = "T", value_parser = time, default_value = "0", allow_negative_numbers = true, conflicts_with = "animate")]
    pub(crate) at: f64,
    /// Show the whole plan, moving
    #[arg(long)]
    pub(crate) animate: bool,
    /// The file to write: .svg, .png or .gif. Without it an SVG goes to standard output
    #[arg(short, long, value_name = "FILE")]
    pub(crate) output: Option<PathBuf>,
    /// Whether it is light or dark
    #[arg(long, value_enum, default_value_t, value_name = "LOOK")]
    pub(crate) look: Look,
    /// The side of a cell, in pixels [default: 64, and less for large maps]
    #[arg(long, value_name = "PX", value_parser = pixels, allow_negative_numbers = true)]
    pub(crate) cell: Option<u32>,
}

/// Light or dark.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub(crate) enum Look {
    /// Dark on white
    #[default]
    Light,
    /// Light on dark
    Dark,
}

impl From<Look> for Theme {
    fn from(look: Look) -> Self {
        match look {
            Look::Light => Self::Light,
            Look::Dark => Self::Dark,
        }
    }
}

/// A time in steps.
fn time(word: &str) -> Result<f64, String> {
    word.parse::<f64>()
        .ok()
        .filter(|time| time.is_finite() && *time >= 0.0)
        .ok_or_else(|| format!("found \"{word}\", expected a number of steps from 0"))
}

/// The side of a cell, in pixels.
fn pixels(word: &str) -> Result<u32, String> {
    let (least, most) = CELL_PX;
    word.parse()
        .ok()
        .filter(|pixels| (least..=most).contains(pixels))
        .ok_or_else(|| {
            format!("found \"{word}\", expected a whole number of pixels from {least} to {most}")
        })
}
