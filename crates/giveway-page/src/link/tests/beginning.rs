//! Links whose beginning did not arrive.

use crate::link::{From, is_link, read, write};

#[test]
fn a_link_without_its_beginning_is_told() {
    let text = write(&crate::sample::solved());
    for begin in ["check=", "map=", "name=", "rules="] {
        let at = text.find(begin).unwrap();
        for cut in [&text[at..], &text[at + 2..]] {
            for cut in [cut.to_owned(), cut.replace('&', "%26").replace('=', "%3D")] {
                assert!(is_link(&cut), "{cut}");
                let notice = read(&cut, From::Anywhere).unwrap_err();
                let told = notice.details().join(" ");
                assert!(told.contains("its beginning is missing"), "{cut}: {told}");
            }
        }
    }
    for other in [
        "check=yes",
        "plans",
        "agents",
        "top&agents",
        "lesson=room-to-pass",
    ] {
        assert!(!is_link(other), "{other}");
    }
}
