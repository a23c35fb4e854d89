//! Steps of several agents at once that do not collide.

use super::lone::{Lone, Step};

/// Every choice of one step an agent without a collision.
///
/// Two agents that are on one edge in one step in opposite directions swap; for
/// slow moves, which take two steps, that is beginning less than two steps apart.
pub(super) fn joint_steps(lones: &[Lone<'_>], steps: &[Vec<Step>]) -> Vec<Vec<Step>> {
    let mut chosen: Vec<Vec<Step>> = vec![Vec::new()];
    for (lone, steps) in lones.iter().zip(steps) {
        let mut longer = Vec::new();
        for before in &chosen {
            for step in steps {
                let others = lones.iter().zip(before);
                let mut others = others.map(|(other, theirs)| collide(lone, step, other, theirs));
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

fn collide(a: &Lone<'_>, mine: &Step, b: &Lone<'_>, theirs: &Step) -> bool {
    let here = a.cell(mine.to);
    if here.is_some() && here == b.cell(theirs.to) {
        return true;
    }
    let Some((u, v)) = mine.crosses else {
        return false;
    };
    theirs.crosses == Some((v, u))
}
