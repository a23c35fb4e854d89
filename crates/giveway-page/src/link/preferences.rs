//! What a person set, as the browser keeps it: numbers joined by points.

use super::text::numbers;
use crate::{Fill, State, Theme};

/// The version of what is written here.
const VERSION: u32 = 4;

const THEMES: [Theme; 3] = [Theme::System, Theme::Light, Theme::Dark];

/// What a person set beside the scene.
///
/// ```
/// use giveway_page::{Draft, State, link};
/// assert_eq!(
///     link::preferences(&State::new(Draft::default())),
///     "4.30.0.1.1.0.20.4.1.0.0.1"
/// );
/// ```
pub fn preferences(state: &State) -> String {
    let (settings, view) = (&state.settings, &state.view);
    let fill = &settings.fill;
    let theme = THEMES.iter().position(|theme| *theme == view.theme);
    let numbers = [
        VERSION,
        settings.seconds,
        u32::from(settings.solve_on_change),
        u32::from(view.layers.trails),
        u32::from(view.table),
        theme.unwrap_or(0) as u32,
        fill.obstacles,
        fill.agents,
        fill.seed,
        u32::from(view.layers.heat),
        u32::from(settings.front),
        u32::from(settings.letter_keys),
    ];
    numbers.map(|n| n.to_string()).join(".")
}

/// Whether a text holds preferences of a newer version than this page: it must not
/// be overwritten.
pub fn are_newer(text: &str) -> bool {
    let version = text.split('.').next().and_then(|n| n.parse::<u32>().ok());
    version.is_some_and(|version| version > VERSION)
}

/// Takes in what [`preferences`] wrote, in this version or an earlier one; what
/// cannot be read changes nothing.
pub fn prefer(state: &mut State, text: &str) {
    let numbers = numbers(text).unwrap_or_default();
    // Up to the third version the horizon stood among them, at the third place; the
    // first knew no heat and no front, and none knew whether letters are keys.
    let (set, later): (Vec<u32>, Vec<u32>) = match numbers[..] {
        [VERSION, ref set @ ..] if set.len() == 11 => (set[..8].to_vec(), set[8..].to_vec()),
        [1..=3, seconds, _, ref rest @ ..] if rest.len() >= 7 => {
            let set = [&[seconds], &rest[..7]].concat();
            let later = rest[7..].iter().copied().take(2);
            (set, later.chain([1]).collect())
        }
        _ => return,
    };
    let &[
        seconds,
        on_change,
        trails,
        table,
        theme,
        obstacles,
        agents,
        seed,
    ] = &set[..]
    else {
        return;
    };
    let (heat, front, letters) = match later[..] {
        [heat, front, letters] => (heat, front, letters),
        [letters] if numbers.first() == Some(&1) => (0, 0, letters),
        _ => return,
    };
    let (settings, view) = (&mut state.settings, &mut state.view);
    settings.seconds = seconds.max(1);
    settings.solve_on_change = on_change == 1;
    view.layers.trails = trails == 1;
    view.table = table == 1;
    view.theme = THEMES.get(theme as usize).copied().unwrap_or_default();
    view.layers.heat = heat == 1;
    settings.front = front == 1;
    settings.letter_keys = letters == 1;
    settings.fill = Fill {
        obstacles,
        agents,
        seed,
    };
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Action, Draft, ViewAction, reduce};

    #[test]
    fn what_was_set_comes_back() {
        let fresh = State::new(Draft::default());
        let actions = [
            ViewAction::SetSeconds(7),
            ViewAction::SetSolveOnChange(true),
            ViewAction::ShowTrails(false),
            ViewAction::ShowHeat(true),
            ViewAction::SetFront(true),
            ViewAction::ShowTable(false),
            ViewAction::SetTheme(Theme::Dark),
            ViewAction::SetFill(Fill {
                obstacles: 5,
                agents: 6,
                seed: u32::MAX,
            }),
        ];
        let mut set = actions.into_iter().fold(fresh.clone(), |state, action| {
            reduce(&state, Action::View(action))
        });
        let preferred = |text: &str| {
            let mut state = fresh.clone();
            prefer(&mut state, text);
            state
        };
        let third = "3.7.1.1.0.0.2.5.6.4294967295.1.1.0.1.2.3.4.5.6.7.8.9.10.11";
        assert_eq!(preferred(third), set, "as the third version kept it");
        assert_eq!(preferred("2.7.1.1.0.0.2.5.6.4294967295.1.1"), set);
        set.settings.letter_keys = false;
        assert_eq!(preferred(&preferences(&set)), set);
        set.settings.letter_keys = true;
        set.view.layers.heat = false;
        set.settings.front = false;
        assert_eq!(preferred("1.7.1.1.0.0.2.5.6.4294967295"), set);
        for text in [
            "",
            "2.1.1",
            "2.30.0.0.1.1.0.20.4.1",
            "5.30.0.1.1.0.20.4.1.0.0.1",
            "4.30.0.1.1.0.20.4.1.0.0",
            "1.x",
            "1.30.0.0.1.1.0.20.4",
            "1.-3.0.0.1.1.0.20.4.1",
        ] {
            assert_eq!(preferred(text), fresh, "{text}");
        }
    }
}
