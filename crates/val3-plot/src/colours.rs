//! Colours of motion.

use val3_motion::{MotionPhase, SpeedLimit};

/// Phases with their colours, which are distinguishable with any kind of colour vision (Okabe and Ito), and their
/// names.
pub(crate) const PHASES: [(MotionPhase, &str, &str); 7] = [
    (MotionPhase::Nominal, "#0072b2", "path of a move"),
    (MotionPhase::Blend, "#e69f00", "blend"),
    (MotionPhase::Connection, "#cc79a7", "connection move"),
    (MotionPhase::Alter, "#009e73", "altered"),
    (MotionPhase::Compliant, "#56b4e9", "compliant"),
    (MotionPhase::Stopping, "#d55e00", "stopping"),
    (MotionPhase::Waiting, "#999999", "waiting"),
];

/// Colours of axes 1 to 6.
pub(crate) const AXES: [&str; 6] = ["#0072b2", "#e69f00", "#009e73", "#cc79a7", "#56b4e9", "#d55e00"];

/// Style of a recorded motion: a wide band below the present motion, so that both are visible where they are equal.
pub(crate) const REFERENCE: &str = "stroke:#c9c9c9;stroke-width:7;stroke-linejoin:round;stroke-linecap:round";

/// Returns the colour of a phase.
pub(crate) fn colour(phase: MotionPhase) -> &'static str {
    PHASES.iter().find(|(known, ..)| *known == phase).map_or("#000000", |(_, colour, _)| colour)
}

/// Returns the name and the colour of a speed limit. Its axis is shown as a number in the picture.
pub(crate) const fn limit_colour(limit: SpeedLimit) -> (&'static str, &'static str) {
    match limit {
        SpeedLimit::Acceleration(_) => ("acceleration of the axis", "#56b4e9"),
        SpeedLimit::Deceleration(_) => ("deceleration of the axis", "#0072b2"),
        SpeedLimit::AxisSpeed(_) => ("speed of the axis", "#009e73"),
        SpeedLimit::Translation => ("tvel", "#f0e442"),
        SpeedLimit::Rotation => ("rvel", "#8b6914"),
        SpeedLimit::Corner => ("corner", "#cc79a7"),
        SpeedLimit::ReducedSpeed => ("manual mode", "#d55e00"),
        SpeedLimit::MonitorSpeed => ("monitor speed", "#e69f00"),
        SpeedLimit::Stop => ("stop", "#c00000"),
        SpeedLimit::Connection => ("connection", "#a6761d"),
        SpeedLimit::Force => ("force", "#7570b3"),
        SpeedLimit::Alter => ("alter", "#66a61e"),
        SpeedLimit::NextMove | SpeedLimit::Fault | SpeedLimit::Held | SpeedLimit::End => ("waiting", "#d0d0d0"),
    }
}
