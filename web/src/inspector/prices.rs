//! The prices of rules: what a rule costs beside what the plan costs, and the button that asks.

use giveway_model::tr;
use giveway_page::Action;
use giveway_page::rules::{CostsOfRule, RuleAction};
use yew::prelude::*;

use super::rules::act;
use crate::icon;
use crate::part::part;
use crate::turning::{Turning, TurningProps};

/// What the best plan costs with a rule and without it.
pub(super) fn costs_of(costs: &[CostsOfRule]) -> Html {
    let row = |cost: &CostsOfRule| {
        let with = cost.with.map_or_else(
            || tr!("costs with a rule that no plan keeps" => "no plan").to_owned(),
            |with| with.to_string(),
        );
        html! {
            <tr class={(cost.with == Some(cost.without)).then_some("same")}>
                <th scope="row">{ cost.title }</th><td>{ with }</td><td>{ cost.without }</td>
            </tr>
        }
    };
    html! {
        <table class="rule-costs">
            <thead><tr><td></td><th scope="col">{ tr!("a rule" => "with it") }</th><th scope="col">{ tr!("a rule" => "without it") }</th></tr></thead>
            <tbody>{ for costs.iter().map(row) }</tbody>
        </table>
    }
}

/// The button that asks what rules cost; it stops, while that is being found out, and goes on
/// where prices are left open.
pub(super) fn ask(
    asking: Option<(u32, u32)>,
    goes_on: bool,
    longer: Option<u32>,
    send: &Callback<Action>,
) -> Html {
    let onclick = act(send, || RuleAction::Price);
    let label = asking.map(|(known, of)| {
        tr!(
            "What do the rules cost? {known} of {of} known. Press to stop.",
            known,
            of
        )
    });
    let content = html! {
        <>
            { icon::show("price") }<span>{ if goes_on { tr!("Go on with the prices") } else { tr!("What do the rules cost?") } }</span>
            if let (Some(seconds), None) = (longer, asking) { <small>{ tr!("up to {seconds} s", seconds) }</small> }
            if let Some((known, of)) = asking {
                <small>{ tr!("{known} of {of}", known, of) }</small>{ icon::show("stop") }
                <progress aria-hidden="true" max={of.to_string()} value={known.to_string()}></progress>
            }
        </>
    };
    part::<Turning>(TurningProps {
        meaning: if asking.is_some() { "stop" } else { "ask" }.into(),
        class: classes!("btn", "outline", "ask-price"),
        title: None,
        label: label.map(AttrValue::from),
        is_off: false,
        is_toggle: false,
        content,
        onclick,
    })
}
