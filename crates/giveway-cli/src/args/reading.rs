//! How plans of others are to be read, where a person knows better.

use clap::builder::PossibleValue;
use clap::{Args as ClapArgs, ValueEnum};
use giveway_formats::{CellOrder, Origin, Up};

/// The conventions that a person chose.
#[derive(Clone, Copy, Debug, Default, ClapArgs)]
pub(crate) struct Reading {
    /// Which number of a cell comes first in a plan [default: what fits]
    #[arg(long, value_enum, value_name = "ORDER")]
    pub(crate) cells: Option<Order>,
    /// The number of the first row and column of a plan [default: what fits]
    #[arg(long, value_enum, value_name = "NUMBER")]
    pub(crate) origin: Option<First>,
    /// Which row "up" leads to in a plan, y counted from the top [default: what fits]
    #[arg(long, value_enum, value_name = "ROW")]
    pub(crate) up: Option<UpTo>,
}

impl Reading {
    /// The options that were chosen, with their values.
    pub(crate) fn chosen(self) -> Vec<(&'static str, String)> {
        let name = |value: Option<PossibleValue>| value.map(|value| value.get_name().to_owned());
        let cells = self.cells.and_then(|it| name(it.to_possible_value()));
        let origin = self.origin.and_then(|it| name(it.to_possible_value()));
        let up = self.up.and_then(|it| name(it.to_possible_value()));
        let all = [("cells", cells), ("origin", origin), ("up", up)].into_iter();
        all.filter_map(|(option, value)| Some((option, value?)))
            .collect()
    }
}

/// Which number of a cell comes first.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum Order {
    /// The row, then the column
    #[value(name = "row,column")]
    RowColumn,
    /// The column, then the row
    #[value(name = "column,row")]
    ColumnRow,
}

/// The number of the first row and column.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum First {
    /// From 0
    #[value(name = "0")]
    Zero,
    /// From 1
    #[value(name = "1")]
    One,
}

/// Which row "up" leads to.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum UpTo {
    /// The row above
    #[value(name = "y-1")]
    Above,
    /// The row below
    #[value(name = "y+1")]
    Below,
}

impl From<Order> for CellOrder {
    fn from(order: Order) -> Self {
        match order {
            Order::RowColumn => Self::RowColumn,
            Order::ColumnRow => Self::ColumnRow,
        }
    }
}

impl From<First> for Origin {
    fn from(first: First) -> Self {
        match first {
            First::Zero => Self::Zero,
            First::One => Self::One,
        }
    }
}

impl From<UpTo> for Up {
    fn from(up: UpTo) -> Self {
        match up {
            UpTo::Above => Self::Lowers,
            UpTo::Below => Self::Raises,
        }
    }
}
