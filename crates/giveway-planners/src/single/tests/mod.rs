//! Tables and MDDs of one agent against the rules, step by step.

mod cost_to_go;
mod mdd;

/// One agent each, with slow zones, chargers, waypoints and batteries.
const PICTURES: [&str; 9] = [
    "a . . . A",
    "a ~ ~ ~ A
     . . # . .",
    "a  a! #  A
     .  .  .  a!",
    "aA a! . .",
    "aa! ~ ~Aa!
     ~a! # ~",
    "a . + . A
     battery a 2/3",
    "a . + . . *  ~ A
     . . # . . +a! . .
     battery a 3/5
     floor 1",
    "*a ~ ~ *A
     .  . #  .
     battery a 0/5",
    "+aA . a! .
     +   . .  a!
     battery a 1/7
     vanish",
];
