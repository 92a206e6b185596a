//! Data file of a new application.

use val3_kinematics::{Arm, Configuration, Elbow, Shoulder, Wrist};

use super::positions::NewPositions;

/// Text of the data file.
pub(super) fn file(arm: &Arm, positions: &NewPositions) -> String {
    let (joint, point) = if arm.is_scara() { ("jointRs", "pointRs") } else { ("jointRx", "pointRx") };
    include_str!("template/application.dtx")
        .replace("{joint}", joint)
        .replace("{point}", point)
        .replace("{home}", &joints(arm, positions))
        .replace("{pose}", &pose(positions))
        .replace("{configuration}", &configuration(arm, positions.configuration))
        .replace("{height}", &positions.height.to_string())
}

fn joints(arm: &Arm, positions: &NewPositions) -> String {
    let axes = positions.home.iter().take(arm.axes()).zip(1..);
    written(axes.map(|(value, axis)| (format!("j{axis}"), *value)))
}

fn pose(positions: &NewPositions) -> String {
    let point = &positions.point;
    let fields = [("x", point.x), ("y", point.y), ("z", point.z), ("rx", point.rx), ("ry", point.ry), ("rz", point.rz)];
    written(fields.into_iter().map(|(name, value)| (name.to_owned(), value)))
}

/// Formats numbers as attributes. Data files omit attributes with the value 0.
fn written(values: impl Iterator<Item = (String, f64)>) -> String {
    let attributes = values.filter(|(_, value)| *value != 0.0).map(|(name, value)| format!("{name}=\"{value}\""));
    attributes.collect::<Vec<_>>().join(" ")
}

fn configuration(arm: &Arm, Configuration { shoulder, elbow, wrist }: Configuration) -> String {
    let shoulder = match shoulder {
        Shoulder::Lefty => "shoulder=\"lefty\"",
        Shoulder::Righty => "shoulder=\"righty\"",
    };
    if arm.is_scara() {
        return shoulder.to_owned();
    }
    let elbow = match elbow {
        Elbow::Positive => "elbow=\"epositive\"",
        Elbow::Negative => "elbow=\"enegative\"",
    };
    let wrist = match wrist {
        Wrist::Positive => "wrist=\"wpositive\"",
        Wrist::Negative => "wrist=\"wnegative\"",
    };
    format!("{shoulder} {elbow} {wrist}")
}
