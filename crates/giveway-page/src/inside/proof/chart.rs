//! The bound that rises and the best plan that falls, until they meet: of the cost
//! that the chosen step is about.

use std::fmt::Write as _;

use giveway_model::tr;
use giveway_picture::whole;
use giveway_solve::trace::SearchEvent;

use super::rows::{Known, known};
use super::{chosen, steps, trace};
use crate::{State, words};

/// Around the lines, in pixels: left, right, above, below.
const MARGIN: (f64, f64, f64, f64) = (44.0, 18.0, 42.0, 42.0);

/// The chart, in pixels.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Chart {
    /// What is said of it.
    pub name: String,
    /// Of which cost.
    pub title: String,
    /// The `d` of the gap between both, of the bound, and of the best plan.
    pub gap: String,
    /// The bound.
    pub bound: String,
    /// The best plan.
    pub best: String,
    /// Lines across, with their figures.
    pub across: Vec<Tick>,
    /// Figures below: the numbers of steps.
    pub below: Vec<Tick>,
    /// The chosen step: its place and its number.
    pub head: (f64, usize),
    /// The bound there, and the best plan.
    pub dots: [Option<Dot>; 2],
    /// Where both met.
    pub seal: Option<(f64, f64)>,
    /// Where the names of both lines stand, from above: the bound's, the best plan's.
    pub names: [Option<f64>; 2],
    /// The first and the last step of it.
    pub steps: (usize, usize),
    /// From where to where steps stand.
    pub across_from: (f64, f64),
}

/// A figure at an axis.
#[derive(Clone, Debug, PartialEq)]
pub struct Tick {
    /// Its place along the axis.
    pub at: f64,
    /// The figure.
    pub value: u32,
}

/// A value at the chosen step.
#[derive(Clone, Debug, PartialEq)]
pub struct Dot {
    /// How far from above.
    pub y: f64,
    /// The value.
    pub value: u32,
}

impl Chart {
    /// The step that is nearest to a place.
    pub fn step_at(&self, x: f64) -> usize {
        let (first, last) = self.steps;
        let (left, right) = self.across_from;
        let share = ((x - left) / (right - left).max(1.0)).clamp(0.0, 1.0);
        first + whole((share * (last - first) as f64).round()) as usize
    }
}

/// The chart in so much room; `None` without a proof.
pub fn chart(state: &State, (width, height): (f64, f64)) -> Option<Chart> {
    let trace = trace(state)?;
    let (at, _) = chosen(state)?;
    let known = known(trace);
    let cost = known.get(at)?.cost;
    // The steps before and after that are about the same cost.
    let first = known[..at].iter().rposition(|known| known.cost != cost);
    let first = first.map_or(0, |before| before + 1);
    let last = known[at..].iter().position(|known| known.cost != cost);
    let last = last.map_or(known.len() - 1, |after| at + after - 1);
    let part = &known[first..=last];

    let values = || {
        part.iter()
            .flat_map(|known| [known.bound, known.best])
            .flatten()
    };
    let (low, high) = (values().min()?, values().max()?);
    let (left, right, top, bottom) = (MARGIN.0, width - MARGIN.1, MARGIN.2, height - MARGIN.3);
    let x = |step: usize| {
        let share = (step - first) as f64 / (last - first).max(1) as f64;
        left + share * (right - left)
    };
    let y = |value: u32| {
        // A value that never changes stands in the middle.
        let share = match high - low {
            0 => 0.5,
            all => f64::from(value - low) / f64::from(all),
        };
        bottom - share * (bottom - top)
    };
    let mut lines = [String::new(), String::new()];
    let values_of: [fn(&Known) -> Option<u32>; 2] = [|known| known.bound, |known| known.best];
    for (line, value) in lines.iter_mut().zip(values_of) {
        let mut before = None;
        for (step, known) in (first..).zip(part) {
            let Some(value) = value(known) else { continue };
            // Writing to a string cannot fail.
            let _ = match before {
                None => write!(line, "M{:.1} {:.1}", x(step), y(value)),
                Some(same) if same == value && step < last => Ok(()),
                Some(_) => write!(line, "H{:.1}V{:.1}", x(step), y(value)),
            };
            before = Some(value);
        }
    }
    let [bound, best] = lines;
    let now = known.get(at)?;
    let dot = |value: Option<u32>| value.map(|value| Dot { y: y(value), value });
    let end = known.get(last)?;
    // The proof of this cost is over where the next one begins.
    let last_event = steps(trace).nth(last).map(|event| &event.event);
    let is_over = last + 1 < known.len() || matches!(last_event, Some(SearchEvent::Met { .. }));
    let met = end.bound.filter(|_| is_over && end.bound == end.best);
    let title = words::title(cost);
    let said = |from: Option<u32>, to: Option<u32>| from.zip(to);
    let bounds = said(part.iter().find_map(|k| k.bound), end.bound);
    let plans = said(part.iter().find_map(|k| k.best), end.best);
    Some(Chart {
        name: name(title, bounds, plans),
        title: title.to_owned(),
        gap: gap(part, first, x, y),
        bound,
        best,
        across: across(low, high, y),
        below: below(first, last, at, x, right - left),
        head: (x(at), at),
        dots: [dot(now.bound), dot(now.best)],
        seal: met.map(|value| (x(last), y(value))),
        names: [
            part.iter()
                .find_map(|known| known.bound)
                .map(|value| y(value) + 17.0),
            part.iter()
                .find_map(|known| known.best)
                .map(|value| y(value) - 8.0),
        ],
        steps: (first, last),
        across_from: (left, right),
    })
}

/// The gap between both lines, from where both are known.
fn gap(part: &[Known], first: usize, x: impl Fn(usize) -> f64, y: impl Fn(u32) -> f64) -> String {
    let both = (first..).zip(part);
    let both = both.filter_map(|(step, known)| Some((x(step), known.bound?, known.best?)));
    let both: Vec<(f64, u32, u32)> = both.collect();
    let mut path = String::new();
    let mut level = None;
    for &(x, _, best) in &both {
        // Writing to a string cannot fail.
        let _ = match level.replace(best) {
            None => write!(path, "M{x:.1} {:.1}", y(best)),
            Some(_) => write!(path, "H{x:.1}V{:.1}", y(best)),
        };
    }
    for pair in both.windows(2).rev() {
        let ((x, ..), (u, bound, _)) = (pair[0], pair[1]);
        let _ = write!(path, "L{u:.1} {:.1}V{:.1}H{x:.1}", y(bound), y(pair[0].1));
    }
    path
}

/// What is said of the chart.
fn name(title: &str, bounds: Option<(u32, u32)>, plans: Option<(u32, u32)>) -> String {
    let bound = match bounds {
        None => String::new(),
        Some((from, to)) if from == to => tr!(" The bound is {from}.", from),
        Some((from, to)) => tr!(" The bound rises from {from} to {to}.", from, to),
    };
    let best = match plans {
        None => String::new(),
        Some((from, to)) if from == to => tr!(" The best plan is {from}.", from),
        Some((from, to)) => tr!(" The best plan falls from {from} to {to}.", from, to),
    };
    tr!(
        "{title}: proved bound and best plan by step.{bound}{best}",
        title,
        bound,
        best
    )
}

/// At most four round figures from the least to the greatest.
fn across(low: u32, high: u32, y: impl Fn(u32) -> f64) -> Vec<Tick> {
    let every = (high - low).div_ceil(3).max(1);
    let mut values: Vec<u32> = (low..=high).step_by(every as usize).collect();
    if values.last().is_some_and(|&last| high - last > every / 2) {
        values.push(high);
    }
    values
        .into_iter()
        .map(|value| Tick {
            at: y(value),
            value,
        })
        .collect()
}

/// The numbers of steps, as many as fit; not where the chosen one stands.
fn below(first: usize, last: usize, at: usize, x: impl Fn(usize) -> f64, room: f64) -> Vec<Tick> {
    let fits = whole(room / 44.0).max(1) as usize;
    let every = (last - first).div_ceil(fits).max(1);
    let steps = (first..=last).step_by(every);
    let is_apart = |step: &usize| (x(*step) - x(at)).abs() > 26.0;
    let tick = |step: usize| Tick {
        at: x(step),
        value: u32::try_from(step).unwrap_or(u32::MAX),
    };
    steps.filter(is_apart).map(tick).collect()
}
