//! Gives every robot a goal of its own out of those that it may choose.

use std::collections::{BTreeMap, VecDeque};

use giveway_model::Cell;

/// A goal for each robot, the first that it can have, with as many robots served as
/// possible: a matching by augmenting paths, robot by robot (Berge 1957).
pub(super) fn assign(choices: &[Vec<Cell>]) -> Vec<Option<Cell>> {
    let mut owners: BTreeMap<Cell, usize> = BTreeMap::new();
    let mut goals: Vec<Option<Cell>> = vec![None; choices.len()];
    for robot in 0..choices.len() {
        // How each goal was reached: by which robot that would take it.
        let mut taken_by: BTreeMap<Cell, usize> = BTreeMap::new();
        let mut queue = VecDeque::from([robot]);
        let mut free = None;
        'search: while let Some(robot) = queue.pop_front() {
            for &goal in choices.get(robot).into_iter().flatten() {
                if taken_by.contains_key(&goal) {
                    continue;
                }
                taken_by.insert(goal, robot);
                match owners.get(&goal) {
                    None => {
                        free = Some(goal);
                        break 'search;
                    }
                    Some(&owner) => queue.push_back(owner),
                }
            }
        }
        while let Some(goal) = free {
            let Some(&robot) = taken_by.get(&goal) else {
                break;
            };
            owners.insert(goal, robot);
            free = goals.get_mut(robot).and_then(|own| own.replace(goal));
        }
    }
    goals
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_robot_makes_room_for_one_with_less_choice() {
        let [a, b, c] = [0, 1, 2].map(|x| Cell::new(x, 0));
        let goals = assign(&[vec![a, b], vec![a, c], vec![a]]);
        assert_eq!(goals, [Some(b), Some(c), Some(a)]);
        assert_eq!(assign(&[vec![a], vec![a]]), [Some(a), None]);
    }
}
