//! Two robots on one cell make way for each other, so that both are seen.

use std::collections::BTreeMap;
use std::rc::Rc;

use giveway_model::check::Rule;
use giveway_model::{Agent, Cell};

use crate::{Answer, State, inside};

/// A time at which an agent is on one cell with others: its place among them from the
/// left, and how many they are.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Aside {
    time: f64,
    place: usize,
    count: usize,
}

/// How much smaller two robots on one cell are drawn, and how far apart in cells.
const TWO: (f64, f64) = (0.74, 0.44);

/// The broken rules that are looked at.
const MOST_MEETINGS: usize = 1000;

/// Who is on one cell with others, by the rules that a plan of elsewhere or of one's own
/// breaks, or by the conflict of a node that is looked at.
pub(super) fn asides(
    state: &State,
    answer: &Rc<Answer>,
    agents: &[Agent],
) -> BTreeMap<usize, Vec<Aside>> {
    let mut asides: BTreeMap<usize, Vec<Aside>> = BTreeMap::new();
    if state.is_inside()
        && let Some((group, time)) = inside::on_one_cell(state, answer)
    {
        let (time, count) = (f64::from(time), group.len());
        for (place, agent) in group.into_iter().enumerate() {
            asides.insert(agent, vec![Aside { time, place, count }]);
        }
        return asides;
    }
    let plans = state.audit().into_iter().flat_map(|audit| &audit.plans);
    let mut own = plans.filter(|dropped| Rc::ptr_eq(&dropped.answer, answer));
    let led = state.document.mode.steering();
    let led = led.filter(|led| Rc::ptr_eq(&led.answer, answer));
    let of_led = led.into_iter().flat_map(|led| &led.violations);
    let violations = own
        .next()
        .into_iter()
        .flat_map(|dropped| &dropped.violations)
        .chain(of_led);
    let meets = violations
        .filter(|violation| violation.rule == Rule::Vertex)
        .take(MOST_MEETINGS);
    let mut groups: BTreeMap<(u32, Option<Cell>), Vec<usize>> = BTreeMap::new();
    for violation in meets {
        let group = groups.entry((violation.time, violation.cell)).or_default();
        let index = |name: &String| agents.iter().position(|agent| agent.name == *name);
        for agent in violation.agents.iter().filter_map(index) {
            if !group.contains(&agent) {
                group.push(agent);
            }
        }
    }
    for ((time, _), group) in &groups {
        for (place, &agent) in group.iter().enumerate() {
            asides.entry(agent).or_default().push(Aside {
                time: f64::from(*time),
                place,
                count: group.len(),
            });
        }
    }
    asides
}

/// How far an agent makes way at a time: wholly when both are on the cell, and the
/// less the further away that time is.
pub(super) fn aside(times: &[Aside], time: f64) -> Option<(f64, f64)> {
    let share = |aside: &Aside| 1.0 - 2.0 * (time - aside.time).abs();
    let near = times.iter().max_by(|a, b| share(a).total_cmp(&share(b)))?;
    let share = share(near);
    let gaps = near.count.saturating_sub(1).max(1) as f64;
    let side = near.place as f64 / gaps - 0.5;
    // More than two share the room of two.
    let (scale, apart) = (TWO.0 / gaps.sqrt(), TWO.1 * (2.0 - 1.0 / gaps).min(1.3));
    (share > 0.0).then_some((side * apart * share, 1.0 - (1.0 - scale) * share))
}
