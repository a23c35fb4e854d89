//! Agents that join others on their way: revise, tunnels and replanning.

use std::collections::BTreeSet;
use std::error::Error;
use std::fmt::Write as _;

use cpu_time::ProcessTime;
use giveway_model::change::{Change, Changes, What};
use giveway_model::{Cell, Cost, Objective, Plan, Scene, Version};
use giveway_solve::change::{ChangeRequest, Method, MethodAnswer};
use giveway_solve::{
    Host, Limits, Progress, Request, Response, SilentHost, SolveRequest, Status, serve,
};
use giveway_tests::upheaval::{Field, SIDE, crowd, field};

const METHODS: [Method; 4] = [
    Method::Revise,
    Method::Tunnel(1),
    Method::Tunnel(3),
    Method::Replan,
];
/// The seed of all maps and agents.
const SEED: u64 = 11;
/// Agents that run already.
const RUNNING: usize = 20;
/// When others join.
const AT: u32 = 5;
/// What takes less CPU seconds is counted as so many: clocks are no finer.
const SHORTEST: f64 = 0.001;
/// What a person begins to notice, in CPU seconds.
const NOTICED: f64 = 0.05;
/// The side of a corner.
const CORNER: u32 = 6;

/// A host whose only clock is that of the processor.
struct Clock;

impl Host for Clock {
    fn wall_seconds(&self) -> f64 {
        ProcessTime::try_now().map_or(0.0, |time| time.as_duration().as_secs_f64())
    }

    fn progress(&self, _: &Progress) {}
}

/// A plan that runs, and what has changed so far.
struct Run {
    scene: Scene,
    plan: Plan,
    changes: Changes,
    cells: Vec<Cell>,
}

/// The table, and what it comes to.
///
/// # Errors
/// Where a running plan is not found, or a change is refused.
pub(crate) fn table(seconds: f64) -> Result<String, Box<dyn Error>> {
    let fields = [
        ("empty", Field::Empty),
        ("rooms", Field::Rooms),
        ("random 10 %", Field::Random(10)),
        ("random 20 %", Field::Random(20)),
    ];
    let mut rows = String::new();
    let mut ratios = Vec::new();
    for (name, kind) in fields {
        let (map, cells) = field(kind, SEED);
        for count in [5, 10, 20] {
            let mut run = Run::new(&map, &cells, crowd("A", RUNNING, (&cells, &cells), SEED, 1))?;
            let label = format!("{name}, {count} at once");
            run.join(&label, (AT, count), None, seconds, &mut rows, &mut ratios)?;
        }
        let mut run = Run::new(&map, &cells, crowd("A", RUNNING, (&cells, &cells), SEED, 1))?;
        for step in 1..=5 {
            let label = format!("{name}, 2 more, step {step}");
            run.join(&label, (2 * step, 2), None, seconds, &mut rows, &mut ratios)?;
        }
    }
    let (map, cells) = field(Field::Empty, SEED);
    let far = SIDE - CORNER;
    let near_corner: Vec<Cell> = cells
        .iter()
        .copied()
        .filter(|c| c.x < CORNER && c.y < CORNER)
        .collect();
    let far_corner: Vec<Cell> = cells
        .iter()
        .copied()
        .filter(|c| c.x >= far && c.y >= far)
        .collect();
    let running = crowd("A", RUNNING, (&near_corner, &far_corner), SEED, 1);
    let mut run = Run::new(&map, &cells, running)?;
    let corners = Some((far_corner, near_corner));
    run.join(
        "opposite corners, 20 more",
        (1, 20),
        corners,
        seconds,
        &mut rows,
        &mut ratios,
    )?;
    let all = median(ratios.iter().map(|&(_, ratio)| ratio));
    let slow: Vec<f64> = ratios
        .iter()
        .filter(|(replan, _)| *replan >= NOTICED)
        .map(|&(_, ratio)| ratio)
        .collect();
    let mut text = format!(
        "Where both are proved within {seconds} CPU seconds ({} of the rows), replanning takes {all:.1} times as \
         long as revising in\nthe median; in the {} of these rows in which replanning takes {NOTICED} s or more, \
         {:.1} times.\n\n| joining |",
        ratios.len(),
        slow.len(),
        median(slow.iter().copied()),
    );
    let mut ruler = "| --- |".to_owned();
    for method in METHODS {
        let _ = write!(text, " {method}: s | makespan | sum |");
        ruler.push_str(" ---: | ---: | ---: |");
    }
    Ok(format!("{text} replan / revise |\n{ruler} ---: |\n{rows}"))
}

/// The upper median; 0 of nothing.
fn median(values: impl Iterator<Item = f64>) -> f64 {
    let mut values: Vec<f64> = values.collect();
    values.sort_by(f64::total_cmp);
    values.get(values.len() / 2).copied().unwrap_or(0.0)
}

impl Run {
    fn new(
        map: &[String],
        cells: &[Cell],
        agents: Vec<giveway_model::Agent>,
    ) -> Result<Self, Box<dyn Error>> {
        let scene = Scene {
            map: map.to_vec(),
            agents,
            objective: Objective::new(vec![Cost::Makespan, Cost::SumOfCosts])?,
            ..Scene::default()
        };
        let solve = Request::Solve(SolveRequest {
            scene: scene.clone(),
            limits: Limits {
                conflicts: Some(100_000),
                ..Limits::default()
            },
            ..SolveRequest::default()
        });
        let Response::Solved(solved) = serve(&solve, &SilentHost) else {
            return Err("the running plan was not looked for".into());
        };
        Ok(Self {
            scene,
            plan: solved.plan.ok_or("there is no running plan")?,
            changes: Changes {
                giveway: Version,
                changes: Vec::new(),
            },
            cells: cells.to_vec(),
        })
    }

    /// So many agents join at a time: a row.
    fn join(
        &mut self,
        label: &str,
        (at, count): (u32, usize),
        corners: Option<(Vec<Cell>, Vec<Cell>)>,
        seconds: f64,
        rows: &mut String,
        ratios: &mut Vec<(f64, f64)>,
    ) -> Result<(), Box<dyn Error>> {
        let (starts, goals) = corners.unwrap_or_else(|| (self.cells.clone(), self.cells.clone()));
        let (taken, aimed) = self.occupied(at);
        let free = |cells: Vec<Cell>, taken: &BTreeSet<Cell>| -> Vec<Cell> {
            cells
                .into_iter()
                .filter(|cell| !taken.contains(cell))
                .collect()
        };
        let ends = (free(starts, &taken), free(goals, &aimed));
        let agents = crowd(
            &format!("N{at}-"),
            count,
            (&ends.0, &ends.1),
            SEED,
            u64::from(at) + 2,
        );
        let joining = agents.into_iter().map(|agent| Change {
            at,
            what: What::AddAgent { agent },
        });
        self.changes.changes.extend(joining);
        let request = Request::Change(ChangeRequest {
            scene: self.scene.clone(),
            plan: self.plan.clone(),
            changes: self.changes.clone(),
            since: None,
            methods: METHODS.to_vec(),
            objective: None,
            within: None,
            limits: Limits {
                seconds: Some(seconds),
                ..Limits::default()
            },
        });
        let answer = match serve(&request, &Clock) {
            Response::Changed(answer) => answer,
            Response::Refused(refusal) => return Err(refusal.sentences().join(" ").into()),
            _ => return Err(format!("{label}: no answer").into()),
        };
        let mut row = format!("| {label} |");
        for (_, method) in &answer.methods.0 {
            row.push_str(&cells_of(method));
        }
        let proved = |method| {
            let answer = answer.methods.get(method)?;
            let is_proved = answer.result.status == Status::Optimal;
            is_proved.then_some(answer.result.stats.cpu_seconds)
        };
        if let (Some(revise), Some(replan)) = (proved(Method::Revise), proved(Method::Replan)) {
            let ratio = replan / revise.max(SHORTEST);
            ratios.push((replan, ratio));
            let _ = write!(row, " {ratio:.1} |");
        } else {
            row.push_str(" |");
        }
        eprintln!("{row}");
        rows.push_str(&row);
        rows.push('\n');
        if let Some(plan) = answer
            .adopted()
            .and_then(|method| method.result.plan.clone())
        {
            self.plan = plan;
        }
        Ok(())
    }

    /// Where agents are at a time, and where they end.
    fn occupied(&self, at: u32) -> (BTreeSet<Cell>, BTreeSet<Cell>) {
        let (mut here, mut goals) = (BTreeSet::new(), BTreeSet::new());
        for (name, path) in &self.plan.paths {
            let from = self.plan.from.get(name).copied().unwrap_or(0);
            let last = path.len().saturating_sub(1);
            let now = (at.saturating_sub(from) as usize).min(last);
            here.extend(path.get(now).copied().flatten());
            goals.extend(path.last().copied().flatten());
        }
        (here, goals)
    }
}

/// Seconds, makespan and sum of costs; `*` where agents were freed, `<=` where
/// the time ran out.
fn cells_of(answer: &MethodAnswer) -> String {
    let result = &answer.result;
    let mark = if answer.freed.is_empty() { "" } else { "*" };
    let open = if result.status == Status::Optimal {
        ""
    } else {
        "<= "
    };
    let value = |cost: Cost| {
        let value = result.costs.map(|costs| costs.get(cost));
        value.map_or("none".to_owned(), |value| format!("{open}{value}{mark}"))
    };
    let seconds = result.stats.cpu_seconds;
    format!(
        " {seconds:.3} | {} | {} |",
        value(Cost::Makespan),
        value(Cost::SumOfCosts)
    )
}
