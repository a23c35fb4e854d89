//! The published benchmark (`docs/optima/`): its rows can be so, and are made again.
#![allow(
    clippy::unwrap_used,
    clippy::panic,
    reason = "a test that cannot go on ends with a panic"
)]

use std::collections::BTreeMap;
use std::path::Path;

use giveway_model::Cost;
use giveway_proof::bundle::archive::unpack;
use giveway_proof::bundle::fingerprint;
use giveway_proof::{Budget, verify};
use giveway_solve::SilentHost;
use giveway_sweep::{Folder, Spec, Task, run};

const ROWS: &str = include_str!("../../docs/optima/rows.csv");
const SPEC: &str = include_str!("../../docs/optima/spec.toml");
const CERTIFICATES: &[u8] = include_bytes!("../../docs/optima/certificates.zip");

/// In the usual run so many rows are made again, those with the smallest certificates.
const AGAIN: usize = 8;

/// A row by its columns; no cell has a comma in it.
struct Published(BTreeMap<&'static str, &'static str>);

impl Published {
    fn text(&self, column: &str) -> &'static str {
        self.0[column]
    }

    fn number(&self, column: &str) -> Option<u32> {
        let text = self.text(column);
        (!text.is_empty()).then(|| text.parse().unwrap())
    }

    /// The scenario, the objective and the number of agents.
    fn name(&self) -> String {
        let [scenario, objective, agents] =
            ["scenario", "objective", "agents"].map(|column| self.text(column));
        format!("{scenario}-{agents}-{objective}")
    }
}

fn rows() -> Vec<Published> {
    let mut lines = ROWS.lines();
    let head: Vec<&str> = lines.next().unwrap().split(',').collect();
    let row = |line: &'static str| {
        let cells: Vec<&str> = line.split(',').collect();
        assert_eq!(cells.len(), head.len(), "{line}");
        Published(head.iter().copied().zip(cells).collect())
    };
    lines.map(row).collect()
}

#[test]
fn the_bounds_of_each_row_can_be_so_beside_those_of_fewer_agents() {
    let rows = rows();
    assert!(rows.len() > 300, "{}", rows.len());
    // What fewer agents of the same scenario need at least.
    let mut known: BTreeMap<(&str, &str), (u32, u32)> = BTreeMap::new();
    for row in &rows {
        let name = row.name();
        let (lower, upper) = (row.number("lower bound"), row.number("upper bound"));
        let (lower, status) = (lower.unwrap_or(0), row.text("status"));
        assert!(
            ["optimal", "feasible", "unknown"].contains(&status),
            "{name}"
        );
        assert_eq!(status == "optimal", upper == Some(lower), "{name}");
        assert!(upper.is_none_or(|upper| lower <= upper), "{name}");
        let series = (row.text("scenario"), row.text("objective"));
        let agents = row.number("agents").unwrap();
        let (fewer, least) = known.insert(series, (agents, lower)).unwrap_or((0, 0));
        assert!(
            fewer < agents,
            "{name}: rows come by their agents, once each"
        );
        assert!(upper.is_none_or(|upper| least <= upper), "{name}");
        let is_proved = row.text("certificate") == "proved";
        assert_eq!(
            is_proved,
            row.text("manifest SHA-256").len() == 64,
            "{name}"
        );
        assert!(
            row.text("certificate").is_empty() || status == "optimal",
            "{name}"
        );
    }
}

#[test]
fn rows_are_made_again_with_the_same_certificate() {
    let folder = Folder::new(&Path::new(env!("CARGO_MANIFEST_DIR")).join("data/movingai"));
    let spec = Spec::read(SPEC).unwrap();
    let files = |pattern: &str| folder.files(pattern);
    let tasks = spec.tasks(&files, &|path| folder.agents(path)).unwrap();
    let mut rows = rows();
    rows.retain(|row| row.text("certificate") == "proved");
    rows.sort_by_key(|row| row.number("certificate bytes"));
    let most = match std::env::var_os("GIVEWAY_LONG") {
        Some(_) => rows.len(),
        None => AGAIN,
    };
    for row in rows.iter().take(most) {
        let is_it = |task: &&Task| {
            let objective = task.objective.as_ref().unwrap().to_string();
            let agents = task.agents.map(|agents| agents as u32);
            task.instance == format!("{}.scen", row.text("scenario"))
                && agents == row.number("agents")
                && objective == row.text("objective")
        };
        let task = tasks.iter().find(is_it).unwrap();
        let loaded = folder.load(task).unwrap();
        // No clock: nothing but the size ends the work.
        let made = run(task, &loaded, &SilentHost);
        let name = row.name();
        let cost: Cost = task.objective.as_ref().unwrap().costs()[0];
        assert_eq!(
            made.bounds.get(&cost).copied(),
            row.number("lower bound"),
            "{name}"
        );
        let upper = made.costs.map(|costs| costs.get(cost));
        assert_eq!(upper, row.number("upper bound"), "{name}");
        let certificate = made.certificate.unwrap();
        assert_eq!(
            certificate.manifest.as_deref(),
            Some(row.text("manifest SHA-256")),
            "{name}"
        );
        assert_eq!(
            Some(certificate.bytes as u32),
            row.number("certificate bytes"),
            "{name}"
        );
    }
}

#[test]
fn the_stored_certificates_are_those_of_their_rows_and_hold() {
    assert!(CERTIFICATES.len() < 200_000, "{}", CERTIFICATES.len());
    let rows = rows();
    let bundles = unpack(CERTIFICATES).unwrap();
    assert!(bundles.len() >= 4);
    for (name, bundle) in bundles {
        let row = rows.iter().find(|row| row.name() == name);
        let row = row.unwrap_or_else(|| panic!("no row {name}"));
        let manifest = fingerprint(&bundle["manifest.json"]);
        assert_eq!(manifest, row.text("manifest SHA-256"), "{name}");
        let report = verify(&bundle, &Budget::default());
        assert!(report.accepted, "{name}: {report:?}");
    }
}
