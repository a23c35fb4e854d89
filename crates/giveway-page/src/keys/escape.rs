//! Escape, which closes one thing after the other.

use crate::area::AreaAction;
use crate::fleet::FleetAction;
use crate::floor_plan::FloorPlanAction;
use crate::freedom::FreedomAction;
use crate::grow::GrowAction;
use crate::inside::InsideAction;
use crate::intake::Job;
use crate::ledger::LedgerAction;
use crate::order::OrderAction;
use crate::robots::RobotsAction;
use crate::rules::RuleAction;
use crate::slot::SlotAction;
use crate::steering::Lead;
use crate::{
    Action, AskAction, BoardAction, ChangeAction, Phase, Selection, SolveAction, State, ViewAction,
};

/// What Escape closes first: what is being placed, what runs, the notice, the
/// welcome, robots that are looked at alone, robots that are to be added, a floor plan that is
/// turned into cells, the part of the floor that is selected, a rule that is being written, the other plan of a
/// question, the question, what is led, the selection, the changes of the world, the ledger, the
/// order, what is laid over the plan.
pub(super) fn escape(state: &State) -> Option<Action> {
    if state.has_gesture() {
        Some(Action::Board(BoardAction::Abandon))
    } else if state
        .growing()
        .is_some_and(|growing| growing.held.is_some())
    {
        Some(Action::Grow(GrowAction::Abandon))
    } else if state.closed_cell().is_some() && state.view.selection == Selection::Nothing {
        Some(Action::Freedom(FreedomAction::Open))
    } else if state.is_pricing()
        || state.intake.job().is_some_and(Job::is_picture)
        || matches!(
            state.phase(),
            Phase::Solving | Phase::Asking | Phase::Checking | Phase::Counting | Phase::Adapting
        )
    {
        Some(Action::Solve(SolveAction::Cancel))
    } else if state.view.notice.is_some() {
        Some(Action::View(ViewAction::DismissNotice))
    } else if state.view.waiting.welcome {
        Some(Action::Slot(SlotAction::Close))
    } else if state.is_inside() && state.inside.alone.is_some() {
        Some(Action::Inside(InsideAction::Alone(false)))
    } else if state.view.fleet.is_some() {
        Some(Action::Fleet(FleetAction::Cancel))
    } else if state.open_plan().is_some() {
        Some(Action::FloorPlan(FloorPlanAction::Cancel))
    } else if state.growing().is_some() {
        Some(Action::Grow(GrowAction::Cancel))
    } else if state.view.robots.waiting.is_some() {
        Some(Action::Robots(RobotsAction::Drop))
    } else if state.has_area() {
        Some(Action::Area(AreaAction::Drop))
    } else if state.is_writing_rule() {
        let open = state.view.rules.writing.as_ref();
        let has_open = open.is_some_and(|writing| writing.open.is_some());
        Some(Action::Rules(if has_open {
            RuleAction::OpenSlot(None)
        } else {
            RuleAction::Cancel
        }))
    } else if let Some(asking) = state.document.mode.asking() {
        let is_open = asking.shows_other && asking.other.is_some();
        Some(Action::Ask(if is_open {
            AskAction::ShowOther(false)
        } else {
            AskAction::Close
        }))
    } else if let Some(own) = state.document.mode.steering() {
        // Another agent or a cell is looked at in between.
        let led = Selection::Agent(own.agent);
        Some(match state.view.selection {
            Selection::Nothing => Action::Steer(Lead::Discard),
            selection if selection == led => Action::Steer(Lead::Discard),
            _ => Action::Board(BoardAction::Select(led)),
        })
    } else if state.view.selection != Selection::Nothing {
        Some(Action::Board(BoardAction::Select(Selection::Nothing)))
    } else if state.document.mode.changing().is_some() {
        Some(Action::Change(ChangeAction::Discard))
    } else if state.ledger().is_some() {
        Some(Action::Ledger(LedgerAction::Show(false)))
    } else if state.shows_order() {
        Some(Action::Order(if state.view.order.late.is_some() {
            OrderAction::Late(false)
        } else if state.view.order.is_whole {
            OrderAction::Links(false)
        } else {
            OrderAction::Show(false)
        }))
    } else if state.freedom().is_some() {
        Some(Action::Freedom(FreedomAction::Show(false)))
    } else {
        None
    }
}
