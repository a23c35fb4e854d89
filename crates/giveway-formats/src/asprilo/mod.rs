//! asprilo: instances and plans as facts of a logic program.
//!
//! ```text
//! init(object(node,I),value(at,(X,Y))).          coordinates from 1, y = 1 at the top
//! init(object(robot,I),value(at,(X,Y))).         likewise shelf, pickingStation, highway
//! init(object(product,I),value(on,(SHELF,AMOUNT))).
//! init(object(order,I),value(line,(PRODUCT,AMOUNT))).
//! init(object(order,I),value(pickingStation,STATION)).
//! occurs(object(robot,I),action(move,(DX,DY)),T).      a step from T - 1 to T; also pickup,
//!                                                      putdown, deliver: the robot stands still
//! ```
//!
//! A missing node is an obstacle. What a robot does at no time is a wait. Cells of
//! the plan of a warehouse are those of its robots and moves: the format leaves no
//! convention open. Source: the language of asprilo (Gebser et al. 2018,
//! *Experimenting with robotic intra-logistics domains*) and the published
//! instances.

mod facts;
mod plan;
mod tasks;
mod term;
mod warehouse;
mod write;

use super::Held;
use giveway_model::Fault;
pub(super) use write::write;

/// Whether a text begins with a fact or a comment of asprilo.
pub(super) fn is_asprilo(text: &str) -> bool {
    let mut rest = text.trim_start();
    loop {
        let skipped = if let Some(comment) = rest.strip_prefix("%*") {
            comment.split_once("*%").map(|(_, rest)| rest)
        } else if rest.starts_with('%') {
            rest.split_once('\n').map(|(_, rest)| rest)
        } else if rest.starts_with('#') {
            // YAML has comments with `#`, too.
            let is_directive = ["#program", "#const", "#show", "#include"]
                .iter()
                .any(|directive| rest.starts_with(directive));
            let end = term::directive(rest).filter(|_| is_directive);
            end.and_then(|end| rest.get(end..))
        } else {
            return rest.starts_with("init(") || rest.starts_with("occurs(");
        };
        match skipped {
            Some(skipped) => rest = skipped.trim_start(),
            None => return false,
        }
    }
}

/// Reads an instance, a plan, or both.
pub(super) fn read(text: &str) -> Result<Held, Fault> {
    warehouse::held(text, &facts::read(text)?)
}
