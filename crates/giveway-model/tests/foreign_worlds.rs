//! Files of other planners that hold worlds of their own: asprilo, the League of
//! Robot Runners, mapfw and libMultiRobotPlanning.

#[path = "foreign/asprilo.rs"]
mod asprilo;
#[path = "foreign/support.rs"]
mod support;
