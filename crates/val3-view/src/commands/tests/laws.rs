//! Properties of teaching that hold for all arms.

use proptest::prelude::*;
use val3_kinematics::{Arm, Joints};
use val3_machine::arm::RobotArm;
use val3_machine::controller::Controller;
use val3_test::Fixture;

use super::*;

/// Teaches during the delay, then moves to the taught values.
const LISTING: &str = r#"
frame fTable
point pPick
joint jPick
tool tGripper
mdesc mSlow

program start()
begin
  link(fTable,world)
  fTable.trsf={FRAME}
  link(pPick,fTable)
  pPick.config=CONFIG
  link(tGripper,flange)
  tGripper.trsf={TOOL}
  delay(1)
  enablePower()
  wait(isPowered())
  movej(pPick,tGripper,mSlow)
  movej(jPick,tGripper,mSlow)
  waitEndMove()
end
"#;

/// Application in inches or mm for a kind of arm. Frames and tools of SCARA arms turn around z.
fn listing(is_scara: bool, has_config: bool, is_inch: bool, x: f64, angle: f64) -> String {
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
    let mut listing = LISTING.replace("CONFIG", config).replace("FRAME", &frame).replace("TOOL", &tool);
    if is_scara {
        listing = listing.replace("point pPick", "pointRs pPick").replace("joint jPick", "jointRs jPick");
    }
    if is_inch { Fixture::in_inches(&listing) } else { listing }
}

fn is_near(joints: &[f64], taught: &Joints) -> bool {
    joints.iter().zip(taught).all(|(joint, taught)| (joint - taught).abs() < 1e-6)
}

fn solved(name: &str, controller: &mut Controller) -> Vec<Value> {
    let arguments = json!({ "name": name, "tool": { "name": "tGripper" } });
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

    /// A `movej` to a taught point or joint position does not change the joints, and `solve` predicts it.
    #[test]
    fn a_move_to_a_taught_value_keeps_the_joints(
        fractions in prop::array::uniform6(0.05..0.95_f64), x in -300.0..300.0_f64, angle in -80.0..80.0_f64,
        has_config: bool, is_inch: bool,
    ) {
        for name in Arm::names() {
            let arm = Arm::by_name(name).unwrap();
            let Some(taught) = joints(&arm, fractions) else { continue };
            let listing = listing(arm.is_scara(), has_config, is_inch, x, angle);
            let mut running = Running::start(&listing);
            let controller = &mut running.controller;
            controller.step();
            controller.devices.state.arm = RobotArm::new(arm);
            controller.devices.state.arm.start_at(taught).unwrap();
            run(controller, "teach", json!({ "name": "pPick", "tool": { "name": "tGripper" } })).unwrap();
            run(controller, "teach", json!({ "name": "jPick" })).unwrap();
            for value in ["pPick", "jPick"] {
                let kept = chosen(&solved(value, controller));
                prop_assert!(is_near(&kept, &taught), "{name}: {kept:?} is not {taught:?}");
            }
            let (running, samples) = running.sampled();
            prop_assert_eq!(running.printed(), "");
            for sample in samples {
                prop_assert!(is_near(&sample.joints, &taught), "{name}: {:?} is not {taught:?}", sample.joints);
            }
        }
    }
}
