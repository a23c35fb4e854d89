//! Rows as text: cut into blocks of times that fit the width, and the legend.

use super::rows::Row;
use crate::output::plain;

/// The rows, cut into blocks of times that fit the width.
pub(super) fn blocks(rows: &[Row], times: usize, columns: usize) -> String {
    let widest = |texts: &mut dyn Iterator<Item = usize>| texts.max().unwrap_or(0);
    let label = widest(&mut rows.iter().map(|row| plain::width(&row.label))).max(4);
    let entry = widest(
        &mut rows
            .iter()
            .flat_map(|row| row.entries.iter().map(String::len)),
    );
    let pitch = entry.max(times.to_string().len() + 1) + 1;
    let fitting = (columns.saturating_sub(label) / pitch).max(1);
    // Blocks of about one length read better than one that holds the rest.
    let per_block = times.div_ceil(times.div_ceil(fitting).max(1)).max(1);
    let mut text = String::new();
    for first in (0..times).step_by(per_block) {
        if first > 0 {
            text.push('\n');
        }
        let block = first..times.min(first + per_block);
        let header = block.clone().map(|t| format!("{t} "));
        text += &line("time", label, pitch, header);
        for row in rows {
            let entries = block
                .clone()
                .map(|t| row.entries.get(t).cloned().unwrap_or_default());
            // Who has arrived is left out of the later blocks.
            if row.entries.len() > first {
                text += &line(&row.label, label, pitch, entries);
            }
        }
    }
    text
}

fn line(
    label: &str,
    label_columns: usize,
    pitch: usize,
    entries: impl Iterator<Item = String>,
) -> String {
    let mut line = plain::pad_right(label, label_columns);
    for entry in entries {
        line += &plain::pad_left(&entry, pitch);
    }
    line.trim_end().to_owned() + "\n"
}

/// What the signs in the rows mean, those that occur.
pub(super) fn legend(rows: &[Row]) -> String {
    let occurs = |what: &str| {
        rows.iter()
            .any(|row| row.entries.iter().any(|e| e.contains(what)))
    };
    let words: Vec<&str> = [("..", ".. in transit on a slow move"), ("*", "* charges")]
        .into_iter()
        .filter(|(what, _)| occurs(what))
        .map(|(_, words)| words)
        .collect();
    if words.is_empty() {
        String::new()
    } else {
        format!("  {}\n", words.join(", "))
    }
}
