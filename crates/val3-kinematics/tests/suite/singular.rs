//! Singular and unreachable poses.

use val3_geometry::Trsf;
use val3_kinematics::{Configuration, Elbow, RequestedConfiguration, Shoulder, Unreachable, Wrist};

use crate::{apart, arm, difference};

const LEFTY: Configuration = Configuration::new(Shoulder::Lefty, Elbow::Positive, Wrist::Positive);

#[test]
fn with_axes_4_and_6_in_line_axis_4_stays() {
    let arm = arm("TX2-90");
    let joints = [10.0, 20.0, 70.0, 30.0, 0.0, 40.0];
    let near = [10.0, 20.0, 70.0, 12.5, 3.0, 0.0];
    let found = arm.inverse_isometry_on(LEFTY, &arm.flange(&joints), &near).unwrap();
    assert!(apart(&found, &[10.0, 20.0, 70.0, 12.5, 0.0, 57.5]) < 1e-9, "{found:?}");
    let other = Configuration { wrist: Wrist::Negative, ..LEFTY };
    assert_eq!(arm.inverse_isometry_on(other, &arm.flange(&joints), &near).unwrap(), found);
    assert_eq!(arm.solutions(&arm.flange(&joints), &near).filter(|found| found[4] == 0.0).count(), 1);
}

#[test]
fn with_the_wrist_above_axis_1_this_axis_stays() {
    let arm = arm("TX200");
    // With this elbow the wrist is on axis 1.
    let flange = Trsf::new([0.0, 0.0, 1400.0 + 194.0], [0.0, 0.0, 25.0]);
    let near = [77.0, 0.0, 60.0, 0.0, 10.0, 0.0];
    let found = arm.solve(&flange, &near, RequestedConfiguration::FREE).unwrap();
    assert_eq!(found[0], 77.0);
    let (mm, rotation) = difference(&arm.flange(&found), &flange.isometry());
    assert!(mm < 1e-9 && rotation < 1e-12);
}

#[test]
fn a_stretched_arm_has_one_elbow() {
    let arm = arm("TX2-90");
    let stretched = [0.0, 30.0, 0.0, 0.0, 40.0, 0.0];
    let flange = arm.flange(&stretched);
    let lefty = |elbow| arm.inverse_isometry_on(Configuration { elbow, ..LEFTY }, &flange, &stretched).unwrap();
    // The elbow depends on the square root of the remaining distance.
    assert!(apart(&lefty(Elbow::Positive), &stretched) < 1e-4);
    assert!(apart(&lefty(Elbow::Negative), &stretched) < 1e-4);
}

#[test]
fn beyond_the_reach_is_an_error_with_distances() {
    let far = Trsf::new([2000.0, 50.0, 0.0], [0.0, 90.0, 0.0]);
    let error = arm("TX2-90").solve(&far, &[0.0; 6], RequestedConfiguration::FREE).unwrap_err();
    let expected = "the centre of the wrist would be 1850.0 mm from the shoulder, the arm reaches 0.0 to 850.0 mm";
    assert_eq!(error.to_string(), expected);
    let near = Trsf::new([0.0, 0.0, 400.0], [0.0, 0.0, 0.0]);
    let error = arm("TX60").solve(&near, &[0.0; 6], RequestedConfiguration::FREE).unwrap_err();
    assert_eq!(error, Unreachable::InsideCylinder { distance: 0.0, radius: 20.0 });
}

#[test]
fn an_axis_beyond_its_limit_is_named() {
    let arm = arm("TX2-90");
    let beyond = [0.0, 0.0, 90.0, 0.0, 160.0, 0.0];
    let error = arm.inverse_on(LEFTY, &arm.forward(&beyond), &[0.0; 6]).unwrap_err();
    assert!(matches!(error, Unreachable::Limit { axis: 5, max: 140.0, .. }), "{error:?}");
    let violations: Vec<_> = arm.violations(&beyond).map(|violation| (violation.axis, violation.position)).collect();
    assert_eq!(violations, [(5, 160.0)]);
    assert!(!arm.is_in_range(&beyond) && arm.is_in_range(&[0.0; 6]));
}

#[test]
fn a_scara_arm_cannot_tilt_its_flange() {
    let tilted = Trsf::new([400.0, 0.0, 100.0], [170.0, 0.0, 0.0]);
    let error = arm("TS2-60").solve(&tilted, &[0.0; 6], RequestedConfiguration::FREE).unwrap_err();
    assert_eq!(error.to_string(), "the flange would be tilted by 10.000 degrees, this arm keeps it vertical");
}

#[test]
fn a_number_that_is_none_reaches_nothing() {
    for name in ["TX2-90", "TS2-60"] {
        let nowhere = Trsf::new([f64::NAN; 3], [f64::NAN; 3]);
        assert!(arm(name).solve(&nowhere, &[0.0; 6], RequestedConfiguration::FREE).is_err());
    }
}
