//! Names of units for display.

use val3_analysis::db::{Db, Project};
use val3_analysis::items::manifest::length_unit;
use val3_lang::types::{LengthUnit, Unit};

/// Whether lengths of the application are in inches (2.1.4.1).
fn is_inch(db: &dyn Db, project: Project) -> bool {
    length_unit(db, project.manifest(db)) == LengthUnit::Inch
}

/// Unit name.
pub(super) fn word(db: &dyn Db, project: Project, unit: Unit) -> Option<&'static str> {
    let inch = || is_inch(db, project);
    Some(match unit {
        Unit::None => return None,
        Unit::Length => {
            if inch() {
                "inches"
            } else {
                "mm"
            }
        }
        Unit::Degrees => "degrees",
        Unit::Percent => "per cent of the arm's nominal value",
        Unit::LengthPerSecond => {
            if inch() {
                "inches per second"
            } else {
                "mm per second"
            }
        }
        Unit::DegreesPerSecond => "degrees per second",
        Unit::Seconds => "seconds",
    })
}

/// Unit symbol after a number; empty without a unit.
pub(crate) fn sign(db: &dyn Db, project: Project, unit: Unit) -> &'static str {
    let inch = || is_inch(db, project);
    match unit {
        Unit::None => "",
        Unit::Length => {
            if inch() {
                " in"
            } else {
                " mm"
            }
        }
        Unit::Degrees => "°",
        Unit::Percent => " %",
        Unit::LengthPerSecond => {
            if inch() {
                " in/s"
            } else {
                " mm/s"
            }
        }
        Unit::DegreesPerSecond => "°/s",
        Unit::Seconds => " s",
    }
}
