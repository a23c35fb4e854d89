//! What varisat takes from the package of this name, but with sets in order.
//!
//! varisat gives a new variable the first free number of such a set. In a hash
//! set, which one is first depends on how wide a machine's words are: a browser
//! would search in another order than the command, and find other plans. The
//! workspace puts this in the place of the package (`[patch]` in its manifest).

use std::collections::BTreeSet;

/// A map that varisat only looks things up in.
#[expect(
    clippy::disallowed_types,
    reason = "its hasher is fixed, and varisat only looks things up in it"
)]
pub type FxHashMap<K, V> = std::collections::HashMap<K, V, hashers::FxBuildHasher>;

/// A set in order.
pub type FxHashSet<T> = BTreeSet<T>;
