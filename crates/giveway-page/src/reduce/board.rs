//! On the board: the keyboard's cursor, the tools, the selection.

use giveway_model::{Cell, tr_data};

use super::{area, ask, delete, fleet, floor_plan, grow, press, rules, steer, stroke};
use crate::area::Area;
use crate::draw::Shape;
use crate::gesture::Gesture;
use crate::steering::Lead;
use crate::{BoardAction, Selection, State, Tool};

pub(super) fn board(state: &mut State, action: BoardAction) {
    match action {
        BoardAction::PickTool(tool) => pick(state, tool),
        BoardAction::PickShape(shape) => {
            stroke::release(state);
            state.view.drawing = state.view.drawing.with_shape(shape);
        }
        BoardAction::SetMeasure(measure, cells) => {
            state.view.drawing = state.view.drawing.with_measure(measure, cells);
            let every = state.robot_every();
            state.view.fleet = state.view.fleet.take().map(|fleet| fleet.with_every(every));
        }
        BoardAction::MoveCursor(cell) => move_cursor(state, cell),
        BoardAction::StepCursor { by, carries } => step_cursor(state, by, carries),
        BoardAction::UseTool if state.hand().is_some() => stroke::release(state),
        BoardAction::UseTool if state.area().is_some_and(Area::has_ghost) => area::keep(state),
        BoardAction::UseTool if state.is_drawing() => stroke::release(state),
        BoardAction::UseTool => {
            press::press(state, state.view.cursor);
            if !stays_down(state) {
                stroke::release(state);
            }
        }
        BoardAction::Mark {
            cell,
            takes,
            is_rect,
        } => {
            press::press_with(state, cell, takes, is_rect);
        }
        BoardAction::Press(cell) => press::press(state, cell),
        BoardAction::Drag(cells) => {
            // Of an area only counts where the hand is now.
            let skipped = state.hand().map_or(0, |_| cells.len().saturating_sub(1));
            for cell in cells.into_iter().skip(skipped) {
                stroke::drag(state, cell);
            }
        }
        BoardAction::Release => stroke::release(state),
        BoardAction::Delete => delete::delete(state),
        BoardAction::Abandon => stroke::abandon(state),
        BoardAction::Select(selection) => select(state, selection),
    }
}

/// Whether the arrows go on with what the tool was used for, until it is used again: a lane, or a
/// shape between two cells.
fn stays_down(state: &State) -> bool {
    let stretches = match state.shape() {
        Shape::Pen | Shape::Fill | Shape::One => false,
        Shape::Rectangle
        | Shape::Line
        | Shape::Racks
        | Shape::Blocks
        | Shape::Aisle
        | Shape::Row => true,
    };
    state.view.tool == Tool::OneWay || stretches
}

/// Picks a tool; what another was doing is over.
fn pick(state: &mut State, tool: Tool) {
    stroke::release(state);
    if tool != Tool::Select && steer::is_in_the_way(state) {
        return;
    }
    stroke::abandon(state);
    grow::keep(state);
    if tool != Tool::Select {
        area::keep(state);
        state.view.area = None;
    }
    if tool != Tool::Agent {
        fleet::settle(state);
    }
    if tool != Tool::Select {
        floor_plan::settle(state);
    }
    if state.view.tool == tool {
        // Another zone begins.
        state.view.rules.zone = None;
    } else if tool.is_of_rules() {
        state.view.rules.writing = None;
    }
    state.view.tool = tool;
    if let Some(changing) = state.document.mode.changing() {
        let at = changing.at;
        return super::play::seek(state, at);
    }
    let answer = state.document.fresh_answer();
    let is_other_world = answer.is_some_and(|answer| answer.course.is_some());
    if tool.is_of_agents() || tool == Tool::Erase || (tool != Tool::Select && is_other_world) {
        // Agents are placed where they begin: that is shown, not where they are.
        super::play::seek(state, 0);
    }
}

/// What is selected has the inspector: a question makes way for it.
pub(super) fn select(state: &mut State, selection: Selection) {
    if floor_plan::takes_cell(state, selection) {
        return;
    }
    if let Selection::Agent(agent) = selection
        && ask::lights_robot(state, agent)
    {
        return;
    }
    ask::close(state);
    if rules::takes_cell(state, selection) {
        return;
    }
    area::keep(state);
    state.view.area = None;
    let count = state.world().agents().len();
    state.view.asker = match (selection, state.view.selection) {
        (Selection::Cell(_), Selection::Agent(agent)) => Some(agent),
        (Selection::Cell(_), Selection::Cell(_)) => state.view.asker,
        (Selection::Cell(_), Selection::Nothing)
        | (Selection::Agent(_) | Selection::Nothing, _) => None,
    };
    state.view.selection = match selection {
        // Of a scene before this one.
        Selection::Agent(agent) if agent >= count => Selection::Nothing,
        Selection::Cell(cell) => Selection::Cell(state.document.draft.clamp(cell)),
        selection => selection,
    };
    // Nobody is followed any more, nor whoever is selected next.
    state.view.follow &= state.view.selection != Selection::Nothing;
    steer::follow(state);
}

/// A step of the keyboard; with the tool that selects, a thing can go along. The
/// agent that is led takes the step itself.
fn step_cursor(state: &mut State, (right, down): (i32, i32), carries: bool) {
    let is_one = right.unsigned_abs().saturating_add(down.unsigned_abs()) == 1;
    let is_led = state.document.mode.steering().is_some();
    if is_led && is_one && !carries {
        return steer::steer(state, Lead::Step((right, down)));
    }
    if !is_led && state.view.tool == Tool::Select && area::step(state, (right, down), carries) {
        return;
    }
    let Cell { x, y } = state.view.cursor;
    let to = Cell::new(
        x.saturating_add_signed(right),
        y.saturating_add_signed(down),
    );
    let draws = carries && (state.view.tool == Tool::Zone || state.view.tool.can_paint());
    if state.is_drawing() || draws {
        // A lane goes on, or a rectangle is drawn.
        if !state.is_drawing() {
            press::press_with(state, state.view.cursor, false, true);
        }
        stroke::drag(state, to);
    }
    if carries && !is_led && state.view.tool == Tool::Select {
        let from = state.view.cursor;
        if !state.can_move(from) {
            move_cursor(state, to);
            let at = crate::words::at(from);
            return ask::refuse(state, tr_data!("There is nothing to move at {at}.", at));
        }
        press::press(state, from);
        stroke::drag(state, to);
        stroke::release(state);
    }
    move_cursor(state, to);
}

/// An agent that waits for its goal looks where the keyboard is.
fn move_cursor(state: &mut State, cell: Cell) {
    state.view.cursor = state.document.draft.clamp(cell);
    if let Gesture::Placing(placing) = &mut state.view.gesture {
        placing.goal = state.view.cursor;
    }
}
