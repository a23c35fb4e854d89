//! What the column says of an order of prioritised planning.

use giveway_model::tr;
use giveway_model::words::values;
use giveway_solve::plan::words;

use super::column::{Button, Column, OrderRow, Tint, Verdict};
use super::looking::all_orders;
use super::{InsideAction, Looked, OrderRun, index};
use crate::State;

/// So many orders are listed.
const LISTED: usize = 50;

pub(super) fn column(state: &State) -> Option<Column> {
    let looked = state.looked()?;
    let run = looked.orders.get(state.inside.order);
    // A long list is shown around the order that is chosen.
    let first = match looked.orders.len() {
        ..=LISTED => 0,
        _ => state.inside.order.saturating_sub(LISTED / 2),
    };
    let rows = looked.orders.iter().enumerate().skip(first).take(LISTED);
    let rows: Vec<OrderRow> = rows.map(|(place, run)| row(state, place, run)).collect();
    let proved = state
        .document
        .fresh_answer()
        .filter(|answer| answer.plan().is_some());
    let note = proved.map(|answer| {
        let objective = &answer.draft.scene().objective;
        let costs = answer.solved.costs.unwrap_or_default();
        tr!(
            "There is a plan: {costs}.",
            costs = values(objective.costs(), &costs)
        )
    });
    let can_play = proved.is_some();
    Some(Column {
        over: tr!("Prioritised planning").to_owned(),
        title: tr!("One robot after the other").to_owned(),
        verdict: run.map(|run| verdict(state, run)),
        orders: (!rows.is_empty()).then(|| (title(state, looked), rows)),
        note,
        remark: looked.failed.clone().filter(|_| looked.orders.is_empty()),
        foot: if can_play {
            vec![Button::new(
                "play",
                tr!("Play the best plan"),
                Some(InsideAction::PlayPlan),
                true,
            )]
        } else if looked.failed.is_some() {
            vec![Button::new(
                "",
                tr!("Try again"),
                Some(InsideAction::Again),
                false,
            )]
        } else {
            Vec::new()
        },
        ..Column::default()
    })
}

fn verdict(state: &State, run: &OrderRun) -> Verdict {
    let objective = state.document.draft.scene().objective.costs();
    match words::why_stuck(&run.told) {
        Some(why) => Verdict {
            tint: Tint::Stuck,
            word: tr!("Stuck").to_owned(),
            beside: tr!("in this order").to_owned(),
            text: why,
        },
        None => Verdict {
            tint: Tint::Fine,
            word: tr!("It works").to_owned(),
            beside: tr!("in this order").to_owned(),
            text: match run.costs {
                Some(costs) => {
                    let costs = giveway_model::words::capital(&values(objective, &costs));
                    tr!("{costs}. There may be better plans.", costs)
                }
                None => tr!("There may be better plans.").to_owned(),
            },
        },
    }
}

/// `All 6 orders get stuck`.
fn title(state: &State, looked: &Looked) -> String {
    let count = looked.orders.len();
    let stuck = looked
        .orders
        .iter()
        .filter(|run| run.told.stuck.is_some())
        .count();
    match all_orders(state.document.agents().len()) {
        Some(all) if count < all => tr!("{count} of {all} orders", count, all),
        Some(1) if stuck == 0 => tr!("There is one order, and it works").to_owned(),
        Some(all) if stuck == all => tr!("All {all} orders get stuck", all),
        Some(all) if stuck == 0 => tr!("All {all} orders work", all),
        Some(all) => tr!("{stuck} of {all} orders get stuck", stuck, all),
        None => tr!("{n} order was tried" | "{n} orders were tried" % count),
    }
}

fn row(state: &State, place: usize, run: &OrderRun) -> OrderRow {
    let agents = run
        .told
        .order
        .iter()
        .map(|name| (index(state, name), name.clone()));
    let objective = state.document.draft.scene().objective.costs().first();
    OrderRow {
        agents: agents.collect(),
        outcome: match (&run.told.stuck, run.costs.zip(objective)) {
            (Some(stuck), _) => tr!("{agent} stuck", agent = stuck.agent),
            (None, Some((costs, &cost))) => {
                format!("{} {}", giveway_model::words::name(cost), costs.get(cost))
            }
            (None, None) => tr!("an order" => "works").to_owned(),
        },
        is_stuck: run.told.stuck.is_some(),
        is_current: place == state.inside.order,
        place,
    }
}
