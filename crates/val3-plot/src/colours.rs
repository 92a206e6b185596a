//! Colours of motion.

use val3_motion::Phase;

/// The phases with their colours, which people with any kind of colour vision tell apart (Okabe and Ito), and their names.
pub(crate) const PHASES: [(Phase, &str, &str); 7] = [
    (Phase::Nominal, "#0072b2", "path of a move"),
    (Phase::Blend, "#e69f00", "blend"),
    (Phase::Connection, "#cc79a7", "connection move"),
    (Phase::Alter, "#009e73", "altered"),
    (Phase::Compliant, "#56b4e9", "compliant"),
    (Phase::Stopping, "#d55e00", "stopping"),
    (Phase::Waiting, "#999999", "waiting"),
];

/// A recorded motion is a wide band below the present one, so that both can be seen where they are the same.
pub(crate) const REFERENCE: &str = "stroke:#c9c9c9;stroke-width:7;stroke-linejoin:round;stroke-linecap:round";

/// The colour of a phase.
pub(crate) fn colour(phase: Phase) -> &'static str {
    PHASES.iter().find(|(known, ..)| *known == phase).map_or("#000000", |(_, colour, _)| colour)
}
