//! What a class did with each task, beside the table.

use giveway_course::grade::{Given, Share, Unread, Wrong};
use giveway_model::tr;
use yew::prelude::*;

use super::Collected;
use crate::icon;

/// The most wrong answers of a task that are told.
const MOST_WRONG: usize = 4;
/// The width of a bar, in parts.
const WIDTH: usize = 1_000;

pub(super) fn show(class: &Collected) -> Html {
    let place = class.looking.lesson;
    let Some(given) = class.class.lessons().get(place) else {
        return html! { <aside class="class-side">{ unread(class) }</aside> };
    };
    let shares = class.class.shares(place);
    let wrong = class.class.wrong(place);
    html! {
        <aside class="class-side">
            <section aria-labelledby="class-did">
                <h3 id="class-did">{ tr!("How the class did") }</h3>
                <ol class="hows">{ for shares.iter().map(|it| share(it, given)) }</ol>
                <p class="sleg">
                    <span><i class="ok"></i>{ tr!("solved") }</span>
                    <span><i class="lie"></i>{ tr!("says solved, is not") }</span>
                    <span><i class="un"></i>{ tr!("not solved") }</span>
                    <span><i class="nil"></i>{ tr!("not tried") }</span>
                </p>
            </section>
            if !wrong.is_empty() {
                <section aria-labelledby="class-wrong">
                    <h3 id="class-wrong">{ tr!("Most common wrong answers") }</h3>
                    { for shares.iter().map(|it| wrong_of(it.step, &wrong, given)) }
                </section>
            }
            { unread(class) }
        </aside>
    }
}

/// A task's bar: solved, claimed, not solved, not tried; what is not decided is the rest.
fn share(share: &Share, given: &Given) -> Html {
    let all = share.all().max(1);
    let honest = share.not_solved.saturating_sub(share.false_claims);
    let label = tr!(
        "{solved} solved, {claimed} says solved, is not, {not} not solved, {none} not tried",
        solved = share.solved,
        claimed = share.false_claims,
        not = honest,
        none = share.not_tried
    );
    let parts = [
        ("ok", share.solved),
        ("lie", share.false_claims),
        ("un", honest),
        ("nil", share.not_tried),
    ];
    let mut from = 0;
    let bars = parts.into_iter().filter(|(_, count)| *count > 0);
    let bars: Vec<Html> = bars
        .map(|(class, count)| {
            let (x, width) = (from * WIDTH / all, count * WIDTH / all);
            from += count;
            html! { <rect {class} x={x.to_string()} width={width.saturating_sub(8).to_string()} height="12" rx="3" /> }
        })
        .collect();
    html! {
        <li>
            <span class="hn"><b>{ given.task_words(share.step) }</b><em>{ tr!("{n} of {all}", n = share.solved, all = share.all()) }</em></span>
            <svg class="sbar" viewBox={format!("0 0 {WIDTH} 12")} preserveAspectRatio="none" role="img" aria-label={label}>{ for bars }</svg>
        </li>
    }
}

/// The wrong answers to a task, the most common first.
fn wrong_of(step: usize, wrong: &[Wrong], given: &Given) -> Html {
    let of_task: Vec<&Wrong> = wrong.iter().filter(|it| it.step == step).collect();
    if of_task.is_empty() {
        return html! {};
    }
    let rest = of_task.len().saturating_sub(MOST_WRONG);
    let row = |it: &&Wrong| {
        html! {
            <li>
                <span><b>{ it.words.clone() }</b>if let Some(reply) = &it.reply { <small>{ reply.plain() }</small> }</span>
                <b class="num">{ it.count }</b>
            </li>
        }
    };
    html! {
        <>
            <p class="wq">{ given.task_words(step) }</p>
            <ol class="wl">{ for of_task.iter().take(MOST_WRONG).map(row) }</ol>
            if rest > 0 { <p class="quiet">{ tr!("and {n} more" | "and {n} more" % rest) }</p> }
        </>
    }
}

/// Files that are not judged, each with the reason.
fn unread(class: &Collected) -> Html {
    let files = class.class.files().iter();
    let unread: Vec<(&str, String)> = files
        .filter_map(|file| Some((file.file.as_str(), file.unread().map(Unread::words)?)))
        .collect();
    if unread.is_empty() {
        return html! {};
    }
    let row = |(name, why): &(&str, String)| {
        html! { <li>{ icon::show("file") }<span><bdi>{ (*name).to_owned() }</bdi><small>{ why.clone() }</small></span></li> }
    };
    html! {
        <section aria-labelledby="class-unread">
            <h3 id="class-unread">{ tr!("Not judged") }</h3>
            <ul class="unr">{ for unread.iter().map(row) }</ul>
        </section>
    }
}
