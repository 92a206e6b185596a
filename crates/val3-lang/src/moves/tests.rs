//! Joint positions of a SCARA arm in applications in millimetres and in inches.

use val3_kinematics::{Arm, Joints};
use val3_moves::MovePath;

use crate::ports::SECOND;
use crate::testing::Bench;
use crate::types::{self, LengthUnit};

/// Joint position in degrees and mm.
const POSITION: Joints = [10.0, 20.0, 50.8, 40.0, 0.0, 0.0];

/// Index of the linear axis.
const STROKE: usize = 2;

/// Bench of a TS2-60, in which `jA` is [`POSITION`].
fn bench(unit: LengthUnit) -> Bench {
    let mut bench = Bench::default().global("joint jA; joint jB; tool tT; frame fF; point pP; mdesc mA");
    (bench.unit, bench.arm) = (unit, Some(types::Arm::Scara));
    bench.controller.arm = Arm::by_name("TS2-60").unwrap();
    bench.run("link(tT,flange)");
    bench.run("link(fF,world)");
    bench.set("jA", &scaled(POSITION, 1.0 / unit.millimetres()));
    bench
}

fn scaled(mut joints: Joints, factor: f64) -> Joints {
    joints[STROKE] *= factor;
    joints
}

fn is_close(a: &[f64], b: &[f64]) -> bool {
    a.len() == b.len() && a.iter().zip(b).all(|(a, b)| (a - b).abs() < 1e-9)
}

/// Value of `jB` after the line, in degrees and mm. A waiting instruction is continued.
fn assigned(line: &str, unit: LengthUnit) -> Joints {
    let mut bench = bench(unit);
    while bench.run(line).starts_with("sleeps") {
        bench.now += SECOND;
    }
    scaled(bench.numbers("jB").try_into().unwrap(), unit.millimetres())
}

#[test]
fn positions_of_the_arm_have_the_unit_of_the_application() {
    for (line, stroke) in [
        ("jB=herej()", 90.0),
        ("jB=$getJntFbk()", 91.0),
        ("jB=getPositionErr()", -1.0),
        ("jB=getJntRef(\"park\")", 30.0),
        ("getLatch(jB)", 40.0),
        ("jB=resetTurn(jA)", POSITION[STROKE]),
    ] {
        let [mm, inches] = [LengthUnit::Millimetre, LengthUnit::Inch].map(|unit| assigned(line, unit));
        assert!(is_close(&mm, &inches) && (mm[STROKE] - stroke).abs() < 1e-9, "{line}: {mm:?} {inches:?}");
    }
}

#[test]
fn positions_of_the_application_are_converted_for_the_arm() {
    for unit in [LengthUnit::Millimetre, LengthUnit::Inch] {
        let mut bench = bench(unit);
        for line in ["movej(jA,tT,mA)", "alterMovej(jA,tT,mA)", "movejf(jA,tT,mA,10)"] {
            bench.run(line);
            let path = bench.controller.moves.last().map(|request| request.path.clone());
            let Some(MovePath::Joint(target)) = path else { panic!("{line}: {path:?}") };
            assert!(is_close(&target, &POSITION), "{line}: {target:?}");
        }
        bench.run("resetMotion(jA)");
        assert!(is_close(&bench.controller.start.unwrap(), &POSITION), "{:?}", bench.controller.start);
    }
}

#[test]
fn points_and_joints_are_converted_in_the_unit_of_the_application() {
    let [mm, inches] = [LengthUnit::Millimetre, LengthUnit::Inch].map(|unit| {
        let mut bench = bench(unit);
        bench.run("pP=jointToPoint(tT,fF,jA)");
        assert_eq!(bench.run("pointToJoint(tT,jA,pP,jB)"), "true");
        assert!(is_close(bench.numbers("jA"), bench.numbers("jB")), "{:?}", bench.numbers("jB"));
        bench.numbers("pP")[..3].iter().map(|length| length * unit.millimetres()).collect::<Vec<_>>()
    });
    assert!(is_close(&mm, &inches), "{mm:?} {inches:?}");
}

#[test]
fn ranges_are_in_the_unit_of_the_application() {
    let range = Arm::by_name("TS2-60").unwrap().limits()[STROKE].max;
    for (unit, factor) in [(LengthUnit::Millimetre, 1.0), (LengthUnit::Inch, 25.4)] {
        let mut bench = bench(unit);
        for (stroke, expected) in [(range - 0.1, "true"), (range + 0.1, "false")] {
            bench.set("jA", &[0.0, 0.0, stroke / factor]);
            assert_eq!(bench.run("isInRange(jA)"), expected, "{unit:?} {stroke}");
        }
    }
}
