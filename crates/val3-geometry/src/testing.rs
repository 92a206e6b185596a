//! Transformations for tests, and when two of them are one place.

use proptest::prelude::*;
use proptest::test_runner::TestCaseError;

use crate::Trsf;

/// Any place within 2 m, angles of any size, quarter turns among them.
pub(crate) fn any_trsf() -> impl Strategy<Value = Trsf> {
    let length = || -2000.0..2000.0;
    let quarter = || (-4..=4).prop_map(|quarters| f64::from(quarters) * 90.0);
    let angle = || prop_oneof![1 => quarter(), 4 => -400.0..400.0];
    let place = [length(), length(), length()];
    (place, [angle(), angle(), angle()]).prop_map(|(place, angles)| Trsf::new(place, angles))
}

/// Whether both are one place to 1e-9 mm, however their angles are written.
pub(crate) fn near(left: &Trsf, right: &Trsf) -> bool {
    let (left, right) = (left.isometry(), right.isometry());
    let turned = (left.rotation.matrix() - right.rotation.matrix()).amax();
    turned < 1e-12 && (left.translation.vector - right.translation.vector).amax() < 1e-9
}

/// Fails where both are not one place.
///
/// # Errors
/// The failure, as proptest wants it.
pub(crate) fn assert_near(left: &Trsf, right: &Trsf) -> Result<(), TestCaseError> {
    prop_assert!(near(left, right), "{:?} is not {:?}", left, right);
    Ok(())
}
