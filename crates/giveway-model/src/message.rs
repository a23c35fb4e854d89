//! Maps as messages between programs have them.

use borsh::io::{Read, Result};
use std::collections::BTreeMap;

use borsh::BorshDeserialize;

/// Reads what borsh writes of a map, entry by entry.
///
/// Its own reader makes a list and sorts it, though it is in order already; code
/// to sort each type of entry would weigh more in a page than all maps do.
///
/// # Errors
/// When the bytes are no such map.
pub fn read_map<K, V, R>(reader: &mut R) -> Result<BTreeMap<K, V>>
where
    K: BorshDeserialize + Ord,
    V: BorshDeserialize,
    R: Read,
{
    let mut map = BTreeMap::new();
    for _ in 0..u32::deserialize_reader(reader)? {
        let key = K::deserialize_reader(reader)?;
        map.insert(key, V::deserialize_reader(reader)?);
    }
    Ok(map)
}
