//! Results for programs: one JSON object, laid out to be read by people, too.
//!
//! Objects take a line a key; arrays stay on one line, so that a path is one
//! line however long it is.

use std::io::{self, Write};

use serde::Serialize;
use serde_json::ser::{Formatter, PrettyFormatter, Serializer};

use crate::failure::Failure;

/// The text of a result, with a newline at its end.
pub(crate) fn text(value: &impl Serialize) -> Result<String, Failure> {
    let mut bytes = Vec::new();
    let mut serializer = Serializer::with_formatter(&mut bytes, Layout::default());
    value
        .serialize(&mut serializer)
        .map_err(|error| Failure::output("standard output", error.into()))?;
    bytes.push(b'\n');
    String::from_utf8(bytes)
        .map_err(|error| Failure::output("standard output", io::Error::other(error)))
}

/// Objects as the pretty layout has them, arrays as the compact one.
#[derive(Default)]
struct Layout {
    pretty: PrettyFormatter<'static>,
}

impl Formatter for Layout {
    fn begin_array_value<W: ?Sized + Write>(&mut self, out: &mut W, first: bool) -> io::Result<()> {
        if first { Ok(()) } else { out.write_all(b", ") }
    }

    fn begin_object<W: ?Sized + Write>(&mut self, out: &mut W) -> io::Result<()> {
        self.pretty.begin_object(out)
    }

    fn end_object<W: ?Sized + Write>(&mut self, out: &mut W) -> io::Result<()> {
        self.pretty.end_object(out)
    }

    fn begin_object_key<W: ?Sized + Write>(&mut self, out: &mut W, first: bool) -> io::Result<()> {
        self.pretty.begin_object_key(out, first)
    }

    fn begin_object_value<W: ?Sized + Write>(&mut self, out: &mut W) -> io::Result<()> {
        self.pretty.begin_object_value(out)
    }

    fn end_object_value<W: ?Sized + Write>(&mut self, out: &mut W) -> io::Result<()> {
        self.pretty.end_object_value(out)
    }
}

#[cfg(test)]
mod tests {
    use expect_test::expect;
    use serde_json::json;

    use super::*;

    #[test]
    fn a_path_is_one_line_and_a_key_is_one_line() {
        let value = json!({
            "empty": {},
            "paths": { "A1": [[0, 0], null, [1, 0]], "A2": [] },
            "violations": [{ "time": 1 }, { "time": 2 }],
        });
        expect![[r#"
            {
              "empty": {},
              "paths": {
                "A1": [[0, 0], null, [1, 0]],
                "A2": []
              },
              "violations": [{
                "time": 1
              }, {
                "time": 2
              }]
            }
        "#]]
        .assert_eq(&text(&value).unwrap());
    }
}
