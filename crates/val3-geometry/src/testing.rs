//! Transformations for tests, and their comparison.

use proptest::prelude::*;
use proptest::test_runner::TestCaseError;

use crate::Trsf;

/// Any pose within 2 m, with angles of any size, including quarter turns.
pub(crate) fn any_trsf() -> impl Strategy<Value = Trsf> {
    let length = || -2000.0..2000.0;
    let quarter = || (-4..=4).prop_map(|quarters| f64::from(quarters) * 90.0);
    let angle = || prop_oneof![1 => quarter(), 4 => -400.0..400.0];
    let place = [length(), length(), length()];
    (place, [angle(), angle(), angle()]).prop_map(|(place, angles)| Trsf::new(place, angles))
}

/// Whether both are the same pose up to 1e-9 mm, even if their angles have different forms.
pub(crate) fn near(left: &Trsf, right: &Trsf) -> bool {
    let (left, right) = (left.isometry(), right.isometry());
    let turned = (left.rotation.matrix() - right.rotation.matrix()).amax();
    turned < 1e-12 && (left.translation.vector - right.translation.vector).amax() < 1e-9
}

/// Checks that both are the same pose.
///
/// # Errors
/// Returns the failure for proptest.
pub(crate) fn assert_near(left: &Trsf, right: &Trsf) -> Result<(), TestCaseError> {
    prop_assert!(near(left, right), "{:?} is not {:?}", left, right);
    Ok(())
}
