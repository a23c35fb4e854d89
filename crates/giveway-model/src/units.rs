//! What a cell and a time step are in the world.

use std::fmt;

use borsh::{BorshDeserialize, BorshSerialize};
use serde::de::{Error, Unexpected};
use serde::{Deserialize, Deserializer, Serialize, Serializer};

use crate::object_only;

/// The side of a cell and the length of a time step. They are shown beside cells and steps, and no
/// claim is about them.
#[derive(
    Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, BorshSerialize, BorshDeserialize,
)]
#[serde(remote = "Self", deny_unknown_fields)]
pub struct Units {
    /// The side of a cell, in metres.
    pub cell: Measure,
    /// The length of a time step, in seconds.
    pub step: Measure,
}

object_only!(Units);

/// A number above 0 with at most three decimals.
#[derive(Clone, Copy, Debug, PartialEq, Eq, BorshSerialize, BorshDeserialize)]
pub struct Measure(u32);

/// The largest measure.
const MOST: f64 = 1e6;

impl Measure {
    /// A measure out of thousandths; `None` where it is 0 or too large.
    ///
    /// ```
    /// use giveway_model::Measure;
    /// assert_eq!(Measure::from_thousandths(1500).map(Measure::thousandths), Some(1500));
    /// assert_eq!(Measure::from_thousandths(0), None);
    /// ```
    pub fn from_thousandths(thousandths: u32) -> Option<Self> {
        let fits = thousandths > 0 && f64::from(thousandths) <= MOST * 1000.0;
        fits.then_some(Self(thousandths))
    }

    /// The measure in thousandths.
    pub const fn thousandths(self) -> u32 {
        self.0
    }
}

impl fmt::Display for Measure {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (whole, rest) = (self.0 / 1000, self.0 % 1000);
        if rest == 0 {
            return write!(f, "{whole}");
        }
        let rest = format!("{rest:03}");
        write!(f, "{whole}.{}", rest.trim_end_matches('0'))
    }
}

impl Serialize for Measure {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        if self.0.is_multiple_of(1000) {
            serializer.serialize_u32(self.0 / 1000)
        } else {
            serializer.serialize_f64(f64::from(self.0) / 1000.0)
        }
    }
}

impl<'de> Deserialize<'de> for Measure {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let number = <f64 as Deserialize>::deserialize(deserializer)?;
        let thousandths = (number * 1000.0).round();
        #[expect(
            clippy::cast_sign_loss,
            reason = "a conversion of floats saturates, and 0 is refused"
        )]
        let measure = (number <= MOST).then(|| Self::from_thousandths(thousandths as u32));
        measure.flatten().ok_or_else(|| {
            let expected = "a number from 0.001 to 1000000";
            // A whole number is told as it is written: 0, not 0.0.
            let found = if number.fract() == 0.0 && number.abs() < 1e15 {
                Unexpected::Signed(number as i64)
            } else {
                Unexpected::Float(number)
            };
            D::Error::invalid_value(found, &expected)
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Scene;
    use crate::format::native::{read_scene, write_scene};

    fn scene(units: &str) -> String {
        format!(r#"{{ "giveway": 1, "map": ["."], "agents": [], "units": {units} }}"#)
    }

    #[test]
    fn units_are_written_as_they_were_read() {
        let read = read_scene(&scene(r#"{ "cell": 0.8, "step": 1.5 }"#)).unwrap();
        let units = read.units.unwrap();
        assert_eq!(
            (units.cell.thousandths(), units.step.thousandths()),
            (800, 1500)
        );
        let text = write_scene(&read);
        assert!(
            text.contains(r#""units": { "cell": 0.8, "step": 1.5 }"#),
            "{text}"
        );
        assert_eq!(read_scene(&text).unwrap(), read);
        assert_eq!(read_scene(&scene("null")).unwrap().units, None);
        let whole = Units {
            cell: Measure(1000),
            step: Measure(2000),
        };
        let scene = Scene {
            units: Some(whole),
            map: vec![".".to_owned()],
            ..Scene::default()
        };
        assert!(write_scene(&scene).contains(r#""units": { "cell": 1, "step": 2 }"#));
    }

    #[test]
    fn faults_have_their_place() {
        let fault = |units: &str| read_scene(&scene(units)).unwrap_err().to_string();
        for (units, place) in [
            (r#"{ "cell": 0, "step": 1 }"#, "units.cell"),
            (r#"{ "cell": 1, "step": -2.5 }"#, "units.step"),
            (r#"{ "cell": 1, "step": 1e9 }"#, "units.step"),
            (r#"{ "cell": "1 m", "step": 1 }"#, "units.cell"),
            (r#"{ "cell": 1 }"#, "units"),
            (r#"{ "cell": 1, "step": 1, "mass": 2 }"#, "mass"),
            ("[1, 2]", "units"),
        ] {
            let fault = fault(units);
            assert!(fault.contains(place), "{units}: {fault}");
            assert!(fault.contains("line 1"), "{units}: {fault}");
        }
        let found = fault(r#"{ "cell": 0, "step": 1 }"#);
        assert!(found.contains("found the number 0, expected"), "{found}");
        let found = fault(r#"{ "cell": -2.5, "step": 1 }"#);
        assert!(found.contains("found the number -2.5, expected"), "{found}");
    }
}
