//! What a person set, as the browser keeps it: numbers joined by points.

use super::text::numbers;
use crate::{Colours, Fill, State, Theme};

const THEMES: [Theme; 3] = [Theme::System, Theme::Light, Theme::Dark];

/// What a person set beside the scene.
///
/// ```
/// use giveway_page::{Draft, State, link};
/// assert_eq!(
///     link::preferences(&State::new(Draft::default())),
///     "3.30.0.0.1.1.0.20.4.1.0.0.0.1.2.3.4.5.6.7.8.9.10.11"
/// );
/// ```
pub fn preferences(state: &State) -> String {
    let (settings, view, fill) = (&state.settings, &state.view, &state.fill);
    let theme = THEMES.iter().position(|theme| *theme == view.theme);
    let numbers = [
        3,
        settings.seconds,
        settings.within.map_or(0, |within| within.saturating_add(1)),
        u32::from(settings.solve_on_change),
        u32::from(view.layers.trails),
        u32::from(view.table),
        theme.unwrap_or(0) as u32,
        fill.obstacles,
        fill.agents,
        fill.seed,
        u32::from(view.layers.heat),
        u32::from(settings.front),
    ];
    let all = numbers.into_iter().chain(view.colours.numbers());
    let all: Vec<String> = all.map(|n| n.to_string()).collect();
    all.join(".")
}

/// Takes in what [`preferences`] wrote; what cannot be read changes nothing.
pub fn prefer(state: &mut State, text: &str) {
    let numbers = numbers(text).unwrap_or_default();
    // The first version knew no heat and kept no front, the second no colours.
    let (set, later) = numbers.split_at(numbers.len().min(10));
    let (version, set) = match set {
        [version, set @ ..] => (*version, set),
        [] => return,
    };
    let own = Colours::default();
    let (heat, front, colours) = match (version, later) {
        (1, []) => (0, 0, own),
        (2, &[heat, front]) => (heat, front, own),
        (3, &[heat, front, ref colours @ ..]) => match colours.try_into() {
            Ok(numbers) => (heat, front, Colours::from_numbers(numbers)),
            Err(_) => return,
        },
        _ => return,
    };
    let &[
        seconds,
        within,
        on_change,
        trails,
        table,
        theme,
        obstacles,
        agents,
        seed,
    ] = set
    else {
        return;
    };
    state.settings.seconds = seconds.max(1);
    state.settings.within = within.checked_sub(1);
    state.settings.solve_on_change = on_change == 1;
    state.view.layers.trails = trails == 1;
    state.view.table = table == 1;
    state.view.theme = THEMES.get(theme as usize).copied().unwrap_or_default();
    state.view.layers.heat = heat == 1;
    state.settings.front = front == 1;
    state.view.colours = colours;
    state.fill = Fill {
        obstacles,
        agents,
        seed,
    };
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Action, Draft, reduce};

    #[test]
    fn what_was_set_comes_back() {
        let fresh = State::new(Draft::default());
        let actions = [
            Action::SetSeconds(7),
            Action::SetWithin(Some(0)),
            Action::SetSolveOnChange(true),
            Action::ShowTrails(false),
            Action::ShowHeat(true),
            Action::SetFront(true),
            Action::ShowTable(false),
            Action::SetTheme(Theme::Dark),
            Action::Recolour(0, 11),
            Action::Recolour(13, 0),
            Action::SetFill(Fill {
                obstacles: 5,
                agents: 6,
                seed: u32::MAX,
            }),
        ];
        let mut set = actions
            .into_iter()
            .fold(fresh.clone(), |state, action| reduce(&state, action));
        let mut again = fresh.clone();
        prefer(&mut again, &preferences(&set));
        assert_eq!(again, set);
        let mut old = fresh.clone();
        prefer(&mut old, "1.7.1.1.0.0.2.5.6.4294967295");
        set.view.colours = Colours::default();
        let mut second = fresh.clone();
        prefer(&mut second, "2.7.1.1.0.0.2.5.6.4294967295.1.1");
        assert_eq!(second, set, "what was kept by the second version");
        set.view.layers.heat = false;
        set.settings.front = false;
        assert_eq!(old, set, "what was kept by the first version");
        for text in [
            "",
            "2.1.1",
            "2.30.0.0.1.1.0.20.4.1",
            "4.30.0.0.1.1.0.20.4.1.0.0.0.1.2.3.4.5.6.7.8.9.10.11",
            "3.30.0.0.1.1.0.20.4.1.0.0.0.1.2.3.4.5.6.7.8.9.10",
            "1.x",
            "1.30.0.0.1.1.0.20.4",
            "1.-3.0.0.1.1.0.20.4.1",
        ] {
            let mut state = fresh.clone();
            prefer(&mut state, text);
            assert_eq!(state, fresh, "{text}");
        }
    }
}
