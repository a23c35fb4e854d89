//! The address of a page.

use std::str::FromStr;

/// Where the page is, such as `https://example.org/giveway/`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Address(String);

impl Address {
    pub(crate) fn as_str(&self) -> &str {
        &self.0
    }
}

impl FromStr for Address {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let is_web = ["http://", "https://"]
            .iter()
            .any(|&kind| text.strip_prefix(kind).is_some_and(|rest| !rest.is_empty()));
        let is_plain = text
            .chars()
            .all(|c| c.is_ascii_graphic() && !"\"<>#\\`".contains(c));
        if is_web && is_plain {
            Ok(Self(text.to_owned()))
        } else {
            Err("expected an address such as https://example.org/giveway/, without #".to_owned())
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_an_address_of_the_web_is_one() {
        for text in ["https://example.org/giveway/", "http://localhost:8080"] {
            assert_eq!(text.parse(), Ok(Address(text.to_owned())));
        }
        for text in [
            "",
            "https://",
            "example.org",
            "file:///a",
            "https://a/#b",
            "https://a/ b",
            "https://a/\">",
        ] {
            assert!(text.parse::<Address>().is_err(), "{text}");
        }
    }
}
