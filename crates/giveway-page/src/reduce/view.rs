//! What is shown and how; and what a person set for all scenes.

use super::{play, stroke};
use crate::present::present;
use crate::{State, ViewAction};

pub(super) fn view(state: &mut State, action: &ViewAction) {
    if let ViewAction::Present(to) = *action {
        stroke::abandon(state);
        return present(state, to);
    }
    let (view, settings) = (&mut state.view, &mut state.settings);
    match *action {
        ViewAction::DismissNotice => view.notice = None,
        ViewAction::ShowTrails(on) => view.layers.trails = on,
        ViewAction::ShowHeat(on) => view.layers.heat = on,
        ViewAction::ShowLanes(lanes) => view.lanes = lanes,
        ViewAction::Follow(on) => view.follow = on,
        ViewAction::ShowTable(on) => view.table = on,
        ViewAction::Unfold(fold, on) => view.folds.set(fold, on),
        ViewAction::ShowTab(tab) => view.tab = tab,
        ViewAction::SetWide(on) => play::widen(state, on),
        ViewAction::Present(_) => {}
        ViewAction::SetTheme(theme) => view.theme = theme,
        ViewAction::SetSeconds(seconds) => settings.seconds = seconds.max(1),
        ViewAction::SetSolveOnChange(on) => settings.solve_on_change = on,
        ViewAction::SetFront(on) => settings.front = on,
        ViewAction::SetFill(fill) => settings.fill = fill,
        ViewAction::SetLetterKeys(on) => settings.letter_keys = on,
    }
}
