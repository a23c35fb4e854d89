//! Why no plan can keep a rule, as far as that is seen at once: by starts, goals and waypoints;
//! and the robots for which it could hold.

use giveway_model::condition::Times;
use giveway_model::constraint::{ConstraintKind, meant};
use giveway_model::words::and;
use giveway_model::{Agent, AtGoal, Cell, Constraint, Scene, tr};

/// Among more robots no pairs are looked at.
const PAIRED: usize = 500;

/// Why no plan can keep a rule.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Never {
    /// Why, as a sentence.
    pub(crate) why: String,
    /// The robots that keep every plan from it.
    robots: Vec<String>,
}

/// The rule for all robots but those that keep every plan from it, with the names of these; `None`
/// where it can be kept, where that is not seen at once, or where no robot would be left.
pub(super) fn but_some(scene: &Scene, rule: &Constraint) -> Option<(Constraint, Vec<String>)> {
    let (mut rule, mut left_out) = (rule.clone(), Vec::new());
    while let Some(never) = never(scene, &rule) {
        let rest = bound(scene, &rule).map(|agent| &agent.name);
        let rest = rest.filter(|name| !never.robots.contains(name));
        let rest: Vec<String> = rest.cloned().collect();
        rule.agents = Some(rest);
        left_out.extend(never.robots);
    }
    let has_robots = rule.agents.as_ref().is_some_and(|names| !names.is_empty());
    (has_robots && !left_out.is_empty()).then_some((rule, left_out))
}

/// Why no plan can keep a rule; nothing where that is not seen at once.
pub(crate) fn never(scene: &Scene, rule: &Constraint) -> Option<Never> {
    match &rule.kind {
        ConstraintKind::Capacity { zone, most, times } => {
            in_zone(scene, rule, zone, *most as usize, *times)
        }
        ConstraintKind::Closed { zone, times } => in_zone(scene, rule, zone, 0, *times),
        ConstraintKind::Apart { distance, times } => near(scene, rule, *distance, *times),
        ConstraintKind::OneWay { .. }
        | ConstraintKind::Gap { .. }
        | ConstraintKind::Sequence { .. }
        | ConstraintKind::Visit { .. }
        | ConstraintKind::Arrive { .. }
        | ConstraintKind::Late { .. }
        | ConstraintKind::Depart { .. }
        | ConstraintKind::Before { .. }
        | ConstraintKind::NoWaiting { .. }
        | ConstraintKind::Turns { .. }
        | ConstraintKind::Avoid { .. } => None,
    }
}

fn bound<'a>(scene: &'a Scene, rule: &'a Constraint) -> impl Iterator<Item = &'a Agent> {
    let names = rule.agents.as_deref();
    let agents = scene.agents.iter();
    agents.filter(move |agent| names.is_none_or(|names| names.contains(&agent.name)))
}

fn is_for_ever(times: Times) -> bool {
    meant(times).to.is_none()
}

/// More robots than may be in the zone begin there, or rest there for ever, or one has to be
/// there at some time while the zone is closed at all times.
fn in_zone(
    scene: &Scene,
    rule: &Constraint,
    zone: &str,
    most: usize,
    times: Times,
) -> Option<Never> {
    let cells = scene.zones.iter().find(|of| of.name == zone)?.cell_set();
    let is_in = |cell: Option<Cell>| cell.is_some_and(|cell| cells.contains(&cell));
    let names = |is_it: &dyn Fn(&Agent) -> bool| {
        let names = bound(scene, rule).filter(|agent| is_it(agent));
        let names: Vec<String> = names.map(|agent| agent.name.clone()).collect();
        (names.len() > most).then_some(names)
    };
    let for_ever = is_for_ever(times);
    let stay = scene.rules.at_goal == AtGoal::Stay;
    let always_closed = most == 0 && for_ever && times.first() == 0;
    if for_ever
        && (stay || always_closed)
        && let Some(names) = names(&|agent| is_in(agent.goal))
    {
        let why = tr!(
            "{robots} has its goal in {zone}, so no plan can keep this rule."
                | "{robots} have their goals in {zone}, so no plan can keep this rule."
                    % names.len(),
            robots = and(&names),
            zone
        );
        return Some(Never { why, robots: names });
    }
    if times.first() == 0
        && let Some(names) = names(&|agent| is_in(Some(agent.start)))
    {
        let why = tr!(
            "{robots} starts in {zone}, so no plan can keep this rule."
                | "{robots} start in {zone}, so no plan can keep this rule." % names.len(),
            robots = and(&names),
            zone
        );
        return Some(Never { why, robots: names });
    }
    if always_closed
        && let Some(names) = names(&|agent| agent.waypoints.iter().any(|&at| is_in(Some(at))))
    {
        let why = tr!(
            "{robots} has a waypoint in {zone}, so no plan can keep this rule."
                | "{robots} have waypoints in {zone}, so no plan can keep this rule." % names.len(),
            robots = and(&names),
            zone
        );
        return Some(Never { why, robots: names });
    }
    None
}

/// Two robots begin nearer to each other than the distance, or rest so for ever.
fn near(scene: &Scene, rule: &Constraint, distance: u32, times: Times) -> Option<Never> {
    let pair = |at: fn(&Agent) -> Option<Cell>| {
        let known = bound(scene, rule).filter_map(|agent| Some((&agent.name, at(agent)?)));
        let known: Vec<(&String, Cell)> = known.collect();
        if known.len() > PAIRED {
            return None;
        }
        known.iter().enumerate().find_map(|(place, one)| {
            let is_near = |other: &&(&String, Cell)| {
                one.1.x.abs_diff(other.1.x) + one.1.y.abs_diff(other.1.y) < distance
            };
            let other = known.iter().skip(place + 1).find(is_near)?;
            Some((one.0.clone(), other.0.clone()))
        })
    };
    let stays = is_for_ever(times) && scene.rules.at_goal == AtGoal::Stay;
    if let Some((one, other)) = stays.then(|| pair(|agent| agent.goal)).flatten() {
        let why = tr!(
            "The goals of {one} and {other} are nearer than that, so no plan can keep this rule.",
            one,
            other
        );
        let robots = vec![other];
        return Some(Never { why, robots });
    }
    let from_start = times.first() == 0;
    let (one, other) = from_start
        .then(|| pair(|agent| Some(agent.start)))
        .flatten()?;
    let why = tr!(
        "{one} and {other} start nearer than that, so no plan can keep this rule.",
        one,
        other
    );
    let robots = vec![other];
    Some(Never { why, robots })
}
