//! Plans of more and more robots as a table for spreadsheets.

use giveway_model::words::decimal;
use giveway_model::{Cost, Objective, csv, tr};

use super::{SizingAnswer, SizingPoint};
use crate::Status;

/// A row for each plan; the floor that is compared has a name of its own.
pub fn csv(answer: &SizingAnswer, (this, beside): (&str, &str)) -> String {
    let heads = [
        tr!("Robots"),
        tr!("Floor"),
        tr!("Known"),
        tr!("Last arrival"),
        tr!("Sum of costs"),
        tr!("Charges"),
        tr!("Sum, at least"),
        tr!("Sum, each alone"),
        tr!("Mean delay"),
    ];
    let heads = heads.map(csv::text).to_vec();
    let points = answer.points.iter().enumerate();
    let rows = points.flat_map(|(place, point)| {
        let other = answer.beside.get(place);
        let other = other.map(|other| row(&answer.objective, other, beside));
        std::iter::once(row(&answer.objective, point, this)).chain(other)
    });
    csv::table(std::iter::once(heads).chain(rows))
}

fn row(objective: &Objective, point: &SizingPoint, floor: &str) -> Vec<String> {
    let number = |n: Option<u32>| n.map_or_else(String::new, |n| n.to_string());
    let cost = |cost: Cost| number(point.costs.map(|costs| costs.get(cost)));
    let delay = point.mean_delay(objective);
    let known = match point.status {
        Status::Optimal => tr!("a plan is" => "proved"),
        Status::Feasible => tr!("best so far"),
        Status::Impossible => tr!("no plan"),
        Status::Unknown => tr!("not solved in time"),
    };
    let fields = [
        point.robots.to_string(),
        floor.to_owned(),
        known.to_owned(),
        cost(Cost::Makespan),
        cost(Cost::SumOfCosts),
        cost(Cost::Charges),
        number(point.proved_sum(objective)),
        number(point.alone),
        delay.map_or_else(String::new, |(mean, _)| decimal(mean, 3)),
    ];
    fields.map(|field| csv::text(&field)).to_vec()
}
