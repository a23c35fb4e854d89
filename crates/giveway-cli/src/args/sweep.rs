//! The arguments of `giveway sweep` and `giveway table`.

use std::path::PathBuf;

use clap::Args as ClapArgs;
use giveway_sweep::Shard;
use giveway_sweep::table::{Show, Written};

/// A benchmark of many instances, or a part of it.
#[derive(Debug, ClapArgs)]
#[command(after_help = "\
A SPEC says what is combined with what; paths start from its folder, or from --files:
  objectives = [\"sum-of-costs\"]          # by default the instances' own
  planners = [\"search\", \"cbs\"]           # by default search, the best plan with its proof
  time-limit = 30                        # seconds a task; conflict-limit, memory-limit
  clock = \"cpu\"                          # they are CPU seconds; by default wall seconds
  skip-after = 2                         # so many misses in a row end a series
  [[instances]]
  files = [\"maze-32-32-2-*.scen\"]
  agents = { from = 5, to = 50, step = 5 }   # or 20, or [5, 10]; without to: as many as there are
  [[planner]]                            # a planner of others, judged by what it writes; needs a time-limit
  name = \"mine\"
  command = \"mine -m {map} -s {scen} -k {agents} -t {seconds} -o {out}\"
  [certificates]                         # makes and checks certificates of what is proved
  time-limit = 10                        # seconds for each; memory-limit

Each result is one line of JSON in the folder of results, written whole. What is there is not done
again: run the same command once more, and it goes on. Every shard may run on another machine.

Examples
  giveway sweep maze.toml --list | wc -l
  giveway sweep maze.toml --shard 3/64
  giveway table maze-results")]
pub(crate) struct Sweep {
    /// What to do, a file of TOML
    #[arg(value_name = "SPEC")]
    pub(crate) spec: PathBuf,
    /// List the tasks, a line of JSON each, and do nothing
    #[arg(long)]
    pub(crate) list: bool,
    /// Do one part of so many, such as 3/64 [default: all of it]
    #[arg(long, value_name = "I/N", default_value_t = Shard::ALL, hide_default_value = true)]
    pub(crate) shard: Shard,
    /// The folder from which the paths of the spec start [default: the folder of the spec]
    #[arg(long, value_name = "DIR")]
    pub(crate) files: Option<PathBuf>,
    /// The folder of results [default: NAME-results beside NAME.toml]
    #[arg(long, value_name = "DIR")]
    pub(crate) results: Option<PathBuf>,
}

/// Tables and plots of a sweep's results.
#[derive(Debug, ClapArgs)]
#[command(after_help = "\
Examples
  giveway table maze-results
  giveway table maze-results --show rows --to csv > rows.csv
  giveway table maze-results more-results --show cactus --to svg > cactus.svg
  giveway table maze-results --show planners --to html > planners.html")]
pub(crate) struct Table {
    /// Folders of results, or files of them
    #[arg(required = true, value_name = "RESULTS")]
    pub(crate) results: Vec<PathBuf>,
    /// What to show: summary (how many tasks of each map, objective, planner and number of robots
    /// ended how), rows (every result), optima (the bounds of every row that was tried, and its certificate), success (the success rate against the number of robots), cactus (how many within how many CPU seconds each),
    /// planners (what each planner solved, how fast, and how far from what is proved)
    #[arg(long, default_value = "summary", value_name = "WHAT")]
    pub(crate) show: Show,
    /// How it is written: markdown, csv, svg (a plot of success, cactus or planners), or html, a page of planners
    #[arg(long, default_value = "markdown", value_name = "FORMAT")]
    pub(crate) to: Written,
}
