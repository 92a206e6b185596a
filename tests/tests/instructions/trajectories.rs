//! Programs in 10.1.2 and 10.6 of the manual. The arm is a TX2-90.

use val3_geometry::Vector3;
use val3_motion::{MotionPhase, Sample};
use val3_tests::running::Running;

/// The arm is at `pPick`, and `pDepart`, `pAppro` and `pPlace` form a U of 250, 600 and 250 mm.
const U: &str = "mdesc mDesc\njoint jReady\npoint pPick\npoint pDepart\npoint pAppro\npoint pPlace\nnum nStart\n  \
                 mDesc.blend=off\n  enablePower()\n  wait(isPowered())\n  jReady={0,0,90,0,90,0}\n  \
                 movej(jReady,flange,mDesc)\n  waitEndMove()\n  pPick=appro(here(flange,world),{0,300,200,0,0,0})\n  \
                 movel(pPick,flange,mDesc)\n  waitEndMove()\n  pDepart=appro(pPick,{0,0,-250,0,0,0})\n  \
                 pPlace=appro(pPick,{0,-600,0,0,0,0})\n  pAppro=appro(pPlace,{0,0,-250,0,0,0})\n  setMoveId(0)\n";

/// The cycle in 10.1.1.
const STOPS: &str = "  movel(pDepart,flange,mDesc)\n  movej(pAppro,flange,mDesc)\n  movel(pPlace,flange,mDesc)\n";

/// The cycle in 10.1.2.1.
const BLENDS: &str = "  mDesc.blend=joint\n  mDesc.leave=50\n  mDesc.reach=200\n  movel(pDepart,flange,mDesc)\n  \
                      mDesc.leave=200\n  mDesc.reach=50\n  movej(pAppro,flange,mDesc)\n  mDesc.blend=off\n  \
                      movel(pPlace,flange,mDesc)\n";

/// Returns the output of a cycle, and the samples of the arm during it.
fn cycle(moves: &str) -> (String, Vec<Sample>) {
    let listing = format!("{U}  nStart=clock()\n{moves}  waitEndMove()\n  ? clock()-nStart");
    let (running, samples) = Running::start(&listing).sampled();
    (running.printed(), since_ids_begin_again(&samples))
}

/// Returns the samples of the moves after `setMoveId(0)`.
fn since_ids_begin_again(samples: &[Sample]) -> Vec<Sample> {
    let falls = samples.windows(2).rposition(|pair| pair[1].id < pair[0].id);
    samples[falls.unwrap() + 1..].to_vec()
}

fn place(sample: &Sample) -> Vector3<f64> {
    sample.pose.translation.vector
}

/// Returns `pPick`, `pDepart`, `pAppro` and `pPlace`.
fn corners() -> [Vector3<f64>; 4] {
    [[350.0, 125.0], [350.0, 375.0], [-250.0, 375.0], [-250.0, 125.0]].map(|[y, z]| Vector3::new(475.0, y, z))
}

/// Returns the smallest distance of the arm to a position, in mm.
fn nearest(samples: &[Sample], to: Vector3<f64>) -> f64 {
    samples.iter().map(|sample| (place(sample) - to).norm()).fold(f64::INFINITY, f64::min)
}

/// Returns the lowest speed within 2 mm of a position, in mm/s.
fn slowest(samples: &[Sample], at: Vector3<f64>) -> f64 {
    let near = samples.iter().filter(|sample| (place(sample) - at).norm() < 2.0);
    near.map(|sample| sample.speed.0).fold(f64::INFINITY, f64::min)
}

/// 10.1.2.1: the arm no longer stops at `pDepart` and `pAppro`, so the cycle is faster.
#[test]
fn blends_make_the_cycle_faster() {
    let [_, depart, appro, end] = corners();
    let (stops, samples) = cycle(STOPS);
    assert!([depart, appro].into_iter().all(|corner| slowest(&samples, corner) < 60.0));
    let (blends, samples) = cycle(BLENDS);
    assert!(nearest(&samples, end) < 1e-6);
    let missed = [depart, appro].map(|corner| nearest(&samples, corner));
    assert!(missed.iter().all(|missed| *missed > 5.0), "{missed:?}");
    let blended = samples.iter().filter(|sample| sample.phase == MotionPhase::Blend);
    let least = blended.map(|sample| sample.speed.0).fold(f64::INFINITY, f64::min);
    assert!(least > 500.0, "{least}");
    assert_eq!((stops.as_str(), blends.as_str()), ("1.016\n", "0.844\n"));
}

/// At 1 % of the speed, samples are close enough to each other to show where each blend begins and ends.
#[test]
fn leave_and_reach_are_distances_to_the_point() {
    let (_, samples) = cycle(&format!("  setMonitorSpeed(1)\n{BLENDS}"));
    let changes: Vec<_> = samples.windows(2).filter(|pair| pair[0].phase != pair[1].phase).collect();
    let [_, depart, appro, _] = corners();
    let expected = [(depart, 50.0), (depart, 200.0), (appro, 200.0), (appro, 50.0)];
    for (pair, (corner, distance)) in changes.iter().zip(expected) {
        let [before, after] = [&pair[0], &pair[1]].map(|sample| (place(sample) - corner).norm());
        assert!((before - distance) * (after - distance) <= 0.0 && (before - after).abs() < 0.1, "{before} {after}");
    }
    assert_eq!(changes.len(), 4);
}

const POINTS: &str = "mdesc mDesc\njoint jA\njoint jB\njoint jC\njoint jD\n  enablePower()\n  wait(isPowered())\n  \
                      jA={0,20,90,0,70,0}\n  jB={40,20,90,0,70,0}\n  jC={40,0,110,0,70,0}\n  jD={0,0,110,0,70,0}\n";

/// 10.1.2.2: `waitEndMove` ends `pB` without a blend; the other moves are not reached, and the arm waits before the
/// last one.
#[test]
fn waiting_for_the_end_of_a_move_cancels_its_blend() {
    let listing = format!(
        "{POINTS}  mDesc.blend=joint\n  mDesc.leave=10\n  mDesc.reach=10\n  movej(jA,flange,mDesc)\n  \
         movej(jB,flange,mDesc)\n  waitEndMove()\n  ? herej()\n  ? getMoveId()\n  movej(jC,flange,mDesc)\n  \
         movej(jD,flange,mDesc)\n  delay(2)\n  ? isEmpty()\n  ? \
         round(distance(here(flange,world),jointToPoint(flange,world,jD))*1000)/1000"
    );
    let (running, samples) = Running::start(&listing).sampled();
    assert_eq!(running.printed(), "{40,20,90,0,70,0}\n2\nfalse\n10\n");
    let model = running.controller.arm().model();
    let at = |j1: f64, j2: f64, j3: f64| model.flange(&[j1, j2, j3, 0.0, 70.0, 0.0]).translation.vector;
    let [a, b, c] = [at(0.0, 20.0, 90.0), at(40.0, 20.0, 90.0), at(40.0, 0.0, 110.0)].map(|at| nearest(&samples, at));
    assert!((1.0..10.0).contains(&a) && b < 1e-9 && (1.0..10.0).contains(&c), "{a} {b} {c}");
}

/// 10.6, `getMoveId`: 15.8 after 80 % of the segment to `pA`, 16.572 after 57.2 % of the segment to `pB`, 17 at the
/// end.
#[test]
fn ids_are_those_of_the_manual() {
    let listing = format!(
        "{U}num nIdA\nnum nIdB\nnum nId\n  setMoveId(15)\n  nIdA=movel(pDepart,flange,mDesc)\n  \
         nIdB=movel(pAppro,flange,mDesc)\n  waitEndMove()\n  nId=getMoveId()\n  ? nIdA\n  ? nIdB\n  ? nId"
    );
    let (running, samples) = Running::start(&listing).sampled();
    assert_eq!(running.printed(), "15\n16\n17\n");
    let [pick, depart, appro, _] = corners();
    let parts = [(15.0, pick, depart), (16.0, depart, appro)];
    for (id, from, to) in parts {
        let done = samples.iter().filter(|sample| (id..id + 1.0).contains(&sample.id));
        let shares: Vec<_> = done.map(|sample| (sample.id - id, (place(sample) - from).norm())).collect();
        assert!(shares.len() > 50);
        for (share, way) in shares {
            assert!((way - share * (to - from).norm()).abs() < 1e-6, "{share} of {way} mm");
        }
    }
}

/// The speed on a line is `tvel`, and after the arrival the encoders reach the commanded position.
#[test]
fn the_tool_moves_at_tvel_and_settles() {
    let listing = format!(
        "{U}num nLate\n  mDesc.tvel=250\n  movel(pDepart,flange,mDesc)\n  delay(0.5)\n  ? abs(getSpeed(flange)-250)<0.25\n  \
         waitEndMove()\n  ? isSettled()\n  nLate=clock()\n  wait(isSettled())\n  nLate=clock()-nLate\n  ? nLate>=0.05 and nLate<=0.1"
    );
    assert_eq!(Running::start(&listing).to_the_end().printed(), "true\nfalse\ntrue\n");
}

/// Real programs contain such descriptors.
#[test]
fn generous_descriptors_are_accepted() {
    let listing = format!(
        "{U}  mDesc.vel=500\n  mDesc.accel=9999\n  mDesc.decel=4000\n  mDesc.tvel=99999\n  mDesc.rvel=99999\n{BLENDS}  \
         waitEndMove()\n  ? distance(here(flange,world),pPlace)<1e-9"
    );
    assert_eq!(Running::start(&listing).to_the_end().printed(), "true\n");
}
