//! Units, as a reader knows them.

use val3_analysis::db::{Db, Project};
use val3_analysis::items::parse;
use val3_analysis::xml;
use val3_lang::types::Unit;

/// The application counts lengths in inches (2.1.4.1).
fn is_inch(db: &dyn Db, project: Project) -> bool {
    let parse = parse(db, project.manifest(db));
    let root = xml::root(parse.view());
    let value =
        |root: xml::Element<'_>| root.elements().find_map(|element| element.value("millimeterUnit").map(String::from));
    root.and_then(value).is_some_and(|text| text.trim() == "false")
}

/// The unit in words.
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

/// The unit sign after a number; empty without a unit.
pub(super) fn sign(db: &dyn Db, project: Project, unit: Unit) -> &'static str {
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
