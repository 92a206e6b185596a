//! `setRobotJointPos`: places the arm without power elsewhere, in no time. Its moves are discarded.

use serde_json::{Map, json};
use val3_machine::script::ScriptAction;
use val3_soap::v0::SetRobotJointPos;
use val3_soap::{Empty, ExceptionCode, SoapFault};

use crate::context::{Context, refused};
use crate::units::joints_from_si;

/// Answers the request.
pub(super) fn answer(request: &SetRobotJointPos, context: &mut Context<'_, '_>) -> Result<Empty, SoapFault> {
    context.check_robot(request.robot)?;
    let controller = context.controller();
    let joints = joints_from_si(&request.position, controller.arm().model()).ok_or_else(|| {
        let explanation = format!("the arm has {} joints", controller.arm().model().axes());
        refused(ExceptionCode::InvalidNumberOfAxis, &explanation)
    })?;
    if !controller.devices.state.robot.is_power_off() {
        return Err(refused(ExceptionCode::SetPosPowerOn, "switch the power off first"));
    }
    // An action outside the limits would be recorded before it is rejected.
    if let Some(violation) = controller.arm().model().violations(&joints).next() {
        return Err(refused(ExceptionCode::InvalidParameters, &format!("joints: {violation}")));
    }
    let joints = joints.get(..controller.arm().model().axes()).unwrap_or_default();
    let keys = Map::from_iter([("joints".to_owned(), json!(joints))]);
    let invalid = |reason: String| refused(ExceptionCode::InvalidParameters, &reason);
    let action = ScriptAction::from_json(keys).map_err(|error| invalid(error.to_string()))?;
    controller.act(&action).map_err(|problems| invalid(problems.join("; ")))?;
    Ok(Empty)
}
