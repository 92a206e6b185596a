//! Descriptions of small traces.

use expect_test::{Expect, expect};
use val3_geometry::IsometryMatrix3;
use val3_motion::MotionPhase;

use super::*;
use crate::comparison::compare;
use crate::row::TraceRow;
use crate::testing::{at, line, trace};
use crate::zone::Zone;

const TOLERANCES: Tolerances = Tolerances { mm: 0.5, degrees: 0.5, time: 5.0 };

/// Returns a recording whose moves come from consecutive lines.
fn recording(rows: &[TraceRow]) -> MotionRecording {
    MotionRecording::with_sources(trace(rows), source)
}

fn source(number: i64) -> CodeSource {
    CodeSource {
        instruction: "movel",
        at: Default::default(),
        program: "start".to_owned(),
        line: 10 + number as u32,
        file: "start.pgx".to_owned(),
    }
}

#[track_caller]
fn check(recorded: &[TraceRow], present: &[TraceRow], expected: Expect) {
    let findings = describe(&compare(recorded, present, TOLERANCES), &recording(present));
    expected.assert_eq(&findings.iter().map(shown).collect::<String>());
}

/// Returns the message of a finding with its line.
fn shown(finding: &Finding) -> String {
    let source = finding.source.as_ref().map_or(String::new(), |source| format!(" [{}]", source.line));
    format!("{}{source}\n", finding.message)
}

/// Moves and turns a range of rows.
fn changed(rows: &[TraceRow], part: std::ops::Range<usize>, way: [f64; 3], turn: [f64; 3]) -> Vec<TraceRow> {
    let mut rows = rows.to_vec();
    rows[part].iter_mut().for_each(|row| *row = at(row, way, turn));
    rows
}

#[test]
fn nothing_to_report() {
    check(&line(35), &line(35), expect![[""]]);
    check(&line(35), &changed(&line(35), 3..9, [0.0, 0.4, 0.0], [0.0; 3]), expect![[""]]);
}

#[test]
fn paths_that_differ() {
    let rows = line(35);
    let once = changed(&rows, 14..15, [0.0, 3.0, 4.0], [0.0; 3]);
    check(
        &rows,
        &once,
        expect![[r#"
        move 2 (movel, start:12) leaves the recorded path: 5.000 mm away, at 0.056 s at (14.0, 3.0, 4.0); this is the largest deviation [12]
    "#]],
    );
    check(
        &once,
        &rows,
        expect![[r#"
        move 2 (movel, start:12) misses a part of the recorded path: 5.000 mm away, recorded at 0.056 s at (14.0, 3.0, 4.0); this is the largest deviation [12]
    "#]],
    );
    check(
        &rows,
        &changed(&once, 25..26, [0.0, 0.0, 9.0], [0.0, 0.0, 2.0]),
        expect![[r#"
            move 2 (movel, start:12) leaves the recorded path: 5.000 mm away, at 0.056 s at (14.0, 3.0, 4.0); the largest deviation is in move 3 (movel, start:13): 9.000 mm away and turned by 2.000 degrees, at 0.100 s at (25.0, 0.0, 9.0) [12]
        "#]],
    );
    check(
        &rows,
        &changed(&rows, 2..3, [0.0; 3], [0.0, 0.7, 0.0]),
        expect![[r#"
        move 1 (movel, start:11) leaves the recorded path: turned by 0.700 degrees, at 0.008 s at (2.0, 0.0, 0.0); this is the largest deviation [11]
    "#]],
    );
    let mut flipped = rows.clone();
    flipped.iter_mut().for_each(|row| row.joints[3] += 180.0);
    check(
        &rows,
        &flipped,
        expect![[r#"
        move 1 (movel, start:11) leaves the recorded path: an axis is 180.0 degrees away, in another configuration, at 0.000 s at (0.0, 0.0, 0.0); this is the largest deviation [11]
    "#]],
    );
}

#[test]
fn moves_that_differ() {
    let rows = line(35);
    check(
        &rows,
        &rows[..31],
        expect![[r#"
            move 4 of the recorded motion is missing: 4.000 mm away, recorded at 0.136 s at (34.0, 0.0, 0.0); this is the largest deviation
            the motion has 3 moves instead of 4
            the whole motion takes 0.124 s instead of 0.140 s (-11.4 %)
        "#]],
    );
    check(
        &rows[..31],
        &rows,
        expect![[r#"
            move 4 (movel, start:14) is not in the recorded motion: 4.000 mm away, at 0.136 s at (34.0, 0.0, 0.0); this is the largest deviation [14]
            the motion has 4 moves instead of 3
            the whole motion takes 0.140 s instead of 0.124 s (+12.9 %)
        "#]],
    );
    check(
        &rows[..11],
        &rows,
        expect![[r#"
            move 2 (movel, start:12) is not in the recorded motion: 10.000 mm away, at 0.080 s at (20.0, 0.0, 0.0); the largest deviation is in move 4 (movel, start:14): 24.000 mm away, at 0.136 s at (34.0, 0.0, 0.0) [12]
            the motion has 4 moves instead of 1
            the whole motion takes 0.140 s instead of 0.044 s (+218.2 %)
        "#]],
    );
    check(
        &rows,
        &rows[..11],
        expect![[r#"
            move 2 of the recorded motion is missing: 10.000 mm away, recorded at 0.080 s at (20.0, 0.0, 0.0); the largest deviation is in move 4: 24.000 mm away, recorded at 0.136 s at (34.0, 0.0, 0.0)
            the motion has 1 move instead of 4
            the whole motion takes 0.044 s instead of 0.140 s (-68.6 %)
        "#]],
    );
    check(
        &rows,
        &[],
        expect![[r#"
        move 1 of the recorded motion is missing
        the motion has 0 moves instead of 4
        the whole motion takes 0.000 s instead of 0.140 s (-100.0 %)
    "#]],
    );
    check(
        &[],
        &rows,
        expect![[r#"
            move 1 (movel, start:11) is not in the recorded motion [11]
            the motion has 4 moves instead of 0
            the whole motion takes 0.140 s instead of 0.000 s
        "#]],
    );
    let both = [changed(&rows[..11], 5..6, [0.0, 0.0, 1.0], [0.0; 3]), rows[11..].to_vec()].concat();
    check(
        &rows[..31],
        &both,
        expect![[r#"
            move 1 (movel, start:11) leaves the recorded path: 1.000 mm away, at 0.020 s at (5.0, 0.0, 1.0); the largest deviation is in move 4 (movel, start:14): 4.000 mm away, at 0.136 s at (34.0, 0.0, 0.0) [11]
            the motion has 4 moves instead of 3
            the whole motion takes 0.140 s instead of 0.124 s (+12.9 %)
        "#]],
    );
}

/// Extends the time before some rows by milliseconds.
fn slowed(rows: &[TraceRow], part: std::ops::Range<usize>, each: u64) -> Vec<TraceRow> {
    let (mut slowed, mut delay) = (rows.to_vec(), 0);
    for (place, row) in slowed.iter_mut().enumerate() {
        delay += if part.contains(&place) { each * 1_000_000 } else { 0 };
        row.time += delay;
    }
    slowed
}

#[test]
fn times_that_differ() {
    let rows = line(91);
    check(
        &rows,
        &slowed(&rows, 11..21, 1),
        expect![[r#"
        move 2 (movel, start:12) takes 0.050 s instead of 0.040 s (+25.0 %) [12]
    "#]],
    );
    check(
        &slowed(&rows, 11..21, 4),
        &rows,
        expect![[r#"
        move 2 (movel, start:12) takes 0.040 s instead of 0.080 s (-50.0 %) [12]
        the whole motion takes 0.364 s instead of 0.404 s (-9.9 %)
    "#]],
    );
    check(
        &rows,
        &slowed(&rows, 0..51, 4),
        expect![[r#"
        move 1 (movel, start:11) takes 0.084 s instead of 0.044 s (+90.9 %); move 2 (movel, start:12) takes 0.080 s instead of 0.040 s (+100.0 %); move 3 (movel, start:13) takes 0.080 s instead of 0.040 s (+100.0 %); move 4 (movel, start:14) takes 0.080 s instead of 0.040 s (+100.0 %); move 5 (movel, start:15) takes 0.080 s instead of 0.040 s (+100.0 %) [11]
        the whole motion takes 0.564 s instead of 0.364 s (+54.9 %)
    "#]],
    );
    check(
        &rows,
        &slowed(&rows, 0..61, 4),
        expect![[r#"
            move 1 (movel, start:11) takes 0.084 s instead of 0.044 s (+90.9 %); move 2 (movel, start:12) takes 0.080 s instead of 0.040 s (+100.0 %); move 3 (movel, start:13) takes 0.080 s instead of 0.040 s (+100.0 %); move 4 (movel, start:14) takes 0.080 s instead of 0.040 s (+100.0 %); move 5 (movel, start:15) takes 0.080 s instead of 0.040 s (+100.0 %); and 1 more [11]
            the whole motion takes 0.604 s instead of 0.364 s (+65.9 %)
        "#]],
    );
    check(
        &rows,
        &slowed(&rows, 0..91, 4),
        expect![[r#"
            move 1 (movel, start:11) takes 0.084 s instead of 0.044 s (+90.9 %); move 2 (movel, start:12) takes 0.080 s instead of 0.040 s (+100.0 %); move 3 (movel, start:13) takes 0.080 s instead of 0.040 s (+100.0 %); move 4 (movel, start:14) takes 0.080 s instead of 0.040 s (+100.0 %); move 5 (movel, start:15) takes 0.080 s instead of 0.040 s (+100.0 %); and 4 more [11]
            the whole motion takes 0.724 s instead of 0.364 s (+98.9 %)
        "#]],
    );
    let resting: Vec<TraceRow> = rows
        .iter()
        .enumerate()
        .map(|(place, row)| if place == 10 { TraceRow { phase: MotionPhase::Waiting, ..*row } } else { *row })
        .collect();
    check(
        &resting,
        &slowed(&resting, 11..12, 400),
        expect![[r#"
        the whole motion takes 0.764 s instead of 0.364 s (+109.9 %), at rest for 0.404 s instead of 0.004 s
    "#]],
    );
}

#[test]
fn limits_that_are_exceeded() {
    let rows = line(30);
    let zone = |min: [f64; 3], max: [f64; 3]| Zone::new(min, max, &IsometryMatrix3::identity());
    let limits = [
        Limit::Speed { most: 200.0, zone: None },
        Limit::Inside(zone([0.0; 3], [20.5, 1.0, 1.0])),
        Limit::Clear { zone: zone([5.0, 2.0, 0.0], [6.0, 3.0, 0.0]), least: 50.0 },
        Limit::Clear { zone: zone([15.5, -1.0, 0.0], [16.0, 1.0, 0.0]), least: 12.5 },
    ];
    let recording = recording(&rows);
    let violation = |limit: &Limit| limit.violation(&rows, 0..30).unwrap();
    let sentence = |limit: &Limit| shown(&describe_violation(limit, &violation(limit), &recording));
    expect![[r#"
        the tool centre point moves at 250.0 mm/s instead of at most 200 mm/s, at 0.000 s at (0.0, 0.0, 0.0), in move 1 (movel, start:11) [11]
        the tool centre point is 8.500 mm outside of its box, at 0.116 s at (29.0, 0.0, 0.0), in move 3 (movel, start:13) [13]
        the tool centre point comes within 2.000 mm of the box to which it must keep 50 mm, at 0.020 s at (5.0, 0.0, 0.0), in move 1 (movel, start:11) [11]
        the tool centre point is in the box to which it must keep a distance of 12.5 mm, at 0.064 s at (15.5, 0.0, 0.0), in move 2 (movel, start:12) [12]
    "#]].assert_eq(&limits.iter().map(sentence).collect::<String>());
}
