//! The other plan beside the plan: what is claimed of it, and who is marked on both boards.

use giveway_model::{Cell, Plan};
use giveway_solve::explain::{ExplainAnswer, Near, Part};

use super::nearby::slide;
use super::{asked, hear, told};
use crate::ask::closeness;
use crate::board::{lit, reasons};
use crate::reduce::tests::after;
use crate::{Action, AskAction, Lit, PlayAction, State, ViewAction};

/// A plan in which A2 stays at its start for one step more.
fn later(state: &State) -> Plan {
    let answer = state.document.answer.as_ref().unwrap();
    let mut plan = answer.plan().unwrap().clone();
    let path = plan.paths.get_mut("A2").unwrap();
    path.insert(0, path[0]);
    plan
}

fn shown(answer: ExplainAnswer) -> State {
    let state = hear(&asked(), answer);
    let wide = Action::View(ViewAction::SetWide(true));
    after(&state, [wide, Action::Ask(AskAction::ShowOther(true))])
}

#[test]
fn only_of_the_best_other_plan_it_is_claimed_that_none_is_closer() {
    let start = asked();
    let near = Near {
        variations: vec![slide(&start, Cell::new(3, 1), 2)],
        at_most: None,
        words: String::new(),
    };
    let answer = ExplainAnswer {
        near: Some(near),
        closest: true,
        pending: vec![Part::Repairs],
        ..told(&start)
    };
    let open = ExplainAnswer {
        closest: false,
        ..answer.clone()
    };
    assert_eq!(closeness(&shown(open)), None, "it is not proved");
    let state = shown(answer);
    assert_eq!(closeness(&state), Some("closest to this plan"));
    let chosen = after(&state, [Action::Ask(AskAction::Choose(Some(0)))]);
    assert_eq!(closeness(&chosen), None, "a variation is looked at");
    let back = after(&chosen, [Action::Ask(AskAction::Choose(None))]);
    assert_eq!(closeness(&back), Some("closest to this plan"));
}

#[test]
fn the_robots_of_the_difference_are_marked_and_nobody_is_faded() {
    let answer = ExplainAnswer {
        alternative: Some(later(&asked())),
        ..told(&asked())
    };
    let state = shown(answer);
    let at = |time| after(&state, [Action::Play(PlayAction::Seek(time))]);
    let first = state.differences()[0].clone();
    assert_eq!(first.agents, [1]);
    let differs = at(first.time);
    assert_eq!(reasons(&differs).agents, [1]);
    assert_eq!(lit(&differs), None);
    let before = at(first.time - 1);
    assert_eq!(reasons(&before).agents, [] as [usize; 0]);
    // A robot that is lit up is marked instead, and others are faded.
    let lit_up = after(
        &differs,
        [Action::Ask(AskAction::Light(Some(Lit::Robot(0))))],
    );
    assert_eq!(reasons(&lit_up).agents, [0]);
    assert_eq!(lit(&lit_up), Some(vec![0]));
}
