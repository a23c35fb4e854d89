//! Edits of zones and of rules of the scene's own.

use giveway_model::words::Sentence;
use giveway_model::{Cell, Constraint, Ground, Zone, constraint::ConstraintKind, tr_data};

use super::scene::short;
use super::{RuleEdit, Sketch};

impl Sketch {
    /// Makes an edit of zones and rules.
    ///
    /// # Errors
    /// Why it cannot be, as a sentence.
    pub(super) fn make_of_rules(&mut self, edit: &RuleEdit) -> Result<(), Sentence> {
        let scene = &mut self.scene;
        match edit {
            RuleEdit::PaintZone(name, cell, on) => {
                if self.grid.ground(*cell).is_some() {
                    self.paint_zone(name, &[*cell], *on);
                }
            }
            RuleEdit::PaintRect(name, from, to, on) => {
                let (x0, x1) = (from.x.min(to.x), from.x.max(to.x));
                let (y0, y1) = (from.y.min(to.y), from.y.max(to.y));
                let rows = (y0..=y1).flat_map(|y| (x0..=x1).map(move |x| Cell::new(x, y)));
                let cells: Vec<Cell> = rows.filter(|&at| self.grid.ground(at).is_some()).collect();
                self.paint_zone(name, &cells, *on);
            }
            RuleEdit::RenameZone(from, to) => {
                let to = short(to);
                if to.is_empty() || to == *from {
                    return Ok(());
                }
                if scene.zones.iter().any(|zone| zone.name == to) {
                    return Err(tr_data!(
                        "There is a zone of the name {name} already.",
                        name = to
                    ));
                }
                for zone in scene.zones.iter_mut().filter(|zone| zone.name == *from) {
                    zone.name.clone_from(&to);
                }
                for rule in &mut scene.constraints {
                    let parts = crate::rules::parts(&mut rule.kind);
                    if let Some(zone) = parts.zone.filter(|zone| **zone == *from) {
                        zone.clone_from(&to);
                    }
                }
            }
            RuleEdit::RemoveZone(name) => scene.zones.retain(|zone| zone.name != *name),
            RuleEdit::Put(None, rule) => scene.constraints.push(rule.clone()),
            RuleEdit::Put(Some(index), rule) => {
                if let Some(of) = scene.constraints.get_mut(*index) {
                    of.clone_from(rule);
                }
            }
            RuleEdit::Remove(index) => {
                if *index < scene.constraints.len() {
                    scene.constraints.remove(*index);
                }
            }
            RuleEdit::Switch(index) => {
                if let Some(rule) = scene.constraints.get_mut(*index) {
                    rule.off = !rule.off;
                }
            }
            RuleEdit::Lane(lane) => self.lay(lane),
        }
        Ok(())
    }

    /// Adds cells to a zone, which is made where there is none of the name, or takes them away.
    fn paint_zone(&mut self, name: &str, cells: &[Cell], on: bool) {
        let zones = &mut self.scene.zones;
        let place = zones.iter().position(|zone| zone.name == name);
        let zone = match place.and_then(|place| zones.get_mut(place)) {
            Some(zone) => zone,
            None if on => {
                zones.push(Zone::of(name, cells.to_vec()));
                return;
            }
            None => return,
        };
        let mut all = zone.cell_set();
        for cell in cells {
            if on {
                all.insert(*cell);
            } else {
                all.remove(cell);
            }
        }
        // A zone of one cell less is no rectangle any longer.
        *zone = Zone::of(name, all.into_iter().collect());
    }

    /// Lays a one-way lane: one that is there turns round where it is led back, and stays as
    /// it is where it is led along.
    fn lay(&mut self, lane: &[Cell]) {
        let led = lane.windows(2);
        if led.len() == 0 || lane.iter().any(|&at| self.is_blocked(at)) {
            return;
        }
        let is_part = |of: &[Cell], turned: bool| {
            lane.windows(2).all(|step| {
                of.windows(2).any(|other| match (step, other) {
                    ([a, b], [c, d]) if turned => (a, b) == (d, c),
                    ([a, b], [c, d]) => (a, b) == (c, d),
                    (_, _) => false,
                })
            })
        };
        for rule in &mut self.scene.constraints {
            if let ConstraintKind::OneWay { lane: other } = &mut rule.kind {
                if is_part(other, true) {
                    other.reverse();
                    return;
                }
                if is_part(other, false) {
                    return;
                }
            }
        }
        self.scene.constraints.push(Constraint {
            kind: ConstraintKind::OneWay {
                lane: lane.to_vec(),
            },
            agents: None,
            name: None,
            off: false,
        });
    }

    /// Whether no lane can lead over a cell.
    pub(crate) fn is_blocked(&self, cell: Cell) -> bool {
        self.ground(cell)
            .is_none_or(|ground| ground == Ground::Obstacle)
    }
}
