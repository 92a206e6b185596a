//! Tolerance of movements.

use std::str::FromStr;

use serde::Serialize;

use crate::model::Displacement;

/// Maximum movement that is ignored.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Tolerance {
    /// Distance between origins, or movement of a linear axis, in mm.
    pub distance_mm: f64,
    /// Angle between orientations, or movement of a rotary axis, in degrees.
    pub angle_deg: f64,
}

impl Tolerance {
    /// Whether a movement is within the tolerance.
    pub(crate) fn includes(self, moved: Displacement) -> bool {
        moved.distance_mm <= self.distance_mm && moved.angle_deg <= self.angle_deg
    }
}

/// Hint on the syntax of a tolerance.
const USAGE: &str = "write a distance in mm, an angle in deg, or both, for example 0.01mm,0.01deg";

impl FromStr for Tolerance {
    type Err = String;

    /// Parses `0.01mm,0.01deg`. An omitted part is 0.
    fn from_str(text: &str) -> Result<Self, String> {
        let (mut distance, mut angle) = (None, None);
        for part in text.split(',').map(str::trim) {
            let split = |unit| Some((part.strip_suffix(unit)?.trim_end(), unit));
            let Some((number, unit)) = split("mm").or_else(|| split("deg")) else {
                return Err(format!("`{part}` has no unit: {USAGE}"));
            };
            let number: Option<f64> = number.parse().ok().filter(|number: &f64| number.is_finite() && *number >= 0.0);
            let number = number.ok_or_else(|| format!("`{part}` is no distance or angle of at least 0: {USAGE}"))?;
            let target = if unit == "mm" { &mut distance } else { &mut angle };
            if target.replace(number).is_some() {
                return Err(format!("`{unit}` is written twice: {USAGE}"));
            }
        }
        Ok(Self { distance_mm: distance.unwrap_or(0.0), angle_deg: angle.unwrap_or(0.0) })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_tolerance_has_units() {
        let read = |text: &str| text.parse().map(|Tolerance { distance_mm, angle_deg }| (distance_mm, angle_deg));
        assert_eq!(read("0.01mm,0.02deg"), Ok((0.01, 0.02)));
        assert_eq!(read("1 deg, .5 mm"), Ok((0.5, 1.0)));
        assert_eq!(read("2mm"), Ok((2.0, 0.0)));
        for (text, word) in [
            ("0.01", "`0.01` has no unit"),
            ("1mm,", "`` has no unit"),
            ("-1mm", "at least 0"),
            ("NaNdeg", "at least 0"),
            ("xmm", "at least 0"),
            ("1mm,2mm", "`mm` is written twice"),
            ("1um", "`1um` has no unit"),
        ] {
            assert!(read(text).unwrap_err().contains(word), "{text}");
        }
    }
}
