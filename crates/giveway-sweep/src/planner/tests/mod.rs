//! Small shell scripts as planners: one that works, and each way to fail.

mod killed;

use std::fs;
use std::path::Path;

use giveway_model::format::native::read_instance;
use giveway_solve::{Limits, Progress};

use super::*;
use crate::{Clock, Failure, RowStatus};

/// Two robots side by side: each goes two cells to the right.
const SCENE: &str = r#"{ "giveway": 1, "map": ["...", "..."],
    "agents": [{ "name": "a", "start": [0, 0], "goal": [2, 0] },
               { "name": "b", "start": [0, 1], "goal": [2, 1] }] }"#;
const STEPS: &str = r"solution=\n0:(0,0),(0,1),\n1:(1,0),(1,1),\n2:(2,0),(2,1),\n";

/// A clock that stands still until a file is there; then every limit is over.
struct Until<'a> {
    file: &'a Path,
    cancels: bool,
}

impl Host for Until<'_> {
    fn wall_seconds(&self) -> f64 {
        if !self.cancels && self.file.exists() {
            1e9
        } else {
            0.0
        }
    }

    fn cancelled(&self) -> bool {
        self.cancels && self.file.exists()
    }

    fn progress(&self, _: &Progress) {}
}

/// A task, its planner, and the folder in which that runs.
struct Case {
    task: Task,
    spec: PlannerSpec,
    loaded: Loaded,
    folder: tempfile::TempDir,
}

impl Case {
    /// A script as planner: `$0` is the map, `$1` the scenario, `$2` the file to write.
    fn script(script: &str) -> Self {
        assert!(!script.contains(['\'', '{', '}']));
        Self::new(&format!(
            "sh -c '{script}' {{map}} {{scen}} {{out}} {{agents}} {{seconds}}"
        ))
    }

    fn new(command: &str) -> Self {
        let folder = tempfile::tempdir().unwrap();
        let spec = PlannerSpec {
            name: "mine".to_owned(),
            command: command.to_owned(),
            about: Some("a script".to_owned()),
        };
        let task = Task {
            instance: "a.json".to_owned(),
            agents: None,
            objective: None,
            planner: spec.method(),
            command: Some(spec.clone()),
            limits: Limits {
                seconds: Some(2.5),
                ..Limits::default()
            },
            clock: Clock::Wall,
            certificate: None,
        };
        let loaded = Loaded {
            folder: folder.path().to_owned(),
            ..Loaded::of(read_instance(SCENE).unwrap())
        };
        Self {
            task,
            spec,
            loaded,
            folder,
        }
    }

    /// Its row; nobody stops it.
    fn row(&self) -> Row {
        let file = Path::new("/nowhere");
        let cancels = false;
        row(
            &self.task,
            &self.spec,
            &self.loaded,
            &Until { file, cancels },
        )
    }

    /// Why it failed.
    fn failure(&self) -> (Failure, String) {
        let row = self.row();
        assert_eq!(
            (row.status, row.costs),
            (RowStatus::Failed, None),
            "{row:?}"
        );
        (row.failure.unwrap(), row.reason.unwrap())
    }

    fn path(&self, name: &str) -> std::path::PathBuf {
        self.folder.path().join(name)
    }
}

fn failure(script: &str) -> (Failure, String) {
    Case::script(script).failure()
}

#[test]
fn a_legal_plan_with_the_cost_that_it_says_is_solved() {
    for header in ["", r"soc=4\nmakespan=2\n"] {
        let row = Case::script(&format!("printf \"{header}{STEPS}\" >\"$2\"")).row();
        assert_eq!(row.status, RowStatus::Feasible, "{row:?}");
        assert_eq!(row.costs.unwrap().sum_of_costs, 4);
        assert_eq!((row.failure, row.reason.as_deref()), (None, None));
        assert_eq!(row.about.as_deref(), Some("a script"));
        assert!(row.is_success() && row.agents == Some(2));
    }
    // As EECBS writes it, the row of a cell first.
    let paths = r"Agent 0: (0,0)->(0,1)->(0,2)->\nAgent 1: (1,0)->(1,1)->(1,2)->\n";
    let row = Case::script(&format!("printf \"{paths}\" >\"$2\"")).row();
    assert_eq!(row.status, RowStatus::Feasible, "{row:?}");
}

#[test]
fn it_gets_what_is_judged_in_the_folder_of_the_spec() {
    let case = Case::script("cat \"$0\" \"$1\" >got; echo \"$3 $4\" >>got");
    case.row();
    let got = fs::read_to_string(case.path("got")).unwrap();
    let map = "type octile\nheight 2\nwidth 3\nmap\n...\n...\n";
    let route = |y: u32| format!("0\tinstance.map\t3\t2\t0\t{y}\t2\t{y}\t0\n");
    let scen = format!("version 1\n{}{}", route(0), route(1));
    assert_eq!(got, format!("{map}{scen}2 2.5\n"));
    let program = Case::new("./own.sh {map} {out}");
    let text = format!("#!/bin/sh\nprintf '{STEPS}' >\"$2\"\n");
    fs::write(program.path("own.sh"), text).unwrap();
    let made = std::process::Command::new("chmod")
        .arg("+x")
        .arg(program.path("own.sh"))
        .status();
    assert!(made.unwrap().success());
    assert_eq!(program.row().status, RowStatus::Feasible);
}

#[test]
fn one_that_crashes_is_told_with_its_last_line() {
    let (kind, how) = failure("echo good >&2; echo bad luck >&2; exit 7");
    assert_eq!(kind, Failure::Crashed);
    assert!(
        how.starts_with("exit 7 after ") && how.ends_with(": bad luck"),
        "{how}"
    );
    let (kind, how) = failure(&format!("printf \"{STEPS}\" >\"$2\"; kill -9 $$"));
    assert_eq!(kind, Failure::Crashed, "whatever it wrote before");
    assert!(how.starts_with("killed by signal 9"), "{how}");
}

#[test]
fn a_wrong_cost_and_a_plan_that_breaks_a_rule_are_told() {
    let (kind, how) = failure(&format!("printf \"soc=5\\n{STEPS}\" >\"$2\""));
    assert_eq!(kind, Failure::WrongCost);
    assert_eq!(how, "says sum of costs 5, the plan has 4");
    let (kind, how) = failure(&format!("printf \"soc=6\\n{STEPS}\" >\"$2\""));
    assert_eq!(kind, Failure::WrongCost);
    assert!(how.contains("number of cells of all paths"), "{how}");
    let illegal = STEPS.replace("1:(1,0),", "1:(0,0),");
    let (kind, how) = failure(&format!("printf \"{illegal}\" >\"$2\""));
    assert_eq!(kind, Failure::Illegal);
    assert!(how.starts_with("a ") && how.contains("(2, 0)"), "{how}");
}

#[test]
fn what_is_no_plan_is_nothing_or_unreadable() {
    assert_eq!(
        failure("true"),
        (Failure::Nothing, "wrote no plan".to_owned())
    );
    let (kind, how) = failure("printf \"agents=2\\nsolved=0\\nsolution=\\n\" >\"$2\"");
    assert_eq!(kind, Failure::Nothing, "{how}");
    for (script, expected) in [
        ("echo good morning >\"$2\"", "found"),
        ("mkfifo \"$2\"", "ordinary file"),
        ("echo x >x; ln -s \"$PWD/x\" \"$2\"", "a link"),
        ("head -c 64000001 /dev/zero >\"$2\"", "more than 64 MB"),
        ("cp \"$0\" \"$2\"", ""),
        (
            "printf \"solution=\\n0:(0,0),(0,1),(2,1),\\n\" >\"$2\"",
            "robots",
        ),
    ] {
        let (kind, how) = failure(script);
        assert_eq!(kind, Failure::Unreadable, "{script}: {how}");
        assert!(how.contains(expected), "{how}");
    }
}

#[test]
fn what_a_planner_would_not_know_and_a_missing_program_are_no_failures() {
    let mut case = Case::script("true");
    let scene = SCENE.replace("\"...\", \"...\"", "\".~.\", \"...\"");
    let goal = "\"goal\": [2, 0]";
    let scene = scene.replace(goal, &format!("{goal}, \"waypoints\": [[1, 1]]"));
    case.loaded.instance = read_instance(&scene).unwrap();
    let row = case.row();
    assert_eq!((row.status, row.failure), (RowStatus::Refused, None));
    let reason = row.reason.unwrap();
    assert!(
        reason.contains("the slow zone (1 cell), the waypoints of 1 robot"),
        "{reason}"
    );
    let row = Case::new("./no-such-planner {map} {out}").row();
    assert_eq!(row.status, RowStatus::Error);
    assert!(
        row.reason
            .unwrap()
            .contains("no-such-planner cannot be run")
    );
}
