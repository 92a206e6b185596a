//! Pictures of small motions.

use expect_test::expect;
use proptest::prelude::*;

use super::*;
use crate::colours::{PHASES, REFERENCE, colour};

fn axes(count: usize) -> Vec<PictureAxis> {
    (0..count).map(|index| axis(count == 4 && index == 2)).collect()
}

fn axis(is_stroke: bool) -> PictureAxis {
    PictureAxis {
        is_stroke,
        min: -180.0,
        max: 180.0,
        nominal_speed: 200.0,
        nominal_acceleration: 1000.0,
        nominal_deceleration: 1000.0,
    }
}

fn limits() -> impl Iterator<Item = SpeedLimit> {
    SpeedLimit::all()
}

fn line() -> Picture {
    let (target, leave) = ([100.0, 50.0, 300.0], Some([60.0, 50.0, 300.0]));
    let mark = |line, started| MoveMark { leave, ..mark(line, target, started) };
    Picture {
        title: "cell & <table>".to_owned(),
        arm: "TX2-90".to_owned(),
        axes: axes(6),
        samples: (0..=10).map(sample_of_line).collect(),
        moves: vec![mark(7, 0.0), mark(9, 0.03)],
        ..Picture::default()
    }
}

fn sample_of_line(index: u32) -> Sample {
    let x = f64::from(index) * 10.0;
    let phase = if index > 5 { MotionPhase::Blend } else { MotionPhase::Nominal };
    Sample { t: f64::from(index) * 0.004, joints: [x / 10.0; 6], position: [x, 50.0, 300.0], phase, ..sample() }
}

fn sample() -> Sample {
    Sample {
        t: 0.0,
        joints: [0.0; 6],
        position: [0.0; 3],
        speed: 250.0,
        rotation: 0.0,
        phase: MotionPhase::Nominal,
        limit: None,
    }
}

/// Returns a move of a line in `start`, which begins at a time in seconds.
fn mark(line: u32, target: [f64; 3], started: f64) -> MoveMark {
    MoveMark { program: "start".to_owned(), line, target, started: Some(started), ..MoveMark::default() }
}

/// Fails unless the text is well-formed XML without invalid numbers.
#[track_caller]
fn assert_sound(svg: &str) {
    let mut reader = quick_xml::Reader::from_str(svg);
    while !matches!(reader.read_event().unwrap(), quick_xml::events::Event::Eof) {}
    for wrong in ["NaN", "inf"] {
        assert!(!svg.contains(wrong), "{wrong}");
    }
}

#[test]
fn a_line_in_a_plane() {
    let svg = line().to_svg();
    assert_sound(&svg);
    let texts: Vec<_> = svg.lines().filter(|line| line.contains("class=\"label\"")).collect();
    expect![[r#"
        <text x="48.0" y="88.0" class="label">top: x, y (mm)</text>
        <text x="493.0" y="303.6" class="label">7, 9</text>
        <text x="563.0" y="88.0" class="label">front: x, z (mm)</text>"#]]
    .assert_eq(&texts.iter().take(3).copied().collect::<Vec<_>>().join("\n"));
    let drawn = |colour: &str| svg.lines().filter(|line| line.contains("<path") && line.contains(colour)).count();
    assert!(drawn(colour(MotionPhase::Nominal)) >= 3 && drawn(colour(MotionPhase::Blend)) >= 3);
    assert!(svg.contains("<title>cell &amp; &lt;table&gt;</title>"));
}

#[test]
fn nothing_moves() {
    let svg = Picture { title: "idle".to_owned(), axes: axes(6), ..Picture::default() }.to_svg();
    assert_sound(&svg);
    assert!(svg.contains("0 moves, 0.000 s") && svg.contains("recorded no move"));
}

/// Cycles over the same line, there and back, have nearly as many arrows as one cycle.
#[test]
fn a_repeated_path_has_the_arrows_of_one_cycle() {
    let cycles = |count: u32| {
        let at = |index: u32| {
            let (lap, step) = (index / 100 % 2, f64::from(index % 100) * 4.0);
            [if lap == 0 { step } else { 400.0 - step }, 50.0, 300.0]
        };
        let samples =
            (0..200 * count).map(|index| Sample { t: f64::from(index) * 0.004, position: at(index), ..sample() });
        Picture { samples: samples.collect(), moves: Vec::new(), ..line() }.to_svg()
    };
    let arrows = |svg: &str| svg.matches("stroke:none").count();
    let once = arrows(&cycles(1));
    assert!(once >= 8, "{once}");
    // A later cycle may add an arrow at an end that is far from the arrows of the first one.
    let often = arrows(&cycles(7));
    assert!(often <= once + 2, "{often} instead of {once}");
}

#[test]
fn a_line_with_many_targets_has_one_label_a_view() {
    let moves = [0.0, 1.0, 2.0, 3.0].map(|index| mark(13, [index * 20.0; 3], index * 0.01));
    let svg = Picture { moves: moves.to_vec(), ..line() }.to_svg();
    assert_eq!((svg.matches(">13 (4 moves)<").count(), svg.matches(">13<").count()), (3, 1), "{svg}");
}

#[test]
fn the_smallest_distance_is_a_curve_with_a_label() {
    let distance = |index: u32| DistanceSample {
        t: f64::from(index) * 0.004,
        distance: (index != 8).then(|| 100.0 - f64::from(index) * 9.0),
        clearance: 40.0,
        pair: "gripper - rack".to_owned(),
    };
    let svg = Picture { distances: (0..=10).map(distance).collect(), ..line() }.to_svg();
    assert_sound(&svg);
    assert!(svg.contains(">gripper - rack: 10.0 mm<") && svg.contains(">clearance 40<"), "{svg}");
    // A distance that is unknown divides the curve.
    assert_eq!(svg.matches("stroke:#0b6e4f;stroke-width:1.6").count(), 2);
    assert!(!line().to_svg().contains("smallest distance"));
}

#[test]
fn an_hour_of_motion_is_a_small_file() {
    let samples = (0..900_000).step_by(10).map(sample_of_circle).collect();
    let svg = Picture { axes: axes(4), samples, ..line() }.to_svg();
    assert_sound(&svg);
    assert!(svg.len() < 4_000_000, "{}", svg.len());
}

fn sample_of_circle(index: u32) -> Sample {
    let t = f64::from(index) * 0.004;
    let angle = t / 3.0;
    let position = [500.0 * libm::cos(angle), 500.0 * libm::sin(angle), 300.0 + 10.0 * libm::sin(t)];
    let limit = limits().nth(index as usize % 20);
    Sample { t, joints: [90.0 * libm::sin(angle); 6], position, speed: 166.0, limit, ..sample() }
}

proptest! {
    #[test]
    fn any_motion_can_be_drawn(
        points in proptest::collection::vec(([-1.0..1.0_f64, -1.0..1.0_f64, -1.0..1.0_f64], -1e6..1e6_f64, 0..7_usize), 0..40),
        spread in 0.0..1e4_f64,
    ) {
        let samples: Vec<_> = points.iter().enumerate().map(|(index, (point, joint, phase))| Sample {
            t: index as f64 * 0.004,
            joints: [*joint; 6],
            position: point.map(|coordinate| coordinate * spread),
            speed: joint.abs(),
            rotation: joint.abs(),
            phase: PHASES[*phase].0,
            limit: limits().nth(*phase),
        }).collect();
        let picture = Picture { samples, axes: axes(6), has_accelerations: true, ..line() };
        assert_sound(&picture.to_svg());
    }
}

#[test]
fn a_recorded_motion_is_a_band_below_the_present_one() {
    let plain = line().to_svg();
    assert!(!plain.contains(REFERENCE) && !plain.contains("recorded") && !plain.contains("deviation\""));
    let higher = |sample: Sample| Sample { position: [sample.position[0], 50.0, 400.0], ..sample };
    let reference: Vec<_> = line().samples.into_iter().map(higher).collect();
    let deviation =
        Deviation { label: "100.000 mm".to_owned(), at: [50.0, 50.0, 300.0], nearest: [50.0, 50.0, 400.0], t: 0.02 };
    let svg = Picture { reference, deviation: Some(deviation), ..line() }.to_svg();
    assert_sound(&svg);
    // Three views, six axes, the speed, and the legend.
    assert_eq!(svg.matches(REFERENCE).count(), 3 + 6 + 1 + 1, "{svg}");
    let of_first_view = svg.lines().filter(|line| line.starts_with("<path") && line.contains("stroke-linejoin"));
    assert!(of_first_view.map(|line| line.contains(REFERENCE)).take(2).eq([true, false]), "{svg}");
    assert!(svg.contains("0.040 s, recorded 0.040 s") && svg.contains("largest deviation: 100.000 mm"));
    let of_gap: Vec<_> = svg.lines().filter(|line| line.contains("\"deviation")).collect();
    expect![[r#"
        <line x1="285.0" y1="305.0" x2="285.0" y2="305.0" class="deviation"/>
        <text x="286.8" y="297.3" class="deviation label">100.000 mm</text>
        <line x1="800.0" y1="504.0" x2="800.0" y2="106.0" class="deviation"/>
        <text x="801.8" y="496.3" class="deviation label">100.000 mm</text>
        <line x1="1315.0" y1="504.0" x2="1315.0" y2="106.0" class="deviation"/>
        <text x="1324.0" y="502.6" class="deviation label">100.000 mm</text>
        <line x1="840.0" y1="600.0" x2="840.0" y2="1352.0" class="deviation"/>"#]]
    .assert_eq(&of_gap.join("\n"));
}

/// The lines of a class.
fn of_class<'a>(svg: &'a str, class: &str) -> Vec<&'a str> {
    svg.lines().filter(|line| line.contains(&format!("class=\"{class}"))).collect()
}

/// Returns a motion of axis 1 between two positions at constant speed, with the limits of a move.
fn sweep([from, to]: [f64; 2], joint_speed: f64, tool_speed: f64) -> Picture {
    let samples = line()
        .samples
        .into_iter()
        .map(|sample| Sample { joints: [from + (to - from) * sample.t / 0.04, 0.0, 0.0, 0.0, 0.0, 0.0], ..sample });
    let limits =
        MoveLimits { joint_speed, acceleration: 100.0, deceleration: 100.0, tool_speed, tool_rotation: 9999.0 };
    let mark = MoveMark {
        program: "start".to_owned(),
        line: 7,
        limits: Some(limits),
        started: Some(0.0),
        ended: Some(0.04),
        ..MoveMark::default()
    };
    Picture { samples: samples.collect(), axes: axes(1), moves: vec![mark], ..line() }
}

#[test]
fn limits_are_drawn_where_they_come_into_view() {
    let svg = sweep([0.0, 2.0], 40.0, 300.0).to_svg();
    assert_sound(&svg);
    expect![[r#"
        <text x="123.0" y="707.9" class="limit-label">vel 40</text>
        <text x="123.0" y="867.9" class="limit-label">tvel 300</text>"#]]
    .assert_eq(&of_class(&svg, "limit-label").join("\n"));
    // Far above the used values.
    let svg = sweep([0.0, 2.0], 100.0, 9999.0).to_svg();
    assert_eq!(of_class(&svg, "limit-label"), [""; 0]);
    let svg = sweep([100.0, 178.0], 1e6, 9999.0).to_svg();
    let labels = of_class(&svg, "limit-label");
    assert!(matches!(labels[..], [label] if label.contains(">limit 180<")), "{labels:?}");
}

/// Counts the bands along curves at a limit, without the band in the legend.
fn bands(svg: &str) -> usize {
    svg.lines().filter(|line| line.starts_with("<path") && line.contains("#d00000")).count()
}

#[test]
fn a_motion_at_a_limit_is_marked() {
    let speed = 2.0 / 0.04 / 200.0 * 100.0;
    assert_eq!(bands(&sweep([0.0, 2.0], 40.0, 300.0).to_svg()), 0);
    assert_eq!(bands(&sweep([0.0, 2.0], speed, 300.0).to_svg()), 1);
    assert_eq!(bands(&sweep([0.0, 2.0], speed, 250.0).to_svg()), 2);
    let svg = sweep([100.0, 181.5], 1e6, 9999.0).to_svg();
    assert_sound(&svg);
    assert_eq!((bands(&svg), of_class(&svg, "deviation label").len()), (1, 1), "{svg}");
    assert!(svg.contains(">181.5 beyond the limit<"), "{svg}");
}

#[test]
fn accelerations_are_an_option() {
    let picture = Picture { has_accelerations: true, ..sweep([0.0, 2.0], 40.0, 300.0) };
    let (with, without) = (picture.to_svg(), sweep([0.0, 2.0], 40.0, 300.0).to_svg());
    assert_sound(&with);
    assert!(with.contains("joint accelerations") && !without.contains("joint accelerations"));
}

#[test]
fn the_intermediate_point_of_a_circle_is_marked() {
    let mut picture = line();
    assert!(!picture.to_svg().contains("intermediate point"));
    picture.moves[0].intermediate = Some([50.0, 90.0, 300.0]);
    let svg = picture.to_svg();
    // Three views and the legend.
    let diamonds = svg.lines().filter(|line| line.starts_with("<path") && line.contains("fill:#fff"));
    assert_eq!(diamonds.count(), 2 * (3 + 1), "{svg}");
    assert!(svg.contains(">intermediate point<"));
}

#[test]
fn equal_notes_on_blends_are_in_one_view_once() {
    let mut picture = line();
    for mark in &mut picture.moves {
        mark.note = Some("leave 50 → 40 mm".to_owned());
    }
    let svg = picture.to_svg();
    assert_sound(&svg);
    assert_eq!(of_class(&svg, "note").len(), 1, "{svg}");
}

/// Each limit has its colour over its time. Equal neighbours are one piece, and all reasons for rest are one limit.
#[test]
fn the_limits_of_the_speed_are_a_strip_with_a_legend() {
    assert!(!line().to_svg().contains("limited by"));
    let mut picture = line();
    let limits = [
        SpeedLimit::Acceleration(1),
        SpeedLimit::Acceleration(1),
        SpeedLimit::Translation,
        SpeedLimit::Deceleration(3),
        SpeedLimit::Held,
        SpeedLimit::End,
    ];
    for (sample, limit) in picture.samples.iter_mut().zip(limits) {
        sample.limit = Some(limit);
    }
    let svg = picture.to_svg();
    assert_sound(&svg);
    let pieces = svg.lines().filter(|line| line.starts_with("<rect") && line.contains("<title>"));
    expect![[r##"
        <rect x="120.0" y="1352.0" width="288.0" height="12.0" fill="#56b4e9"><title>acceleration of axis 2</title></rect>
        <rect x="408.0" y="1352.0" width="144.0" height="12.0" fill="#f0e442"><title>tvel</title></rect>
        <rect x="552.0" y="1352.0" width="144.0" height="12.0" fill="#0072b2"><title>deceleration of axis 4</title></rect>
        <rect x="696.0" y="1352.0" width="288.0" height="12.0" fill="#d0d0d0"><title>waiting</title></rect>"##]]
    .assert_eq(&pieces.collect::<Vec<_>>().join("\n"));
    // A limit without an axis has its name at its piece, too.
    for (name, count) in [("acceleration of the axis", 1), ("tvel", 2), ("deceleration of the axis", 1), ("waiting", 2)]
    {
        assert_eq!(svg.matches(&format!(">{name}<")).count(), count, "{name}");
    }
}

#[test]
fn rotation_is_drawn_where_rvel_comes_into_view() {
    assert!(!rotation(9999.0).contains("rotation of the tool"));
    let svg = rotation(60.0);
    assert_sound(&svg);
    assert!(svg.contains(">rotation of the tool (°/s)<") && svg.contains(">rvel 60<"), "{svg}");
    assert_eq!((bands(&svg), bands(&rotation(50.0))), (0, 1));
}

/// Returns the picture of a rotation by 50 degrees/s with the limit `rvel`.
fn rotation(rvel: f64) -> String {
    let mut picture = sweep([0.0, 2.0], 40.0, 9999.0);
    picture.samples.iter_mut().for_each(|sample| sample.rotation = 50.0);
    picture.moves.iter_mut().flat_map(|mark| &mut mark.limits).for_each(|limits| limits.tool_rotation = rvel);
    picture.to_svg()
}

#[test]
fn times_of_a_model_arm_have_a_note() {
    let note = "times of a model arm".to_owned();
    let svg = Picture { times_note: Some(note), ..line() }.to_svg();
    assert_eq!((svg.matches("model arm").count(), line().to_svg().matches("model arm").count()), (1, 0));
}
