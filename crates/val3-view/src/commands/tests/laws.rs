//! Laws of teaching for all arms.

use proptest::prelude::*;
use val3_kinematics::{Arm, Joints};
use val3_machine::arm::RobotArm;
use val3_machine::controller::Controller;

use super::*;

const LISTING: &str = r#"
frame fTable
point pPick
tool tGripper

program start()
begin
  link(fTable,world)
  fTable.trsf={X,-200,300,A,20,-30}
  link(pPick,fTable)
  pPick.config=CONFIG
  link(tGripper,flange)
  tGripper.trsf={10,X,120,5,A,0}
  delay(1)
end
"#;

fn solved(controller: &mut Controller) -> Vec<Value> {
    let arguments = json!({ "name": "pPick", "tool": { "name": "tGripper" } });
    let solved = Operator::default().execute("solve", arguments.as_object().unwrap(), controller).unwrap();
    solved["solutions"].as_array().unwrap().clone()
}

fn chosen(solutions: &[Value]) -> Vec<f64> {
    let chosen: Vec<&Value> = solutions.iter().filter(|solution| solution["isChosen"] == true).collect();
    assert_eq!(chosen.len(), 1, "{solutions:?}");
    chosen[0]["joints"].as_array().unwrap().iter().map(|joint| joint.as_f64().unwrap()).collect()
}

/// Joints at the fractions of each axis's range, away from the limits and singular positions.
fn joints(arm: &Arm, fractions: [f64; 6]) -> Option<Joints> {
    let mut joints = Joints::default();
    for ((joint, axis), fraction) in joints.iter_mut().zip(arm.limits()).zip(fractions) {
        *joint =
            (axis.min.max(-180.0) + fraction * (axis.max.min(180.0) - axis.min.max(-180.0))).clamp(axis.min, axis.max);
    }
    let is_regular = arm.is_scara() || joints[2].abs() > 5.0 && joints[4].abs() > 5.0;
    is_regular.then_some(joints)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(12))]

    /// `movej` to a taught point leaves the joints unchanged.
    #[test]
    fn a_move_to_a_taught_point_keeps_the_joints(
        fractions in prop::array::uniform6(0.05..0.95_f64), x in -300.0..300.0_f64, angle in -80.0..80.0_f64, has_config: bool,
    ) {
        let six = LISTING.replace('X', &format!("{x:.3}")).replace('A', &format!("{angle:.3}"));
        for name in Arm::names() {
            let arm = Arm::by_name(name).unwrap();
            if arm.is_scara() {
                continue;
            }
            let Some(taught) = joints(&arm, fractions) else { continue };
            let config = if has_config { "{sfree,efree,wfree}" } else { "{righty,enegative,wsame}" };
            let mut controller = Running::start(&six.replace("CONFIG", config)).controller;
            controller.step();
            controller.devices.state.arm = RobotArm::new(arm);
            controller.devices.state.arm.start_at(taught).unwrap();
            run(&mut controller, "teach", json!({ "name": "pPick", "tool": { "name": "tGripper" } })).unwrap();
            let solutions = solved(&mut controller);
            let kept = chosen(&solutions);
            let is_near = kept.iter().zip(&taught).all(|(kept, taught)| (kept - taught).abs() < 1e-6);
            prop_assert!(is_near, "{name}: {kept:?} is not {taught:?}");
        }
    }
}
