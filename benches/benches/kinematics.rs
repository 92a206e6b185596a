//! Kinematics of a TX60: `cargo bench --bench kinematics`, in comparison with rs-opw-kinematics.
//!
//! Targets: a pose in less than 150 ns, all 8 branches of the inverse kinematics in less than 1 µs.

#![allow(missing_docs, reason = "benchmarks are named by their functions")]
#![allow(clippy::expect_used, reason = "an arm that cannot be loaded measures nothing")]

use divan::{Bencher, black_box};
use rs_opw_kinematics::kinematic_traits::Kinematics;
use rs_opw_kinematics::kinematics_impl::OPWKinematics;
use rs_opw_kinematics::parameters::opw_kinematics::Parameters;
use val3_kinematics::{Arm, Joints};

const JOINTS: Joints = [12.0, 34.0, 56.0, 78.0, 65.0, -43.0];

fn main() {
    divan::main();
}

fn arm() -> Arm {
    Arm::by_name("TX60").expect("a shipped arm")
}

fn peer() -> OPWKinematics {
    OPWKinematics::new(Parameters {
        a1: 0.0,
        a2: 0.0,
        b: 0.02,
        c1: 0.0,
        c2: 0.29,
        c3: 0.31,
        c4: 0.07,
        offsets: [0.0; 6],
        sign_corrections: [1; 6],
        dof: 6,
    })
}

#[divan::bench]
fn forward(bencher: Bencher<'_, '_>) {
    let arm = arm();
    bencher.bench_local(|| arm.flange(black_box(&JOINTS)));
}

#[divan::bench]
fn forward_peer(bencher: Bencher<'_, '_>) {
    let (peer, joints) = (peer(), JOINTS.map(f64::to_radians));
    bencher.bench_local(|| peer.forward(black_box(&joints)));
}

#[divan::bench]
fn inverse(bencher: Bencher<'_, '_>) {
    let arm = arm();
    let flange = arm.flange(&JOINTS);
    bencher.bench_local(|| arm.solutions(black_box(&flange), &JOINTS).count());
}

#[divan::bench]
fn inverse_peer(bencher: Bencher<'_, '_>) {
    let peer = peer();
    let pose = peer.forward(&JOINTS.map(f64::to_radians));
    bencher.bench_local(|| peer.inverse(black_box(&pose)).len());
}

#[divan::bench]
fn inverse_on_a_branch(bencher: Bencher<'_, '_>) {
    let arm = arm();
    let (flange, branch) = (arm.flange(&JOINTS), arm.configuration(&JOINTS));
    bencher.bench_local(|| arm.inverse_isometry_on(branch, black_box(&flange), &JOINTS));
}
