//! The page of the shipped arms.

use std::fmt::Write as _;

use anyhow::Result;
use val3_kinematics::Arm;

use crate::page::Page;

/// The path of the page.
const PATH: &str = "arm-list.md";

const HEAD: &str = "\
# Arms

The arms that `val3 run`, `val3 check --motion` and `--arm` know. The reach is the distance of the wrist's centre from axis 1 with a
stretched arm. Values that no public source has are choices of the model; `val3 arm show NAME` prints them all with their sources, and
[Arms and their times](arms.md) describes how to measure those of your arm.
";

/// A table with a row for each arm, by series.
pub(crate) fn page() -> Result<Page> {
    let mut text = HEAD.to_owned();
    let mut series = "";
    for name in Arm::names() {
        let arm = Arm::by_name(name)?;
        let own =
            name.split_once(|letter: char| letter.is_ascii_digit() && letter != '2').map_or(name, |(series, _)| series);
        if own != series {
            series = own;
            text.push_str("\n| name | axes | reach | ranges of the axes | load | times | sources |\n|---|---|---|---|---|---|---|\n");
        }
        row(&arm, &mut text);
    }
    Ok(Page::plain(PATH, text))
}

fn row(arm: &Arm, text: &mut String) {
    let axes = if arm.is_scara() { "4 (SCARA)" } else { "6" };
    let times = if arm.has_measured_times() { "measured" } else { "model" };
    let range = |(place, axis): (usize, &val3_kinematics::Axis)| {
        let unit = if arm.is_stroke(place) { " mm" } else { "°" };
        format!("{} to {}{unit}", axis.min, axis.max)
    };
    let ranges: Vec<String> = arm.limits().iter().enumerate().map(range).collect();
    let load = arm.payload().nominal.map_or_else(|| "not public".to_owned(), |load| format!("{load} kg"));
    let _ = writeln!(
        text,
        "| {} | {axes} | {:.0} mm | {} | {load} | {times} | {} |",
        arm.name(),
        arm.reach(),
        ranges.join(", "),
        arm.sources().join("; ")
    );
}
