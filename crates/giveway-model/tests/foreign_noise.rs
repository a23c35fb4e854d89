//! No file of another planner makes a reader panic, however it is damaged; each
//! fault has a line and a column; and what is read can be gathered and written.
//!
//! The seeds are the samples here and every small file in `data/asprilo` and
//! `data/plans`, so that a new format is covered once it has a sample.
//! `GIVEWAY_RANDOM_TEXTS` says how many texts are tried (20,000; with
//! `GIVEWAY_LONG=1` ten million).

#![allow(
    clippy::unwrap_used,
    clippy::panic,
    reason = "a test stops at the first surprise"
)]

use std::collections::BTreeSet;
use std::path::PathBuf;

use giveway_model::Fault;
use giveway_model::format::foreign::{
    Format, Gathered, Held, MAX_STEPS, Options, Source, Walk, gather, read, write,
};

const MAP: &str = "type octile\nheight 3\nwidth 4\nmap\n....\n.@..\n....\n";
const SCENARIO: &str = "version 1\n0\tm.map\t4\t3\t0\t0\t3\t0\t3\n0\tm.map\t4\t3\t3\t2\t0\t2\t3\n";

/// Files of each format that are read.
const SEEDS: [&str; 13] = [
    MAP,
    SCENARIO,
    r##"{ "giveway": 1, "name": "n", "map": ["..~~", "#+*."], "agents": [
        { "name": "A", "start": [0, 0], "goal": [1, 1] }] }"##,
    r#"{ "giveway": 1, "paths": { "A": [[0, 0], null, [1, 0], [1, 1]] }, "knows": 1 }"#,
    "agents,lower_cost,solution_cost,path\n\"2\",\"6\",\"6\",\"3r\n3l\"\n",
    "map_name,scen_type,type_id,agents,solution_plan,flip_up_down\n\
     \"m\",even,0,2,\"2r1wr\r\nlll\",FALSE\r\nm,even,0,2,,TRUE\r\n",
    r#"[{ "map_name": "m", "scen_type": "even", "type_id": 0, "agents": 2,
        "solution_plan": "3r\n3l" }, { "agents": 1, "solution_plan": ["u"] }]"#,
    "---\nmap_name: \"m\"\nagents: 2\nsolution_plan:\n  - 3r\n  - 'lll'\n---\n\
     agents: 2\nflip_up_down: true\nsolution_plan: |\n  u\n  2dw\n",
    "Agent 0: (0,0)->(0,1)->(0,2)->(0,3)->\nAgent 1: (2,3)->(2,2)->(2,1)->(2,0)->\n",
    "Agent 0:(0,0)->(1,0)->\r\nAgent 1:\r\n",
    "agents=2\nmap_file=m.map\nsolver=planner\nsolved=1\nsoc=6\nmakespan=3\n\
     starts=(0,0),(3,2),\ngoals=(3,0),(0,2),\nsolution=\n0:(0,0),(3,2),\n1:(1,0),(2,2),\n",
    "0:(0,0,X_PLUS),(3,2,Y_MINUS),\n1:(1,0,X_PLUS),(2,2,X_MINUS)",
    "agents=1\ntask=\n0:12->13,appear=0,finished=2\nsolution=\n0:(0,0)->(2,3):-1,\n",
];

/// Bits of files, to be put anywhere.
const BITS: [&str; 24] = [
    "(",
    ")",
    "->",
    ",",
    ":",
    "=",
    "-",
    "\n",
    "\r\n",
    "\"",
    "[",
    "{",
    "}",
    "]",
    "- ",
    "*a",
    "&a ",
    "\u{feff}",
    "\u{e9}",
    "0",
    "99999999999999999999",
    "-1",
    "null",
    "12r",
];

/// Numbers that look random, the same in every run (xorshift64*).
struct Dice(u64);

impl Dice {
    fn below(&mut self, limit: usize) -> usize {
        self.0 ^= self.0 >> 12;
        self.0 ^= self.0 << 25;
        self.0 ^= self.0 >> 27;
        let number = self.0.wrapping_mul(0x2545_F491_4F6C_DD1D) >> 33;
        usize::try_from(number).unwrap() % limit.max(1)
    }

    fn of<'a, T: ?Sized>(&mut self, all: &[&'a T]) -> &'a T {
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

    /// A text damaged in some places, or one of bits alone.
    fn text(&mut self, seeds: &[&str]) -> String {
        if self.below(20) == 0 {
            return (0..self.below(30)).map(|_| self.of(&BITS)).collect();
        }
        let mut text = self.of(seeds).to_owned();
        for _ in 0..=self.below(3) {
            let (from, to) = self.part(&text);
            match self.below(6) {
                0 => text.replace_range(from..to, ""),
                1 => text.insert_str(from, self.of(&BITS)),
                2 => text.replace_range(from..to, self.of(&BITS)),
                3 => text.truncate(to),
                4 => {
                    let copy = text[from..to].to_owned();
                    let place = self.place(&text);
                    text.insert_str(place, &copy);
                }
                _ => {
                    let other = self.of(seeds);
                    let (from, to) = self.part(other);
                    let place = self.place(&text);
                    text.insert_str(place, &other[from..to]);
                }
            }
        }
        text
    }
}

fn number(name: &str) -> Option<u64> {
    let value = std::env::var(name).ok()?;
    Some(
        value
            .parse()
            .unwrap_or_else(|_| panic!("{name} is {value:?}")),
    )
}

/// The text of every small file of a folder of the tests' data, in order.
fn files(folder: &str) -> Vec<String> {
    let folder = PathBuf::from(env!("CARGO_MANIFEST_DIR"))
        .join("tests/data")
        .join(folder);
    let Ok(entries) = std::fs::read_dir(&folder) else {
        return Vec::new();
    };
    let mut paths: Vec<PathBuf> = entries.map(|entry| entry.unwrap().path()).collect();
    paths.sort();
    let texts = paths
        .iter()
        .filter_map(|path| std::fs::read_to_string(path).ok());
    texts.filter(|text| text.len() < 3_000).collect()
}

fn assert_placed(fault: &Fault, text: &str) {
    assert!(
        fault.line.is_some() && fault.column.is_some(),
        "{fault}\n{text}"
    );
    let sentence = fault.to_string();
    assert!(sentence.chars().count() < 400, "{sentence}");
    assert!(!sentence.contains(['\n', '\r']), "{sentence}");
}

fn steps(held: &Held) -> usize {
    let (Held::Plan(plan) | Held::Both(_, plan)) = held else {
        return 0;
    };
    let walks = plan.agents.iter().map(|agent| match &agent.walk {
        Walk::Cells(cells) => cells.len(),
        Walk::Moves(moves) | Walk::Fixed(moves) => moves.len(),
        Walk::Turns(_, actions) => actions.len(),
    });
    walks.sum()
}

/// Reads a text, gathers it with a map and a scenario, and writes what comes out.
fn try_all(text: &str) {
    let held = match read(text) {
        Ok((_, held)) => held,
        Err(faults) => {
            assert!(!faults.is_empty(), "{text}");
            for fault in &faults {
                assert_placed(fault, text);
            }
            return;
        }
    };
    let steps = steps(&held);
    assert!(steps <= MAX_STEPS, "{text}");
    if steps > 2_000 {
        return;
    }
    let source = |name, text| Source { name, text };
    let (own, map, scenario) = (
        source("it", text),
        source("m.map", MAP),
        source("m.scen", SCENARIO),
    );
    for sources in [vec![own], vec![own, map], vec![own, map, scenario]] {
        if let Ok(gathered) = gather(&sources, &Options::default()) {
            write_all(&gathered);
        }
    }
}

fn write_all(gathered: &Gathered) {
    let plan = gathered.plans.first().map(|plan| &plan.plan);
    for format in Format::ALL {
        let _ = write(format, "it", Some(&gathered.instance), plan);
    }
}

#[test]
fn the_seeds_are_read_and_are_of_many_formats() {
    let mut formats = BTreeSet::new();
    for seed in SEEDS {
        match read(seed) {
            Ok((format, _)) => drop(formats.insert(format)),
            Err(faults) => panic!("{faults:?}\n{seed}"),
        }
    }
    assert!(formats.len() >= 5, "{formats:?}");
}

#[test]
fn damaged_files_are_read_without_a_panic() {
    let long = if number("GIVEWAY_LONG").is_some_and(|long| long > 0) {
        10_000_000
    } else {
        20_000
    };
    let all = number("GIVEWAY_RANDOM_TEXTS").unwrap_or(long);
    let more = [files("plans"), files("asprilo")].concat();
    let seeds: Vec<&str> = SEEDS
        .into_iter()
        .chain(more.iter().map(String::as_str))
        .collect();
    let mut dice = Dice(0x0DDB_1A5E_5BAD_5EED);
    for _ in 0..all {
        try_all(&dice.text(&seeds));
    }
}
