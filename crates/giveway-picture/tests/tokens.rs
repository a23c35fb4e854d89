//! The colours of pictures are those of the page.
#![allow(clippy::unwrap_used, reason = "a test may panic")]

use giveway_picture::{Colours, Ink, Inks, Theme, robot};

const TOKENS: &str = include_str!("../../../static/tokens.css");

/// What a token is in a theme: `--name: light-dark(#a, #b);`.
fn token(name: &str, theme: Theme) -> String {
    let line = TOKENS.split(&format!("--{name}:")).nth(1).unwrap();
    let value = line.split(';').next().unwrap().trim();
    if let Some(of) = value.strip_prefix("var(--") {
        return token(of.strip_suffix(')').unwrap(), theme);
    }
    let pair = value.strip_prefix("light-dark(").unwrap();
    let (light, dark) = pair.strip_suffix(')').unwrap().split_once(", ").unwrap();
    match theme {
        Theme::Light => light.to_owned(),
        Theme::Dark => dark.to_owned(),
    }
}

#[test]
fn pictures_have_the_colours_of_the_page() {
    for theme in [Theme::Light, Theme::Dark] {
        let check = |name: &str, ink: Ink| {
            assert_eq!(ink.to_string(), token(name, theme), "{name}, {theme:?}");
        };
        let named = Inks::of(theme).named();
        assert!(named.len() > 15);
        for (name, ink) in named {
            check(name, ink);
        }
        for agent in 0..12 {
            let (fill, on) = robot(theme, Colours::default(), agent);
            check(&format!("agent-{}", agent + 1), fill);
            check(&format!("agent-{}-on", agent + 1), on);
        }
    }
}
