//! Hover for positions: their pose, and how the arm reaches them.

use val3_analysis::body::{Body, Expr, ExprId, body};
use val3_analysis::changes::is_changed;
use val3_analysis::db::{Db, Project};
use val3_analysis::items::parse;
use val3_analysis::items::positions::{TaughtPosition, each};
use val3_analysis::items::project::items;
use val3_analysis::occurrences::Symbol;
use val3_analysis::placement::{Placement, joints, placement, position};
use val3_analysis::reach::configuration_words;
use val3_analysis::targets::{key, path};
use val3_geometry::{IsometryMatrix3, Trsf};
use val3_kinematics::{Arm, Joints};
use val3_lang::types::BaseType;
use val3_syntax::TextRange;

use crate::FilePosition;
use crate::markdown::code;
use crate::reached::{Reached, UNTAUGHT, arm_of, not_placed, outside, reached_with_tool, rounded};

/// Description of the value named by `symbol` at `range`: in code the indexed element, in data files a single value.
pub(super) fn named(
    db: &dyn Db,
    project: Project,
    at: FilePosition,
    symbol: &Symbol,
    range: TextRange,
) -> Option<String> {
    let Symbol::Data(owner, name) = symbol else { return None };
    let body = body(db, at.file);
    let variable = body.exprs().find(|(_, expr, found)| match expr {
        Expr::Name(_) | Expr::Path { .. } => found.contains_range(range),
        Expr::Field { range: field, .. } => *field == range,
        _ => false,
    });
    match variable {
        Some((id, expr, _)) => {
            let key = key_at(body, id)?;
            match expr {
                Expr::Field { base, .. } => {
                    about(db, project, project, &format!("{}.{name}[{key}]", path(body, *base)?))
                }
                _ => about(db, project, *owner, &format!("{name}[{key}]")),
            }
        }
        None => {
            let is_single = items(db, *owner).data.get(name)?.decl.sizes == [1];
            is_single.then(|| about(db, project, *owner, &format!("{name}[0]")))?
        }
    }
}

/// Description of the value in a data file that contains the position.
pub(super) fn around(db: &dyn Db, project: Project, at: FilePosition) -> Option<String> {
    let parse = parse(db, at.file);
    let mut found = None;
    each(parse.view(), &mut |value| {
        if value.element.view().range().contains_inclusive(at.offset) {
            found = Some(value.path);
        }
    });
    about(db, project, project, &found?)
}

/// Constant index after a variable; `0` without an index.
fn key_at(body: &Body, variable: ExprId) -> Option<String> {
    let indexed = body.exprs().find_map(|(_, expr, _)| match expr {
        Expr::Index(base, keys) if *base == variable => Some(keys),
        _ => None,
    });
    indexed.map_or_else(|| Some("0".to_owned()), |keys| key(body, keys))
}

/// Description of a value in the data of `owner`, for the arm of `project`.
fn about(db: &dyn Db, project: Project, owner: Project, path: &str) -> Option<String> {
    let value = position(db, owner, path)?;
    let arm = arm_of(db, project, value);
    let (mut text, chain) = match value.ty {
        BaseType::Joint => (of_joints(arm?, &joints(db, owner, value, arm?)), vec![path.into()]),
        BaseType::Point | BaseType::Frame | BaseType::Tool => match placement(db, owner, path) {
            Ok(placed) => (of_placement(db, owner, path, value, &placed, arm), placed.chain),
            Err(unplaced) => (not_placed(&unplaced), Vec::new()),
        },
        _ => return None,
    };
    if chain.iter().any(|path| is_changed(db, owner, path)) {
        text.push_str("\n\nat the start; a program changes it or one of its fathers");
    }
    Some(format!("\n{text}\n"))
}

fn of_placement(
    db: &dyn Db,
    owner: Project,
    path: &str,
    value: &TaughtPosition,
    placed: &Placement,
    arm: Option<&Arm>,
) -> String {
    let reference = if value.ty == BaseType::Tool { "on the flange" } else { "in `world`" };
    let mut text = format!("{reference}: {}", pose(&placed.pose));
    if let Some(arm) = arm.filter(|_| value.ty != BaseType::Tool) {
        text.push_str("\n\n");
        text.push_str(&reached(db, owner, path, value, &placed.pose, arm));
    }
    text
}

/// Joints in which the arm reaches a point or the origin of a frame.
fn reached(
    db: &dyn Db,
    owner: Project,
    path: &str,
    value: &TaughtPosition,
    point: &IsometryMatrix3<f64>,
    arm: &Arm,
) -> String {
    match reached_with_tool(db, owner, path, value, point, arm) {
        Reached::Untaught => UNTAUGHT.to_owned(),
        Reached::WithTool(tool, Ok(joints)) => {
            format!("{} with {}: {}", arm.name(), code(&tool), in_words(arm, &joints))
        }
        Reached::WithTool(tool, Err(reason)) => format!("{} with {}: out of reach, {reason}", arm.name(), code(&tool)),
    }
}

fn of_joints(arm: &Arm, joints: &Joints) -> String {
    let outside = outside(arm, joints);
    let words: Vec<String> = configuration_words(arm, joints).iter().map(|word| format!("`{word}`")).collect();
    let about = if outside.is_empty() { words.join(", ") } else { outside.join(", ") };
    format!("{}: flange in `world` {}\n\n{about}", arm.name(), pose(&arm.flange(joints)))
}

/// Joints with their configuration.
fn in_words(arm: &Arm, joints: &Joints) -> String {
    let axes = joints.iter().take(arm.axes()).enumerate();
    let axes: Vec<String> = axes
        .map(|(axis, joint)| {
            let unit = if arm.is_stroke(axis) { " mm" } else { "°" };
            format!("j{}={}{unit}", axis + 1, rounded(*joint))
        })
        .collect();
    let words: Vec<String> = configuration_words(arm, joints).iter().map(|word| format!("`{word}`")).collect();
    format!("{}, {}", axes.join(" "), words.join(", "))
}

/// A pose, for example `x=100 y=0 z=50 mm, rx=180 ry=0 rz=0 degrees`.
fn pose(pose: &IsometryMatrix3<f64>) -> String {
    let Trsf { x, y, z, rx, ry, rz } = Trsf::from(*pose);
    let [x, y, z, rx, ry, rz] = [x, y, z, rx, ry, rz].map(rounded);
    format!("x={x} y={y} z={z} mm, rx={rx} ry={ry} rz={rz} degrees")
}
