//! What a person shares: a link or an embed, with the answer or without it, in the
//! reader's own language or in another one. And the language in an address.

use giveway_model::format::link::seal;

use super::read::is_of_scene;

/// The name of the language in the query of an address.
const LANGUAGE: &str = "lang=";

/// The choices of a person who shares.
///
/// ```
/// use giveway_page::link::Sharing;
/// let whole = "https://example.org/#giveway=1&map=3.3f&plan=2r&time=1";
/// let german = Sharing { language: "de", ..Sharing::default() };
/// assert_eq!(
///     german.link(whole),
///     "https://example.org/?lang=de#giveway=1&map=3.3f&plan=2r&time=1"
/// );
/// let puzzle = Sharing { hides_answer: true, ..Sharing::default() };
/// let link = puzzle.link(whole);
/// assert!(link.starts_with("https://example.org/#giveway=1&check=") && link.ends_with("&map=3.3f"));
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Sharing {
    /// Whether the answer stays hidden: only the scene is shared.
    pub hides_answer: bool,
    /// The tag of the language in which the page opens; empty for the reader's own.
    pub language: &'static str,
}

impl Sharing {
    /// The link for these choices, made from the link that holds everything.
    pub fn link(self, whole: &str) -> String {
        let (page, text) = whole.split_once('#').unwrap_or((whole, ""));
        let mut link = page.to_owned();
        if !self.language.is_empty() {
            link.push('?');
            link += LANGUAGE;
            link += self.language;
        }
        link.push('#');
        if self.hides_answer {
            let parts: Vec<&str> = text.split('&').filter(|part| is_of_scene(part)).collect();
            link + &seal::write(&parts.join("&"))
        } else {
            link + text
        }
    }
}

/// HTML that shows the scene of a link inside another page.
///
/// ```
/// use giveway_page::link::embed;
/// let html = embed("https://example.org/?lang=de#giveway=1&map=1.f", "5 < 6");
/// assert!(html.contains("src=\"https://example.org/?embed&amp;lang=de#giveway=1&amp;map=1.f\""));
/// assert!(html.contains("title=\"Giveway: 5 &lt; 6\""));
/// ```
pub fn embed(link: &str, name: &str) -> String {
    let text = |text: &str| {
        let text = text.replace('&', "&amp;").replace('"', "&quot;");
        text.replace('<', "&lt;").replace('>', "&gt;")
    };
    let (page, scene) = link.split_once('#').unwrap_or((link, ""));
    let (page, query) = page.split_once('?').unwrap_or((page, ""));
    let and = if query.is_empty() { "" } else { "&" };
    let link = text(&format!("{page}?embed{and}{query}#{scene}"));
    let name = text(name);
    format!(
        "<iframe src=\"{link}\" title=\"Giveway: {name}\" width=\"640\" height=\"480\" \
         loading=\"lazy\" style=\"border: 0\"></iframe>"
    )
}

/// The language that the query of an address names; it may be one that the page does
/// not speak.
///
/// ```
/// use giveway_page::link::language;
/// assert_eq!(language("?embed&lang=de"), Some("de"));
/// assert_eq!(language("?slang=de"), None);
/// ```
pub fn language(query: &str) -> Option<&str> {
    parts(query).find_map(|part| part.strip_prefix(LANGUAGE))
}

/// The query of an address without its language.
///
/// ```
/// use giveway_page::link::without_language;
/// assert_eq!(without_language("?from=notes&lang=de"), "?from=notes");
/// assert_eq!(without_language("?lang=de"), "");
/// ```
pub fn without_language(query: &str) -> String {
    let others = parts(query).filter(|part| !part.starts_with(LANGUAGE));
    let others: Vec<&str> = others.collect();
    if others.is_empty() {
        String::new()
    } else {
        format!("?{}", others.join("&"))
    }
}

/// The address of the whole page, from that of an embed.
///
/// ```
/// use giveway_page::link::whole_page;
/// let embed = "https://example.org/?embed&lang=de#giveway=1";
/// assert_eq!(whole_page(embed), "https://example.org/?lang=de#giveway=1");
/// assert_eq!(whole_page("https://example.org/?embed"), "https://example.org/");
/// ```
pub fn whole_page(address: &str) -> String {
    let (page, text) = match address.split_once('#') {
        Some((page, text)) => (page, format!("#{text}")),
        None => (address, String::new()),
    };
    let (page, query) = page.split_once('?').unwrap_or((page, ""));
    let others: Vec<&str> = parts(query)
        .filter(|part| !part.is_empty() && *part != "embed")
        .collect();
    let query = if others.is_empty() { "" } else { "?" };
    format!("{page}{query}{}{text}", others.join("&"))
}

fn parts(query: &str) -> impl Iterator<Item = &str> {
    // Some programs write `&amp;` for `&`.
    let parts = query.trim_start_matches('?').split('&');
    parts.map(|part| part.strip_prefix("amp;").unwrap_or(part))
}
