//! Sweeps: benchmarks of many instances, agents, objectives and planners.
//!
//! A [`Spec`] says what is combined with what, [`Spec::tasks`] lists the combinations,
//! [`run()`] does one [`Task`] and gives one [`Row`], which is one line of JSON. Rows are
//! kept in a folder, a file a shard ([`Results`]); what has a row is not done again.
//! [`mod@table`] makes tables and plots of them. There is no scheduler here: a shard is one
//! process, and whoever has a cluster starts as many of them as it likes.
//!
//! ```
//! use giveway_sweep::{Shard, Spec};
//! let spec = Spec::read(
//!     r#"
//!     time-limit = 30
//!     [[instances]]
//!     files = ["maze-32-32-2-*.scen"]
//!     agents = { from = 5, to = 20, step = 5 }
//!     "#,
//! )?;
//! let files = |_: &str| Ok(vec!["maze-32-32-2-even-1.scen".to_owned()]);
//! let tasks = spec.tasks(&files, &|_: &str| Ok(20))?;
//! assert_eq!(tasks.len(), 4);
//! let shard: Shard = "2/4".parse().map_err(|error| giveway_model::Fault::at("shard", error, "I/N"))?;
//! assert_eq!(spec.part(&tasks, shard).len(), 1);
//! # Ok::<(), giveway_model::Fault>(())
//! ```

mod agents;
mod certificate;
mod clock;
mod folder;
mod method;
mod patience;
mod planner;
mod read;
mod results;
mod row;
mod run;
mod shard;
mod spec;
pub mod table;
mod task;

pub use agents::Agents;
pub use certificate::{Certificates, RowCertificate};
pub use clock::Clock;
pub use folder::{Folder, Loaded};
pub use method::Method;
pub use patience::Patience;
pub use planner::PlannerSpec;
pub use read::{Unreadable, read};
pub use results::{Results, line};
pub use row::{Failure, Row, RowStatus, Took};
pub use run::run;
pub use shard::Shard;
pub use spec::{Instances, Spec};
pub use task::Task;
