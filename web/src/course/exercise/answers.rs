//! Questions with answers: one is picked, or a value is said.

use giveway_course::judge::{Did, Verdict, Why};
use giveway_course::learner::{Action, Judge, Open};
use giveway_course::lesson::task::{Choose, Guess, Predict};
use giveway_course::lesson::{Task, Text};
use giveway_model::tr;
use yew::prelude::*;

use super::super::prose::{Reader, first_sentence};
use super::super::sight::once;
use super::super::tutor::{Msg, Tutor};
use super::{before, free, hint, hints, is_answered, is_looking, judge, price, solved};
use crate::icon;

/// How an answer stands.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Stands {
    /// It can be picked.
    Open,
    /// It was not picked, and is not right.
    Passed,
    /// It was picked.
    Mine,
    /// It is right.
    Right,
}

/// An answer as a button, with the key that presses it.
fn option(
    place: usize,
    text: &Text,
    stands: Stands,
    note: &'static str,
    press: &Callback<MouseEvent>,
    reader: Reader<'_>,
) -> Html {
    let (title, detail) = first_sentence(text);
    let class = match stands {
        Stands::Mine => Some("mine"),
        Stands::Right => Some("right"),
        Stands::Open | Stands::Passed => None,
    };
    let is_over = stands != Stands::Open;
    let number = place + 1;
    html! {
        <li><button type="button" class={classes!("opt", class)} title={tr!("Key {number}", number)} data-key={number.to_string()}
            aria-disabled={is_over.then_some("true")} onclick={press.clone()}>
            <kbd aria-hidden="true">if stands == Stands::Right { { icon::show("check") } } else { { number } }</kbd>
            <span><b>{ reader.still(&title) }</b>if !detail.is_empty() { <small>{ reader.still(&detail) }</small> }</span>
            if !note.is_empty() { <em>{ note }</em> }
        </button></li>
    }
}

/// Something is said before it is shown.
pub(super) fn predict(tutor: &Tutor, open: &Open, task: &Predict, reader: Reader<'_>) -> Html {
    let answered = is_answered(open);
    let is_free = task.answers.is_empty();
    let verdict = open.judge().verdict();
    let truth = verdict.and_then(Verdict::truth);
    let guess = match open.did() {
        Did::Guessed(guess) if truth.is_some() || is_looking(open) => Some(guess),
        _ => None,
    };
    let one = |(place, answer): (usize, &Guess)| {
        let is_mine = guess == Some(&answer.value);
        let (stands, note) = match truth {
            Some(truth) if *truth == answer.value => (Stands::Right, tr!("an answer" => "proved")),
            _ if is_mine => (Stands::Mine, tr!("your guess")),
            Some(_) => (Stands::Passed, ""),
            None => (Stands::Open, ""),
        };
        let value = answer.value.clone();
        let press = reader.send.reform(move |_: MouseEvent| {
            let act = Action::Guess(value.clone());
            Msg::Do(act)
        });
        let idle = Callback::from(|_: MouseEvent| ());
        let press = if answered { &idle } else { &press };
        option(place, &answer.text, stands, note, press, reader)
    };
    let shown = price::show(open).unwrap_or_else(|| free::beside(open, reader));
    html! {
        <section class="ask-it predicts" aria-labelledby="ex-h">
            <h3 id="ex-h">{ reader.show(&task.say) }</h3>
            { before(open) }
            if is_free && !answered {
                { free::show(tutor, open, task, reader) }
            } else if !is_free {
                <ol class={classes!("opts", answered.then_some("done"))}>{ for task.answers.iter().enumerate().map(one) }</ol>
            }
            <div class="judge-at" role="status">
                if is_free && answered { { shown } }
                { outcome(tutor, open, reader) }
            </div>
            if !answered {
                { hints(open.hints(), reader) }
                if !open.hides_answers() {
                    <p class="quiet">
                        { tr!("Guess: then the right answer is shown and explained.") }{ " " }
                        <button type="button" class="link" onclick={reader.send.reform(|_: MouseEvent| Msg::Do(Action::Reveal))}>{ tr!("Show me the answer") }</button>
                    </p>
                }
                <div class="exa">{ hint(open, reader.send) }</div>
            }
        </section>
    }
}

/// Takes a wrong guess back.
pub(in crate::course) fn again(reader: Reader<'_>) -> Html {
    html! { <button type="button" class="link" onclick={once(reader.send, || Msg::Do(Action::Afresh))}>{ tr!("Guess again") }</button> }
}

/// What is said once the answer is on the table: to the guess first, then why it is so.
fn outcome(tutor: &Tutor, open: &Open, reader: Reader<'_>) -> Html {
    let (Some(verdict), Some(step)) = (open.judge().verdict(), open.step()) else {
        return match open.judge() {
            Judge::Looking(_) if tutor.is_late => {
                html! { <p class="quiet">{ tr!("Looking\u{2026}") }</p> }
            }
            _ => html! {},
        };
    };
    if !is_answered(open) {
        return judge::bare(tutor, open, reader);
    }
    let said = giveway_course::judge::words::said(verdict, step).text;
    let is_reply = matches!(
        verdict.why,
        Why::Guessed {
            answer: Some(_),
            ..
        }
    );
    // Answers show by themselves which is right: those that are listed, where one is, and
    // those that are said freely.
    let shows_right = match (&step.task, verdict.truth()) {
        (Some(Task::Predict(task)), Some(truth)) => {
            let mut answers = task.answers.iter();
            task.answers.is_empty() || answers.any(|answer| answer.value == *truth)
        }
        _ => false,
    };
    html! {
        <div class="why">
            if verdict.is_solved() { <p class="exw">{ icon::show("proved") }<b>{ tr!("a verdict" => "Solved") }</b></p> }
            if is_reply || !shows_right || step.reason.is_none() { <p>{ reader.show(&said) }</p> }
            if let Some(reason) = &step.reason { <p>{ reader.show(reason) }</p> }
            if !verdict.is_solved() { <p>{ again(reader) }</p> }
        </div>
    }
}

/// One of several answers is picked.
pub(super) fn choose(tutor: &Tutor, open: &Open, task: &Choose, reader: Reader<'_>) -> Html {
    let picked = match open.did() {
        Did::Chose(answer) => Some(*answer),
        _ => None,
    };
    let is_solved = open.is_solved();
    let one = |(place, choice): (usize, &giveway_course::lesson::task::Choice)| {
        let is_mine = picked == Some(place);
        let stands = match (is_solved, is_mine) {
            (true, true) => Stands::Right,
            (true, false) => Stands::Passed,
            (false, true) => Stands::Mine,
            (false, false) => Stands::Open,
        };
        let note = if stands == Stands::Mine {
            tr!("your answer")
        } else {
            ""
        };
        let press = reader
            .send
            .reform(move |_: MouseEvent| Msg::Do(Action::Choose(place)));
        let idle = Callback::from(|_: MouseEvent| ());
        let press = if is_solved { &idle } else { &press };
        option(place, &choice.text, stands, note, press, reader)
    };
    html! {
        <section class="ask-it" aria-labelledby="ex-q">
            <h3 id="ex-q">{ reader.show(&task.say) }</h3>
            <ol class={classes!("opts", is_solved.then_some("done"))}>{ for task.answers.iter().enumerate().map(one) }</ol>
            if is_solved {
                <div class="ex solved">{ solved::show(open, reader) }</div>
            } else {
                { judge::show(tutor, open, reader) }
                { hints(open.hints(), reader) }
                <div class="exa">{ hint(open, reader.send) }</div>
            }
        </section>
    }
}
