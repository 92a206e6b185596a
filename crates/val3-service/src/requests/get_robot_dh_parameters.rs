//! `getRobotDhParameters`: the geometry of the arm. The parameter `b` of the controller has no field.

use val3_kinematics::Dh;
use val3_soap::SoapFault;
use val3_soap::v2::{DhParameters, GetRobotDhParameters, GetRobotDhParametersAnswer};

use crate::context::Context;
use crate::units::MM;

/// Answers the request.
pub(super) fn answer(
    request: &GetRobotDhParameters,
    context: &mut Context<'_, '_>,
) -> Result<GetRobotDhParametersAnswer, SoapFault> {
    context.check_robot(request.robot)?;
    let arm = context.controller().arm().model();
    let (dh, axes) = (arm.dh(), arm.axes());
    let last_d = dh.d.get(axes).copied().unwrap_or_default() / MM;
    Ok(GetRobotDhParametersAnswer { joints: (0..axes).map(|axis| dh_parameters(&dh, axis)).collect(), last_d })
}

/// Parameters of an axis in rad and m.
fn dh_parameters(dh: &Dh, axis: usize) -> DhParameters {
    let at = |values: &[f64]| values.get(axis).copied().unwrap_or_default();
    DhParameters {
        theta: at(&dh.theta).to_radians(),
        d: at(&dh.d) / MM,
        a: at(&dh.a) / MM,
        alpha: at(&dh.alpha).to_radians(),
        beta: at(&dh.beta).to_radians(),
    }
}
