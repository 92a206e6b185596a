//! Planning and execution of moves: `cargo bench --bench motion`.
//!
//! Targets: a line of 200 mm planned in under 30 µs, a move appended to a queue of 1,000 in under 100 µs, a cycle of 4
//! ms in under 2 µs.

#![allow(missing_docs, reason = "benchmarks are named by their functions")]
#![allow(clippy::expect_used, reason = "a move that is refused measures nothing")]

use std::sync::Arc;

use divan::Bencher;
use val3_geometry::{IsometryMatrix3, Trsf};
use val3_kinematics::{Arm, Joints, RequestedConfiguration};
use val3_motion::{
    Blend, DegreesPerSecond, Manner, Millimetres, MillimetresPerSecond, Motion, Move, MovePath, MoveTarget, Seconds,
    SpeedLimits,
};

const START: Joints = [0.0, 0.0, 90.0, 0.0, 90.0, 0.0];

const CORNER: Blend = Blend::Joint { leave: Millimetres(30.0), reach: Millimetres(30.0) };

fn main() {
    divan::main();
}

fn arm() -> Arm {
    Arm::by_name("TX2-90").expect("the arm is known")
}

/// Returns a linear move to a position `y` mm to the side and `z` mm above the start.
fn line(y: f64, z: f64, blend: Blend) -> Move {
    let arm = arm();
    let start = arm.forward(&START);
    let pose = Trsf { y: start.y + y, z: start.z + z, ..start }.isometry();
    let axes = [0, 1, 2, 3, 4, 5];
    let limits = SpeedLimits {
        speed: axes.map(|axis| arm.nominal_speed(axis)),
        acceleration: axes.map(|axis| arm.nominal_acceleration(axis)),
        deceleration: axes.map(|axis| arm.nominal_deceleration(axis)),
        translation: MillimetresPerSecond(9999.0),
        rotation: DegreesPerSecond(9999.0),
    };
    let path = MovePath::Line(MoveTarget { pose, configuration: RequestedConfiguration::FREE });
    Move { path, tool: IsometryMatrix3::identity(), limits, blend, id: 0.0, manner: Manner::Rigid }
}

/// Returns an arm with this number of queued moves.
fn queue(moves: usize) -> Motion {
    let mut motion = Motion::new(Arc::new(arm()), START);
    for index in 0..moves {
        let (y, z) = if index % 2 == 0 { (200.0, 0.0) } else { (0.0, 100.0) };
        motion.record(&line(y, z, CORNER)).expect("the arm reaches it");
    }
    motion
}

#[divan::bench]
fn plan_a_line(bencher: Bencher<'_, '_>) {
    let (motion, request) = (Motion::new(Arc::new(arm()), START), line(200.0, 0.0, Blend::Off));
    bencher.with_inputs(|| motion.clone()).bench_values(|mut motion| motion.record(&request).map(|()| motion));
}

#[divan::bench(args = [1, 100, 1000])]
fn append(bencher: Bencher<'_, '_>, moves: usize) {
    let (motion, request) = (queue(moves - 1), line(100.0, 200.0, CORNER));
    let first = line(150.0, 50.0, CORNER);
    // A copy has no capacity for another move, unlike a queue that grows.
    let with_room = || recorded(motion.clone(), &first);
    bencher.with_inputs(with_room).bench_values(|mut motion| motion.record(&request).map(|()| motion));
}

fn recorded(mut motion: Motion, request: &Move) -> Motion {
    motion.record(request).expect("the arm reaches it");
    motion
}

#[divan::bench]
fn advance_a_cycle(bencher: Bencher<'_, '_>) {
    let motion = queue(100);
    bencher.with_inputs(|| motion.clone()).bench_values(|mut motion| {
        for _ in 0..100 {
            divan::black_box(motion.advance(Seconds(0.004)));
        }
        motion
    });
}
