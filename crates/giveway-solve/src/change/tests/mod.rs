//! How plans go on around which the world changes.

mod example;
mod fewest;
