//! A lane in words.

use giveway_model::tr;

use super::{Lane, Way};

impl Lane {
    /// The lane in one sentence, for those who do not see it.
    pub fn sentence(&self) -> String {
        let mut parts = vec![tr!("{n} move" | "{n} moves" % self.moves())];
        match self.count(Way::Slow) {
            0 => {}
            slow => parts.push(tr!("{slow} of them slow", slow)),
        }
        match self.waits() {
            0 => {}
            waits => parts.push(tr!("{n} wait" | "{n} waits" % waits)),
        }
        match self.turns() {
            0 => {}
            turns => parts.push(tr!("{turns} of them to turn", turns)),
        }
        match self.count(Way::Stay) {
            0 => {}
            stays => parts.push(tr!("{stays} of them for a stay", stays)),
        }
        match self.count(Way::Broken) {
            0 => {}
            broken if broken == self.waits() => {
                parts.push(tr!("all of them broken down").to_owned());
            }
            broken => parts.push(tr!("{broken} of them broken down", broken)),
        }
        if !self.charges.is_empty() {
            parts.push(tr!("charges at {times}", times = list(&self.charges)));
        }
        if self.begins > 0 {
            parts.insert(0, tr!("joins at {time}", time = self.begins));
        }
        parts.push(match self.removed {
            Some(_) if let Some((time, cell)) = self.stopped => tr!(
                "breaks down for good at {cell} at {time}",
                cell = crate::words::at(cell),
                time
            ),
            Some(time) => tr!("is removed at {time}", time),
            None if self.arrives => tr!("arrives at {time}", time = self.arrival),
            None => tr!("led up to {time}", time = self.arrival),
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
            tr!("list" => "{list} and {last}", list = first.join(", "), last)
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
