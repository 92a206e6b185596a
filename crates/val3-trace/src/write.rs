//! Formatting of traces as comma-separated tables.

use val3_geometry::Trsf;
use val3_machine::event::seconds;

use crate::row::{Trace, TraceRow};

/// First line of a file that `--update` has written.
const NOTE: &str = "# Motion of a test, recorded by `val3 test --update`: s, mm, degrees, mm/s";

/// Whether a file is a motion that `--update` has recorded, in this or an earlier version.
#[must_use]
pub fn is_recording(text: &str) -> bool {
    text.starts_with("# Motion of a test")
}

/// Prefix of the line with the arm's name.
pub(crate) const ARM: &str = "# arm: ";

/// Precision of the numbers in a table.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Precision {
    /// For computations in other programs.
    Exact,
    /// Three decimals, for files under version control.
    Compact,
}

/// Returns the line with the column names.
#[must_use]
pub fn head(axes: usize) -> String {
    let joints: Vec<String> = (1..=axes).map(|axis| format!("j{axis}")).collect();
    format!("t,id,phase,{},x,y,z,rx,ry,rz,v", joints.join(","))
}

/// Returns [`head`] with an additional column for the speed limit. The limit is no part of a [`TraceRow`], so comparisons
/// ignore it.
#[must_use]
pub fn head_with_limit(axes: usize) -> String {
    head(axes) + ",limit"
}

impl TraceRow {
    /// Formats a line of the table.
    #[must_use]
    pub fn line(&self, axes: usize, precision: Precision) -> String {
        let (decimals, of_speed) = match precision {
            Precision::Exact => (7, 4),
            Precision::Compact => (3, 3),
        };
        let Trsf { x, y, z, rx, ry, rz } = self.pose.into();
        let numbers = self.joints.iter().take(axes).copied().chain([x, y, z, rx, ry, rz]);
        let texts = numbers.map(|number| text(number, decimals)).chain([text(self.speed, of_speed)]);
        let texts: Vec<String> = texts.collect();
        format!("{:.3},{:.6},{},{}", seconds(self.time), self.id, self.phase.word(), texts.join(","))
    }
}

impl Trace {
    /// Formats the file, with the name of the arm in its heading.
    #[must_use]
    pub fn to_text(&self) -> String {
        let arm = self.arm.iter().map(|arm| format!("{ARM}{arm}"));
        let heading = [NOTE.to_owned()].into_iter().chain(arm).chain([head(self.axes)]);
        let rows = self.rows.iter().map(|row| row.line(self.axes, Precision::Compact));
        heading.chain(rows).map(|line| line + "\n").collect()
    }
}

/// Formats a number. Zero has no sign, because a sign could change without a change of the motion.
fn text(number: f64, decimals: usize) -> String {
    let text = format!("{number:.decimals$}");
    match text.strip_prefix('-') {
        Some(zero) if zero.trim_matches(['0', '.']).is_empty() => zero.to_owned(),
        _ => text,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn zero_has_no_sign() {
        let texts = [-0.0004, -0.0006, 0.0, -1.0, 10.0, -0.1].map(|number| text(number, 3));
        assert_eq!(texts, ["0.000", "-0.001", "0.000", "-1.000", "10.000", "-0.100"]);
    }
}
