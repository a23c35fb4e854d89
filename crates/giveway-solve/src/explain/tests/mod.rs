//! Reasons, judged by other means than those that found them.

mod ask;
