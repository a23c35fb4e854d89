//! What moves of a picture, as style: an animation for each thing that changes, all of
//! one length, again and again.

use std::fmt::Write as _;

use super::keys::{Key, bends};

/// How long a step takes, the start is seen before, and the end after it, in seconds.
const STEP: f64 = 0.48;
const LEAD: f64 = 0.6;
const REST: f64 = 1.8;

/// The animations of a picture, as they are found while it is drawn.
pub(crate) struct Motion {
    prefix: String,
    steps: f64,
    /// Names so far.
    count: usize,
    rules: String,
}

/// When a picture is drawn: at a time, or as it moves from time 0 on.
pub(super) enum When<'a> {
    At(f64),
    Moving(&'a mut Motion),
}

impl When<'_> {
    /// The time that the shapes themselves show.
    pub(super) const fn time(&self) -> f64 {
        match self {
            Self::At(time) => *time,
            Self::Moving(_) => 0.0,
        }
    }

    pub(super) const fn moves(&self) -> bool {
        matches!(self, Self::Moving(_))
    }

    /// The class of what changes evenly from key to key, by steps, with a blank before
    /// it; empty where nothing changes or nothing moves.
    pub(super) fn evenly<const N: usize>(
        &mut self,
        keys: impl FnOnce() -> Vec<Key<N>>,
        style: impl Fn([f64; N]) -> String,
    ) -> String {
        match self {
            Self::At(_) => String::new(),
            Self::Moving(motion) => motion.evenly(&keys(), style),
        }
    }

    /// The class of what changes at once, at steps.
    pub(super) fn at_once<T>(
        &mut self,
        values: impl FnOnce() -> Vec<(f64, T)>,
        style: impl Fn(&T) -> String,
    ) -> String {
        match self {
            Self::At(_) => String::new(),
            Self::Moving(motion) => motion.at_once(&values(), style),
        }
    }
}

impl Motion {
    pub(crate) fn new(prefix: &str, steps: u32) -> Self {
        Self {
            prefix: prefix.to_owned(),
            steps: f64::from(steps),
            count: 0,
            rules: String::new(),
        }
    }

    fn evenly<const N: usize>(
        &mut self,
        keys: &[Key<N>],
        style: impl Fn([f64; N]) -> String,
    ) -> String {
        let (Some(first), Some(last)) = (keys.first(), keys.last()) else {
            return String::new();
        };
        let mut all = vec![(-LEAD / STEP, first.1)];
        all.extend_from_slice(keys);
        all.push((self.steps + REST / STEP, last.1));
        let bends = bends(&all);
        if bends.len() < 3 {
            return String::new();
        }
        let mut frames = String::new();
        for (time, values) in bends {
            self.frame(time, &style(values), &mut frames);
        }
        self.rule(&frames, "")
    }

    fn at_once<T>(&mut self, values: &[(f64, T)], style: impl Fn(&T) -> String) -> String {
        let [(_, first), later @ ..] = values else {
            return String::new();
        };
        if later.is_empty() {
            return String::new();
        }
        let mut frames = String::new();
        self.frame(-LEAD / STEP, &style(first), &mut frames);
        for (time, value) in later {
            self.frame(*time, &style(value), &mut frames);
        }
        let end = self.steps + REST / STEP;
        let last = values.last().map(|(_, value)| style(value));
        self.frame(end, &last.unwrap_or_default(), &mut frames);
        self.rule(&frames, ";animation-timing-function:step-end")
    }

    /// The class of a column of numbers, so far apart, that shows one a step.
    pub(super) fn counting(&mut self, apart: f64) -> String {
        let steps = self.steps;
        if steps < 1.0 {
            return String::new();
        }
        let (begin, end) = (self.percent(0.0), self.percent(steps));
        let last = -apart * steps;
        let frames = format!(
            "0%{{transform:none}}{begin}%{{transform:none;animation-timing-function:steps({steps},end)}}\
             {end}%,100%{{transform:translateY({last:.2}px)}}"
        );
        self.rule(&frames, "")
    }

    /// What stands before the shapes: all animations, none of them for those who want
    /// less motion.
    pub(crate) fn style(&self) -> String {
        if self.count == 0 {
            return String::new();
        }
        let (prefix, rules, seconds) = (&self.prefix, &self.rules, self.seconds());
        format!(
            "<style>[class^={prefix}]{{animation:{seconds:.2}s linear infinite}}{rules}\
             @media(prefers-reduced-motion:reduce){{[class^={prefix}]{{animation:none}}}}</style>"
        )
    }

    /// How long all of it takes, in seconds.
    fn seconds(&self) -> f64 {
        LEAD + self.steps * STEP + REST
    }

    fn percent(&self, time: f64) -> String {
        let percent = (LEAD + time * STEP) / self.seconds() * 100.0;
        let text = format!("{:.4}", percent.clamp(0.0, 100.0));
        text.trim_end_matches('0').trim_end_matches('.').to_owned()
    }

    fn frame(&self, time: f64, style: &str, frames: &mut String) {
        // Writing to a string cannot fail.
        let _ = write!(frames, "{}%{{{style}}}", self.percent(time));
    }

    fn rule(&mut self, frames: &str, more: &str) -> String {
        let name = format!("{}-{}", self.prefix, self.count);
        self.count += 1;
        // The class weighs more than the rule for all, and less than the one for those
        // who want less motion, which comes later.
        let _ = write!(
            self.rules,
            ".{name}{{animation-name:{name}{more}}}@keyframes {name}{{{frames}}}"
        );
        format!(" class=\"{name}\"")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_animation_lasts_from_the_start_to_the_rest() {
        let mut motion = Motion::new("p", 5);
        let class = motion.evenly(&[(0.0, [0.0]), (5.0, [500.0])], |[x]| format!("x:{x}"));
        assert_eq!(class, " class=\"p-0\"");
        // 0.6, 2.4 and 1.8 seconds.
        assert_eq!(
            motion.rules,
            ".p-0{animation-name:p-0}@keyframes p-0{0%{x:0}12.5%{x:0}62.5%{x:500}100%{x:500}}"
        );
        assert!(motion.style().contains("animation:4.80s linear infinite"));
    }

    #[test]
    fn what_never_changes_has_no_animation() {
        let mut motion = Motion::new("p", 5);
        assert_eq!(
            motion.evenly(&[(0.0, [7.0]), (5.0, [7.0])], |_| String::new()),
            ""
        );
        assert_eq!(motion.at_once(&[(0.0, 1)], |_| String::new()), "");
        assert_eq!(motion.style(), "");
    }

    #[test]
    fn those_who_want_less_motion_get_none() {
        let mut motion = Motion::new("p", 1);
        motion.counting(10.0);
        let style = motion.style();
        assert!(style.ends_with(
            "@media(prefers-reduced-motion:reduce){[class^=p]{animation:none}}</style>"
        ));
    }
}
