//! From a state and an action to the next state.

mod ask;
mod change;
mod edit;
mod play;
mod proof;
mod solve;
mod steer;
mod stroke;
#[cfg(test)]
pub(crate) mod tests;
mod touch;

use giveway_model::Cell;

use crate::changing::Changing;
use crate::steering::Lead;
use crate::{Action, Selection, State, Tool};

/// The next state. Pure: the same state and action always give the same.
///
/// ```
/// use giveway_model::Scene;
/// use giveway_page::{Action, Draft, State, Work, reduce};
/// let scene = Scene { map: vec!["..".into()], ..Scene::default() };
/// let state = State::new(Draft::new(scene).unwrap());
/// let state = reduce(&state, Action::Solve);
/// assert!(matches!(state.work, Work::Solving(_)));
/// ```
#[must_use]
pub fn reduce(state: &State, action: Action) -> State {
    let mut next = state.clone();
    step(&mut next, action);
    next
}

fn step(state: &mut State, action: Action) {
    match action {
        Action::Open(scene) => edit::open(state, *scene),
        Action::OpenLink(linked) => edit::open_link(state, *linked),
        Action::Refuse(notice) => state.notice = Some(notice),
        Action::DismissNotice => state.notice = None,

        Action::PickTool(tool) => stroke::pick(state, tool),
        Action::MoveCursor(cell) => move_cursor(state, cell),
        Action::StepCursor { by, carries } => step_cursor(state, by, carries),
        Action::UseTool => {
            stroke::press(state, state.cursor);
            stroke::release(state);
        }
        Action::Press(cell) => stroke::press(state, cell),
        Action::Drag(cell) => stroke::drag(state, cell),
        Action::Release => stroke::release(state),
        Action::Abandon => stroke::abandon(state),
        Action::Select(selection) => select(state, selection),
        Action::Edit(edit) => edit::change(state, |scene| edit.make(scene)),
        Action::SetFill(fill) => state.fill = fill,
        Action::Undo => edit::undo(state),
        Action::Redo => edit::redo(state),

        Action::SetObjective(objective) => edit::change(state, |scene| scene.objective = objective),
        Action::SetAtGoal(at_goal) => edit::change(state, |scene| scene.rules.at_goal = at_goal),
        Action::SetBatteryFloor(floor) => {
            edit::change(state, |scene| scene.rules.battery_floor = floor);
        }
        Action::SetWithin(within) => state.settings.within = within,
        Action::SetSeconds(seconds) => state.settings.seconds = seconds.max(1),
        Action::SetSolveOnChange(on) => state.settings.solve_on_change = on,
        Action::SetFront(on) => state.settings.front = on,
        Action::ShowPoint(point) => solve::show_point(state, point),

        Action::Solve => solve::start(state),
        Action::Cancel => solve::cancel(state),
        Action::Progress { run, event } => solve::progress(state, run, event),
        Action::Respond { run, response } => solve::respond(state, run, *response),
        Action::Crash {
            run,
            sentence,
            had_started,
        } => solve::crash(state, run, sentence, had_started),

        Action::Ask(question) => ask::ask(state, question),
        Action::CloseQuestion => ask::close(state),
        Action::ShowOther(on) => ask::show_other(state, on),
        Action::Light(lit) => ask::light(state, lit),
        Action::TakeOther => ask::take_other(state),
        Action::TakeRepair(index) => ask::take_repair(state, index),

        Action::CheckProof => proof::start(state),

        Action::BeginChange => change::begin(state),
        Action::DiscardChange => change::discard(state),
        Action::ListChange(what) => change::list(state, what),
        Action::TakeBack(index) => change::take_back(state, index),
        Action::ChooseMethods(choice) => change::choose_methods(state, choice),
        Action::Adapt => change::adapt(state),
        Action::Preview(index) => change::preview(state, index),
        Action::Adopt(index) => change::adopt(state, index),

        Action::Steer(lead) => steer::steer(state, lead),

        Action::Play => play::play(state),
        Action::Pause => state.playback.playing = false,
        Action::Seek(time) => play::seek(state, time),
        Action::StepForward => play::seek(state, state.playback.time.saturating_add(1)),
        Action::StepBack => play::seek(state, state.playback.time.saturating_sub(1)),
        Action::Reach(time) => play::reach(state, time),
        Action::SetSpeed(speed) => state.playback.speed = speed,

        Action::ShowTrails(on) => state.view.layers.trails = on,
        Action::ShowHeat(on) => state.view.layers.heat = on,
        Action::Follow(on) => state.view.follow = on,
        Action::Recolour(agent, colour) => state.view.colours.set(agent, colour),
        Action::ShowTable(on) => state.view.table = on,
        Action::ShowTab(tab) => state.view.tab = tab,
        Action::SetWide(on) => play::widen(state, on),
        Action::SetTheme(theme) => state.view.theme = theme,
    }
}

/// Whether the tool that selects can move what is on a cell of the changing
/// world.
pub(crate) fn can_hold(state: &State, changing: &Changing, cell: Cell) -> bool {
    touch::held(state, changing, cell).is_some()
}

/// What is selected has the inspector: a question makes way for it.
fn select(state: &mut State, selection: Selection) {
    ask::close(state);
    state.selection = selection;
}

/// A step of the keyboard; with the tool that selects, a thing can go along. The
/// agent that is led takes the step itself.
fn step_cursor(state: &mut State, (right, down): (i32, i32), carries: bool) {
    let is_one = right.unsigned_abs().saturating_add(down.unsigned_abs()) == 1;
    if state.steering.is_some() && is_one && !carries {
        return steer::steer(state, Lead::Step((right, down)));
    }
    let carries = carries && state.steering.is_none();
    let Cell { x, y } = state.cursor;
    let to = Cell::new(
        x.saturating_add_signed(right),
        y.saturating_add_signed(down),
    );
    if carries && state.tool == Tool::Select {
        stroke::press(state, state.cursor);
        stroke::drag(state, to);
        stroke::release(state);
    }
    move_cursor(state, to);
}

/// An agent that waits for its goal looks where the keyboard is.
fn move_cursor(state: &mut State, cell: Cell) {
    state.cursor = state.draft.clamp(cell);
    if let Some(placing) = &mut state.placing {
        placing.goal = state.cursor;
    }
}
