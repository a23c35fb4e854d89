//! The question at the foot of the ledger.

use giveway_model::Question;

use super::answered;
use super::ledger::{OPEN, column_of, solved, told};
use crate::ledger::{LedgerAction, LedgerLit, column, heat};
use crate::reduce::tests::after;
use crate::{Action, AskAction, ask};

#[test]
fn its_foot_asks_about_the_largest_loss_and_the_way_back_leads_to_it() {
    let state = told();
    let offer = column_of(&state).ask.unwrap();
    let first = &column_of(&state).losses[0];
    let question = Question::Arrival {
        agent: first.name.clone(),
    };
    assert_eq!(offer.question, question);
    assert_eq!(
        offer.text,
        format!("Why does {} not arrive sooner?", first.name)
    );
    let asked = answered(&after(&state, [Action::Ask(AskAction::Ask(question))]));
    assert_eq!(column(&asked), None);
    assert!(ask::card(&asked).is_some() && heat(&asked).is_none());
    let back = after(&asked, [Action::Ask(AskAction::Close)]);
    assert_eq!(column(&back), column(&state));
}

#[test]
fn its_foot_asks_about_the_robot_that_is_lit_up() {
    let corridors = solved(
        &["......", "##.###", "######", "......", "##.###"],
        &[
            ("A1", (0, 0), (5, 0)),
            ("A2", (5, 0), (0, 0)),
            ("A3", (0, 3), (5, 3)),
            ("A4", (5, 3), (0, 3)),
        ],
    );
    let state = answered(&after(&corridors, [OPEN]));
    let second = &column_of(&state).losses[1];
    let light = LedgerAction::Light(second.agent.map(LedgerLit::Robot));
    let lit = column_of(&after(&state, [Action::Ledger(light)]));
    let agent = second.name.clone();
    assert_eq!(lit.ask.unwrap().question, Question::Arrival { agent });
}
