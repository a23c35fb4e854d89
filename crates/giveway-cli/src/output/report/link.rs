//! The link of a report, which opens the plan on the page.

use giveway_formats::ForeignPlan;
use giveway_formats::link;
use giveway_model::{Plan, Scene};

use crate::args::Address;

/// Where the page is published; empty until somebody does.
const PUBLISHED: &str = env!("CARGO_PKG_HOMEPAGE");

/// Where a plan can be opened.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum Link {
    /// Nobody knows where a page is.
    Nowhere,
    /// The page does not take so much.
    TooLarge,
    /// This address opens it.
    To(String),
}

impl Link {
    /// A link to the page at an address, or else where it is published.
    pub(crate) fn new(
        address: Option<&Address>,
        scene: &Scene,
        plan: &ForeignPlan,
        notes: &[String],
    ) -> Self {
        Self::to(address, || link::audited(scene, plan, notes))
    }

    /// A link to a plan of the scene's own.
    pub(crate) fn planned(address: Option<&Address>, scene: &Scene, plan: &Plan) -> Self {
        Self::to(address, || link::planned(scene, plan))
    }

    fn to(address: Option<&Address>, text: impl FnOnce() -> Option<String>) -> Self {
        let address = address.map_or(PUBLISHED, Address::as_str);
        if address.is_empty() {
            return Self::Nowhere;
        }
        text().map_or(Self::TooLarge, |text| Self::To(format!("{address}#{text}")))
    }

    /// The address, where there is one.
    pub(crate) fn address(&self) -> Option<&str> {
        match self {
            Self::To(address) => Some(address),
            Self::Nowhere | Self::TooLarge => None,
        }
    }
}

#[cfg(test)]
mod tests {
    use giveway_formats::{Options, Source, combine};

    use super::*;

    fn link(address: &str, side: usize) -> Link {
        let rows = format!("{}\n", ".".repeat(side));
        let map = format!("type octile\nheight 1\nwidth {side}\nmap\n{rows}");
        let sources = [("a.map", &*map), ("a.txt", "Agent 0: (0,0)->(0,1)->\n")];
        let sources = sources.map(|(name, text)| Source { name, text });
        let read = combine(&sources, &Options::default()).unwrap();
        let address = address.parse().unwrap();
        let scene = read.instance.to_scene();
        Link::new(Some(&address), &scene, &read.plans[0], &read.notes)
    }

    #[test]
    fn a_plan_is_in_the_link() {
        let to = link("https://example.org/giveway/", 3);
        let begin = "https://example.org/giveway/#giveway=1&check=";
        assert!(to.address().unwrap().starts_with(begin), "{to:?}");
        assert!(
            to.address().unwrap().contains("&map=3.3f&name=a&"),
            "{to:?}"
        );
        assert!(to.address().unwrap().ends_with("!lr"), "{to:?}");
        assert!(link("http://localhost:8080", 513).address().is_some());
    }
}
