//! Files of the measuring application.

use std::fmt::Write as _;

use val3_kinematics::Arm;

use crate::args::AxisRange;

use super::data;

/// Programs that are independent of the arm and the ranges.
const PROGRAMS: &[(&str, &str)] = &[
    ("ask.pgx", include_str!("application/ask.pgx")),
    ("measure.pgx", include_str!("application/measure.pgx")),
    ("ready.pgx", include_str!("application/ready.pgx")),
    ("stop.pgx", include_str!("application/stop.pgx")),
    ("timeMoves.pgx", include_str!("application/timeMoves.pgx")),
    ("write.pgx", include_str!("application/write.pgx")),
];

/// Returns names and texts of all files in the application `name`.
pub(super) fn files(name: &str, arm: &Arm, ranges: &[AxisRange]) -> Vec<(String, String)> {
    let mut files: Vec<_> = PROGRAMS.iter().map(|(file, text)| ((*file).to_owned(), (*text).to_owned())).collect();
    files.push(("start.pgx".to_owned(), include_str!("application/start.pgx").replace("READ_AXES", &read_axes(arm))));
    files.push(("move.pgx".to_owned(), include_str!("application/move.pgx").replace("SET_AXIS", &set_axis(arm))));
    files.push((format!("{name}.pjx"), include_str!("application/project.pjx").replace("NAME", name)));
    files.push((format!("{name}.dtx"), data::file(arm, ranges)));
    files
}

/// Lines that copy the start position into an array.
fn read_axes(arm: &Arm) -> String {
    (0..arm.axes()).fold(String::new(), |mut lines, axis| {
        let _ = writeln!(lines, "  nStart[{axis}]=jStart.j{}", axis + 1);
        lines
    })
}

/// Cases that assign one axis of the target.
fn set_axis(arm: &Arm) -> String {
    (0..arm.axes()).fold(String::new(), |mut lines, axis| {
        let _ = writeln!(lines, "    case {axis}\n      l_jTarget.j{}=x_nTarget\n    break", axis + 1);
        lines
    })
}
