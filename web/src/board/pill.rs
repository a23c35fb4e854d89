//! A few words on the board, in a pill.

use yew::prelude::*;

/// How wide a letter is on average, and how much room the words have around them, in sizes of the text.
const LETTER: f64 = 0.58;
const ROOM: (f64, f64) = (1.2, 1.8);

/// Words in a pill around a point, in units of the board.
pub(super) fn pill(x: f64, y: f64, size: f64, words: &str) -> Html {
    let letters = u32::try_from(words.chars().count()).unwrap_or_default();
    let width = (LETTER * f64::from(letters) + ROOM.0) * size;
    let height = ROOM.1 * size;
    html! {
        <g class="area-pill">
            <rect x={(x - width / 2.0).to_string()} y={(y - height / 2.0).to_string()} width={width.to_string()} height={height.to_string()} rx={(height / 2.0).to_string()} />
            <text x={x.to_string()} y={(y + size / 3.0).to_string()} font-size={size.to_string()}>{ words.to_owned() }</text>
        </g>
    }
}
