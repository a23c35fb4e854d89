//! Which files that are opened together are a floor plan.

use giveway_formats::pgm::{MapSheet, read_sheet};

use crate::files::Opened;

/// The endings of pictures that a browser shows.
const ENDINGS: [&str; 8] = ["png", "jpg", "jpeg", "webp", "gif", "bmp", "svg", "pgm"];

/// A picture, and what the file beside it says.
#[derive(Clone, Debug, PartialEq)]
pub struct Brought<'a> {
    /// The picture.
    pub picture: &'a Opened,
    /// What a robot's map says of its picture.
    pub sheet: Option<MapSheet>,
}

/// The floor plan among files: a picture, alone or with its YAML file. `None` where they are
/// something else.
///
/// ```
/// use giveway_page::{files::Opened, floor_plan::brought};
/// let file = |name: &str, text: &str| Opened { name: name.into(), bytes: text.into() };
/// let files = [file("hall.PGM", ""), file("hall.yaml", "image: hall.pgm\nresolution: 0.05\n")];
/// assert_eq!(brought(&files).unwrap().sheet.unwrap().resolution, 0.05);
/// assert!(brought(&files[1..]).is_none());
/// ```
pub fn brought(files: &[Opened]) -> Option<Brought<'_>> {
    let ending = |file: &Opened| {
        let ending = file.name.rsplit_once('.').map(|(_, ending)| ending);
        ending.map(str::to_ascii_lowercase).unwrap_or_default()
    };
    let is_picture = |file: &&Opened| ENDINGS.contains(&&*ending(file));
    match files {
        [picture] if is_picture(&picture) => Some(Brought {
            picture,
            sheet: None,
        }),
        [one, other] => {
            let (picture, sheet) = if is_picture(&one) {
                (one, other)
            } else {
                (other, one)
            };
            let text = std::str::from_utf8(&sheet.bytes).ok()?;
            let sheet = read_sheet(text)?;
            is_picture(&picture).then_some(Brought {
                picture,
                sheet: Some(sheet),
            })
        }
        _ => None,
    }
}
