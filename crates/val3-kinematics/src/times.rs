//! Note about times for arms whose speeds and accelerations were not measured.

use crate::Arm;

impl Arm {
    /// Returns the note for readers of cycle times; `None` if the arm's speeds and accelerations were measured.
    #[must_use]
    pub fn times_note(&self) -> Option<String> {
        let name = self.name();
        (!self.has_measured_times()).then(|| {
            format!(
                "times of a model arm: the speeds and accelerations of the {name} are not measured; `val3 arm measure` \
                 measures yours"
            )
        })
    }

    /// Returns the origin of this arm's times, for machine-readable output: `measured` or `model`.
    #[must_use]
    pub const fn times_origin(&self) -> &'static str {
        if self.has_measured_times() { "measured" } else { "model" }
    }
}
