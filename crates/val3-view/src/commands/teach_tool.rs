//! Teaching the centre point of a tool with positions in which its tip touches the same point.

use val3_geometry::{IsometryMatrix3, tool_centre};
use val3_lang::call::ToolRef;
use val3_lang::references;
use val3_machine::controller::Controller;

use super::store::write;
use super::teach::joints_of;
use crate::positions::GlobalValue;
use crate::units;
use crate::wire::{CommandError, TaughtTool};

/// Sets x, y and z of a tool. Its orientation is unchanged, because the touched point does not determine it.
pub(super) fn teach_tool(
    tool: &GlobalValue,
    joints: &[Vec<f64>],
    controller: &mut Controller,
) -> Result<TaughtTool, CommandError> {
    let memory = &controller.vm.space.memory;
    let father = references::reference(memory, tool.place).ok().flatten();
    let father = father.ok_or_else(|| CommandError(format!("the tool `{}` has no father", tool.name)))?;
    let father = units::poses(controller).of_tool(ToolRef(father));
    let father = father.map_err(|fault| CommandError(format!("a father has no father (error {})", fault.0)))?;
    let model = controller.arm().model();
    let flange = |joints: &Vec<f64>| Ok(model.flange(&joints_of(joints, controller)?));
    let flanges: Vec<IsometryMatrix3<f64>> = joints.iter().map(flange).collect::<Result<_, CommandError>>()?;
    let found = tool_centre(&flanges).map_err(|error| CommandError(error.to_string()))?;
    let father = father.inverse();
    let centre = father.rotation * found.centre + father.translation.vector;
    let centre = units::data_of_position(&centre, controller);
    write(tool, (0..).zip(centre), controller)?;
    Ok(TaughtTool { residual: found.residual })
}
