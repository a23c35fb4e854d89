//! The row of rules below the ruler: when each rule with times is in force.

use giveway_model::tr;
use giveway_page::rules::{Lit, RuleAction, Stretch, TimesRow, times_row};
use giveway_page::timeline::Axis;
use giveway_page::{Action, State};
use yew::prelude::*;

use crate::board::STAR;
use crate::inspector::show_rules;

/// The height of a line and of a stretch in it, and the width of a letter, in pixels.
const LINE: f64 = 22.0;
const BAR: f64 = 18.0;
const LETTER: f64 = 6.6;
/// Half the width of a burst, in pixels.
const BURST: f64 = 9.0;
/// The fewest letters that tell something of a name.
const LEAST: usize = 5;

/// The row; nothing where no rule has times.
pub(super) fn show(state: &State, axis: Axis, send: &Callback<Action>) -> Html {
    let Some(row) = times_row(state, axis.times - 1) else {
        return Html::default();
    };
    let line = |(at, line): (usize, &Vec<Stretch>)| {
        html! { { for line.iter().map(|of| stretch(of, at as f64 * LINE, axis, send)) } }
    };
    let height = (row.lines.len() as f64 * LINE).to_string();
    html! {
        <div class="row rule-times">
            <span class="lab">{ tr!("Rules") }{ more(&row, send) }</span>
            <svg width={axis.width().to_string()} {height} role="group" aria-label={tr!("Times of rules")}>
                <defs><pattern id="in-force" width="8" height="8" patternUnits="userSpaceOnUse" patternTransform="rotate(-45)"><path d="M4 0V8" /></pattern></defs>
                { for row.lines.iter().enumerate().map(line) }
            </svg>
        </div>
    }
}

/// The button that opens the row and folds it again.
fn more(row: &TimesRow, send: &Callback<Action>) -> Html {
    let (all, words, label) = if row.is_open {
        (false, tr!("Fewer").to_owned(), None)
    } else if row.hidden > 0 {
        let n = row.hidden;
        let label = tr!("Show {n} more line of rules" | "Show {n} more lines of rules" % n);
        (true, format!("+{n}"), Some(label))
    } else {
        return Html::default();
    };
    let onclick = send.reform(move |_| Action::Rules(RuleAction::AllTimes(all)));
    html! { <button type="button" class="link" aria-expanded={row.is_open.to_string()} aria-label={label} {onclick}>{ words }</button> }
}

fn stretch(of: &Stretch, top: f64, axis: Axis, send: &Callback<Action>) -> Html {
    let rule = of.rule;
    let light =
        move |is_lit: bool| Action::Rules(RuleAction::Light(is_lit.then_some(Lit::Rule(rule))));
    let open = {
        let send = send.clone();
        move || {
            send.emit(Action::Rules(RuleAction::Show(rule)));
            show_rules();
        }
    };
    let press = {
        let open = open.clone();
        move |_: MouseEvent| open()
    };
    let onkeydown = move |event: KeyboardEvent| {
        if matches!(event.key().as_str(), "Enter" | " ") {
            event.prevent_default();
            event.stop_propagation();
            open();
        }
    };
    // It covers the columns of both its ends.
    let left = f64::from(of.from) * axis.column;
    let width = f64::from(of.to + 1 - of.from) * axis.column;
    let (begin, end) = gap(of, left, width, axis);
    let middle = f64::midpoint(begin, end);
    let fits = ((end - begin - 12.0) / LETTER).max(0.0);
    let room = giveway_picture::whole(fits) as usize;
    // What has no room is cut off: what is seen is a part of the name, or nothing.
    let text: String = if of.text.chars().count() > room && room < LEAST {
        String::new()
    } else {
        of.text.chars().take(room).collect()
    };
    let class = classes!(
        "stretch",
        of.is_now.then_some("now"),
        of.is_lit.then_some("lit"),
        (!of.broken.is_empty()).then_some("broken")
    );
    let bar = |class: &'static str| {
        html! { <rect {class} x="1" y="2" width={(width - 2.0).max(1.0).to_string()} height={BAR.to_string()} rx="4" /> }
    };
    let burst = |time: &u32| {
        let x = axis.x(f64::from(*time)) - left;
        html! { <g key={*time} class="bad" transform={format!("translate({x} 11)")}><circle r="8" /><path transform="scale(0.17)" d={STAR} /></g> }
    };
    let plate = text.chars().count() as f64 * LETTER + 8.0;
    html! {
        <g key={rule} {class} role="button" tabindex="0" aria-label={of.label.clone()} transform={format!("translate({left} {top})")}
            onclick={press} {onkeydown} onfocus={send.reform(move |_| light(true))} onblur={send.reform(move |_| light(false))}
            onmouseenter={send.reform(move |_| light(true))} onmouseleave={send.reform(move |_| light(false))}>
            { bar("base") }{ bar("hatch") }
            if !text.is_empty() {
                <rect class="plate" x={(middle - plate / 2.0).to_string()} y="4" width={plate.to_string()} height="14" rx="3" />
                <text x={middle.to_string()} y="15" text-anchor="middle">{ text }</text>
            }
            { for of.broken.iter().map(burst) }
        </g>
    }
}

/// Where the name of a stretch has most room: between two bursts, or between one and an end, in
/// pixels from the left.
fn gap(of: &Stretch, left: f64, width: f64, axis: Axis) -> (f64, f64) {
    let mut widest = (0.0, 0.0);
    let mut begin = 0.0;
    let bursts = of.broken.iter().map(|&time| {
        let x = axis.x(f64::from(time)) - left;
        (x - BURST, x + BURST)
    });
    for (end, next) in bursts.chain([(width, width)]) {
        if end - begin > widest.1 - widest.0 {
            widest = (begin, end);
        }
        begin = next;
    }
    widest
}
