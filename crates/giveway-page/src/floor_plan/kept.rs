//! How a floor plan lies, as a line of text: the browser keeps it beside the picture, so that both
//! are there again when the page is loaded again.
//!
//! Words with blanks between: the size of the map; turns, corner, width and the two points; metres
//! between them and a pixel; the size of a cell; threshold, what cells become; what is open, drawn
//! and shown; then cells that were turned over.

use std::collections::BTreeMap;
use std::rc::Rc;
use std::str::FromStr;

use giveway_model::Cell;

use super::{FloorPlan, METRES, Picture, WIDE};
use crate::State;
use crate::edit::Paint;

/// How the floor plan lies; `None` where there is none that is kept.
pub fn kept(state: &State) -> Option<String> {
    let plan = state.view.floor_plan.as_deref()?;
    let grid = state.document.draft.grid();
    let [one, two] = plan.points;
    let length = |length: Option<f64>| length.map_or_else(|| "-".to_owned(), |it| it.to_string());
    let flag = |is: bool| u8::from(is).to_string();
    let mut words = vec![
        grid.width().to_string(),
        grid.height().to_string(),
        plan.turns.to_string(),
    ];
    let lengths = [
        plan.corner.0,
        plan.corner.1,
        plan.wide,
        one.0,
        one.1,
        two.0,
        two.1,
    ];
    words.extend(lengths.map(|length| length.to_string()));
    words.extend([
        length(plan.apart),
        length(plan.metres),
        plan.cell.to_string(),
        plan.threshold.to_string(),
        flag(plan.becomes == Paint::Slow),
        flag(plan.is_open),
        flag(plan.is_drawn),
        flag(plan.is_shown),
    ]);
    let turned = plan.turned.iter();
    words.extend(turned.map(|(Cell { x, y }, is)| format!("{x}:{y}:{}", u8::from(*is))));
    Some(words.join(" "))
}

/// A floor plan that was kept; `None` where the text is none, or of a map of another size.
pub(crate) fn read(text: &str, picture: Rc<Picture>, state: &State) -> Option<FloorPlan> {
    let grid = state.document.draft.grid();
    let mut words = text.split_ascii_whitespace();
    let size = (word(&mut words)?, word(&mut words)?);
    if size != (grid.width(), grid.height()) {
        return None;
    }
    let turns: u8 = word(&mut words)?;
    let mut lengths = [0.0; 7];
    for length in &mut lengths {
        *length = finite(words.next()?)?;
    }
    let [left, top, wide, x1, y1, x2, y2] = lengths;
    let far = |at: f64| at.clamp(-WIDE.1, WIDE.1);
    let mut known = || match words.next()? {
        "-" => Some(None),
        word => finite(word).filter(|it| *it > 0.0).map(Some),
    };
    let (apart, metres) = (known()?, known()?);
    let cell = finite(words.next()?)?.clamp(METRES.0, METRES.1);
    let threshold: u32 = word(&mut words)?;
    let mut flag = || word::<u8>(&mut words).map(|it| it == 1);
    let (is_slow, is_open, is_drawn, is_shown) = (flag()?, flag()?, flag()?, flag()?);
    let turned = words
        .map(turned)
        .collect::<Option<BTreeMap<Cell, bool>>>()?;
    Some(FloorPlan {
        picture,
        turns: turns % 4,
        corner: (far(left), far(top)),
        wide: wide.clamp(WIDE.0, WIDE.1),
        points: [(far(x1), far(y1)), (far(x2), far(y2))],
        apart,
        metres,
        cell,
        threshold: threshold.clamp(1, 100),
        becomes: if is_slow {
            Paint::Slow
        } else {
            Paint::Obstacle
        },
        turned,
        is_open,
        is_drawn,
        is_shown,
    })
}

fn word<'a, T: FromStr>(words: &mut impl Iterator<Item = &'a str>) -> Option<T> {
    words.next()?.parse().ok()
}

fn finite(word: &str) -> Option<f64> {
    word.parse().ok().filter(|it: &f64| it.is_finite())
}

fn turned(word: &str) -> Option<(Cell, bool)> {
    let mut parts = word.split(':');
    let cell = Cell::new(word_of(parts.next())?, word_of(parts.next())?);
    let is: u32 = word_of(parts.next())?;
    parts.next().is_none().then_some((cell, is == 1))
}

fn word_of(word: Option<&str>) -> Option<u32> {
    word?.parse().ok()
}

#[cfg(test)]
mod tests {
    use super::super::tests::{board, say, under};
    use super::super::{FloorPlanAction, laid};
    use super::*;
    use crate::reduce::tests::after;
    use crate::{Action, BoardAction, Selection};

    #[test]
    fn how_it_lies_is_kept_and_read_back() {
        let state = say(
            &under(),
            &[
                FloorPlanAction::Turn,
                FloorPlanAction::Move(0.125, -1.5),
                FloorPlanAction::Apart(Some(12.8)),
                FloorPlanAction::Threshold(37),
                FloorPlanAction::Becomes(Paint::Slow),
            ],
        );
        let press = Action::Board(BoardAction::Select(Selection::Cell(Cell::new(5, 0))));
        let state = after(&state, [press]);
        let text = kept(&state).unwrap();
        let restore = |text: &str| FloorPlanAction::Restore(picture_of(&state), text.to_owned());
        let again = say(&board(), &[restore(&text)]);
        assert_eq!(again.view.floor_plan, state.view.floor_plan);
        // One that lies there already stays.
        let lies = under();
        let own = say(&lies, &[restore(&text)]);
        assert_eq!(own.view.floor_plan, lies.view.floor_plan);
        assert_eq!(kept(&board()), None);
        // A map of another size, and texts that are none.
        for (old, new) in [
            ("8 6 ", "8 7 "),
            (" 37 ", " much "),
            (" 5:0:", " 5:"),
            ("-1.5", "NaN"),
        ] {
            let other = text.replacen(old, new, 1);
            assert_ne!(other, text, "{old} is in {text}");
            let state = say(&board(), &[restore(&other)]);
            assert!(state.view.floor_plan.is_none(), "{other}");
        }
        for cut in 0..text.len() {
            let _ = say(&board(), &[restore(&text[..cut])]);
        }
        let huge = text.replacen("-1.5", "1e300", 1);
        assert!(laid(&say(&board(), &[restore(&huge)])).is_some());
    }

    fn picture_of(state: &State) -> Rc<Picture> {
        Rc::clone(&state.view.floor_plan.as_ref().unwrap().picture)
    }
}
