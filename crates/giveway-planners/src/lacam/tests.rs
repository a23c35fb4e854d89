//! LaCAM.
