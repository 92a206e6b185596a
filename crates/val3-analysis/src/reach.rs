//! Reachability of poses, independent of the arm's previous position.

use val3_geometry::{IsometryMatrix3, Trsf};
use val3_kinematics::{Arm, ConfigurationRequest, Elbow, Joints, RequestedConfiguration, Shoulder, Unreachable, Wrist};

/// Returns joints for a flange pose. The initial configuration is unknown, so `same` accepts any configuration.
pub fn reach(
    arm: &Arm,
    flange: &IsometryMatrix3<f64>,
    requested: RequestedConfiguration,
) -> Result<Joints, Unreachable> {
    arm.solve(&Trsf::from(*flange), &[0.0; 6], without_same(requested))
}

/// Replaces `same` by `free`, because the initial configuration is unknown.
pub fn without_same(requested: RequestedConfiguration) -> RequestedConfiguration {
    fn freed<T>(request: ConfigurationRequest<T>) -> ConfigurationRequest<T> {
        if matches!(request, ConfigurationRequest::Same) { ConfigurationRequest::Free } else { request }
    }
    RequestedConfiguration {
        shoulder: freed(requested.shoulder),
        elbow: freed(requested.elbow),
        wrist: freed(requested.wrist),
    }
}

/// Returns the configuration of a joint position in VAL 3 words: `lefty`, `epositive`, `wpositive`.
pub fn configuration_words(arm: &Arm, joints: &Joints) -> Vec<&'static str> {
    let found = arm.configuration(joints);
    let shoulder = if found.shoulder == Shoulder::Lefty { "lefty" } else { "righty" };
    if arm.is_scara() {
        return vec![shoulder];
    }
    let elbow = if found.elbow == Elbow::Positive { "epositive" } else { "enegative" };
    let wrist = if found.wrist == Wrist::Positive { "wpositive" } else { "wnegative" };
    vec![shoulder, elbow, wrist]
}
