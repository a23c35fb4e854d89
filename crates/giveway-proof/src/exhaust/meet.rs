//! Steps of several agents at once that do not collide.

use super::lone::{Lone, Step};

/// Every choice of one step an agent without a collision.
///
/// Two agents that are on one edge in one step in opposite directions swap; for
/// slow moves, which take two steps, that is beginning less than two steps apart.
pub(super) fn joint_steps(steps: &[Vec<Step>]) -> Vec<Vec<Step>> {
    let mut chosen: Vec<Vec<Step>> = vec![Vec::new()];
    for steps in steps {
        let mut longer = Vec::new();
        for before in &chosen {
            for step in steps {
                let others = before.iter();
                let mut others = others.map(|theirs| collide(step, theirs));
                if !others.any(|collides| collides) {
                    let mut more = before.clone();
                    more.push(*step);
                    longer.push(more);
                }
            }
        }
        chosen = longer;
    }
    chosen
}

fn collide(mine: &Step, theirs: &Step) -> bool {
    let here = Lone::cell(mine.to);
    if here.is_some() && here == Lone::cell(theirs.to) {
        return true;
    }
    let Some((u, v)) = mine.crosses else {
        return false;
    };
    theirs.crosses == Some((v, u))
}
