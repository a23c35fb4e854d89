//! Three charts over the number of robots: the last arrival, the mean delay, what is still open.

use giveway_model::words::decimal;
use giveway_model::{Objective, tr};
use giveway_solve::Status;
use giveway_solve::sizing::SizingPoint;

use super::SizingRun;
use crate::State;

/// A chart: its dots lie in a square from 0 to 1, the second number upwards.
#[derive(Clone, Debug, PartialEq)]
pub struct Chart {
    /// Its title.
    pub title: &'static str,
    /// The unit of its numbers.
    pub unit: &'static str,
    /// The lines across it, with their numbers.
    pub lines: Vec<Tick>,
    /// The numbers of robots below it.
    pub robots: Vec<Tick>,
    /// The plans of the floor, by their place; nothing where one was not solved.
    pub dots: Vec<Option<Dot>>,
    /// Those of the floor that is compared.
    pub beside: Vec<Option<Dot>>,
    /// The whole of it for who does not see it.
    pub aloud: String,
}

/// A number at its place, from 0 to 1.
#[derive(Clone, Debug, PartialEq)]
pub struct Tick {
    /// Where it is.
    pub at: f64,
    /// The number.
    pub text: String,
}

/// A plan in a chart.
#[derive(Clone, Debug, PartialEq)]
pub struct Dot {
    /// Its place among the numbers of robots.
    pub place: usize,
    /// Where it is.
    pub at: (f64, f64),
    /// How low it may still come to lie.
    pub low: f64,
    /// Whether it is proved to be best.
    pub is_proved: bool,
    /// Whether its plan is on the board.
    pub is_looked: bool,
    /// Its number.
    pub text: String,
}

/// What a chart shows of a plan: the number, and the least that is proved of it.
type Value = fn(&SizingPoint, &Objective) -> Option<(f64, f64)>;

/// The charts; none before anything was asked.
pub fn charts(state: &State) -> Vec<Chart> {
    let Some(run) = state.sizing() else {
        return Vec::new();
    };
    let looked = state.view.sizing.looked.as_ref().map(|looked| looked.place);
    let arrival: Value = |point, _| {
        let makespan = f64::from(point.costs?.makespan);
        let bound = point.bounds.get(&giveway_model::Cost::Makespan);
        let alone = point.slowest.as_ref().map(|it| it.steps);
        let low = bound.copied().or(alone).map_or(makespan, f64::from);
        Some((makespan, low.min(makespan)))
    };
    let delay: Value = |point, objective| point.mean_delay(objective);
    let open: Value = |point, objective| {
        let share = (point.open_share(objective)? * 1000.0).ceil() / 10.0;
        Some((share, share))
    };
    vec![
        chart(run, looked, (tr!("Last arrival"), tr!("steps")), 0, arrival),
        chart(
            run,
            looked,
            (tr!("Mean delay"), tr!("steps a robot, against alone")),
            1,
            delay,
        ),
        chart(
            run,
            looked,
            (
                tr!("Still open"),
                tr!("% of the sum, best so far to proved"),
            ),
            1,
            open,
        ),
    ]
}

fn chart(
    run: &SizingRun,
    looked: Option<usize>,
    (title, unit): (&'static str, &'static str),
    digits: usize,
    value: Value,
) -> Chart {
    let objective = &run.answer.objective;
    let counts = &run.request.counts;
    let values = |points: &[SizingPoint]| -> Vec<Option<(f64, f64)>> {
        points.iter().map(|point| value(point, objective)).collect()
    };
    let (own, beside) = (values(&run.answer.points), values(&run.answer.beside));
    let most = own.iter().chain(&beside).flatten().map(|it| it.0);
    let step = nice(most.fold(0.0, f64::max));
    let top = step * f64::from(LINES);
    let last = counts.len().saturating_sub(1).max(1) as f64;
    let across = |place: usize| {
        if counts.len() < 2 {
            0.5
        } else {
            place as f64 / last
        }
    };
    let dots = |values: &[Option<(f64, f64)>], points: &[SizingPoint]| {
        let dot = |(place, value): (usize, &Option<(f64, f64)>)| {
            let (number, low) = (*value)?;
            Some(Dot {
                place,
                at: (across(place), number / top),
                low: low / top,
                is_proved: points
                    .get(place)
                    .is_some_and(|it| it.status == Status::Optimal),
                is_looked: looked == Some(place),
                text: decimal(number, digits),
            })
        };
        values
            .iter()
            .enumerate()
            .map(dot)
            .collect::<Vec<Option<Dot>>>()
    };
    let every = counts.len().div_ceil(6).max(1);
    let robots = counts
        .iter()
        .enumerate()
        .filter(|(place, _)| place % every == 0);
    let tick = |n: u32| {
        let number = f64::from(n) * step;
        Tick {
            at: f64::from(n) / f64::from(LINES),
            text: decimal(number, usize::from(step.fract() > 0.0)),
        }
    };
    let own = dots(&own, &run.answer.points);
    Chart {
        title,
        unit,
        lines: (0..=LINES).map(tick).collect(),
        robots: robots
            .map(|(place, n)| Tick {
                at: across(place),
                text: n.to_string(),
            })
            .collect(),
        aloud: aloud(title, run, &own),
        beside: dots(&beside, &run.answer.beside),
        dots: own,
    }
}

/// How many lines there are above the lowest one.
const LINES: u32 = 3;

/// The distance of lines up to a number: 1, 2 or 5 with zeros, at least a half.
fn nice(most: f64) -> f64 {
    let each = most / f64::from(LINES);
    let mut unit = 0.5;
    loop {
        for step in [unit, 2.0 * unit, 4.0 * unit] {
            if each <= step {
                return step;
            }
        }
        unit *= 10.0;
    }
}

/// The first and the last number of a chart.
fn aloud(title: &str, run: &SizingRun, dots: &[Option<Dot>]) -> String {
    let mut known = dots.iter().flatten();
    let first = known.next();
    let last = known.next_back().or(first);
    let said = |dot: &Dot| {
        let robots = run.request.counts.get(dot.place).copied().unwrap_or(0);
        tr!("{robots} robots: {number}", robots, number = dot.text)
    };
    let ends: Vec<String> = [first, last].into_iter().flatten().map(said).collect();
    format!("{title}. {}", ends.join("; "))
}
