//! Placements through fathers (manual 9.4 to 9.6): points in frames, frames in frames, tools on tools.
//!
//! A *chain* is a slice of transformations from the inside out: the position itself, then its father, and so on. The
//! last transformation is relative to `world`, or to `flange` for a tool. `world` and `flange` are the empty chain.
//!
//! Equal transformations at the outer ends of two chains do not affect their relative pose and are omitted from the
//! computation. Positions in the same frame are therefore compared exactly, without the rounding of a conversion to
//! `world` and back. Only the values of the fathers are compared, not their variables.
//!
//! The instruction `link` changes only the father and not the transformation, so it needs no computation.

use nalgebra::{IsometryMatrix3, Point3};

use crate::Trsf;

/// Computes the pose of a chain in `world` or at `flange`.
#[must_use]
pub fn resolve(chain: &[Trsf]) -> IsometryMatrix3<f64> {
    chain.iter().fold(IsometryMatrix3::identity(), |inner, link| link.isometry() * inner)
}

/// Implements the instruction `position` (manual 9.4.4, 9.5.4, 9.6.3): computes the pose of `place` relative to
/// `reference`.
#[must_use]
pub fn position(place: &[Trsf], reference: &[Trsf]) -> Trsf {
    between(reference, place).into()
}

/// Implements the instruction `distance` for two points (manual 9.6.3), in mm. The orientations have no effect.
#[must_use]
pub fn distance(left: &[Trsf], right: &[Trsf]) -> f64 {
    let (left, right) = without_common_end(left, right);
    (origin(right) - origin(left)).norm()
}

/// Computes the origin of a chain's first transformation, relative to the end of the chain.
fn origin(chain: &[Trsf]) -> Point3<f64> {
    let Some((place, fathers)) = chain.split_first() else { return Point3::origin() };
    fathers.iter().fold(Point3::from(place.translation()), |point, father| father.isometry() * point)
}

/// Implements the instruction `compose` (manual 9.6.3): moves `point` by a `transformation` relative to `reference`.
///
/// The result is relative to the father of the point, like the point's own transformation; `None` for an empty `point`.
#[must_use]
pub fn compose(point: &[Trsf], reference: &[Trsf], transformation: &Trsf) -> Option<Trsf> {
    let (point, father) = point.split_first()?;
    let reference = between(father, reference);
    Some((reference * transformation.isometry() * reference.inverse() * point.isometry()).into())
}

/// Computes the pose of `place` relative to `reference`.
fn between(reference: &[Trsf], place: &[Trsf]) -> IsometryMatrix3<f64> {
    let (reference, place) = without_common_end(reference, place);
    resolve(reference).inverse() * resolve(place)
}

/// Removes the equal transformations at the outer ends of both chains.
fn without_common_end<'a>(left: &'a [Trsf], right: &'a [Trsf]) -> (&'a [Trsf], &'a [Trsf]) {
    match (left, right) {
        ([left_inner @ .., left_last], [right_inner @ .., right_last]) if left_last == right_last => {
            without_common_end(left_inner, right_inner)
        }
        _ => (left, right),
    }
}

#[cfg(test)]
mod tests {
    use proptest::collection::vec;
    use proptest::prelude::*;

    use super::*;
    use crate::testing::{any_trsf, assert_near};

    const TABLE: Trsf = Trsf::new([500.0, 0.0, 100.0], [0.0, 0.0, 90.0]);
    const PALLET: Trsf = Trsf::new([10.0, 20.0, 0.0], [0.0, 0.0, 90.0]);
    const POINT: Trsf = Trsf::new([0.1, 0.2, 0.3], [180.0, 0.0, 33.3]);

    #[test]
    fn a_chain_leads_to_world() {
        assert_eq!(position(&[POINT, TABLE], &[]), Trsf::new([499.8, 0.1, 100.3], [180.0, 0.0, -56.7]));
        assert_eq!(position(&[PALLET, TABLE], &[]), Trsf::new([480.0, 10.0, 100.0], [0.0, 0.0, 180.0]));
        assert_eq!(position(&[], &[]), Trsf::IDENTITY);
    }

    #[test]
    fn seen_from_its_father_a_place_is_what_it_says() {
        assert_eq!(position(&[POINT, PALLET, TABLE], &[PALLET, TABLE]), POINT);
        assert_eq!(position(&[TABLE], &[]), TABLE);
    }

    #[test]
    fn a_place_is_seen_from_its_brother_and_its_child() {
        let brother = Trsf::new([10.0, 0.0, 0.0], [0.0; 3]);
        assert_eq!(position(&[PALLET, TABLE], &[brother, TABLE]), Trsf::new([0.0, 20.0, 0.0], [0.0, 0.0, 90.0]));
        assert_eq!(position(&[TABLE], &[PALLET, TABLE]), PALLET.inverse());
    }

    /// Example of `distance` between two tools (manual 9.3.4), and the sentence about `position` (manual 9.6.3).
    #[test]
    fn a_distance_is_that_of_the_positions() {
        let (first, second) = (Trsf::new([0.0, 0.0, 100.0], [0.0; 3]), Trsf::new([30.0, 40.0, 100.0], [0.0; 3]));
        assert_eq!(position(&[first], &[]).distance(&position(&[second], &[])), 50.0);
        assert_eq!(distance(&[first, TABLE], &[second, TABLE]), 50.0);
        assert_eq!(distance(&[first, TABLE], &[second, PALLET, TABLE]), 3400.0_f64.sqrt());
    }

    /// First example of `compose` (manual 9.6.3).
    #[test]
    fn a_rotation_turns_a_point_about_the_reference() {
        let turn = Trsf::new([0.0; 3], [0.0, 0.0, 90.0]);
        let point = Trsf::new([100.0, 0.0, 5.0], [180.0, 0.0, 0.0]);
        assert_eq!(compose(&[point], &[], &turn), Some(Trsf::new([0.0, 100.0, 5.0], [180.0, 0.0, -90.0])));
        let at_point = Trsf::new([100.0, 0.0, 0.0], [0.0; 3]);
        assert_eq!(compose(&[point], &[at_point], &turn), Some(Trsf { rz: -90.0, ..point }));
    }

    /// Second example of `compose` (manual 9.6.3).
    #[test]
    fn a_translation_moves_a_point_along_the_axes_of_the_reference() {
        let step = Trsf::new([10.0, 0.0, 0.0], [0.0; 3]);
        assert_eq!(compose(&[POINT, TABLE], &[PALLET, TABLE], &step), Some(Trsf { y: 10.2, ..POINT }));
        assert_eq!(compose(&[POINT, TABLE], &[], &step), Some(Trsf { y: POINT.y - 10.0, ..POINT }));
        assert_eq!(compose(&[], &[], &step), None);
    }

    fn chain() -> impl Strategy<Value = Vec<Trsf>> {
        vec(any_trsf(), 1..4)
    }

    proptest! {
        #[test]
        fn common_fathers_do_not_matter(a in chain(), b in chain(), fathers in chain()) {
            let within = |chain: &[Trsf]| [chain, &fathers].concat();
            prop_assert_eq!(position(&within(&a), &within(&b)), position(&a, &b));
            let seen: Trsf = (resolve(&within(&b)).inverse() * resolve(&within(&a))).into();
            assert_near(&seen, &position(&a, &b))?;
            prop_assert!((distance(&within(&a), &within(&b)) - distance(&a, &b)).abs() < 1e-9);
        }

        #[test]
        fn chains_are_inverted(a in chain(), b in chain()) {
            assert_near(&position(&a, &b), &position(&b, &a).inverse())?;
            prop_assert_eq!(distance(&a, &b), distance(&b, &a));
            let products = a.iter().copied().reduce(|inner, outer| outer * inner).unwrap();
            assert_near(&products, &position(&a, &[]))?;
        }

        #[test]
        fn compose_is_a_product_in_the_reference(point in chain(), reference in chain(), step in any_trsf()) {
            let moved = compose(&point, &reference, &step).unwrap();
            let moved = [&[moved], &point[1..]].concat();
            let expected = step * position(&point, &reference);
            let found = position(&moved, &reference);
            prop_assert!(found.distance(&expected) < 1e-8);
            let turned = |trsf: Trsf| Trsf::new([0.0; 3], trsf.angles());
            assert_near(&turned(found), &turned(expected))?;
        }
    }
}
