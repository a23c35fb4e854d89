//! A plan of elsewhere: how it was read, whether it is legal, how good it is.

use giveway_model::tr;
use giveway_page::Action;
use giveway_page::audit::{
    AuditAction, Choice, Compared, Conflicts, CostRow, Fact, Facts, PlanRow, ViolationRow,
};
use yew::prelude::*;

use crate::icon;

/// What scrolls of it.
#[inline(never)]
pub(super) fn show(
    facts: &Facts,
    walk: Option<&Conflicts>,
    opened: &UseStateHandle<String>,
    send: &Callback<Action>,
) -> Html {
    let verdict = &facts.verdict;
    html! {
        <div class="audit">
            <header class="qh">
                <button type="button" class="crumb" onclick={act(AuditAction::Leave, send)}>
                    { icon::show("back") }{ tr!("Scene") }
                </button>
                <h2>{ facts.title.clone() }</h2>
            </header>
            { file(facts, opened, send) }
            <dl class="read">{ for facts.facts.iter().map(fact) }</dl>
            <div class="verdict-at" aria-live="polite">
                <div class={classes!("verdict", verdict.class.clone())}>
                    <p class="vb">{ icon::show(&verdict.icon) }<b>{ verdict.word.clone() }</b><em>{ verdict.detail.clone() }</em></p>
                    <p class="vs">{ verdict.sentence.clone() }</p>
                </div>
            </div>
            if !facts.violations.is_empty() {
                <section>
                    <h3>{ tr!("What goes wrong") }</h3>
                    { conflicts(walk, send) }
                    <ul class="viols">{ for facts.violations.iter().map(|row| violation(row, send)) }</ul>
                    if facts.more > 0 { <p class="remark">{ tr!("And {more} more.", more = facts.more) }</p> }
                </section>
            }
            if !facts.costs.is_empty() { { costs(&facts.costs) } }
            if let Some((share, words)) = &facts.stands { { stands(*share, words) } }
            if !facts.plans.is_empty() {
                <section>
                    <h3>{ tr!("Plans of these files") }</h3>
                    <ul class="viols">{ for facts.plans.iter().enumerate().map(|row| plan(row, send)) }</ul>
                </section>
            }
            { for facts.notes.iter().map(|note| html! { <p class="remark">{ note.clone() }</p> }) }
        </div>
    }
}

fn act(action: AuditAction, send: &Callback<Action>) -> Callback<MouseEvent> {
    send.reform(move |_| Action::Audit(action))
}

/// The way from one conflict to the next, of the robot selected or of all.
pub(super) fn conflicts(walk: Option<&Conflicts>, send: &Callback<Action>) -> Html {
    let Some(walk) = walk else {
        return html! {};
    };
    html! {
        <div class="walk">
            <p aria-live="polite">{ walk.sentence.clone() }</p>
            if walk.has_next {
                <button type="button" class="btn outline" title={tr!("Next conflict (n)")} onclick={act(AuditAction::Next, send)}>
                    { icon::show("collision") }<span>{ tr!("Next conflict") }</span>
                </button>
            }
        </div>
    }
}

/// What begins the audit of the plan on the board.
#[inline(never)]
pub(super) fn begin(question: Option<&'static str>, send: &Callback<Action>) -> Html {
    let Some(question) = question else {
        return html! {};
    };
    html! {
        <ul class="asks"><li><button type="button" class="ask" onclick={act(AuditAction::Begin, send)}>
            { icon::show("search") }<span>{ question }</span>{ icon::at_end("chevron") }
        </button></li></ul>
    }
}

/// The file, and the other ways to read it.
fn file(facts: &Facts, opened: &UseStateHandle<String>, send: &Callback<Action>) -> Html {
    let is_open = **opened == facts.file;
    let toggle = {
        let (opened, file) = (opened.clone(), facts.file.clone());
        move |_: MouseEvent| opened.set(if is_open { String::new() } else { file.clone() })
    };
    html! {
        <section class="filec" aria-label={tr!("File")}>
            { icon::show("file") }
            <p><b>{ facts.file.clone() }</b><small>{ facts.extent.clone() }</small></p>
            if !facts.choices.is_empty() {
                <button type="button" class="link" aria-expanded={is_open.to_string()} onclick={toggle}>{ tr!("Change") }</button>
            }
            if is_open && !facts.choices.is_empty() {
                <ul class="ways" aria-label={tr!("Ways to read it")}>{ for facts.choices.iter().map(|way| choice(way, send)) }</ul>
                if !facts.can_read_again {
                    <p class="remark">{ tr!("Open the file again to read it in another way.") }</p>
                }
            }
        </section>
    }
}

fn choice(way: &Choice, send: &Callback<Action>) -> Html {
    html! {
        <li><button type="button" class="way" aria-pressed={way.is_chosen.to_string()}
            onclick={act(AuditAction::ReadAs(way.conventions), send)}>
            { way.words.clone() }<small>{ way.meaning.clone() }</small>
        </button></li>
    }
}

fn fact(fact: &Fact) -> Html {
    html! {
        <div><dt>{ fact.title.clone() }</dt><dd>{ fact.what.clone() }<small>{ fact.why.clone() }</small></dd></div>
    }
}

/// Pressing it shows its time and its place.
fn violation(row: &ViolationRow, send: &Callback<Action>) -> Html {
    let (time, index) = (row.time, row.index);
    let detail = if row.detail.is_empty() {
        String::new()
    } else {
        format!(", {}", row.detail)
    };
    html! {
        <li><button type="button" class={classes!("viol", row.is_now.then_some("on"))} aria-current={row.is_now.then_some("true")}
            aria-label={tr!("{row}{detail}, go to time {time}", row = row.text, detail, time)}
            onclick={act(AuditAction::Show(index), send)}>
            { icon::show("collision") }
            <span>{ row.text.clone() }<small>{ row.detail.clone() }</small></span>
            <span class="tt">{ tr!("at {time}", time) }{ icon::show("chevron") }</span>
        </button></li>
    }
}

fn plan((index, row): (usize, &PlanRow), send: &Callback<Action>) -> Html {
    html! {
        <li><button type="button" class="way" aria-pressed={row.is_chosen.to_string()}
            onclick={act(AuditAction::Choose(index), send)}>
            { row.file.clone() }<small>{ row.detail.clone() }</small>
        </button></li>
    }
}

fn costs(rows: &[CostRow]) -> Html {
    let row = |row: &CostRow| {
        html! {
            <tr>
                <th scope="row">{ row.title.clone() }</th>
                <td>{ row.this }</td><td>{ row.least.map(|least| least.to_string()) }</td><td class="d">{ row.difference() }</td>
            </tr>
        }
    };
    html! {
        <table class="compare" aria-label={tr!("Costs")}>
            <thead><tr>
                <th scope="col"><span class="vh">{ tr!("Cost") }</span></th>
                <th scope="col">{ tr!("This plan") }</th><th scope="col">{ tr!("At least") }</th>
                <th scope="col"><span class="vh">{ tr!("Difference") }</span></th>
            </tr></thead>
            <tbody>{ for rows.iter().map(row) }</tbody>
        </table>
    }
}

/// The bar: what is proved, and the gap.
fn stands(share: u32, words: &str) -> Html {
    html! {
        <section class="stands">
            <h3>{ tr!("Where it stands") }</h3>
            <svg width="100%" height="14" aria-hidden="true">
                <rect class="gap" width="100%" height="14" /><rect class="done" width={format!("{share}%")} height="14" />
            </svg>
            <p class="remark">{ words.to_owned() }</p>
        </section>
    }
}

/// What stays at the foot of it.
#[inline(never)]
pub(super) fn foot(facts: &Facts, is_wide: bool, send: &Callback<Action>) -> Html {
    let button = |class, icon, text: &str, action, pressed: Option<bool>| {
        html! {
            <button type="button" {class} aria-pressed={pressed.map(|pressed| pressed.to_string())} onclick={act(action, send)}>
                { icon::show(icon) }<span>{ text.to_owned() }</span>
            </button>
        }
    };
    let compare = |compared: Compared| match compared {
        Compared::Beside if is_wide => (tr!("One plan"), AuditAction::Compare(false)),
        Compared::Instead => (tr!("Show this plan"), AuditAction::ShowOther(false)),
        _ => (tr!("Compare side by side"), AuditAction::Compare(true)),
    };
    html! {
        <footer class="foot two2">
            if let Some(take) = &facts.take {
                { button("btn primary", "check", take, AuditAction::Take, None) }
            } else if let Some(find) = &facts.find {
                { button("btn primary", "search", find, AuditAction::Find, None) }
            }
            if let Some(compared) = facts.compared {
                { button("btn outline", "compare", compare(compared).0, compare(compared).1, Some(compared != Compared::Not)) }
            }
        </footer>
    }
}
