//! Sentences about small traces.

use expect_test::{Expect, expect};
use val3_geometry::IsometryMatrix3;
use val3_motion::Phase;

use super::*;
use crate::comparison::compare;
use crate::row::Row;
use crate::testing::{at, line, trace};
use crate::zone::Zone;

const TOLERANCES: Tolerances = Tolerances { mm: 0.5, degrees: 0.5, time: 5.0 };

/// A recording whose moves come from consecutive lines.
fn recording(rows: &[Row]) -> Recording {
    let source = |number: i64| CodeSource {
        instruction: "movel",
        at: Default::default(),
        program: "start".to_owned(),
        line: 10 + number as u32,
        file: "start.pgx".to_owned(),
    };
    Recording::with_sources(trace(rows), source)
}

#[track_caller]
fn check(recorded: &[Row], present: &[Row], expected: Expect) {
    let findings = describe(&compare(recorded, present, TOLERANCES), &recording(present));
    let line = |finding: &Finding| {
        let source = finding.source.as_ref().map_or(String::new(), |source| format!(" [{}]", source.line));
        format!("{}{source}\n", finding.message)
    };
    expected.assert_eq(&findings.iter().map(line).collect::<String>());
}

/// Rows moved and turned.
fn changed(rows: &[Row], part: std::ops::Range<usize>, way: [f64; 3], turn: [f64; 3]) -> Vec<Row> {
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
    check(&rows, &once, expect![[r#""#]]);
    check(&once, &rows, expect![[r#""#]]);
    check(&rows, &changed(&once, 25..26, [0.0, 0.0, 9.0], [0.0, 0.0, 2.0]), expect![[r#""#]]);
    check(&rows, &changed(&rows, 2..3, [0.0; 3], [0.0, 0.7, 0.0]), expect![[r#""#]]);
    let mut flipped = rows.clone();
    flipped.iter_mut().for_each(|row| row.joints[3] += 180.0);
    check(&rows, &flipped, expect![[r#""#]]);
}

#[test]
fn moves_that_differ() {
    let rows = line(35);
    check(&rows, &rows[..31], expect![[r#""#]]);
    check(&rows[..31], &rows, expect![[r#""#]]);
    check(&rows[..11], &rows, expect![[r#""#]]);
    check(&rows, &rows[..11], expect![[r#""#]]);
    check(&rows, &[], expect![[r#""#]]);
    check(&[], &rows, expect![[r#""#]]);
    let both = [changed(&rows[..11], 5..6, [0.0, 0.0, 1.0], [0.0; 3]), rows[11..].to_vec()].concat();
    check(&rows[..31], &both, expect![[r#""#]]);
}

/// The rows with the gaps after some of them prolonged by milliseconds.
fn slowed(rows: &[Row], part: std::ops::Range<usize>, each: u64) -> Vec<Row> {
    let mut late = 0;
    let row = |(place, row): (usize, &Row)| {
        late += if part.contains(&place) { each * 1_000_000 } else { 0 };
        Row { time: row.time + late, ..*row }
    };
    rows.iter().enumerate().map(row).collect()
}

#[test]
fn times_that_differ() {
    let rows = line(91);
    check(&rows, &slowed(&rows, 11..21, 1), expect![[r#""#]]);
    check(&slowed(&rows, 11..21, 4), &rows, expect![[r#""#]]);
    check(&rows, &slowed(&rows, 0..51, 4), expect![[r#""#]]);
    check(&rows, &slowed(&rows, 0..61, 4), expect![[r#""#]]);
    check(&rows, &slowed(&rows, 0..91, 4), expect![[r#""#]]);
    let resting: Vec<Row> =
        rows.iter().enumerate().map(|(place, row)| if place == 10 { Row { phase: Phase::Waiting, ..*row } } else { *row }).collect();
    check(&resting, &slowed(&resting, 11..12, 400), expect![[r#""#]]);
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
    let sentence = |limit: &Limit| {
        let finding = describe_violation(limit, &limit.violation(&rows, 0..30).unwrap(), &recording);
        format!("{} [{}]\n", finding.message, finding.source.unwrap().line)
    };
    expect![[r#""#]].assert_eq(&limits.iter().map(sentence).collect::<String>());
}
