//! Maps of robots: a grey picture, `.pgm` (Netpbm, P2 and P5), and the YAML file that ROS's
//! `map_server` writes beside it.
//!
//! Of the YAML file what the picture cannot say is read: metres a pixel, and from which grey
//! on a pixel is occupied (<https://wiki.ros.org/map_server#YAML_format>).

use giveway_model::words::Sentence;
use giveway_model::{decimal, tr_data};

/// The most pixels that are read.
const MOST: u64 = 64_000_000;

/// A grey picture.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct GreyPicture {
    /// Columns of pixels.
    pub width: u32,
    /// Rows of pixels.
    pub height: u32,
    /// From 0, black, to 255, white; row by row from the top.
    pub grey: Vec<u8>,
}

/// What a map's YAML file says of its picture.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MapSheet {
    /// Metres a pixel.
    pub resolution: f64,
    /// How dark an occupied pixel is at least: 0 is white, 1 black.
    pub occupied: f64,
    /// Whether white is occupied and black is free.
    pub is_negative: bool,
}

/// Whether a file begins as a PGM picture does.
pub fn is_pgm(bytes: &[u8]) -> bool {
    matches!(bytes, [b'P', b'2' | b'5', next, ..] if next.is_ascii_whitespace())
}

/// Reads a PGM picture.
///
/// ```
/// use giveway_formats::pgm::read_pgm;
/// let picture = read_pgm(b"P2\n# a hall\n3 1\n15\n0 15 8\n").unwrap();
/// assert_eq!((picture.width, picture.grey), (3, vec![0, 255, 136]));
/// ```
///
/// # Errors
/// What is wrong with it, as a sentence.
pub fn read_pgm(bytes: &[u8]) -> Result<GreyPicture, Sentence> {
    if !is_pgm(bytes) {
        return Err(tr_data!(
            "found no PGM picture, expected P2 or P5 at its beginning"
        ));
    }
    let is_plain = bytes[1] == b'2';
    let mut rest = &bytes[2..];
    let mut header = [0; 3];
    for number in &mut header {
        *number = next_number(&mut rest).ok_or_else(|| {
            tr_data!("its width, its height and its white are not three whole numbers")
        })?;
    }
    let [width, height, white] = header;
    // In a browser a product of two sides may be larger than what counts places.
    let count = u64::from(width) * u64::from(height);
    if count == 0 || count > MOST || white == 0 || white > 65_535 {
        return Err(tr_data!(
            "found {width} x {height} pixels up to {white}, expected at most {most} pixels up to 65535",
            width,
            height,
            white,
            most = MOST
        ));
    }
    let count = count as usize;
    let scale = |value: u32| (value.min(white) * 255 / white).to_le_bytes()[0];
    let grey: Vec<u8> = if is_plain {
        std::iter::from_fn(|| next_number(&mut rest))
            .take(count)
            .map(scale)
            .collect()
    } else {
        // One space is between the header and the pixels, which may look like spaces, too.
        let pixels = rest.get(1..).unwrap_or_default();
        if white < 256 {
            pixels
                .iter()
                .take(count)
                .map(|&value| scale(value.into()))
                .collect()
        } else {
            let pairs = pixels.chunks_exact(2).take(count);
            pairs
                .map(|pair| scale(u32::from(pair[0]) << 8 | u32::from(pair[1])))
                .collect()
        }
    };
    if grey.len() < count {
        return Err(tr_data!(
            "found {found} pixels, expected {width} x {height}",
            found = grey.len(),
            width,
            height
        ));
    }
    Ok(GreyPicture {
        width,
        height,
        grey,
    })
}

/// The next whole number of at most six digits, behind spaces and comments.
fn next_number(rest: &mut &[u8]) -> Option<u32> {
    loop {
        match rest {
            [b'#', ..] => {
                let end = rest.iter().position(|&byte| byte == b'\n')?;
                *rest = &rest[end..];
            }
            [space, after @ ..] if space.is_ascii_whitespace() => *rest = after,
            _ => break,
        }
    }
    let digits = rest.iter().take_while(|byte| byte.is_ascii_digit()).count();
    let (number, after) = rest.split_at(digits);
    *rest = after;
    let is_short = (1..=6).contains(&number.len());
    std::str::from_utf8(number)
        .ok()?
        .parse()
        .ok()
        .filter(|_| is_short)
}

impl MapSheet {
    /// The grey from which on a pixel is light, 0 is black.
    ///
    /// ```
    /// use giveway_formats::pgm::MapSheet;
    /// let sheet = MapSheet { resolution: 0.05, occupied: 0.65, is_negative: false };
    /// assert_eq!(sheet.dark_below(), 89);
    /// ```
    pub fn dark_below(&self) -> u8 {
        u8::try_from((255.0 * (1.0 - self.occupied)) as i64).unwrap_or(u8::MAX)
    }
}

/// Reads a map's YAML file; `None` where it is none.
///
/// ```
/// use giveway_formats::pgm::read_sheet;
/// let text = "image: hall.pgm\nresolution: 0.05\nnegate: 0\noccupied_thresh: 0.65\n";
/// let sheet = read_sheet(text).unwrap();
/// assert_eq!((sheet.resolution, sheet.is_negative), (0.05, false));
/// assert_eq!(read_sheet("map:\n  dimensions: [2, 2]\n"), None);
/// ```
pub fn read_sheet(text: &str) -> Option<MapSheet> {
    let value = |key: &str| {
        text.lines().find_map(|line| {
            let (name, value) = line.split_once(':')?;
            let value = value.split('#').next().unwrap_or_default().trim();
            (name.trim_end() == key).then(|| value.to_owned())
        })
    };
    value("image")?;
    let resolution = decimal(&value("resolution")?)?;
    let occupied = value("occupied_thresh").and_then(|value| decimal(&value));
    let is_negative = value("negate").is_some_and(|value| value == "1" || value == "true");
    (resolution > 0.0).then(|| MapSheet {
        resolution,
        occupied: occupied.unwrap_or(0.65).clamp(0.0, 1.0),
        is_negative,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bytes_and_pairs_of_bytes_are_read() {
        let one = read_pgm(b"P5 2 2 255\n\x00\x0a\xff\x80").unwrap();
        assert_eq!(one.grey, [0, 10, 255, 128], "a pixel may look like a space");
        let two = read_pgm(b"P5\n2 1\n65535\n\x00\x00\xff\xff").unwrap();
        assert_eq!(two.grey, [0, 255]);
    }

    #[test]
    fn what_is_broken_is_refused_with_a_reason() {
        for (bytes, why) in [
            (&b"P6 1 1 255\n..."[..], "expected P2 or P5"),
            (b"P5 2 x 255\n", "three whole numbers"),
            (b"P5 2 2 255\n\x00", "found 1 pixels, expected 2 x 2"),
            (b"P2 0 4 255\n", "found 0 x 4"),
            (b"P5 99999 99999 255\n", "at most"),
            (b"P2 99999999999 1 1\n", "three whole numbers"),
            (b"P2 2 1 1\n0 # only", "found 1 pixels"),
            (b"P5 1 1 0\n\x00", "up to 0"),
        ] {
            let told = read_pgm(bytes).unwrap_err().to_string();
            assert!(told.contains(why), "{told}");
        }
    }

    #[test]
    fn a_sheet_may_be_negative_and_have_comments() {
        let sheet = read_sheet("image: a.pgm\nresolution: 0.1 # m\nnegate: 1\n").unwrap();
        assert!(sheet.is_negative);
        assert!((sheet.resolution - 0.1).abs() < 1e-9 && (sheet.occupied - 0.65).abs() < 1e-9);
        assert_eq!(read_sheet("image: a.pgm\nresolution: -1\n"), None);
    }
}
