//! `setPower`: switches the power immediately, only in the remote mode.

use serde_json::Map;
use val3_machine::controller::Controller;
use val3_machine::controller_state::WorkingMode;
use val3_machine::script::ScriptAction;
use val3_soap::SoapFault;
use val3_soap::v3::{PowerResult, SetPower, SetPowerAnswer};

use crate::context::Context;

/// Answers the request.
pub(super) fn answer(request: &SetPower, context: &mut Context<'_, '_>) -> Result<SetPowerAnswer, SoapFault> {
    Ok(SetPowerAnswer { code: switch(request.power, context.controller()) })
}

fn switch(power: bool, controller: &mut Controller) -> PowerResult {
    let state = &controller.devices.state;
    if state.robot.working_mode() != WorkingMode::Remote {
        return PowerResult::OnlyInRemoteMode;
    }
    if !power && !state.arm.is_at_rest() {
        return PowerResult::RobotNotStopped;
    }
    let action = ScriptAction::from_json(Map::from_iter([("power".to_owned(), power.into())]));
    let is_applied = action.is_ok_and(|action| controller.act(&action).is_ok());
    // An emergency stop keeps the power off.
    match power {
        _ if is_applied && controller.devices.state.robot.is_powered() == power => PowerResult::NoError,
        true => PowerResult::EnableTimeout,
        false => PowerResult::DisableTimeout,
    }
}
