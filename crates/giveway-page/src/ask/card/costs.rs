//! What both plans cost: this one and the other one.

use giveway_model::tr;

/// A cost of both plans.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct CostRow {
    /// Which cost, or whose arrival.
    pub title: String,
    /// The agent whose arrival it is, by its index.
    pub agent: Option<usize>,
    /// Of this plan.
    pub this: u32,
    /// Of the other plan.
    pub other: u32,
}

impl CostRow {
    /// The difference in words: `same`, `+1`.
    pub fn difference(&self) -> String {
        match i64::from(self.other) - i64::from(self.this) {
            0 => tr!("a cost is the" => "same").to_owned(),
            more => format!("{more:+}").replace('-', "\u{2212}"),
        }
    }

    /// All of the row as it is read aloud: `A14 arrives: 77 here, 122 in the other plan, 45 more`.
    pub fn aloud(&self) -> String {
        let Self {
            title, this, other, ..
        } = self;
        let difference = match i64::from(self.other) - i64::from(self.this) {
            0 => tr!("a cost is the" => "same").to_owned(),
            n if n > 0 => tr!("{n} more", n),
            n => tr!("{n} less", n = n.unsigned_abs()),
        };
        tr!(
            "{title}: {this} here, {other} in the other plan, {difference}",
            title,
            this,
            other,
            difference
        )
    }
}
