//! Runs the command in a folder of its own.

use std::fs;
use std::io::Write as _;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use expect_test::Expect;
use tempfile::TempDir;

pub(crate) const WAREHOUSE: &str = include_str!("data/warehouse.json");
pub(crate) const WAREHOUSE_PLAN: &str = include_str!("data/warehouse.plan.json");
pub(crate) const SCENARIO_1: &str = include_str!("data/scenario-1.json");
pub(crate) const SCENARIO_6: &str = include_str!("data/scenario-6.json");
pub(crate) const EMPTY_MAP: &str = include_str!("data/empty-8-8.map");
pub(crate) const EMPTY_SCEN: &str = include_str!("data/empty-8-8.scen");

/// A folder with files, in which the command is run.
pub(crate) struct Folder {
    dir: TempDir,
}

/// How a run ended.
#[derive(Debug)]
pub(crate) struct Run {
    pub(crate) exit: Option<i32>,
    pub(crate) out: String,
    pub(crate) err: String,
}

impl Folder {
    /// A folder with these files.
    pub(crate) fn with<T: AsRef<[u8]>>(files: &[(&str, T)]) -> Self {
        let dir = tempfile::tempdir().unwrap();
        for (name, text) in files {
            fs::write(dir.path().join(name), text).unwrap();
        }
        Self { dir }
    }

    /// A folder with one instance, `scene.json`.
    pub(crate) fn scene(text: impl AsRef<[u8]>) -> Self {
        Self::with(&[("scene.json", text)])
    }

    pub(crate) fn path(&self, name: impl AsRef<Path>) -> PathBuf {
        self.dir.path().join(name)
    }

    pub(crate) fn read(&self, name: &str) -> String {
        fs::read_to_string(self.path(name)).unwrap()
    }

    /// Runs `giveway` with the words of the line, split at blanks.
    pub(crate) fn run(&self, line: &str) -> Run {
        self.run_with(line, "")
    }

    /// The same with a text on standard input.
    pub(crate) fn run_with(&self, line: &str, input: &str) -> Run {
        self.run_args(line.split_whitespace(), input)
    }

    /// Runs `giveway` with these words, blanks and all.
    pub(crate) fn run_words(&self, words: &[&str]) -> Run {
        self.run_args(words.iter().copied(), "")
    }

    fn run_args<'a>(&self, words: impl Iterator<Item = &'a str>, input: &str) -> Run {
        let mut child = command()
            .args(words)
            .current_dir(self.dir.path())
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .stderr(Stdio::piped())
            .spawn()
            .unwrap();
        // A command that needs no input may be gone by now.
        let _ = child.stdin.take().unwrap().write_all(input.as_bytes());
        let output = child.wait_with_output().unwrap();
        Run {
            exit: output.status.code(),
            out: String::from_utf8(output.stdout).unwrap(),
            err: String::from_utf8(output.stderr).unwrap(),
        }
    }

    /// Runs the command, which must refuse: nothing on standard output, and
    /// `expect` is the exit status and standard error.
    pub(crate) fn refuses(&self, line: &str, expect: &Expect) {
        let run = self.run(line);
        assert_eq!(run.out, "");
        expect.assert_eq(&run.refusal());
    }
}

impl Run {
    /// The exit status and standard error.
    pub(crate) fn refusal(&self) -> String {
        format!("exit {}\n{}", self.exit.unwrap_or(-1), self.err)
    }

    /// Standard output of a run that ended well and said nothing else.
    pub(crate) fn answer(&self) -> &str {
        assert_eq!(
            (self.exit, self.err.as_str()),
            (Some(0), ""),
            "{}",
            self.out
        );
        &self.out
    }

    /// Standard output of a run that ended well, whatever it noted beside.
    pub(crate) fn answer_but_for_notes(&self) -> &str {
        assert_eq!(self.exit, Some(0), "{}", self.err);
        &self.out
    }

    /// The same as JSON.
    pub(crate) fn json(&self) -> serde_json::Value {
        serde_json::from_str(self.answer()).unwrap()
    }
}

/// The command, without what the surroundings may add to it.
pub(crate) fn command() -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_giveway"));
    command.env_remove("CLICOLOR_FORCE");
    command
}

/// An instance of two agents on a map of 4 x 2, with these words replaced.
pub(crate) fn two_agents(replace: &[(&str, &str)]) -> String {
    let mut text = r#"{
  "giveway": 1,
  "name": "two",
  "map": ["..#.", "...."],
  "agents": [
    { "name": "A1", "start": [0, 0], "goal": [3, 1] },
    { "name": "A2", "start": [3, 0], "goal": [0, 1] }
  ]
}
"#
    .to_owned();
    for (old, new) in replace {
        assert!(text.contains(old), "{old}");
        text = text.replacen(old, new, 1);
    }
    text
}
