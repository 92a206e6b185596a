//! Motion descriptors (10.5) as used by moves.

use val3_moves::BlendKind;

use crate::fault::{Fault, Result};
use crate::runtime_errors::{BAD_ACCEL, BAD_DECEL, BAD_LEAVE, BAD_REACH, BAD_RVEL, BAD_TVEL, BAD_VEL};

/// Maximum acceleration in per cent, and maximum speed in degrees/s and in length units of the application per second
/// (model choice: real programs write 99999 for "no limit", in millimetres as in inches).
const HIGHEST: f64 = 1e6;

/// Maximum joint speed in per cent (model choice: real programs use 500). A higher speed is run-time error 100.
pub const HIGHEST_AXIS_SPEED: f64 = 1000.0;

/// A motion descriptor (10.5).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MdescValue {
    /// Maximum joint acceleration in per cent.
    pub accel: f64,
    /// Maximum joint speed in per cent.
    pub vel: f64,
    /// Maximum joint deceleration in per cent.
    pub decel: f64,
    /// Maximum translation speed of the tool in mm/s.
    pub tvel: f64,
    /// Maximum rotation speed of the tool in degrees/s.
    pub rvel: f64,
    /// Kind of the blend at the target.
    pub blend: BlendKind,
    /// Distance before the target at which blending starts, in mm.
    pub leave: f64,
    /// Distance after the target at which blending ends, in mm.
    pub reach: f64,
}

impl MdescValue {
    /// Returns the descriptor with its lengths in millimetres. `unit` is the number of millimetres in its length unit.
    ///
    /// # Errors
    /// 100 to 106: a field is negative, too large, or 0 so that the arm would not move.
    pub fn checked(self, unit: f64) -> Result<Self> {
        self.check()?;
        Ok(Self { tvel: self.tvel * unit, leave: self.leave * unit, reach: self.reach * unit, ..self })
    }

    fn check(&self) -> Result<()> {
        for (value, highest, error) in [
            (self.vel, HIGHEST_AXIS_SPEED, BAD_VEL),
            (self.accel, HIGHEST, BAD_ACCEL),
            (self.decel, HIGHEST, BAD_DECEL),
            (self.tvel, HIGHEST, BAD_TVEL),
            (self.rvel, HIGHEST, BAD_RVEL),
        ] {
            if !(value > 0.0 && value <= highest) {
                return Err(Fault(error));
            }
        }
        for (distance, error) in [(self.reach, BAD_REACH), (self.leave, BAD_LEAVE)] {
            if !(distance >= 0.0 && distance.is_finite()) {
                return Err(Fault(error));
            }
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::{BlendKind, MdescValue};
    use crate::fault::Fault;

    const PLAIN: MdescValue = MdescValue {
        accel: 100.0,
        vel: 100.0,
        decel: 100.0,
        tvel: 99_999.0,
        rvel: 99_999.0,
        blend: BlendKind::Joint,
        leave: 50.0,
        reach: 50.0,
    };

    /// A field of a descriptor.
    type Field = fn(&mut MdescValue) -> &mut f64;

    const FIELDS: [Field; 7] = [
        |mdesc| &mut mdesc.vel,
        |mdesc| &mut mdesc.accel,
        |mdesc| &mut mdesc.decel,
        |mdesc| &mut mdesc.tvel,
        |mdesc| &mut mdesc.rvel,
        |mdesc| &mut mdesc.reach,
        |mdesc| &mut mdesc.leave,
    ];

    #[test]
    fn a_bad_field_is_its_error() {
        let checks: [(Field, f64, u16); 10] = [
            (|mdesc| &mut mdesc.vel, 0.0, 100),
            (|mdesc| &mut mdesc.vel, 1000.1, 100),
            (|mdesc| &mut mdesc.accel, -1.0, 101),
            (|mdesc| &mut mdesc.decel, 0.0, 102),
            (|mdesc| &mut mdesc.tvel, f64::NAN, 103),
            (|mdesc| &mut mdesc.rvel, 1e7, 104),
            (|mdesc| &mut mdesc.reach, -0.1, 105),
            (|mdesc| &mut mdesc.reach, f64::INFINITY, 105),
            (|mdesc| &mut mdesc.leave, -0.1, 106),
            (|mdesc| &mut mdesc.leave, f64::NAN, 106),
        ];
        for (field, value, error) in checks {
            let mut mdesc = PLAIN;
            *field(&mut mdesc) = value;
            assert_eq!(mdesc.checked(1.0), Err(Fault(error)), "{value}");
        }
    }

    #[test]
    fn values_of_real_programs_are_accepted() {
        for mdesc in [PLAIN, MdescValue { vel: 500.0, accel: 9999.0, decel: 9999.0, leave: 0.0, reach: 0.0, ..PLAIN }] {
            assert_eq!(mdesc.checked(1.0), Ok(mdesc));
        }
    }

    /// A descriptor is valid in inches if and only if it is valid in millimetres.
    #[test]
    fn limits_are_in_the_unit_of_the_application() {
        let numbers = [0.0, 50.0, 9_999.0, 99_999.0, 1e6, 1.1e6, f64::INFINITY, f64::NAN];
        for (number, field) in numbers.into_iter().flat_map(|number| FIELDS.map(|field| (number, field))) {
            let mut mdesc = PLAIN;
            *field(&mut mdesc) = number;
            assert_eq!(mdesc.checked(25.4).map(drop), mdesc.checked(1.0).map(drop), "{mdesc:?}");
        }
    }

    #[test]
    fn lengths_become_millimetres() {
        let mdesc = MdescValue { tvel: 10.0, leave: 2.0, reach: 1.0, ..PLAIN }.checked(25.4).unwrap();
        assert_eq!((mdesc.tvel, mdesc.leave, mdesc.reach), (254.0, 50.8, 25.4));
    }
}
