//! Lookup of the data that commands name.

use val3_geometry::IsometryMatrix3;
use val3_lang::call::ToolRef;
use val3_lang::types::BaseType;
use val3_machine::controller::Controller;

use crate::positions::{self, GlobalValue};
use crate::units;
use crate::wire::{CommandError, ElementKey, ToolName};

/// Name of the tool that exists in every application.
const FLANGE: &str = "flange";

/// Finds the point or joint position that a command names.
pub(super) fn datum(name: &str, key: Option<ElementKey>, controller: &Controller) -> Result<GlobalValue, CommandError> {
    find(name, key, &[BaseType::Point, BaseType::Joint], controller)
        .map_err(|key| no_datum("point", name, key.as_deref()))
}

/// Finds the frame that a command names.
pub(super) fn frame_named(
    name: &str,
    key: Option<ElementKey>,
    controller: &Controller,
) -> Result<GlobalValue, CommandError> {
    named("frame", BaseType::Frame, name, key, controller)
}

/// Finds the tool that a command names.
pub(super) fn tool_named(
    name: &str,
    key: Option<ElementKey>,
    controller: &Controller,
) -> Result<GlobalValue, CommandError> {
    named("tool", BaseType::Tool, name, key, controller)
}

/// Finds a value by name. `kind` is the word for its type in the error.
fn named(
    kind: &str,
    base: BaseType,
    name: &str,
    key: Option<ElementKey>,
    controller: &Controller,
) -> Result<GlobalValue, CommandError> {
    find(name, key, &[base], controller).map_err(|key| no_datum(kind, name, key.as_deref()))
}

/// Error for a name without a matching value.
pub(super) fn no_datum(kind: &str, name: &str, key: Option<&str>) -> CommandError {
    CommandError(match key {
        Some(key) => format!("there is no {kind} `{name}[{key}]`"),
        None => format!("there is no {kind} `{name}` with a single value"),
    })
}

/// Pose of the tool centre point on the flange, in mm. Without an argument, the tool of the last move is used.
pub(super) fn tool_pose(tool: Option<ToolName>, controller: &Controller) -> Result<IsometryMatrix3<f64>, CommandError> {
    let Some(ToolName { name, key }) = tool else { return Ok(tool_of_last_move(controller)) };
    if name == FLANGE {
        return Ok(IsometryMatrix3::identity());
    }
    let tool = tool_named(&name, key, controller)?;
    let pose = units::poses(controller).of_tool(ToolRef(tool.place));
    pose.map_err(|fault| CommandError(format!("the tool has no father (error {})", fault.0)))
}

/// Pose of the centre point of the last move's tool on the flange, in mm; of the flange before the first move.
pub(crate) fn tool_of_last_move(controller: &Controller) -> IsometryMatrix3<f64> {
    let sample = controller.arm().sample();
    controller.arm().model().flange(&sample.joints).inverse() * sample.pose
}

/// Finds a value of one of these types. The error is the key as text.
fn find(
    name: &str,
    key: Option<ElementKey>,
    types: &[BaseType],
    controller: &Controller,
) -> Result<GlobalValue, Option<String>> {
    let key = key.map(ElementKey::into_text);
    let mut data = positions::data(controller).into_iter().filter(|datum| types.contains(&datum.base));
    data.find(|datum| datum.name == name && datum.key == key).ok_or(key)
}
