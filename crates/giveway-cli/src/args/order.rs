//! The arguments of `giveway order`.

use std::path::PathBuf;

use clap::Args as ClapArgs;
use clap::builder::{PossibleValuesParser, TypedValueParser};
use giveway_model::Cell;
use giveway_order::Lateness;
use giveway_solve::order::OrderFormat;

use super::{Source, seconds, whole};

/// The order that robots keep where they have no common clock.
#[derive(Debug, ClapArgs)]
#[command(after_help = "\
A robot begins its move into a cell no earlier than the robot before it begins to leave the cell.
Where all keep to that, nobody collides and nobody waits for ever, however late they are. The slack
of such a link is how many steps later the first may leave before the second has to wait.

Formats of --to
  dot          the graph, for Graphviz
  csv          way-points as a table: metres, seconds, headings
  waypoints    the same as JSON
  vda5050      VDA 5050 orders and the updates that release their nodes, as JSON
Metres and seconds come from the units of the scene; without units a cell is 1 m and a step 1 s.

Examples
  giveway order warehouse.json
  giveway order warehouse.json warehouse.plan.json --late 'A4@(4,1)+3'
  giveway order warehouse.json --to dot | dot -Tsvg > order.svg
  giveway order floor.json adopted.json --changes changes.json --to vda5050")]
pub(crate) struct Order {
    #[command(flatten)]
    pub(crate) source: Source,
    /// A plan in any format, or a result of solve with a plan in it; or - for standard input
    /// [default: the instance is solved first]
    #[arg(value_name = "PLAN")]
    pub(crate) plan: Option<PathBuf>,
    /// What changes while the plan runs
    #[arg(long, value_name = "FILE", requires = "plan")]
    pub(crate) changes: Option<PathBuf>,
    /// A robot comes so many steps late to a cell: A4@(4,1)+3; to its second visit of the cell:
    /// A4@(4,1)/2+3 (may be given several times)
    #[arg(long, value_name = "WHO", value_parser = lateness)]
    pub(crate) late: Vec<Lateness>,
    /// Write the order in this format instead of telling it
    #[arg(long, value_name = "FORMAT", value_parser = formats())]
    pub(crate) to: Option<OrderFormat>,
    /// Look only for plans of at most this makespan; 0 is allowed [default: the longest time that a
    /// robot needs alone + 4 (width + height) + 10]
    #[arg(long, value_name = "N", value_parser = whole::<u32>, allow_negative_numbers = true)]
    pub(crate) within: Option<u32>,
    /// Stop the whole command after so many seconds; 0.5 is allowed
    #[arg(long, value_name = "SECONDS", value_parser = seconds, allow_negative_numbers = true)]
    pub(crate) time_limit: Option<f64>,
}

/// The format of a name; clap offers the names.
fn formats() -> impl TypedValueParser<Value = OrderFormat> {
    let named = |name: String| OrderFormat::ALL.into_iter().find(|it| it.name() == name);
    PossibleValuesParser::new(OrderFormat::ALL.map(OrderFormat::name))
        .map(move |name| named(name).unwrap_or(OrderFormat::Dot))
}

/// A lateness as it is typed: `A4@(4,1)+3`, `A4@4,1/2+3`.
fn lateness(word: &str) -> Result<Lateness, String> {
    let read = || {
        let (agent, rest) = word.rsplit_once('@')?;
        let (place, steps) = rest.rsplit_once('+')?;
        let (cell, visit) = match place.split_once('/') {
            Some((cell, visit)) => (cell, visit.parse().ok().filter(|it| *it > 0)?),
            None => (place, 1),
        };
        let cell = cell.trim().trim_start_matches('(').trim_end_matches(')');
        let (x, y) = cell.split_once(',')?;
        Some(Lateness {
            agent: agent.to_owned(),
            cell: Cell::new(x.trim().parse().ok()?, y.trim().parse().ok()?),
            visit,
            steps: steps.trim().parse().ok()?,
        })
    };
    read().ok_or_else(|| {
        format!("found \"{word}\", expected a robot, a cell and steps, such as A4@(4,1)+3")
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_lateness_is_a_robot_a_cell_and_steps() {
        let read = |word: &str| lateness(word).map(|it| (it.agent, it.cell, it.visit, it.steps));
        let cell = Cell::new(4, 1);
        assert_eq!(read("A4@(4,1)+3"), Ok(("A4".to_owned(), cell, 1, 3)));
        assert_eq!(read("A4@4, 1/2+30"), Ok(("A4".to_owned(), cell, 2, 30)));
        assert_eq!(read("a+b@c@(4,1)+0"), Ok(("a+b@c".to_owned(), cell, 1, 0)));
        for word in [
            "",
            "A4",
            "A4@(4,1)",
            "A4@(4)+1",
            "A4@(4,1)/0+1",
            "A4@(4,1)-3",
            "A4@(4,1)+x",
        ] {
            assert!(lateness(word).is_err(), "{word}");
        }
    }
}
