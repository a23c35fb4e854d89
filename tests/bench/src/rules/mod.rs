//! Rules of a scene's own: what each kind adds to the work on graded and standard scenes.

mod scenes;

use std::error::Error;
use std::fmt::Write as _;
use std::fs;
use std::path::{Path, PathBuf};

use giveway_model::format::native;
use giveway_model::{Objective, Scene};
use giveway_solve::Status;

use crate::rows::{Row, data, graded_file};
use crate::run::{Command, Outcome};
use scenes::Added;

const GRADED: [&str; 8] = ["A05", "A10", "A14", "A16", "B10", "B16", "B20", "B22"];
const STANDARD: [(&str, usize); 8] = [
    ("random-32-32-20", 30),
    ("random-32-32-20", 50),
    ("room-32-32-4", 20),
    ("room-32-32-4", 30),
    ("maze-32-32-2", 10),
    ("maze-32-32-2", 20),
    ("warehouse-10-20-10-2-1", 40),
    ("warehouse-10-20-10-2-1", 80),
];
/// CPU seconds that count as more than nothing: starting the process takes as long.
const SHORTEST: f64 = 0.005;

/// A scene without rules, and the objective.
struct Base {
    name: String,
    scene: Scene,
    objective: Objective,
}

/// The table: rows whose names hold one of the parts, or all.
///
/// # Errors
/// Where the command cannot be run or does not answer as documented.
pub(crate) fn table(command: &Command, parts: &[String]) -> Result<String, Box<dyn Error>> {
    let folder = tempfile::tempdir()?;
    let mut text = "| scene | without |".to_owned();
    for added in Added::ALL {
        let _ = write!(text, " {} |", added.head());
    }
    text.push_str("\n| --- |");
    text.push_str(&" ---: |".repeat(1 + Added::ALL.len()));
    text.push('\n');
    let mut ratios = vec![Vec::new(); Added::ALL.len()];
    for (name, file, agents, objective) in sources()? {
        if !parts.is_empty() && !parts.iter().any(|part| name.contains(part)) {
            continue;
        }
        let scene = read(command, &file, agents)?;
        let base = Base {
            name,
            scene,
            objective,
        };
        push_row(&mut text, &base, command, folder.path(), &mut ratios)?;
    }
    text.push('\n');
    for (added, ratios) in Added::ALL.into_iter().zip(&mut ratios) {
        ratios.sort_by(f64::total_cmp);
        let median = ratios.get(ratios.len() / 2);
        if let (Some(median), Some(most)) = (median, ratios.last()) {
            let (head, count) = (added.head(), ratios.len());
            let _ = writeln!(
                text,
                "{head}: where both are settled ({count} scenes), {median:.1} times as long in the median, {most:.1} \
                 times at most.\n"
            );
        }
    }
    Ok(text)
}

type Source = (String, PathBuf, Option<usize>, Objective);

fn sources() -> Result<Vec<Source>, Box<dyn Error>> {
    let mut sources = Vec::new();
    for name in GRADED {
        let (stem, file) = graded_file(name)?;
        sources.push((stem, file, None, Objective::default()));
    }
    for (map, agents) in STANDARD {
        let file = data(&format!("movingai/{map}-random-1.scen"));
        let name = format!("{map}, {agents} agents");
        sources.push((name, file, Some(agents), "sum-of-costs".parse()?));
    }
    Ok(sources)
}

/// A scene of our own format, or of another one by way of the command.
fn read(command: &Command, file: &Path, agents: Option<usize>) -> Result<Scene, Box<dyn Error>> {
    let text = match agents {
        None => fs::read_to_string(file)?,
        Some(agents) => {
            let file = file.display().to_string();
            let agents = agents.to_string();
            command.output(&["convert", &file, "--agents", &agents, "--to", "giveway"])?
        }
    };
    let instance =
        native::read_instance(&text).map_err(|faults| format!("{}: {faults:?}", file.display()))?;
    Ok(instance.to_scene())
}

fn push_row(
    text: &mut String,
    base: &Base,
    command: &Command,
    folder: &Path,
    ratios: &mut [Vec<f64>],
) -> Result<(), Box<dyn Error>> {
    let file = folder.join("scene.json");
    let run = |scene: &Scene, name: String| -> Result<Cell, Box<dyn Error>> {
        fs::write(&file, serde_json::to_string(scene)?)?;
        let row = Row {
            name,
            file: file.clone(),
            agents: None,
            objective: base.objective.clone(),
            known: Vec::new(),
        };
        let outcome = command.run(&row)?;
        eprintln!("{}", outcome.line());
        Ok(Cell::of(&outcome))
    };
    let without = run(&base.scene, base.name.clone())?;
    let _ = write!(text, "| {} | {} |", base.name, without.shown(None));
    let grid = giveway_model::Grid::from_rows(&base.scene.map)
        .map_err(|error| format!("{}: {error:?}", base.name))?;
    for (added, ratios) in Added::ALL.into_iter().zip(ratios) {
        let Some(plan) = &without.plan else {
            text.push_str(" - |");
            continue;
        };
        let scene = added.to_scene(&base.scene, &grid, plan);
        let cell = run(&scene, format!("{}, {}", base.name, added.head()))?;
        let _ = write!(text, " {} |", cell.shown(Some(&without)));
        if without.is_settled && cell.is_settled {
            ratios.push(cell.ratio(&without));
        }
    }
    text.push('\n');
    Ok(())
}

/// What one run came to.
struct Cell {
    seconds: f64,
    status: Status,
    is_settled: bool,
    plan: Option<giveway_model::Plan>,
}

impl Cell {
    fn of(outcome: &Outcome) -> Self {
        let status = outcome.answer.status;
        Self {
            seconds: outcome.cpu_seconds,
            is_settled: matches!(status, Status::Optimal | Status::Impossible),
            status,
            plan: outcome.answer.plan.clone(),
        }
    }

    fn ratio(&self, without: &Self) -> f64 {
        self.seconds.max(SHORTEST) / without.seconds.max(SHORTEST)
    }

    /// The CPU seconds, and how many times as many as without rules; how it ended, where
    /// that is not by an optimum.
    fn shown(&self, without: Option<&Self>) -> String {
        let seconds = format!("{:.3}", self.seconds);
        let note = match self.status {
            Status::Optimal => None,
            Status::Feasible => Some("not proved"),
            Status::Impossible => Some("no plan exists"),
            Status::Unknown => Some("no plan found"),
        };
        let ratio = without.map(|without| format!("{:.1}x", self.ratio(without)));
        let notes: Vec<&str> = ratio.as_deref().into_iter().chain(note).collect();
        if notes.is_empty() {
            seconds
        } else {
            format!("{seconds} ({})", notes.join(", "))
        }
    }
}
