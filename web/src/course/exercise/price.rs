//! What a rule costs, on a line: the best cost without it, what the guess would make of that, and
//! what is proved.

use giveway_course::judge::Did;
use giveway_course::learner::Open;
use giveway_course::lesson::Value;
use giveway_course::port::RulePrice;
use giveway_model::tr;
use giveway_model::words::name;
use yew::prelude::*;

use crate::icon;

/// A point of the line: its class, what it is, and the cost there.
type Point = (&'static str, &'static str, u32);

/// The line; `None` where the answer is no price.
pub(super) fn show(open: &Open) -> Option<Html> {
    let verdict = open.judge().verdict()?;
    let price = verdict.evidence.without.as_ref()?.price?;
    let points = points(&price, guessed(open));
    let point = |(class, word, cost): Point| html! { <li {class}><small>{ word }</small><b>{ cost }</b></li> };
    let text = match price.with.saturating_sub(price.without) {
        0 => tr!("The rule costs nothing.").to_owned(),
        steps => tr!("The rule costs {n}.", n = steps),
    };
    let of = tr!("The best {cost}:", cost = name(price.cost));
    Some(html! {
        <figure class="price-line">
            <figcaption>{ of }</figcaption>
            <ol>{ for points.into_iter().map(point) }</ol>
            <p>{ icon::show("proved") }<b>{ text }</b></p>
        </figure>
    })
}

/// The number that was guessed.
fn guessed(open: &Open) -> Option<u32> {
    match open.did() {
        Did::Guessed(Value::Number(number)) => Some(*number),
        _ => None,
    }
}

/// The points, the least first; a right guess is the proved one.
fn points(price: &RulePrice, guess: Option<u32>) -> Vec<Point> {
    let mut points = vec![
        ("from", tr!("a cost" => "without the rule"), price.without),
        ("right", tr!("an answer" => "proved"), price.with),
    ];
    let guessed = guess.map(|steps| price.without.saturating_add(steps));
    if let Some(cost) = guessed.filter(|cost| *cost != price.with) {
        let place = points.partition_point(|(_, _, other)| *other <= cost);
        points.insert(place, ("mine", tr!("your guess"), cost));
    }
    points
}
