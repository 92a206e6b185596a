//! Regression tests for corners whose shape or time was wrong.

use super::*;

/// Motion of a TX2-90 with joint moves to these positions and a tool off axis 6.
fn joint_moves(tool: &Trsf, targets: &[Joints], blend: Blend) -> Motion {
    let mut motion = motion();
    for (target, id) in targets.iter().zip(0..) {
        let request = request(MovePath::Joint(*target), fast(), blend, f64::from(id));
        motion.record(&Move { tool: tool.isometry(), ..request }).unwrap();
    }
    motion.close().unwrap();
    motion
}

fn joint_corner(leave: f64, reach: f64) -> Blend {
    Blend::Joint { leave: Millimetres(leave), reach: Millimetres(reach) }
}

/// Minimum and maximum value in a run.
fn range(samples: &[Sample], value: impl Fn(&Sample) -> f64) -> [f64; 2] {
    samples
        .iter()
        .map(value)
        .fold([f64::INFINITY, f64::NEG_INFINITY], |[least, most], value| [least.min(value), most.max(value)])
}

/// Regression: an axis that turns the tool about its tip moved to 1169 degrees.
#[test]
fn a_turn_next_to_a_long_move_stays_within_its_angle() {
    let targets = [[0.0, 0.0, 90.0, 0.0, 90.0, 90.0], [40.0, 0.0, 90.0, 0.0, 90.0, 90.0]];
    let mut times = Vec::new();
    for beside in [0.0, 1e-6, 1e-3, 0.05, 0.2, 0.5, 1.0, 2.0, 5.0, 20.0] {
        let tool = Trsf::new([beside, 0.0, 100.0], [0.0; 3]);
        let mut motion = joint_moves(&tool, &targets, joint_corner(50.0, 50.0));
        times.push(motion.time_left().0);
        let [least, most] = range(&run(&mut motion, |_, _| ()), |sample| sample.joints[5]);
        assert!(least > -1e-9 && most < 90.0 + 1e-9, "axis 6 from {least} to {most} with a tip {beside} mm beside it");
    }
    let [first, ..] = times[..] else { unreachable!("a time for each tip") };
    assert!(times.iter().all(|time| (time - first).abs() < 0.02), "{times:?}");
}

/// Regression: the blend exceeded the limit of axis 1 without an error.
#[test]
fn a_corner_at_the_limit_of_an_axis_stays_within_it() {
    for (leave, reach) in [(20.0, 200.0), (5.0, 300.0)] {
        let mut motion = motion();
        let corner = joint_corner(leave, reach);
        motion.record(&request(MovePath::Joint([178.0, 0.0, 90.0, 0.0, 90.0, 0.0]), fast(), corner, 0.0)).unwrap();
        motion.record(&request(MovePath::Joint([178.0, 60.0, 60.0, 0.0, 90.0, 0.0]), fast(), Blend::Off, 1.0)).unwrap();
        let [_, most] = range(&run(&mut motion, |_, _| ()), |sample| sample.joints[0]);
        assert!(most <= 178.0 + 1e-9, "{most}");
    }
}

/// Regression: a blend passed the corner between two lines by up to 36 mm, and the U of manual 10.1.2.1 rose 15 mm
/// above its points.
#[test]
fn corners_of_unequal_distances_do_not_pass_their_points() {
    let pairs = [(50.0, 50.0), (20.0, 50.0), (5.0, 50.0), (1.0, 50.0), (5.0, 200.0), (90.0, 5.0), (50.0, 200.0)];
    for (leave, reach) in pairs {
        for blend in
            [joint_corner(leave, reach), Blend::Cartesian { leave: Millimetres(leave), reach: Millimetres(reach) }]
        {
            let mut motion = motion();
            motion.record(&request(line(moved(0.0, 0.0, 200.0)), fast(), blend, 0.0)).unwrap();
            motion.record(&request(line(moved(0.0, 300.0, 200.0)), fast(), blend, 1.0)).unwrap();
            motion.record(&request(line(moved(0.0, 300.0, 0.0)), fast(), Blend::Off, 2.0)).unwrap();
            let top = moved(0.0, 0.0, 200.0).translation.vector.z;
            let samples = run(&mut motion, |_, _| ());
            let [_, most] = range(&samples, |sample| sample.pose.translation.vector.z);
            assert!(most < top + 0.05, "{} mm above with {blend:?}", most - top);
        }
    }
}

/// Regression: the arm rested forever between two knots.
#[test]
fn a_turn_and_a_move_of_micrometres_end() {
    for micrometres in [1.0, 2.0, 5.0, 10.0, 20.0] {
        for angle in [5.0, 20.0, 40.0, 60.0] {
            let mut motion = motion();
            let turn = Trsf::new([0.0; 3], [0.0, 0.0, angle]).isometry();
            let aside = Trsf::new([0.0, micrometres / 1000.0, 0.0], [0.0; 3]).isometry();
            let target = moved(0.0, 0.0, 0.0) * turn;
            motion.record(&request(line(target), fast(), joint_corner(50.0, 50.0), 0.0)).unwrap();
            motion.record(&request(line(target * aside), fast(), Blend::Off, 1.0)).unwrap();
            motion.close().unwrap();
            let time = motion.time_left().0;
            assert!(time < 1.0, "{time} s after {angle} degrees and {micrometres} um");
            run(&mut motion, |_, _| ());
            assert!(motion.is_empty());
        }
    }
}

/// Regression: a blend that ends at its corner exceeded an acceleration by a factor of five.
#[test]
fn a_corner_with_one_distance_is_a_stop() {
    let target = |change: Trsf| moved(0.0, 0.0, 0.0) * change.isometry();
    let turned = target(Trsf::new([0.0; 3], [8.0, 20.0, 15.0]));
    let away = IsometryMatrix3::from_parts(
        (turned.translation.vector + Vector3::new(0.0, -30.0, 70.0)).into(),
        turned.rotation,
    );
    for (leave, reach) in [(10.0, 0.0), (0.0, 10.0), (10.0, 1.0), (10.0, 0.01)] {
        for blend in
            [joint_corner(leave, reach), Blend::Cartesian { leave: Millimetres(leave), reach: Millimetres(reach) }]
        {
            let mut motion = motion();
            motion.record(&request(line(turned), fast(), blend, 0.0)).unwrap();
            motion.record(&request(line(away), fast(), Blend::Off, 1.0)).unwrap();
            let samples = run(&mut motion, |_, _| ());
            for three in samples.windows(3) {
                for (axis, nominal) in NOMINAL.iter().enumerate() {
                    let [before, here, after] = [0, 1, 2].map(|sample: usize| three[sample].joints[axis]);
                    let used = (after - 2.0 * here + before).abs() / CYCLE.0.powi(2) / (5.0 * nominal);
                    assert!(used < 1.02, "{used} of the acceleration of axis {} with {blend:?}", axis + 1);
                }
            }
        }
    }
}

/// Duration of two lines with an angle `turn` between them, on both of which the tool rotates.
fn corner_time(turn: f64, lengths: [f64; 2], tools: [f64; 2], blend: Blend) -> f64 {
    let mut motion = motion();
    let (sin, cos) = val3_geometry::degrees::sin_cos(turn);
    let [there, back] = lengths;
    let [first, second] = tools.map(|angle| Trsf::new([0.0; 3], [0.0, 0.0, angle]).isometry());
    motion.record(&request(line(moved(0.0, there, 0.0) * first), fast(), blend, 0.0)).unwrap();
    let end = moved(0.0, there + back * cos, back * sin) * second;
    motion.record(&request(line(end), fast(), Blend::Off, 1.0)).unwrap();
    motion.time_left().0
}

/// Positions of the arm on the first blend after a turn of `angle` degrees in a move of `aside`, in mm.
fn blend_after_turn(aside: [f64; 3], angle: f64, blend: Blend) -> Vec<Axes> {
    let mut motion = motion();
    let turn = Trsf::new(aside, [0.0, 0.0, angle]).isometry();
    motion.record(&request(line(moved(0.0, 0.0, 0.0) * turn), fast(), blend, 0.0)).unwrap();
    motion.record(&request(line(moved(0.0, 150.0, 0.0) * turn), fast(), Blend::Off, 1.0)).unwrap();
    let span = &motion.timeline.spans[0].span;
    (0..=50).map(|part| span.axes(&Model(&motion.arm), f64::from(part) / 50.0)).collect()
}

proptest! {
    #![proptest_config(cases())]

    /// Manual 10.1.2.1: the motion is faster because the arm does not stop.
    #[test]
    fn no_blend_takes_longer_than_a_stop(
        turn in 0.0..180.0_f64,
        lengths in prop::array::uniform2(60.0..200.0_f64),
        tools in prop::array::uniform2(-50.0..50.0_f64),
        distances in prop::array::uniform2(2.0..60.0_f64),
    ) {
        let [leave, reach] = distances.map(Millimetres);
        let stop = corner_time(turn, lengths, tools, Blend::Off);
        for blend in [Blend::Joint { leave, reach }, Blend::Cartesian { leave, reach }] {
            let time = corner_time(turn, lengths, tools, blend);
            prop_assert!(time < stop + CYCLE.0, "{time} s instead of {stop} s with {blend:?}");
        }
    }

    /// As a move becomes shorter, its blend approaches the blend of a rotation in place.
    #[test]
    fn a_move_that_shrinks_tends_to_a_turn_in_place(
        angle in 5.0..90.0_f64,
        direction in prop::array::uniform3(-1.0..1.0_f64),
        distances in prop::array::uniform2(2.0..60.0_f64),
        is_joint in any::<bool>(),
    ) {
        let [leave, reach] = distances.map(Millimetres);
        let blend = if is_joint { Blend::Joint { leave, reach } } else { Blend::Cartesian { leave, reach } };
        let exact = blend_after_turn([0.0; 3], angle, blend);
        let mut before = f64::INFINITY;
        for length in [1.0, 1e-2, 1e-4, 1e-6] {
            let near = blend_after_turn(direction.map(|part| part * length), angle, blend);
            let apart = exact.iter().zip(near).map(|(exact, near)| (exact - near).amax()).fold(0.0, f64::max);
            prop_assert!(apart < before.max(1e-6) && apart < 20.0 * length + 1e-6, "{apart} degrees at {length} mm");
            before = apart;
        }
    }
}
