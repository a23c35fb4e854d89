//! A rule that is being written: its sentence with slots, what the plan on the board is under
//! it, and what can be written instead.

use giveway_model::tr;
use giveway_page::rules::{
    Card, Count, Judged, Offer, Piece, RuleAction, Ruling, Slot, Stay, Value,
};
use giveway_page::timeline::Axis;
use giveway_page::{Action, BoardAction, Tool};
use gloo::timers::callback::Timeout;
use wasm_bindgen::JsCast as _;
use web_sys::HtmlElement;
use yew::prelude::*;

use super::back;
use super::rules::act;
use super::slot_editor;
use crate::field::{Field, FieldProps};
use crate::part::part;
use crate::{glyph, icon};

#[inline(never)]
pub(super) fn show(card: &Card, send: &Callback<Action>) -> Html {
    let chooses = matches!(&card.open, Some((Slot::Who, _)));
    html! {
        <>
            { head(card, send) }
            if card.marks {
                <section>
                    <h3>{ tr!("Mark a place on the board") }</h3>
                    <ul class="asks">{ marking(Tool::Zone, tr!("A limit, a closure: mark a zone"), send) }{ marking(Tool::OneWay, tr!("One direction: lead a lane"), send) }</ul>
                </section>
            }
            <section class="writing" id="writing" role="group" aria-labelledby="rule-title">
                <p class="writing-title" id="rule-title">{ icon::show(card.icon) }{ match &card.zone {
                    _ if card.asks => tr!("Why not a plan in which …?").to_owned(),
                    Some(zone) => tr!("A rule for {zone}", zone),
                    None if card.marks => tr!("Or a rule for the whole floor").to_owned(),
                    None => tr!("A rule").to_owned(),
                } }</p>
                <p class={classes!("sentence", chooses.then_some("chooses"))}>{ for card.pieces.iter().map(|of| piece(card, of, send)) }</p>
                if let Some((slot, editor)) = &card.open { { slot_editor::show(*slot, editor, send) } }
                { counts(card) }
                { judged(&card.judged) }
            </section>
            if !card.offers.is_empty() {
                <section>
                    <h3>{ tr!("Or one of these") }</h3>
                    <ul class="asks">{ for card.offers.iter().map(|of| offer(of, send)) }</ul>
                </section>
            }
            if let (Some(zone), false) = (&card.zone, card.stays.is_empty()) {
                <section>
                    <h3>{ tr!("Who is in {zone} when", zone) }</h3>
                    <dl class="facts">{ for card.stays.iter().map(stay) }</dl>
                </section>
            }
            { in_words(card, send) }
        </>
    }
}

fn head(card: &Card, send: &Callback<Action>) -> Html {
    let title = if card.asks {
        tr!("Why not a plan in which …?")
    } else if card.is_edited {
        tr!("Edit the rule")
    } else {
        tr!("A new rule")
    };
    let Some(zone) = &card.zone else {
        return html! { <header class="ih">{ back(send) }<div><h2>{ title }</h2></div></header> };
    };
    let rename = send.reform(|name| Action::Rules(RuleAction::RenameZone(name)));
    let remove = act(send, || RuleAction::RemoveZone);
    html! {
        <header class="ih">
            { back(send) }<h2 class="vh">{ title }</h2>
            <span class="cellsw zone-sign">{ icon::show("zone") }</span>
            <div class="zone-field">
                { part::<Field>(FieldProps { label: tr!("Name of the zone").into(), value: zone.clone().into(), on_change: rename, empty: None, range: None, is_measure: false }) }
                <p>{ card.place.clone() }</p>
            </div>
            <button type="button" class="btn ghost round" title={tr!("Delete the zone")} aria-label={tr!("Delete the zone")} onclick={remove}>{ icon::show("erase") }</button>
        </header>
    }
}

/// A piece of the sentence: words, or a slot that opens its editor.
fn piece(card: &Card, piece: &Piece, send: &Callback<Action>) -> Html {
    let (slot, text) = match piece {
        Piece::Text(text) => return html! { { text.clone() } },
        Piece::Slot(slot, text) => (*slot, text),
    };
    let what = match slot {
        Slot::Number(_) => tr!("a slot of a rule" => "number"),
        Slot::Who => tr!("a slot of a rule" => "who"),
        Slot::Zone => tr!("a slot of a rule" => "zone"),
        Slot::When => tr!("a slot of a rule" => "when"),
        Slot::Cell(_) => tr!("a slot of a rule" => "where"),
        Slot::Agent(_) => tr!("a slot of a rule" => "robot"),
    };
    let is_open = card.open.as_ref().is_some_and(|(open, _)| *open == slot);
    let class = classes!(
        "slot-of-rule",
        (slot == Slot::Zone).then_some("zone-name"),
        is_open.then_some("on")
    );
    html! {
        <button type="button" {class} aria-label={format!("{what}: {text}")} aria-expanded={is_open.to_string()}
            onclick={act(send, move || RuleAction::OpenSlot(Some(slot)))} onkeydown={step(card, slot, send)}>{ text.clone() }</button>
    }
}

/// Up and Down change a number.
fn step(card: &Card, slot: Slot, send: &Callback<Action>) -> Option<Callback<KeyboardEvent>> {
    let Slot::Number(index) = slot else {
        return None;
    };
    let text = card.pieces.iter().find_map(|piece| match piece {
        Piece::Slot(of, text) if *of == slot => Some(text),
        Piece::Slot(..) | Piece::Text(_) => None,
    });
    let value: u32 = text.and_then(|text| text.parse().ok()).unwrap_or(0);
    let send = send.clone();
    Some(Callback::from(move |event: KeyboardEvent| {
        let next = match event.key().as_str() {
            "ArrowUp" => value.saturating_add(1),
            "ArrowDown" => value.saturating_sub(1),
            _ => return,
        };
        event.prevent_default();
        event.stop_propagation();
        fill(&send, Value::Number(index, next));
    }))
}

fn fill(send: &Callback<Action>, value: Value) {
    send.emit(Action::Rules(RuleAction::Fill(value)));
}

/// How wide the row of counts is, and a digit in it, in pixels.
const COUNTS: f64 = 290.0;
const DIGIT: f64 = 7.0;
/// What is free beside a number, in pixels: two side by side are two numbers.
const BESIDE: f64 = 5.0;

/// How many robots are in the zone at each time: a stretch for times of one number, which
/// stands there where it has room; darker where there are more.
fn counts(card: &Card) -> Html {
    let last = card.counts.iter().map(|count| count.times).sum::<u32>();
    let Some(zone) = card.zone.as_ref().filter(|_| last > 1) else {
        return Html::default();
    };
    let axis = Axis::fit(last - 1, COUNTS, 0.0);
    let most = card.counts.iter().map(|count| count.robots).max();
    let mut begun = 0;
    let stretch = |count: &Count| {
        let class = classes!(count.is_in.then_some("in"), count.is_over.then_some("over"));
        let left = f64::from(begun) * axis.column;
        begun += count.times;
        let room = f64::from(count.times) * axis.column;
        let number = count.robots.to_string();
        let shade = f64::from(count.robots) / f64::from(most.unwrap_or(1).max(1));
        html! {
            <g {class}>
                <rect x={left.to_string()} y="16" width={room.to_string()} height="20" fill-opacity={(0.06 + 0.26 * shade).to_string()} />
                if room >= number.len() as f64 * DIGIT + BESIDE {
                    <text x={(left + room / 2.0).to_string()} y="30" text-anchor="middle">{ number }</text>
                }
            </g>
        }
    };
    let label = |time: u32| {
        html! { <text x={axis.x(f64::from(time)).to_string()} y="11" text-anchor="middle">{ time }</text> }
    };
    html! {
        <figure class="counts" aria-hidden="true">
            <svg viewBox={format!("0 0 {} 36", axis.width())}>{ for axis.labels().into_iter().map(label) }{ for card.counts.iter().map(stretch) }</svg>
            <figcaption>{ tr!("Robots in {zone} at each time", zone) }</figcaption>
        </figure>
    }
}

/// What the plan is under the rule.
fn judged(judged: &Judged) -> Html {
    let (class, icon) = match judged.ruling {
        Ruling::Keeps | Ruling::InForce => ("fine", "check"),
        Ruling::Breaks => ("would", "warning"),
        Ruling::Fault | Ruling::Never => ("fault", "warning"),
        Ruling::Open => ("open", "info"),
    };
    html! {
        <div class={classes!("judged", class)} role="status">
            { icon::show(icon) }
            <p><b>{ judged.title.clone() }</b>{ for judged.details.iter().map(|detail| html! { <small>{ detail.clone() }</small> }) }</p>
        </div>
    }
}

fn offer(offer: &Offer, send: &Callback<Action>) -> Html {
    let rule = offer.rule.clone();
    // Its sentence takes the place of the one above, which may be out of sight.
    let onclick = act(send, move || {
        super::show_part("writing");
        RuleAction::Write(rule.clone())
    });
    html! {
        <li key={offer.sentence.clone()}><button type="button" class="ask" {onclick}>
            { icon::show(offer.icon) }<span>{ offer.sentence.clone() }</span>{ icon::at_end("chevron") }
        </button></li>
    }
}

/// A tool that marks a place for a rule.
fn marking(tool: Tool, words: &'static str, send: &Callback<Action>) -> Html {
    let onclick = send.reform(move |_| Action::Board(BoardAction::PickTool(tool)));
    html! {
        <li><button type="button" class="ask" {onclick}>{ icon::show(tool.icon()) }<span>{ words }</span>{ icon::at_end("chevron") }</button></li>
    }
}

fn stay(stay: &Stay) -> Html {
    html! {
        <div key={stay.agent}><dt class="who">{ glyph::show(stay.agent, "pick-glyph") }{ stay.name.clone() }</dt><dd>{ stay.when.clone() }</dd></div>
    }
}

/// The rule as it can be typed.
fn in_words(card: &Card, send: &Callback<Action>) -> Html {
    let read = send.reform(|text| Action::Rules(RuleAction::Read(text)));
    html! {
        <details class="edit">
            <summary>{ tr!("Write it in words") }</summary>
            <div class="edit-body">
                { part::<Field>(FieldProps { label: tr!("The rule, in English").into(), value: card.words.clone().into(), on_change: read, empty: None, range: None, is_measure: false }) }
                if let Some(misread) = &card.misread { <small class="possible" role="status">{ misread.clone() }</small> }
            </div>
        </details>
    }
}

/// What stays at the foot of the inspector.
#[inline(never)]
pub(super) fn foot(card: &Card, send: &Callback<Action>) -> Html {
    let (icon, words) = if card.is_edited {
        ("check", tr!("Change the rule"))
    } else {
        ("plus", tr!("Add the rule"))
    };
    let send_it = act(send, || RuleAction::Add);
    let add = Callback::from(move |event: MouseEvent| {
        send_it.emit(event);
        super::show_rules();
        focus_rule();
    });
    let is_off = matches!(card.judged.ruling, Ruling::Fault | Ruling::InForce);
    if card.asks {
        return html! {
            <footer class="foot making">
                <button type="button" class="btn primary" disabled={is_off} onclick={act(send, || RuleAction::Ask)}>{ icon::show("question") }<span>{ tr!("Ask") }</span></button>
                <button type="button" class="btn outline" disabled={is_off} onclick={add}>{ tr!("Make it a rule") }</button>
                <button type="button" class="btn ghost" onclick={act(send, || RuleAction::Cancel)}>{ tr!("Cancel") }</button>
            </footer>
        };
    }
    // What no plan can keep is not the next step.
    let is_never = card.judged.ruling == Ruling::Never;
    let (class, words) = if is_never && !card.is_edited {
        ("outline", tr!("Add it anyway"))
    } else if is_never {
        ("outline", words)
    } else {
        ("primary", words)
    };
    html! {
        <footer class="foot making">
            if is_never { <p class="which">{ card.judged.title.clone() }</p> }
            <button type="button" class={classes!("btn", class)} disabled={is_off} onclick={add}>{ icon::show(icon) }<span>{ words }</span></button>
            <button type="button" class="btn outline" onclick={act(send, || RuleAction::Cancel)}>{ tr!("Cancel") }</button>
        </footer>
    }
}

/// The rule that was written has the focus in the list.
fn focus_rule() {
    let focus = || {
        let rule = gloo::utils::document().query_selector("#rules .rule.lit .rule-icon");
        if let Ok(Some(rule)) = rule
            && let Ok(rule) = rule.dyn_into::<HtmlElement>()
        {
            let _ = rule.focus();
        }
    };
    Timeout::new(0, focus).forget();
}
