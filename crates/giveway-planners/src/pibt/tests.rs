//! PIBT.
