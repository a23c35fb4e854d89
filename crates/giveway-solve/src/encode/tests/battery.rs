//! Windows against a battery that is simulated step by step.

use super::{as_bits, can, fresh, literal, solver};
use crate::{
    encode::battery::BatteryCode,
    sat::{Clauses, Lit, Sat},
    single::Reserve,
};

/// The latest deadline tried.
const HORIZON: u32 = 6;

/// Whether the battery lasts up to the arrival, charged at the times of a bit set.
fn lasts(reserve: Reserve, charges: u32, arrival: u32) -> bool {
    let mut level = i64::from(reserve.initial);
    for time in 0..arrival {
        if charges >> time & 1 == 1 {
            level = i64::from(reserve.full);
        } else {
            level -= 1;
        }
        if level < 0 {
            return false;
        }
    }
    true
}

#[test]
fn the_simulation_is_right() {
    let reserve = Reserve {
        full: 2,
        initial: 1,
    };
    assert!(lasts(reserve, 0b0, 1));
    assert!(!lasts(reserve, 0b0, 2));
    // Charged at 1: level 2 at time 2, 0 at time 4.
    assert!(lasts(reserve, 0b10, 4));
    assert!(!lasts(reserve, 0b10, 5));
}

/// The windows of one agent, and what is around them.
struct Trial {
    sat: Sat<'static>,
    reserve: Reserve,
    optimum: u32,
    code: BatteryCode,
    /// `by[i]`: arrived by `optimum + i`.
    by: Vec<Lit>,
    /// `places[t]`: the nodes at chargers at t, each with its level: the least
    /// arrival by way of it, which is the deadline at which it came.
    places: Vec<Vec<(Lit, u32)>>,
}

impl Trial {
    fn new(reserve: Reserve, optimum: u32) -> Self {
        let mut sat = solver();
        Self {
            by: fresh(&mut sat, (HORIZON + 1 - optimum) as usize),
            places: vec![Vec::new(); HORIZON as usize],
            sat,
            reserve,
            optimum,
            code: BatteryCode::new(reserve, std::iter::empty()),
        }
    }

    /// A new node at a charger.
    fn place(&mut self, time: u32, level: u32) {
        let node = fresh(&mut self.sat, 1)[0];
        self.code.place(time, node);
        self.places[time as usize].push((node, level));
        if let Some(sooner) = level.checked_sub(self.optimum + 1) {
            self.sat.clause(&[!node, !self.by[sooner as usize]]);
        }
    }

    fn grow(&mut self, deadline: u32) {
        let (by, optimum) = (&self.by, self.optimum);
        let by = |time: u32, _: &mut Sat| {
            let index = time.checked_sub(optimum)?;
            Some(by[index as usize])
        };
        self.code.grow(deadline, by, &mut self.sat);
        assert_eq!(self.code.charges().len(), deadline as usize);
    }

    /// The literals of an arrival.
    fn arrived(&self, arrival: u32) -> Vec<Lit> {
        let by = self.by.iter().zip(self.optimum..);
        by.map(|(&lit, time)| literal(lit, time >= arrival))
            .collect()
    }

    /// All charges before each arrival, at a charger all the time.
    fn check_charges(&mut self, deadline: u32) {
        let nodes: Vec<Lit> = self.places.iter().map(|nodes| nodes[0].0).collect();
        for arrival in self.optimum..=deadline {
            let given = [self.arrived(arrival), nodes.clone()].concat();
            for charges in 0..1 << arrival {
                let pattern = as_bits(self.code.charges(), charges);
                let holds = can(&mut self.sat, &[given.as_slice(), &pattern].concat());
                let what = format!(
                    "{:?}, deadline {deadline}, arrival {arrival}, charges {charges:b}",
                    self.reserve
                );
                assert_eq!(holds, lasts(self.reserve, charges, arrival), "{what}");
            }
        }
    }

    /// Being at chargers at some times, and charging at will: to charge always
    /// is best then. `which` says which nodes the agent takes.
    fn check_places(&mut self, deadline: u32) {
        for arrival in self.optimum..=deadline {
            for taken in 0..1_u32 << arrival {
                let mut given = self.arrived(arrival);
                let (mut there, mut level) = (0, 0);
                for (time, nodes) in self.places.iter().enumerate() {
                    for (which, &(node, needs)) in nodes.iter().enumerate() {
                        // One of the two at a time.
                        let takes = taken >> time & 1 == 1 && which == time % 2;
                        there |= u32::from(takes) << time;
                        level = level.max(if takes { needs } else { 0 });
                        given.push(literal(node, takes));
                    }
                }
                let what = format!(
                    "{:?}, deadline {deadline}, arrival {arrival}, at chargers {there:b}",
                    self.reserve
                );
                let expect = level <= arrival && lasts(self.reserve, there, arrival);
                assert_eq!(can(&mut self.sat, &given), expect, "{what}");
                // No charge where there is no charger.
                for (time, &charge) in self.code.charges().iter().enumerate() {
                    if there >> time & 1 == 0 {
                        given.push(charge);
                        assert!(!can(&mut self.sat, &given), "{what}, a charge at {time}");
                        given.pop();
                    }
                }
            }
        }
    }
}

fn reserves(most: u32) -> impl Iterator<Item = Reserve> {
    (0..=most).flat_map(|full| (0..=full).map(move |initial| Reserve { full, initial }))
}

#[test]
fn charge_patterns_hold_just_when_the_battery_lasts() {
    for reserve in reserves(5) {
        for optimum in 0..=HORIZON {
            let mut trial = Trial::new(reserve, optimum);
            for time in 0..HORIZON {
                trial.place(time, optimum);
            }
            for deadline in optimum..=HORIZON {
                trial.grow(deadline);
                trial.check_charges(deadline);
            }
        }
    }
}

#[test]
fn a_deadline_may_jump() {
    for reserve in reserves(3) {
        let mut trial = Trial::new(reserve, 1);
        for time in 0..HORIZON {
            trial.place(time, 1);
        }
        for deadline in [1, 4, HORIZON] {
            trial.grow(deadline);
            trial.check_charges(deadline);
        }
    }
}

#[test]
fn chargers_may_come_into_reach_with_a_later_deadline() {
    for reserve in reserves(2) {
        let mut trial = Trial::new(reserve, 2);
        for deadline in 2..=HORIZON {
            trial.place(deadline - 1, deadline);
            if deadline == 2 {
                trial.place(0, deadline);
            } else {
                // The second node of an earlier time, known only from now on.
                trial.place(deadline - 3, deadline);
            }
            trial.grow(deadline);
            trial.check_places(deadline);
        }
    }
}
