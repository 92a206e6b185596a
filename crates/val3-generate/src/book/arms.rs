//! Page about the shipped arms.

use std::fmt::Write as _;

use anyhow::Result;
use val3_kinematics::Arm;

use crate::book::page::BookPage;

/// Path of the page.
const PATH: &str = "arm-list.md";

const HEAD: &str = "\
# Arms

The names that `val3 run --arm`, `val3 check --motion --arm` and `arm` in `val3.toml` accept. The reach is the greatest distance of the
flange from axis 1. Speeds and accelerations that no public source has are choices of the model: `val3 arm show NAME` prints all values
of an arm, and [Arms and their times](arms.md) describes how to measure those of yours.

| name | axes | reach | nominal load | times | sources |
|---|---|---|---|---|---|
";

/// Returns the page: a table with a row for each arm.
pub(crate) fn page() -> Result<BookPage> {
    let mut text = HEAD.to_owned();
    for name in Arm::names() {
        row(&Arm::by_name(name)?, &mut text);
    }
    Ok(BookPage::plain(PATH, text))
}

fn row(arm: &Arm, text: &mut String) {
    let axes = if arm.is_scara() { "4 (SCARA)" } else { "6" };
    let times = if arm.has_measured_times() { "measured" } else { "model" };
    let load = arm.payload().nominal.map_or_else(|| "not public".to_owned(), |load| format!("{load} kg"));
    let sources = arm.sources().join("; ");
    let _ = writeln!(text, "| {} | {axes} | {:.0} mm | {load} | {times} | {sources} |", arm.name(), arm.reach());
}
