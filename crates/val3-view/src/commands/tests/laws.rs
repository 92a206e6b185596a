//! Properties of teaching that hold for all arms.

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
  fTable.trsf={FRAME}
  link(pPick,fTable)
  pPick.config=CONFIG
  link(tGripper,flange)
  tGripper.trsf={TOOL}
  delay(1)
end
"#;

/// Listing for a kind of arm. Frames and tools of SCARA arms turn around z.
fn listing(is_scara: bool, has_config: bool, x: f64, angle: f64) -> String {
    let (frame, tool) = if is_scara {
        (format!("{x:.3},-200,300,0,0,{angle:.3}"), format!("10,{x:.3},120,0,0,{angle:.3}"))
    } else {
        (format!("{x:.3},-200,300,{angle:.3},20,-30"), format!("10,{x:.3},120,5,{angle:.3},0"))
    };
    let config = match (is_scara, has_config) {
        (true, true) => "{sfree}",
        (true, false) => "{righty}",
        (false, true) => "{sfree,efree,wfree}",
        (false, false) => "{righty,enegative,wsame}",
    };
    let point = if is_scara { "pointRs pPick" } else { "point pPick" };
    let listing = LISTING.replace("point pPick", point).replace("CONFIG", config);
    listing.replace("FRAME", &frame).replace("TOOL", &tool)
}

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

/// Joints at these fractions of each axis's range, away from the limits and singular positions.
fn joints(arm: &Arm, fractions: [f64; 6]) -> Option<Joints> {
    let mut joints = Joints::default();
    for ((joint, axis), fraction) in joints.iter_mut().zip(arm.limits()).zip(fractions) {
        *joint =
            (axis.min.max(-180.0) + fraction * (axis.max.min(180.0) - axis.min.max(-180.0))).clamp(axis.min, axis.max);
    }
    let is_regular =
        if arm.is_scara() { joints[1].abs() > 5.0 } else { joints[2].abs() > 5.0 && joints[4].abs() > 5.0 };
    is_regular.then_some(joints)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(12))]

    /// A `movej` to a taught point does not change the joints.
    #[test]
    fn a_move_to_a_taught_point_keeps_the_joints(
        fractions in prop::array::uniform6(0.05..0.95_f64), x in -300.0..300.0_f64, angle in -80.0..80.0_f64, has_config: bool,
    ) {
        for name in Arm::names() {
            let arm = Arm::by_name(name).unwrap();
            let Some(taught) = joints(&arm, fractions) else { continue };
            let listing = listing(arm.is_scara(), has_config, x, angle);
            let mut controller = Running::start(&listing).controller;
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
