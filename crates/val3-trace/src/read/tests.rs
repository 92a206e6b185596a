//! Traces as text.

use expect_test::expect;
use proptest::prelude::*;

use super::*;
use crate::testing::{at, line, trace};

#[test]
fn a_trace_is_a_table_that_names_its_arm() {
    let mut rows = line(3);
    rows[1] = at(&rows[1], [0.0, -0.0002, 12.5], [0.0, 0.0, -90.0]);
    rows[1].joints[5] = -12.34567;
    rows[2].phase = MotionPhase::Waiting;
    expect![[r#"
        # Motion of a test, recorded by `val3 test --update`: s, mm, degrees, mm/s
        # arm: TX2-90
        t,id,phase,j1,j2,j3,j4,j5,j6,x,y,z,rx,ry,rz,v
        0.000,1.050000,nominal,0.000,0.000,0.000,0.000,0.000,0.000,0.000,0.000,0.000,0.000,0.000,0.000,250.000
        0.004,1.100000,nominal,1.000,0.000,0.000,0.000,0.000,-12.346,1.000,0.000,12.500,0.000,0.000,-90.000,250.000
        0.008,1.200000,waiting,2.000,0.000,0.000,0.000,0.000,0.000,2.000,0.000,0.000,0.000,0.000,0.000,250.000
    "#]]
    .assert_eq(&trace(&rows).to_text());
}

#[test]
fn exact_rows_are_for_programs() {
    let row = at(&line(2)[1], [0.12345678, 0.0, 0.0], [0.0; 3]);
    let expected = "0.004,1.100000,nominal,1.0000000,0.0000000,0.0000000,0.0000000,1.1234568,0.0000000,0.0000000,0.0000000,\
                    0.0000000,0.0000000,250.0000";
    assert_eq!(row.line(4, crate::write::Precision::Exact), expected);
}

/// The heading of `val3 run --trace` contains no arm.
#[test]
fn comments_and_blank_lines_are_no_rows() {
    let text = format!("{}\n\n# later\n0,1.5,blend,1,2,3,4,10,20,30,0,0,90,5\r\n", head(4));
    let read = Trace::parse(&text).unwrap();
    assert_eq!((read.arm, read.axes, read.rows.len()), (None, 4, 1));
    let row = read.rows[0];
    assert_eq!((row.time, row.id, row.phase, row.speed), (0, 1.5, MotionPhase::Blend, 5.0));
    assert_eq!(
        (row.joints, Trsf::from(row.pose)),
        ([1.0, 2.0, 3.0, 4.0, 0.0, 0.0], Trsf::new([10.0, 20.0, 30.0], [0.0, 0.0, 90.0]))
    );
}

/// `val3 run --trace` writes the speed limit, which is no part of the motion.
#[test]
fn the_limit_of_the_speed_is_checked_and_not_compared() {
    let row = "0,1.5,blend,1,2,3,4,10,20,30,0,0,90,5";
    let with_limit = |limit: &str| Trace::parse(&format!("{}\n{row},{limit}\n", head_with_limit(4)));
    assert_eq!(with_limit("acceleration of axis 3"), Trace::parse(&format!("{}\n{row}\n", head(4))));
    assert_eq!(with_limit("fast").unwrap_err().to_string(), "line 2: column limit: `fast` is no limit of the speed");
}

#[track_caller]
fn refused(rows: &str, expected: &str) {
    let error = Trace::parse(&format!("# arm: TX2-90\n{}\n{rows}", head(6))).unwrap_err();
    assert_eq!(error.to_string(), expected);
}

#[test]
fn errors_name_the_line_and_the_column() {
    let row = |t: &str, id: &str, phase: &str, last: &str| format!("{t},{id},{phase},0,0,0,0,0,0,1,2,3,0,0,{last},0\n");
    let good = row("0.004", "1.1", "nominal", "0");
    refused(&(good.clone() + "0.008,1\n"), "line 4: this row has 2 values instead of 16");
    refused(&row("x", "1", "nominal", "0"), "line 3: column t: `x` is not a number");
    refused(&row("0", "", "nominal", "0"), "line 3: column id: `` is not a number");
    refused(&row("0", "1", "nominal", "inf"), "line 3: column rz: `inf` is not a number");
    refused(
        &row("0", "1", "moving", "0"),
        "line 3: column phase: `moving` is none of nominal, blend, alter, connection, compliant, stopping, waiting",
    );
    refused(&(good.clone() + &good), "line 4: column t: this row is not later than the one before (0.004 s)");
}

#[test]
fn other_files_are_refused() {
    let error = |text: &str| Trace::parse(text).unwrap_err().to_string();
    let begins = "a trace begins with the names of its columns, as in `t,id,phase,j1,j2,j3,j4,j5,j6,x,y,z,rx,ry,rz,v`";
    assert_eq!(error("# no\na;b\n"), format!("line 2: {begins}: `a;b` are others"));
    assert_eq!(error(""), format!("line 1: {begins}: there are none"));
    assert_eq!(error("# arm: TX2-90\n"), format!("line 1: {begins}: there are none"));
}

proptest! {
    #[test]
    fn a_trace_comes_back(
        places in proptest::collection::vec((any::<bool>(), [-2000.0..2000.0_f64, -2000.0..2000.0, -2000.0..2000.0], [-179.0..179.0_f64, -80.0..80.0, -179.0..179.0]), 0..20),
    ) {
        let rows = line(places.len()).into_iter().zip(&places).map(|(row, (blends, place, turn))| {
            let phase = if *blends { MotionPhase::Blend } else { MotionPhase::Waiting };
            TraceRow { phase, pose: Trsf::new(*place, *turn).isometry(), ..row }
        });
        let written = trace(&rows.collect::<Vec<_>>());
        let read = Trace::parse(&written.to_text()).unwrap();
        prop_assert_eq!((&read.arm, read.axes, read.rows.len()), (&written.arm, written.axes, written.rows.len()));
        for (read, written) in read.rows.iter().zip(&written.rows) {
            prop_assert_eq!((read.time, read.number(), read.phase), (written.time, written.number(), written.phase));
            prop_assert!((read.position() - written.position()).amax() <= 0.000_501);
            prop_assert!((read.pose.rotation.matrix() - written.pose.rotation.matrix()).amax() < 5e-5);
        }
        prop_assert_eq!(read.to_text(), Trace::parse(&read.to_text()).unwrap().to_text());
    }
}
