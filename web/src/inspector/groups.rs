//! Facts in groups: a number, a line, a mark; pressing one opens its facts and lights it up.

use giveway_model::tr;
use giveway_page::ask::{FactRow, Facts, GroupMark, GroupRow};
use giveway_page::rules::RuleAction;
use giveway_page::{Action, AskAction};
use yew::prelude::*;

use crate::icon;

/// The groups, and the facts of the one that is open.
#[inline(never)]
pub(super) fn show(facts: &Facts, send: &Callback<Action>) -> Html {
    html! { <ol class="groups">{ for facts.groups.iter().map(|group| one(group, &facts.facts, send)) }</ol> }
}

fn one(group: &GroupRow, facts: &[FactRow], send: &Callback<Action>) -> Html {
    let index = group.index;
    let (class, mark) = match group.mark {
        GroupMark::Helps => ("helps", Some(tr!("a mark of a group of facts" => "helps"))),
        GroupMark::Needed => (
            "needed",
            Some(tr!("a mark of a group of facts" => "needed")),
        ),
        // The sentence below the groups says so of all of them.
        GroupMark::Open => ("open", None),
    };
    let fact = |&fact: &usize| {
        let fact = facts.get(fact)?;
        Some(html! { <li>{ icon::show(fact.icon) }<span>{ fact.text.clone() }</span></li> })
    };
    html! {
        <li>
            <button type="button" class="group" aria-expanded={group.is_open.to_string()}
                onclick={send.reform(move |_| Action::Ask(AskAction::Group(index)))}>
                <span class={classes!("gno", class)}>{ group.number }</span>
                <span>{ group.title.clone() }if let Some(price) = &group.price { <small>{ price.clone() }</small> }</span>
                if let Some(mark) = mark { <em class={class}>{ mark }</em> }
            </button>
            { for group.facts.iter().filter_map(|&fact| loosens(facts.get(fact)?, send)).take(1) }
            if group.is_open {
                <ul>
                    { for group.facts.iter().filter_map(fact) }
                    if group.more > 0 { <li>{ tr!("and {n} more" | "and {n} more" % group.more as u32) }</li> }
                </ul>
            }
        </li>
    }
}

/// What looks for the least by which a rule is to be loosened, beside the fact that it is.
pub(super) fn loosens(fact: &FactRow, send: &Callback<Action>) -> Option<Html> {
    let rule = fact.loosens?;
    let press = send.reform(move |_| Action::Rules(RuleAction::Loosen(rule)));
    Some(html! {
        <button type="button" class="link loosens" aria-label={tr!("Loosen: {rule}", rule = fact.text)}
            title={tr!("Find the least that helps")} onclick={press}>{ tr!("Loosen") }</button>
    })
}
