//! Scenes with rules of their own, made of a scene without and its plan: the same for ever.

mod roads;
mod usage;

use std::collections::BTreeSet;

use giveway_model::condition::Times;
use giveway_model::constraint::ConstraintKind;
use giveway_model::{Cell, Constraint, Grid, Plan, Scene, Zone};

use roads::Roads;
use usage::{around, busy, by_use, most_at_once};

/// The most cells of a zone.
const ZONE: usize = 6;

/// Every so many-th row and column is a lane.
const LANES: u32 = 3;

/// What is added to a scene.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Added {
    /// A cell that the plan does not use is closed.
    Free,
    /// Fewer agents than in the plan may be in each of two zones.
    Zones,
    /// Rows and columns are one-way.
    Lanes,
    /// A cell is left empty for a step between two agents.
    Gap,
    /// Turns take time.
    Turns,
    /// Each agent has a visit at some times, or a sequence.
    Stops,
}

impl Added {
    pub(super) const ALL: [Self; 6] = [
        Self::Free,
        Self::Zones,
        Self::Lanes,
        Self::Gap,
        Self::Turns,
        Self::Stops,
    ];

    /// The head of its column.
    pub(super) const fn head(self) -> &'static str {
        match self {
            Self::Free => "(a) free",
            Self::Zones => "(b) zones",
            Self::Lanes => "(c) lanes",
            Self::Gap => "(d) gap",
            Self::Turns => "(e) turns",
            Self::Stops => "(f) stops",
        }
    }

    /// The scene with its rules.
    pub(super) fn to_scene(self, scene: &Scene, grid: &Grid, plan: &Plan) -> Scene {
        let mut scene = scene.clone();
        match self {
            Self::Free => scene.closed_where_unused(grid, plan),
            Self::Zones => scene.limited(grid, plan),
            Self::Lanes => scene.one_way(grid),
            Self::Gap => scene.rule(ConstraintKind::Gap { steps: 1 }),
            Self::Turns => scene.rule(ConstraintKind::Turns { quarter: 1 }),
            Self::Stops => scene.stops(plan),
        }
        scene
    }
}

trait WithRules {
    fn rule(&mut self, kind: ConstraintKind);
    fn closed_where_unused(&mut self, grid: &Grid, plan: &Plan);
    fn limited(&mut self, grid: &Grid, plan: &Plan);
    fn one_way(&mut self, grid: &Grid);
    fn stops(&mut self, plan: &Plan);
}

impl WithRules for Scene {
    fn rule(&mut self, kind: ConstraintKind) {
        self.constraints.push(Constraint {
            kind,
            agents: None,
            name: None,
            off: false,
        });
    }

    /// Of the cells that no agent uses the one nearest to the busiest cell.
    fn closed_where_unused(&mut self, grid: &Grid, plan: &Plan) {
        let busy = busy(plan);
        let Some(&centre) = by_use(&busy).first() else {
            return;
        };
        let mut cells = around(grid, centre).into_iter();
        if let Some(unused) = cells.find(|cell| !busy.contains_key(cell)) {
            self.zones.push(Zone::of("unused", vec![unused]));
            self.rule(ConstraintKind::Closed {
                zone: "unused".to_owned(),
                times: Times::default(),
            });
        }
    }

    /// Zones around the two busiest cells, each with the largest limit that the plan
    /// breaks.
    fn limited(&mut self, grid: &Grid, plan: &Plan) {
        let mut taken = BTreeSet::new();
        for name in ["first", "second"] {
            let mut cells = by_use(&busy(plan)).into_iter();
            let Some(centre) = cells.find(|cell| !taken.contains(cell)) else {
                return;
            };
            let mut zone = around(grid, centre);
            zone.retain(|cell| !taken.contains(cell));
            zone.truncate(ZONE);
            taken.extend(zone.iter().copied());
            let most = most_at_once(plan, grid, &zone).saturating_sub(1);
            self.zones.push(Zone::of(name, zone));
            self.rule(ConstraintKind::Capacity {
                zone: name.to_owned(),
                most,
                times: Times::default(),
            });
        }
    }

    /// Every third row and every third column, by turns in both directions.
    fn one_way(&mut self, grid: &Grid) {
        let mut roads = Roads {
            grid,
            closed: BTreeSet::new(),
        };
        let rows = (1..grid.height()).step_by(LANES as usize);
        let columns = (1..grid.width()).step_by(LANES as usize);
        let row = |y: u32| (0..grid.width()).map(|x| Cell::new(x, y)).collect();
        let column = |x: u32| (0..grid.height()).map(|y| Cell::new(x, y)).collect();
        let lines: Vec<Vec<Cell>> = rows.map(row).chain(columns.map(column)).collect();
        for (number, mut line) in lines.into_iter().enumerate() {
            if number % 2 == 1 {
                line.reverse();
            }
            for lane in roads.lanes(&line) {
                self.rule(ConstraintKind::OneWay { lane });
            }
        }
    }

    /// By turns: a visit a little later than the plan makes it, and a sequence that it makes.
    fn stops(&mut self, plan: &Plan) {
        let names: Vec<String> = self.agents.iter().map(|it| it.name.clone()).collect();
        for (number, name) in names.iter().enumerate() {
            let path = plan.path(name);
            let at = |time: usize| path.get(time..)?.iter().flatten().next().copied();
            let length = path.len();
            if number % 2 == 0 {
                let Some(cell) = at(length / 2) else { continue };
                let middle = (length / 2) as u32;
                self.constraints.push(Constraint {
                    kind: ConstraintKind::Visit {
                        cell,
                        stay: 0,
                        times: Times {
                            from: Some(middle + 2),
                            to: Some(middle + 8),
                        },
                    },
                    agents: Some(vec![name.clone()]),
                    name: None,
                    off: false,
                });
            } else if let (Some(one), Some(other)) = (at(length / 3), at(2 * length / 3)) {
                self.rule(ConstraintKind::Sequence {
                    agent: name.clone(),
                    cells: vec![one, other],
                });
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeMap;

    use super::*;

    fn grid(rows: &[&str]) -> Grid {
        Grid::from_rows(rows).unwrap()
    }

    #[test]
    fn lanes_leave_a_way_from_every_cell_to_every_cell() {
        let grid = grid(&[
            ".......", ".#.#.#.", ".......", ".#.#.#.", ".......", "...####",
        ]);
        let mut scene = Scene {
            map: grid.rows(),
            ..Scene::default()
        };
        scene.one_way(&grid);
        let mut roads = Roads {
            grid: &grid,
            closed: BTreeSet::new(),
        };
        for rule in &scene.constraints {
            if let ConstraintKind::OneWay { lane } = &rule.kind {
                let back = lane.windows(2).map(|pair| (pair[1], pair[0]));
                roads.closed.extend(back);
            }
        }
        assert!(roads.closed.len() > 5);
        for (cell, ground) in grid.cells().filter(|(_, ground)| ground.is_vertex()) {
            assert!(ground.is_vertex());
            for next in grid.neighbours(cell).filter(|&next| grid.is_vertex(next)) {
                let is_open = !roads.closed.contains(&(cell, next));
                assert!(is_open || roads.has_other_way((cell, next)));
            }
        }
    }

    #[test]
    fn a_limit_is_one_less_than_the_plan_needs() {
        let grid = grid(&["....."]);
        let cell = |x| Some(Cell::new(x, 0));
        let paths = [
            ("A", vec![cell(0), cell(1), cell(2)]),
            ("B", vec![cell(4), cell(3)]),
        ];
        let paths = paths.map(|(name, path)| (name.to_owned(), path));
        let plan = Plan {
            paths: BTreeMap::from(paths),
            ..Plan::default()
        };
        let zone: Vec<Cell> = (1..5).map(|x| Cell::new(x, 0)).collect();
        assert_eq!(most_at_once(&plan, &grid, &zone), 2);
        let mut scene = Scene {
            map: grid.rows(),
            ..Scene::default()
        };
        scene.limited(&grid, &plan);
        assert_eq!(scene.constraints.len(), 1);
        assert!(matches!(
            scene.constraints[0].kind,
            ConstraintKind::Capacity { most: 1, .. }
        ));
    }
}
