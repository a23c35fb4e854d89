//! The order in which events can be timed: rotations as one, each after what it waits for.

use std::collections::VecDeque;

use crate::events::Event;

/// Events that begin together: one, or a rotation.
pub(crate) type Unit = Vec<usize>;

/// The event of the same agent before an event.
pub(crate) fn before(events: &[Event], event: usize) -> Option<usize> {
    let it = events.get(event)?;
    (it.visit > 0).then(|| event.saturating_sub(1))
}

/// The events in units, each after those that it waits for.
///
/// # Errors
/// Events that wait for each other, each for the one after it.
pub(crate) fn units(events: &[Event]) -> Result<Vec<Unit>, Vec<usize>> {
    let rotations = rotations(events);
    let mut unit_of: Vec<Option<usize>> = vec![None; events.len()];
    let mut units: Vec<Unit> = Vec::new();
    for rotation in rotations {
        for &event in &rotation {
            if let Some(it) = unit_of.get_mut(event) {
                *it = Some(units.len());
            }
        }
        units.push(rotation);
    }
    for (event, unit) in unit_of.iter_mut().enumerate() {
        if unit.is_none() {
            *unit = Some(units.len());
            units.push(vec![event]);
        }
    }
    let unit_of = |event: usize| unit_of.get(event).copied().flatten().unwrap_or(usize::MAX);
    let mut waits = vec![0_usize; units.len()];
    let mut followers: Vec<Vec<usize>> = vec![Vec::new(); units.len()];
    for (number, unit) in units.iter().enumerate() {
        for &event in unit {
            for earlier in waits_for(events, event) {
                let earlier = unit_of(earlier);
                if earlier == number {
                    continue;
                }
                if let (Some(list), Some(count)) =
                    (followers.get_mut(earlier), waits.get_mut(number))
                {
                    list.push(number);
                    *count += 1;
                }
            }
        }
    }
    let free = waits.iter().enumerate().filter(|(_, count)| **count == 0);
    let mut free: VecDeque<usize> = free.map(|(number, _)| number).collect();
    let mut sorted = Vec::with_capacity(units.len());
    while let Some(number) = free.pop_front() {
        for &follower in followers.get(number).into_iter().flatten() {
            if let Some(count) = waits.get_mut(follower) {
                *count = count.saturating_sub(1);
                if *count == 0 {
                    free.push_back(follower);
                }
            }
        }
        sorted.push(units.get(number).cloned().unwrap_or_default());
    }
    if sorted.len() == units.len() {
        return Ok(sorted);
    }
    let is_stuck = |event: usize| waits.get(unit_of(event)).is_some_and(|&count| count > 0);
    Err(circle(events, &units, &unit_of, &is_stuck))
}

/// The events that an event waits for: that of its own agent before it, and its link.
fn waits_for(events: &[Event], event: usize) -> impl Iterator<Item = usize> + '_ {
    let linked = events.get(event).into_iter().flat_map(|it| &it.after);
    let linked = linked.map(|&(earlier, _)| earlier);
    before(events, event).into_iter().chain(linked)
}

/// The circles of links alone, each from one event to the one that it waits for.
fn rotations(events: &[Event]) -> Vec<Unit> {
    let mut seen = vec![false; events.len()];
    let mut rotations = Vec::new();
    for start in 0..events.len() {
        let mut chain: Vec<usize> = Vec::new();
        let mut next = Some(start);
        while let Some(event) = next
            && seen.get(event) == Some(&false)
        {
            if let Some(it) = seen.get_mut(event) {
                *it = true;
            }
            chain.push(event);
            let mut linked = events.get(event).into_iter().flat_map(|it| &it.after);
            next = linked
                .find(|(_, gap)| *gap == 0)
                .map(|&(earlier, _)| earlier);
        }
        // It is a circle where it comes back to an event of its own.
        let back = next.and_then(|event| chain.iter().position(|&it| it == event));
        if let Some(back) = back {
            rotations.push(chain.split_off(back));
        }
    }
    rotations
}

/// A circle among the events that wait for ever.
fn circle(
    events: &[Event],
    units: &[Unit],
    unit_of: &dyn Fn(usize) -> usize,
    is_stuck: &dyn Fn(usize) -> bool,
) -> Vec<usize> {
    let Some(start) = (0..events.len()).find(|&event| is_stuck(event)) else {
        return Vec::new();
    };
    // From a unit to one that it waits for; the event that waits and the one waited for.
    let step = |unit: usize| {
        let members = units.get(unit).into_iter().flatten();
        let mut waits = members.flat_map(|&event| {
            let earlier = waits_for(events, event).map(move |earlier| (event, earlier));
            earlier.filter(|&(_, earlier)| unit_of(earlier) != unit && is_stuck(earlier))
        });
        waits.next()
    };
    let mut path: Vec<(usize, usize)> = Vec::new();
    let mut unit = unit_of(start);
    loop {
        if let Some(back) = path.iter().position(|&(number, _)| number == unit) {
            let circle = path.split_off(back);
            return circle.into_iter().map(|(_, event)| event).collect();
        }
        let Some((event, earlier)) = step(unit) else {
            return Vec::new();
        };
        path.push((unit, event));
        unit = unit_of(earlier);
    }
}
