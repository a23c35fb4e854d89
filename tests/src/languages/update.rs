//! A PO file brought up to date.

use std::collections::BTreeMap;
use std::fmt::Write as _;

use giveway_model::words::{Message, messages};

use super::Said;

/// A PO file with exactly the texts of the sources: translations are kept, what is
/// missing has the one of `other`, where that has it, and what nobody says is left out.
///
/// # Panics
///
/// If the file is no PO.
pub fn updated(po: &str, other: &str, said: &[Said]) -> String {
    // What comes last counts.
    let known = [other, po].map(|po| messages(po).expect("a PO file"));
    let known = known.into_iter().flatten().filter(Message::is_translated);
    let known: BTreeMap<String, Message> = known.map(|m| (m.key(), m)).collect();
    let head = po.split_once("\n\n").map_or(po, |(head, _)| head);
    let mut text = format!("{}\n", head.trim_end());
    for one in said {
        let _ = writeln!(text);
        for file in &one.files {
            let _ = writeln!(text, "#: {file}");
        }
        if let Some(context) = &one.context {
            let _ = writeln!(text, "msgctxt {}", quoted(context));
        }
        let _ = writeln!(text, "msgid {}", quoted(&one.text));
        let forms = known.get(&one.key()).map(|message| message.forms.clone());
        let forms = forms.unwrap_or_default();
        let form = |i: usize| forms.get(i).map_or("", String::as_str);
        match &one.plural {
            None => {
                let _ = writeln!(text, "msgstr {}", quoted(form(0)));
            }
            Some(plural) => {
                let _ = writeln!(text, "msgid_plural {}", quoted(plural));
                for i in 0..2.max(forms.len()) {
                    let _ = writeln!(text, "msgstr[{i}] {}", quoted(form(i)));
                }
            }
        }
    }
    text
}

fn quoted(text: &str) -> String {
    let text = text.replace('\\', "\\\\").replace('"', "\\\"");
    format!("\"{}\"", text.replace('\n', "\\n").replace('\t', "\\t"))
}
