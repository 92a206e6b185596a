//! Things around the arm of a new cell.

use val3_kinematics::Arm;

use super::positions::NewPositions;

/// Name of the file, which is next to `val3.toml`.
pub(super) const FILE_NAME: &str = "cell.toml";

/// Distance of the table's top below the point, in mm.
const BELOW: f64 = 100.0;

/// Height of the table's top above its centre, in mm.
const HALF: f64 = 20.0;

/// Side of the table, as a fraction of the arm's reach.
const TABLE: f64 = 0.3;

/// Distance of the fence from the arm's reach, in mm.
const SPACE: f64 = 300.0;

/// Returns the text of `cell.toml`: a table below the point, and a fence behind the arm.
pub(super) fn text(positions: &NewPositions, arm: &Arm) -> String {
    let fence = arm.reach() + SPACE;
    let values = [
        ("below", BELOW),
        ("size", arm.reach() * TABLE),
        ("x", positions.point.x),
        ("y", positions.point.y),
        ("z", positions.point.z - BELOW - HALF),
        ("fence", 2.0 * fence),
        ("behind", -fence),
    ];
    let template = include_str!("template/cell.toml").to_owned();
    values.iter().fold(template, |text, (name, value)| text.replace(&format!("{{{name}}}"), &format!("{value:.0}")))
}
