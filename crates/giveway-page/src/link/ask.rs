//! The question in a link: its kind and its agents, then its options:
//! `wait;A2!at.3.1!from.0`.

use giveway_model::Question;
use giveway_model::question::Asked;

use super::text::{escape, unescape};

pub(super) fn write(question: &Question) -> String {
    let asked = Asked::of(question);
    let mut text = asked.kind.clone();
    for agent in &asked.agents {
        text.push(';');
        text += &escape(agent);
    }
    for (option, value) in asked.options() {
        // A cell has a comma, which some programs take for the end of a link.
        let value = value.replace(',', ".");
        text.extend(["!", option, ".", &value]);
    }
    text
}

/// The question that a text tells; `None` where it is none. It need not fit any
/// plan.
pub(super) fn read(text: &str) -> Option<Question> {
    let mut parts = text.split('!');
    let mut words = parts.next()?.split(';');
    let mut asked = Asked {
        kind: words.next()?.to_owned(),
        agents: words.map(unescape).collect::<Option<_>>()?,
        ..Asked::default()
    };
    for option in parts {
        let (option, value) = option.split_once('.')?;
        asked.set(option, &value.replace('.', ",")).ok()?;
    }
    asked.question().ok()
}
