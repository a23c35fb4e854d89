//! The keys.

use giveway_course::tour;
use giveway_model::tr;
use giveway_page::keys::{HELP, Row, key_name};
use yew::prelude::*;

use super::frame::Frame;
use crate::{icon, keep};

/// All keys, by what they are for, and the way to the tour, which a lesson has no room
/// for; calls back when it was closed.
pub(crate) fn help(has_tour: bool, on_close: Callback<()>) -> Html {
    let tour = on_close.reform(|_: MouseEvent| keep::learn(tour::NAME));
    html! {
        <Frame title={tr!("Keys")} reads=true {on_close}>
            if has_tour {
                <button type="button" class="btn outline take-tour" onclick={tour}>
                    { icon::show("play") }<span>{ tr!("Take the tour") }</span>
                </button>
            }
            { for HELP.iter().map(|(title, rows)| group(title.text(), rows)) }
        </Frame>
    }
}

fn group(title: &'static str, rows: &[Row]) -> Html {
    html! {
        <>
            <h3>{ title }</h3>
            <dl class="keylist">{ for rows.iter().map(row) }</dl>
        </>
    }
}

fn row(row: &Row) -> Html {
    html! {
        <>
            <dt>{ for row.keys.iter().map(|keys| chord(keys)) }</dt>
            <dd>{ row.what.text() }</dd>
        </>
    }
}

/// Keys held together; `+` by itself is a key.
fn chord(keys: &'static str) -> Html {
    let keys: Vec<_> = match keys {
        "+" => vec![keys],
        _ => keys.split('+').collect(),
    };
    html! { <span class="chord">{ for keys.into_iter().map(|key| html! { <kbd>{ key_name(key) }</kbd> }) }</span> }
}
