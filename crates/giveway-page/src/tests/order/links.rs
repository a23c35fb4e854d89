//! All links of a plan as a table.

use super::{act, opened};
use crate::keys::{Command, Key, command};
use crate::order::{OrderAction, column};
use crate::reduce::tests::after;

#[test]
fn all_links_are_a_table_by_time() {
    let state = opened();
    let order = state.order().unwrap();
    let told = column(&state).unwrap();
    assert_eq!(told.table, None);
    let count = order.links.len();
    assert_eq!(told.all, Some(format!("Show all {count} links")));
    let shown = act(&state, &[OrderAction::Links(true)]);
    let table = column(&shown).unwrap().table.unwrap();
    assert_eq!((table.rows.len(), table.more), (count, None));
    assert!(table.rows.is_sorted_by_key(|row| row.comes));
    for row in &table.rows {
        let is_told = order.links.iter().any(|link| {
            let (first, second) = (&link.first, &link.second);
            link.cell == row.cell
                && (&first.agent, first.time) == (&row.first.1, row.leaves)
                && (&second.agent, second.time) == (&row.second.1, row.comes)
                && link.slack == row.slack
        });
        assert!(is_told, "{row:?}");
    }
    // A press on a cell shows the order there.
    let at = table.rows[0].cell;
    let there = act(&shown, &[OrderAction::At(at)]);
    assert_eq!(there.order_cell(), Some(at));
    let escape = Key {
        name: "Escape",
        ..Key::default()
    };
    let Some(Command::Act(leave)) = command(escape, &shown) else {
        panic!("Escape leaves the table first");
    };
    let left = after(&shown, [leave]);
    assert!(left.shows_order() && column(&left).unwrap().table.is_none());
}
