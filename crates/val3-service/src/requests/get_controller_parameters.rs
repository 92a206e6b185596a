//! `getControllerParameters`: the serial number.

use val3_soap::SoapFault;
use val3_soap::v0::{GetControllerParameters, GetControllerParametersAnswer};

use crate::context::Context;
use crate::inferred::serial_number;

/// Answers the request.
pub(super) fn answer(
    _: &GetControllerParameters,
    context: &mut Context<'_, '_>,
) -> Result<GetControllerParametersAnswer, SoapFault> {
    let serial = context.controller().devices.state.versions.version("ControllerSN");
    Ok(GetControllerParametersAnswer { parameters: vec![serial_number(serial)] })
}
