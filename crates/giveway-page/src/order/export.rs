//! The order as a file: its name, and what is in it.

use std::rc::Rc;

use giveway_model::tr;
use giveway_solve::order::{OrderAnswer, OrderFormat};

use crate::State;
use crate::files::name_of;
use crate::intake::Packed;

/// A file with the order.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum OrderExport {
    /// All of it, as JSON.
    #[default]
    Json,
    /// The graph for Graphviz.
    Dot,
    /// Way-points by robot, as JSON.
    Waypoints,
    /// Orders of VDA 5050, as JSON.
    Vda5050,
}

impl OrderExport {
    /// All of them.
    pub const ALL: [Self; 4] = [Self::Json, Self::Dot, Self::Waypoints, Self::Vda5050];

    /// Its name.
    pub fn name(self) -> &'static str {
        match self {
            Self::Json => "JSON",
            Self::Dot => "DOT",
            Self::Waypoints => tr!("a file" => "Way-points"),
            Self::Vda5050 => tr!("VDA 5050 orders"),
        }
    }

    /// What is in it.
    pub fn detail(self) -> &'static str {
        match self {
            Self::Json => tr!("all links with cell, times and slack"),
            Self::Dot => tr!("the graph, for Graphviz"),
            Self::Waypoints => tr!("by robot: cell, time, heading"),
            Self::Vda5050 => tr!("nodes released in this order"),
        }
    }

    /// The format in which the solver writes it; `None` where the page does.
    pub(crate) const fn format(self) -> Option<OrderFormat> {
        match self {
            Self::Json => None,
            Self::Dot => Some(OrderFormat::Dot),
            Self::Waypoints => Some(OrderFormat::Waypoints),
            Self::Vda5050 => Some(OrderFormat::Vda5050),
        }
    }
}

/// A file with the order: what the solver wrote of it, or all of the answer. `None` where it
/// cannot be written.
pub(crate) fn written(
    state: &State,
    answer: &OrderAnswer,
    format: Option<OrderFormat>,
) -> Option<Rc<Packed>> {
    let (ending, text) = match format {
        None => ("order.json", serde_json::to_string_pretty(answer).ok()?),
        Some(format) => {
            let file = answer.files.iter().find(|file| file.format == format)?;
            let ending = match format {
                OrderFormat::Dot => "order.dot",
                OrderFormat::Csv => "waypoints.csv",
                OrderFormat::Waypoints => "waypoints.json",
                OrderFormat::Vda5050 => "vda5050.json",
            };
            (ending, file.text.clone())
        }
    };
    Some(Rc::new(Packed {
        name: name_of(state, ending),
        bytes: text.into_bytes(),
    }))
}
