//! The tab of a zone under a hand: pressed, it shows the zone's rule.

use giveway_picture::{Detail, ZoneShape, tab_parts};

use super::{CELL, rule_shapes, rules_now};
use crate::{Point, State};

/// Half the height of a tab, in units; as it is drawn.
const HALF: f64 = 20.0;

/// The zone whose tab is at a point of the board, by its name; the last of several, which lies
/// above. Where cells are small only its signs are seen, unless it is lit.
pub fn zone_at(state: &State, point: Point, detail: Detail) -> Option<String> {
    let draft = state.world();
    if draft.scene().zones.is_empty() {
        return None;
    }
    let shapes = rule_shapes(draft, &rules_now(state, draft), state.lit_rule());
    // As the style sheet enlarges them.
    let scale = match detail {
        Detail::All => 1.0,
        Detail::Plain => 1.2,
        Detail::Forms | Detail::Numbers => 1.75,
        Detail::Dots => 3.0,
    };
    let is_at = |zone: &&ZoneShape| {
        let parts = tab_parts(zone);
        let end = if detail == Detail::All || zone.is_lit {
            parts.end
        } else {
            parts.signs_end
        };
        let by = |at: f64, from: f64| ((at + 0.5) * CELL - from) / scale;
        let (x, y) = (by(point.x, zone.tab.0), by(point.y, zone.tab.1));
        (-HALF..=end).contains(&x) && y.abs() <= HALF
    };
    let found = shapes.zones.iter().rev().find(is_at);
    found.map(|zone| zone.name.clone())
}

#[cfg(test)]
mod tests {
    use giveway_model::Scene;

    use super::*;
    use crate::Draft;
    use crate::reduce::tests::after;
    use crate::rules::{Lit, RuleAction, list};
    use crate::{Action, Selection, Tab};

    fn state() -> State {
        let scene: Scene = serde_json::from_str(
            r#"{ "giveway": 1, "map": ["......", ".####.", "......"],
                 "agents": [{ "name": "A1", "start": [0, 0], "goal": [5, 2] }],
                 "zones": [{ "name": "aisle", "rect": [1, 0, 4, 1] }],
                 "constraints": [
                   { "kind": "capacity", "zone": "aisle", "most": 1 },
                   { "kind": "arrive", "by": 30 },
                   { "kind": "no-waiting", "zone": "aisle" }] }"#,
        )
        .unwrap();
        State::new(Draft::new(scene).unwrap())
    }

    fn press() -> Action {
        Action::Rules(RuleAction::OfTab("aisle".to_owned()))
    }

    /// A point some units right of where the tab begins, and below.
    fn beside(x: f64, y: f64) -> Point {
        let state = state();
        let shapes = rule_shapes(state.world(), &rules_now(&state, state.world()), None);
        let tab = shapes.zones[0].tab;
        Point {
            x: (tab.0 + x) / CELL - 0.5,
            y: (tab.1 + y) / CELL - 0.5,
        }
    }

    #[test]
    fn a_tab_is_pressed_where_it_is_seen() {
        let at = |x, y, detail| zone_at(&state(), beside(x, y), detail).is_some();
        // Two signs, then five letters.
        assert!(at(0.0, 0.0, Detail::All) && at(120.0, 15.0, Detail::All));
        assert!(!at(-25.0, 0.0, Detail::All) && !at(0.0, 25.0, Detail::All));
        assert!(!at(155.0, 0.0, Detail::All));
        // Among small cells the name is not there, and the signs are larger.
        assert!(at(80.0, 30.0, Detail::Numbers) && !at(140.0, 0.0, Detail::Numbers));
        let lit = after(
            &state(),
            [Action::Rules(RuleAction::Light(Some(Lit::Rule(0))))],
        );
        assert!(zone_at(&lit, beside(140.0, 0.0), Detail::Numbers).is_some());
    }

    #[test]
    fn it_shows_and_opens_its_rule_then_the_next_one() {
        let selected = after(&state(), [crate::tests::select(0)]);
        let first = after(&selected, [press()]);
        assert_eq!(first.view.selection, Selection::Nothing);
        assert_eq!(first.view.tab, Tab::Inspector);
        let open = |state: &State| {
            let rows = list(state).unwrap().rows;
            let open = rows.into_iter().filter(|row| row.is_open);
            open.map(|row| row.index).collect::<Vec<_>>()
        };
        assert_eq!(open(&first), [0]);
        assert_eq!(first.lit_rule(), Some(&Lit::Rule(0)));
        let second = after(&first, [press()]);
        assert_eq!(open(&second), [2]);
        assert_eq!(open(&after(&second, [press()])), [0]);
    }

    #[test]
    fn a_zone_without_a_rule_begins_one() {
        let remove = |index| Action::Rules(RuleAction::Remove(index));
        let bare = after(&state(), [remove(2), remove(0), press()]);
        assert!(bare.is_writing_rule());
        let other = Action::Rules(RuleAction::OfTab("elsewhere".to_owned()));
        assert!(!after(&state(), [other]).is_writing_rule());
    }
}
