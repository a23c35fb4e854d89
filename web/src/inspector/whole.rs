//! The scene and its plan as a whole, and the agents to pick from.

use std::rc::Rc;

use giveway_model::tr;
use giveway_page::audit::question;
use giveway_page::changing::history;
use giveway_page::inspect::{CostFacts, whole};
use giveway_page::{
    Action, Answer, AskAction, BoardAction, Draft, Selection, ask, found_better, words,
};
use yew::prelude::*;

use super::{audit, change, edit, freedom, front, ledger, order, planners, proof, rules, sizing};
use crate::held::{HeldPlace, HeldPlaceProps};
use crate::part::part;
use crate::{Shown, glyph, icon};

/// So many agents are listed at first, and with every press of `More`.
const AGENTS: usize = 50;

pub(super) fn show(state: &Shown, send: &Callback<Action>) -> Html {
    let facts = whole(state);
    let past = state
        .document
        .fresh_answer()
        .map(|answer| history(answer))
        .unwrap_or_default();
    let is_there = 0..state.world().agents().len();
    let is_there: Vec<bool> = is_there.map(|agent| state.is_there(agent)).collect();
    let is_solving = state.work.solving().is_some();
    // What is told of the plan goes with an edit and comes again with the next plan.
    let is_held = is_solving || state.document.is_stale();
    let plan = html! {
        if !facts.costs.is_empty() || !facts.claims.is_empty() || facts.work.is_some() {
            <section>
                <h3>{ if is_solving { tr!("So far") } else { tr!("Plan") } }</h3>
                { costs(state, &facts.costs, send) }
                { for facts.claims.iter().map(|claim| html! { <p class="claim">{ claim.clone() }</p> }) }
                if let Some(work) = facts.work {
                    <p class="remark">{ work }</p>
                }
                if let Some(found) = found_better(state) {
                    <p class="claim">{ found }</p>
                    <button type="button" class="btn outline more" onclick={send.reform(|_: MouseEvent| Action::Ask(AskAction::TakeFound))}>
                        { icon::show("check") }{ tr!("Use this plan") }
                    </button>
                }
                { proof::show(state, send) }
                { audit::begin(question(state), send) }
                { freedom::begin(state, send) }
                { ledger::begin(state, send) }
                { order::begin(state, send) }
                { sizing::begin(state, send) }
                { rules::question(state, send) }
            </section>
        }
    };
    html! {
        <>
            { freedom::closed(state, send) }
            <header class="ih whole"><div><h2>{ facts.title.clone() }</h2><p>{ facts.contents.clone() }</p></div></header>
            { edit::problems(state, send, |_| true) }
            { part::<HeldPlace>(HeldPlaceProps { is_held, content: plan }) }
            { rules::show(state, send) }
            { planners::show(state, send) }
            { change::history(&past, false) }
            { front::show(state, send) }
            { edit::whole(state, send) }
            { part::<Agents>(AgentsProps { draft: Rc::clone(state.world()), is_there, answer: state.so_far().or(state.document.fresh_answer()).cloned(), send: send.clone() }) }
        </>
    }
}

fn costs(state: &Shown, costs: &[CostFacts], send: &Callback<Action>) -> Html {
    if costs.is_empty() {
        return Html::default();
    }
    let units = state.world().scene().units;
    // Why a cost is not less is asked at its row.
    let title = |facts: &CostFacts| match ask::of_cost(state, facts.cost) {
        Some(offer) => {
            let question = offer.question;
            let onclick = send.reform(move |_| Action::Ask(AskAction::Ask(question.clone())));
            html! { <button type="button" class="why" title={offer.text.clone()} aria-label={format!("{}: {}", facts.title, offer.text)} {onclick}>{ facts.title }{ icon::show("question") }</button> }
        }
        None => html! { { facts.title } },
    };
    // A bound that is not there leaves its place empty; without any there is no column.
    let bound = |facts: &CostFacts| facts.at_least.filter(|_| facts.is_minimised);
    let has_bounds = costs.iter().any(|facts| bound(facts).is_some());
    let row = |facts: &CostFacts| {
        let minor = (!facts.is_minimised).then_some("minor");
        html! {
            <tr key={facts.title} class={classes!(minor)}>
                <th scope="row">{ title(facts) }</th>
                <td>{ facts.value.map(|value| words::measured(units, facts.cost, value)) }</td>
                if has_bounds { <td>
                    if facts.is_proved() {
                        <span class="seal">{ icon::show("proved") }<span class="vh">{ tr!("proved least:") }{ " " }</span></span>
                    }
                    { bound(facts) }
                </td> }
            </tr>
        }
    };
    html! {
        <table class="costs" aria-label={tr!("Costs")}>
            <thead><tr><th scope="col">{ tr!("Cost") }</th><th scope="col">{ tr!("Plan") }</th>if has_bounds { <th scope="col">{ tr!("At least") }</th> }</tr></thead>
            <tbody>{ for costs.iter().map(row) }</tbody>
        </table>
    }
}

#[derive(Clone, Properties)]
struct AgentsProps {
    draft: Rc<Draft>,
    is_there: Vec<bool>,
    answer: Option<Rc<Answer>>,
    send: Callback<Action>,
}

impl PartialEq for AgentsProps {
    /// The same objects: to compare long plans would take long.
    fn eq(&self, other: &Self) -> bool {
        let answers = match (&self.answer, &other.answer) {
            (Some(a), Some(b)) => Rc::ptr_eq(a, b),
            (None, None) => true,
            _ => false,
        };
        let is_there = self.is_there == other.is_there;
        answers && is_there && Rc::ptr_eq(&self.draft, &other.draft) && self.send == other.send
    }
}

/// The agents to pick from.
#[component]
fn Agents(props: &AgentsProps) -> Html {
    let AgentsProps {
        draft,
        is_there,
        answer,
        send,
    } = props;
    let shown = use_state_eq(|| AGENTS);
    let agents = draft.agents();
    let arrival = |agent: usize| {
        let answer = answer.as_deref()?;
        *answer.arrivals.get(answer.agent(draft, agent)?)?
    };
    let one = |(agent, who): (usize, &giveway_model::Agent)| {
        let onclick =
            send.reform(move |_| Action::Board(BoardAction::Select(Selection::Agent(agent))));
        html! {
            <li key={agent}><button type="button" class="choice" {onclick}>
                { glyph::show(agent, "choice-glyph") }
                <span>
                    <b><bdi>{ who.name.clone() }</bdi></b>
                    <small>{ match who.goal {
                            Some(goal) => tr!("{start} to {goal}", start = who.start, goal),
                            None => tr!("{start}, rests anywhere", start = who.start),
                        } }
                        if let Some(time) = arrival(agent) { { tr!("behind start and goal" => ", arrives at {time}", time) } }
                    </small>
                </span>
                { icon::at_end("chevron") }
            </button></li>
        }
    };
    let there = agents.iter().enumerate();
    let there = there.filter(|(agent, _)| is_there.get(*agent).copied().unwrap_or(false));
    let more = {
        let shown = shown.clone();
        let next = *shown + AGENTS * 2;
        move |_| shown.set(next)
    };
    html! {
        if agents.is_empty() {
            <p class="remark">{ tr!("No robots.") }</p>
        } else {
            <section>
                <h3>{ tr!("Robots") }</h3>
                <ul class="choices">{ for there.take(*shown).map(one) }</ul>
                if agents.len() > *shown {
                    <button type="button" class="btn outline more" onclick={more}>{ tr!("Show more of {all}", all = agents.len()) }</button>
                }
            </section>
        }
    }
}
