//! Cartesian moves are exactly on their curves, with the correct orientation.

use proptest::prelude::*;
use val3_geometry::{LinePath, rotation};

use super::*;

fn offset() -> impl Strategy<Value = [f64; 3]> {
    prop::array::uniform3(-200.0..200.0_f64)
}

/// Executes a move and checks that every sample is on `curve`, at the fraction of the path in its id.
fn follow(path: MovePath, curve: impl Fn(f64) -> IsometryMatrix3<f64>) -> Result<(), TestCaseError> {
    let mut motion = motion();
    prop_assume!(motion.record(&request(path, fast(), Blend::Off, 0.0)).is_ok() && motion.fault().is_none());
    for sample in run(&mut motion, |_, _| ()) {
        let (ideal, tip) = (curve(sample.id), arm().flange(&sample.joints));
        let off = (ideal.translation.vector - tip.translation.vector).norm();
        let turned = rotation::to_vector(&(ideal.rotation.inverse() * tip.rotation)).norm();
        prop_assert!(off < 1e-6 && turned < 1e-7, "{} mm and {} rad at {}", off, turned, sample.id);
    }
    Ok(())
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 60, max_global_rejects: 100_000, ..ProptestConfig::default() })]

    #[test]
    fn a_line_is_straight(offset in offset(), angles in prop::array::uniform3(-60.0..60.0_f64)) {
        let [x, y, z] = offset;
        let (start, end) = (arm().flange(&START), moved(x, y, z) * Trsf::new([0.0; 3], angles).isometry());
        let ideal = LinePath::between(&start, &end);
        follow(line(end), |share| ideal.at(share))?;
    }

    #[test]
    fn a_circle_is_round(through in offset(), to in offset()) {
        let [through, to] = [through, to].map(|[x, y, z]| moved(x, y, z));
        let ideal = val3_geometry::Arc::through(&arm().flange(&START), &through, &to);
        prop_assume!(ideal.is_ok());
        let destination = MoveTarget { pose: to, configuration: RequestedConfiguration::FREE };
        let ideal = ideal.unwrap();
        follow(MovePath::Circle(through, destination), |share| ideal.at(share))?;
    }
}
