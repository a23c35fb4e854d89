//! How plans go on around which the world changes.

mod causes;
mod example;
mod fewest;
