//! Joint positions (9.2) as program values.

use val3_kinematics::{Arm, Joints};

/// A joint position as in a program: degrees, and the application's length unit for linear axes (2.1.4.1, 9.2.1). The
/// numbers of missing axes are 0.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct JointValue(pub [f64; 6]);

impl JointValue {
    /// Converts an arm's joint position, in degrees and mm. `unit` is the number of millimetres in the length unit.
    #[must_use]
    pub fn of(mut joints: Joints, arm: &Arm, unit: f64) -> Self {
        strokes(&mut joints, arm).for_each(|stroke| *stroke /= unit);
        Self(joints)
    }

    /// Converts the position to degrees and mm. `unit` is the number of millimetres in the length unit.
    #[must_use]
    pub fn joints(self, arm: &Arm, unit: f64) -> Joints {
        let Self(mut joints) = self;
        strokes(&mut joints, arm).for_each(|stroke| *stroke *= unit);
        joints
    }
}

/// Returns the numbers of the linear axes.
fn strokes<'j>(joints: &'j mut Joints, arm: &Arm) -> impl Iterator<Item = &'j mut f64> {
    joints.iter_mut().enumerate().filter(|(axis, _)| arm.is_stroke(*axis)).map(|(_, joint)| joint)
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::{Arm, JointValue};

    #[test]
    fn only_linear_axes_are_converted() {
        let joints = [10.0, 20.0, 50.8, 40.0, 0.0, 0.0];
        for (name, expected) in [("TS2-60", [10.0, 20.0, 2.0, 40.0, 0.0, 0.0]), ("TX2-90", joints)] {
            assert_eq!(JointValue::of(joints, &Arm::by_name(name).unwrap(), 25.4), JointValue(expected), "{name}");
        }
    }

    proptest! {
        #[test]
        fn conversions_are_inverse(joints in prop::array::uniform6(-1e3..1e3_f64), unit in 1.0..100.0_f64) {
            for name in Arm::names() {
                let arm = Arm::by_name(name).unwrap();
                let again = JointValue::of(joints, &arm, unit).joints(&arm, unit);
                prop_assert!(joints.iter().zip(again).all(|(a, b)| (a - b).abs() < 1e-9), "{}", name);
                prop_assert_eq!(JointValue::of(joints, &arm, 1.0).0, joints);
            }
        }
    }
}
