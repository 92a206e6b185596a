//! Range check of coordinates that operators enter.

use val3_lang::types::LengthUnit;

use crate::wire::{self, CommandError};

/// Largest accepted coordinate, in mm: far beyond the reach of any arm, but below most mistyped numbers.
const LONGEST: f64 = 100_000.0;

/// Largest accepted angle, in degrees.
const WIDEST: f64 = 360.0;

const LENGTHS: [&str; 3] = ["x", "y", "z"];

const ANGLES: [&str; 3] = ["rx", "ry", "rz"];

/// Checks that changed coordinates, in this length unit and degrees, are within the range. Unchanged coordinates may be
/// outside.
pub(super) fn check_range(local: &[f64; 6], present: &[f64], unit: LengthUnit) -> Result<(), CommandError> {
    let longest = (LONGEST / unit.millimetres()).floor();
    let lengths = LENGTHS.map(|name| (name, longest, wire::LengthUnit::from(unit).word()));
    let angles = ANGLES.map(|name| (name, WIDEST, "degrees"));
    for (index, (number, (name, most, unit))) in local.iter().zip(lengths.into_iter().chain(angles)).enumerate() {
        let is_changed = present.get(index) != Some(number);
        if is_changed && !(-most..=most).contains(number) {
            return Err(CommandError(format!("{name} is {number}, outside the range from -{most} to {most} {unit}")));
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_coordinate_outside_the_range_is_named() {
        let range_in = |unit: LengthUnit, local: [f64; 6]| {
            check_range(&local, &[0.0, 2e9, 0.0, 720.0, 0.0, 0.0], unit).map_err(|error| error.0)
        };
        let range = |local: [f64; 6]| range_in(LengthUnit::Millimetre, local);
        assert_eq!(range([-1e5, 2e9, 1e5, 720.0, -360.0, 360.0]), Ok(()));
        let (far, turned) = (range([0.0, 99_999_999.0, 0.0, 0.0, 0.0, 0.0]), range([0.0, 0.0, 0.0, 0.0, 0.0, -361.0]));
        assert_eq!(far.unwrap_err(), "y is 99999999, outside the range from -100000 to 100000 mm");
        assert_eq!(turned.unwrap_err(), "rz is -361, outside the range from -360 to 360 degrees");
        assert!(range([f64::NAN; 6]).is_err());
        let inches = range_in(LengthUnit::Inch, [3938.0, 0.0, 0.0, 0.0, 0.0, 0.0]);
        assert_eq!(inches.unwrap_err(), "x is 3938, outside the range from -3937 to 3937 inches");
    }
}
