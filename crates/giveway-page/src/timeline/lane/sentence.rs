//! A lane in words.

use super::{Lane, Way};
use crate::words;

impl Lane {
    /// The lane in one sentence, for those who do not see it.
    pub fn sentence(&self) -> String {
        let mut parts = vec![words::count(self.moves(), "move")];
        match self.count(Way::Slow) {
            0 => {}
            slow => parts.push(format!("{slow} of them slow")),
        }
        match self.count(Way::Wait) {
            0 => {}
            waits => parts.push(words::count(waits, "wait")),
        }
        if !self.charges.is_empty() {
            parts.push(format!("charges at {}", list(&self.charges)));
        }
        if self.begins > 0 {
            parts.insert(0, format!("joins at {}", self.begins));
        }
        parts.push(match self.removed {
            Some(time) => format!("is removed at {time}"),
            None if self.arrives => format!("arrives at {}", self.arrival),
            None => format!("led up to {}", self.arrival),
        });
        format!("{}: {}", self.name, parts.join(", "))
    }
}

/// `3, 7 and 13`.
fn list(times: &[u32]) -> String {
    let text = |time: &u32| time.to_string();
    match times {
        [] => String::new(),
        [only] => text(only),
        [first @ .., last] => {
            let first: Vec<String> = first.iter().map(text).collect();
            format!("{} and {last}", first.join(", "))
        }
    }
}

#[cfg(test)]
mod tests {
    use super::list;

    #[test]
    fn times_in_words() {
        assert_eq!(list(&[]), "");
        assert_eq!(list(&[3]), "3");
        assert_eq!(list(&[3, 13]), "3 and 13");
        assert_eq!(list(&[3, 7, 13]), "3, 7 and 13");
    }
}
