//! Texts that look random, the same in every run: whole files, damaged.

/// Bits of files, to be put anywhere.
const BITS: [&str; 30] = [
    "(", ")", "->", ",", ":", "=", "-", "\n", "\r\n", "\"", "[", "{", "}", "]", "- ", "*a", "&a ",
    "\u{feff}", "\u{e9}", "0", "null", "12r", " ", "\t", "  ", "#", "%*", ".", "\\", "!!str ",
];

/// Numbers to be put where one is.
const NUMBERS: [&str; 14] = [
    "0",
    "1",
    "2",
    "3",
    "-1",
    "01",
    "1.0",
    "2048",
    "2049",
    "10001",
    "24000001",
    "2147483647",
    "2147483648",
    "99999999999999999999",
];

/// Letters to be put where one is.
const LETTERS: [&str; 14] = [
    "F", "R", "C", "W", "T", "U", "D", "L", "E", "N", "S", "x", "y", "",
];

/// Numbers that look random, the same in every run (xorshift64*).
pub(crate) struct Dice(u64);

impl Dice {
    pub(crate) const fn new(seed: u64) -> Self {
        // A state of 0 would stay so.
        Self(seed.wrapping_mul(0x9E37_79B9_7F4A_7C15) ^ 0x0DDB_1A5E_5BAD_5EED | 1 << 63)
    }

    pub(crate) fn below(&mut self, limit: usize) -> usize {
        self.0 ^= self.0 >> 12;
        self.0 ^= self.0 << 25;
        self.0 ^= self.0 >> 27;
        let number = self.0.wrapping_mul(0x2545_F491_4F6C_DD1D) >> 33;
        usize::try_from(number).unwrap() % limit.max(1)
    }

    pub(crate) fn of<'a, T: ?Sized>(&mut self, all: &[&'a T]) -> &'a T {
        all[self.below(all.len())]
    }

    /// A boundary of the text's characters.
    fn place(&mut self, text: &str) -> usize {
        let mut place = self.below(text.len() + 1);
        while !text.is_char_boundary(place) {
            place -= 1;
        }
        place
    }

    fn part(&mut self, text: &str) -> (usize, usize) {
        let (one, other) = (self.place(text), self.place(text));
        // Most parts are short.
        let (from, to) = (one.min(other), one.max(other));
        let mut end = to.min(from + 1 + self.below(40));
        while !text.is_char_boundary(end) {
            end += 1;
        }
        (from, end.min(to))
    }

    /// The whole number that comes next behind some place.
    fn number(&mut self, text: &str) -> Option<(usize, usize)> {
        let is_digit = |c: char| c.is_ascii_digit();
        let place = self.place(text);
        let from = place + text[place..].find(is_digit)?;
        let length = text[from..].find(|c| !is_digit(c));
        Some((from, length.map_or(text.len(), |length| from + length)))
    }

    /// The line around some place, with its end.
    fn line(&mut self, text: &str) -> (usize, usize) {
        let place = self.place(text);
        let from = text[..place].rfind('\n').map_or(0, |end| end + 1);
        let end = text[place..].find('\n');
        (from, end.map_or(text.len(), |end| place + end + 1))
    }

    /// A seed of one of the groups, damaged in some places, or a text of bits alone.
    pub(crate) fn text(&mut self, groups: &[Vec<&str>]) -> String {
        if self.below(30) == 0 {
            return (0..self.below(30)).map(|_| self.of(&BITS)).collect();
        }
        let seeds = &groups[self.below(groups.len())];
        let mut text = self.of(seeds).to_owned();
        for _ in 0..=self.below(3) {
            self.damage(&mut text, seeds);
        }
        text
    }

    fn damage(&mut self, text: &mut String, seeds: &[&str]) {
        let (from, to) = self.part(text);
        // Most damage makes JSON no JSON, which is all that its readers say of it.
        let is_json = text.starts_with(['{', '[']);
        let kind = match self.below(10) {
            ..5 if is_json => 5 + self.below(2),
            kind => kind,
        };
        match kind {
            0 => text.replace_range(from..to, ""),
            1 => text.insert_str(from, self.of(&BITS)),
            2 => text.replace_range(from..to, self.of(&BITS)),
            3 => text.truncate(to),
            4 => {
                let copy = text[from..to].to_owned();
                let place = self.place(text);
                text.insert_str(place, &copy);
            }
            5 | 6 => {
                if let Some((from, to)) = self.number(text) {
                    text.replace_range(from..to, self.of(&NUMBERS));
                }
            }
            7 if is_json => {
                let letters: Vec<usize> = text
                    .match_indices(|c: char| c.is_ascii_alphabetic())
                    .map(|(place, _)| place)
                    .collect();
                if let Some(&place) = letters.get(self.below(letters.len())) {
                    text.replace_range(place..=place, self.of(&LETTERS));
                }
            }
            7 => {
                // A line elsewhere, and perhaps here, too.
                let (from, to) = self.line(text);
                let line = text[from..to].to_owned();
                if self.below(2) == 0 {
                    text.replace_range(from..to, "");
                }
                let (place, _) = self.line(text);
                text.insert_str(place, &line);
            }
            _ => {
                let other = self.of(seeds);
                let (from, to) = self.part(other);
                let place = self.place(text);
                text.insert_str(place, &other[from..to]);
            }
        }
    }
}
