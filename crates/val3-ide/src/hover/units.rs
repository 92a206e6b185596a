//! Names of units for display.

use val3_analysis::db::{Db, Project};
use val3_analysis::items::manifest::length_unit;
use val3_lang::types::{LengthUnit, NumberUnit};

/// Whether lengths of the application are in inches (2.1.4.1).
fn is_inch(db: &dyn Db, project: Project) -> bool {
    length_unit(db, project.manifest(db)) == LengthUnit::Inch
}

/// Unit name.
pub(super) fn word(db: &dyn Db, project: Project, unit: NumberUnit) -> Option<&'static str> {
    let inch = || is_inch(db, project);
    Some(match unit {
        NumberUnit::None => return None,
        NumberUnit::Length => {
            if inch() {
                "inches"
            } else {
                "mm"
            }
        }
        NumberUnit::Degrees => "degrees",
        NumberUnit::Percent => "per cent of the arm's nominal value",
        NumberUnit::LengthPerSecond => {
            if inch() {
                "inches per second"
            } else {
                "mm per second"
            }
        }
        NumberUnit::DegreesPerSecond => "degrees per second",
        NumberUnit::Seconds => "seconds",
    })
}

/// Unit symbol after a number; empty without a unit.
pub(crate) fn sign(db: &dyn Db, project: Project, unit: NumberUnit) -> &'static str {
    let inch = || is_inch(db, project);
    match unit {
        NumberUnit::None => "",
        NumberUnit::Length => {
            if inch() {
                " in"
            } else {
                " mm"
            }
        }
        NumberUnit::Degrees => "°",
        NumberUnit::Percent => " %",
        NumberUnit::LengthPerSecond => {
            if inch() {
                " in/s"
            } else {
                " mm/s"
            }
        }
        NumberUnit::DegreesPerSecond => "°/s",
        NumberUnit::Seconds => " s",
    }
}
