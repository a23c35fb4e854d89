//! Reads a `.map`.

use crate::lines::{Line, lines};
use giveway_model::{Fault, Grid, MAX_SIDE, tr, tr_later};

/// Whether a text is a map by a look at its first line: the lines of a header may
/// come in any order, and some makers leave out `type`.
///
/// ```
/// use giveway_formats::movingai::is_map;
/// assert!(is_map("height 1\nwidth 2\nmap\n..\n"));
/// assert!(!is_map("map:\n  dimensions: [2, 1]\n"));
/// ```
pub fn is_map(text: &str) -> bool {
    let Some(first) = lines(text).find(|line| !line.text.is_empty()) else {
        return false;
    };
    let mut words = first.text.split_whitespace();
    let (key, value) = (words.next().unwrap_or(""), words.next());
    match &*key.to_ascii_lowercase() {
        "type" => value.is_some(),
        "height" | "width" => {
            value.is_some_and(|value| value.trim_start_matches('-').parse::<u32>().is_ok())
        }
        "map" => value.is_none(),
        _ => false,
    }
}

/// Reads a map: `.` and `G` are free, `@`, `O`, `T` and `W` are obstacles. So are
/// `S` and `E` free: service points and emitters in maps of the League of Robot
/// Runners, whose Start-Kit calls both traversable. Their type is `octile`, too.
/// The lines of the header may come in any order, and `type` may be left out.
///
/// # Errors
/// When the header lacks a line or a row lacks a cell, when a character is none
/// of these, or when the map is larger than an instance may be. The fault has a
/// line and a column.
///
/// ```
/// use giveway_formats::movingai::read_map;
/// let grid = read_map("type octile\nheight 1\nwidth 3\nmap\n.@G\n").unwrap();
/// assert_eq!(grid.rows(), [".#."]);
/// ```
pub fn read_map(text: &str) -> Result<Grid, Fault> {
    let mut lines = lines(text);
    let header = read_header(&mut lines)?;
    let mut rows = Vec::new();
    for line in lines {
        if rows.len() == header.height {
            if line.text.is_empty() {
                continue;
            }
            let expected = tr!(
                "no row after the {height} of the header",
                height = header.height
            );
            return Err(line.fault(line.text, expected));
        }
        rows.push(read_row(line, header.width)?);
    }
    if rows.len() < header.height {
        let found = tr!("{n} rows", n = rows.len());
        let expected = tr!("{height}, the height in the header", height = header.height);
        return Err(Fault::at("", found, expected).in_text(header.last + rows.len(), 1));
    }
    Grid::from_rows(&rows)
        .map_err(|_| Fault::at("", tr_later!("no rows"), tr_later!("at least one")))
}

struct Header {
    height: usize,
    width: usize,
    /// The number of its last line, `map`.
    last: usize,
}

fn read_header<'a>(lines: &mut impl Iterator<Item = Line<'a>>) -> Result<Header, Fault> {
    let (mut height, mut width, mut last) = (None, None, 1);
    let take_side = |line: Line<'_>, side: &mut Option<usize>, value: &str| {
        let before = side.replace(read_side(line, value)?);
        match before.filter(|before| Some(*before) != *side) {
            None => Ok(()),
            Some(before) => Err(line.fault(value, tr!("{before}, as above", before))),
        }
    };
    for line in lines.filter(|line| !line.text.is_empty()) {
        last = line.number;
        let (key, value) = line
            .text
            .split_once(char::is_whitespace)
            .unwrap_or((line.text, ""));
        let value = value.trim();
        // A slice at the end of the line, so that its fault points there.
        let value = if value.is_empty() { line.end() } else { value };
        match &*key.to_ascii_lowercase() {
            "type" if matches!(value, "octile" | "tile") => {}
            "type" => return Err(line.fault(value, "octile")),
            "height" => take_side(line, &mut height, value)?,
            "width" => take_side(line, &mut width, value)?,
            "map" if !value.is_empty() => {
                return Err(
                    line.fault(value, tr_later!("the end of the line, with the rows below"))
                );
            }
            "map" => {
                let missing = |key| {
                    let found = tr!("no line \"{key}\" in the header", key);
                    line.fault_saying(line.text, found, tr!("\"{key}\" and a number", key))
                };
                return Ok(Header {
                    height: height.ok_or_else(|| missing("height"))?,
                    width: width.ok_or_else(|| missing("width"))?,
                    last,
                });
            }
            _ => return Err(line.fault(line.text, tr_later!("type, height, width or map"))),
        }
    }
    Err(Fault::at(
        "",
        tr_later!("the end of the file"),
        tr_later!("a header of type, height, width and map"),
    )
    .in_text(last, 1))
}

fn read_side(line: Line<'_>, value: &str) -> Result<usize, Fault> {
    let expected = || tr!("a whole number from 1 to {most}", most = MAX_SIDE);
    let side: u32 = line.number(value, expected)?;
    if (1..=MAX_SIDE).contains(&side) {
        Ok(side as usize)
    } else {
        Err(line.fault(value, expected()))
    }
}

/// A row in the project's own characters.
fn read_row(line: Line<'_>, width: usize) -> Result<String, Fault> {
    let mut row = String::with_capacity(width);
    for (offset, c) in line.text.char_indices() {
        let part = line.text.get(offset..offset + c.len_utf8()).unwrap_or("");
        if row.len() == width {
            return Err(too_many(line, part, width));
        }
        row.push(match c {
            '.' | 'G' | 'S' | 'E' => '.',
            '@' | 'O' | 'T' | 'W' => '#',
            _ => return Err(line.fault(part, tr_later!("one of . G S E @ O T W"))),
        });
    }
    if row.len() < width {
        let found = tr!("a row of {n} cells", n = row.len());
        return Err(line.fault_saying(
            line.end(),
            found,
            tr!("{width}, the width in the header", width),
        ));
    }
    Ok(row)
}

fn too_many(line: Line<'_>, part: &str, width: usize) -> Fault {
    let found = tr!("a row of {n} cells", n = line.text.chars().count());
    line.fault_saying(part, found, tr!("{width}, the width in the header", width))
}
