//! Grids in which a blank is a free cell, as people draw mazes: only obstacles are drawn.

/// The grid with `.` for its blanks, rows filled up to one width; `None` where blanks are no
/// cells: the text has other marks than obstacles and letters, or its rows are as long without
/// their blanks, which then only stand between cells.
pub(super) fn filled(text: &str) -> Option<String> {
    let text = giveway_model::format::text::without_mark(text);
    let rows: Vec<&str> = text.lines().map(str::trim_end).collect();
    let is_mark = |c: char| matches!(c, '#' | '@' | ' ') || c.is_ascii_alphabetic();
    if rows.len() < 2 || !rows.iter().all(|row| row.chars().all(is_mark)) {
        return None;
    }
    let count = |is: fn(char) -> bool| text.chars().filter(|&c| is(c)).count();
    let walls = count(|c| matches!(c, '#' | '@'));
    let letters = count(|c| c.is_ascii_alphabetic());
    let drawn = || rows.iter().filter(|row| !row.is_empty());
    let mut widths = drawn().map(|row| row.bytes().filter(|&byte| byte != b' ').count());
    let first = widths.next()?;
    let is_spaced = widths.all(|width| width == first) && !text.trim_end().contains("  ");
    let has_blank = drawn().any(|row| row.contains(' '));
    if is_spaced || !has_blank || walls < 2 * letters || walls == 0 {
        return None;
    }
    let width = rows.iter().map(|row| row.len()).max()?;
    let last = rows.iter().rposition(|row| !row.is_empty())?;
    let rows = rows.get(..=last)?.iter();
    let rows = rows.map(|row| {
        let row = row.replace(' ', ".");
        format!("{row:.<width$}\n")
    });
    Some(rows.collect())
}
