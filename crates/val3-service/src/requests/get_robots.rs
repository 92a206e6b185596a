//! `getRobots`: the only arm.

use val3_soap::SoapFault;
use val3_soap::v0::{DiameterAxis3, GetRobots, GetRobotsAnswer, Kinematic, LengthAxis3, MountType, RobotDescription};

use crate::context::Context;

/// Answers the request.
pub(super) fn answer(_: &GetRobots, context: &mut Context<'_, '_>) -> Result<GetRobotsAnswer, SoapFault> {
    let state = &context.controller().devices.state;
    let (model, version) = (state.arm.model(), |component| state.versions.version(component));
    let name = version("ArmType");
    let kinematic = if model.is_scara() { Kinematic::Scara } else { Kinematic::Anthropomorph6 };
    let robot = RobotDescription {
        kinematic,
        arm: Some(name.to_owned()),
        tuning: Some(version("Tuning").to_owned()),
        mount: mount(version("Mounting")),
        length_axis_3: in_name(name, "L", LengthAxis3::ALL, LengthAxis3::text).unwrap_or(LengthAxis3::Invalid),
        diameter_axis_3: in_name(name, "D", DiameterAxis3::ALL, DiameterAxis3::text).unwrap_or(DiameterAxis3::Invalid),
    };
    Ok(GetRobotsAnswer { robots: vec![robot] })
}

fn mount(mounting: &str) -> MountType {
    match mounting {
        "floor" => MountType::Floor,
        "ceiling" => MountType::Ceiling,
        "wall" => MountType::Wall,
        _ => MountType::Invalid,
    }
}

/// Finds the enumerator for a part of an arm's name: `L200` in `rs60-S1-D20-L200` is `LENGTHAXIS3-L200`.
fn in_name<T: Copy>(name: &str, letter: &str, all: &[T], text: fn(T) -> &'static str) -> Option<T> {
    let mut parts = name.split('-').filter(|part| part.starts_with(letter));
    parts.find_map(|part| all.iter().copied().find(|value| text(*value).ends_with(&format!("-{part}"))))
}
