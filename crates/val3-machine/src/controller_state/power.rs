//! Power of the arm (8.1).

/// Time to switch on, in nanoseconds: a second, well below the five seconds of the manual's example.
pub const POWER_ON_TIME: u64 = 1_000_000_000;

/// The time from the standstill of the arm until the power is cut, in nanoseconds: 100 ms.
pub const POWER_OFF_TIME: u64 = 100_000_000;

/// Power of the arm. It changes only with time, see [`Power::after`].
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Power {
    /// Cut.
    #[default]
    Off,
    /// Coming on.
    ComingOn {
        /// Time at which the power is on.
        at: u64,
    },
    /// On.
    On,
    /// To be cut as soon as the arm has stopped.
    BeingCut {
        /// Time at which the power is off, if the arm has stopped by then.
        at: u64,
    },
}

impl Power {
    /// Whether the power is on, or not yet cut (`isPowered`).
    #[must_use]
    pub fn is_on(self) -> bool {
        matches!(self, Self::On | Self::BeingCut { .. })
    }

    /// Returns the state at `now`.
    pub(super) fn after(self, now: u64, arm_stands: bool) -> Self {
        match self {
            Self::ComingOn { at } if at <= now => Self::On,
            Self::BeingCut { at } if at <= now && arm_stands => Self::Off,
            same => same,
        }
    }

    /// Begins to cut the power.
    pub(super) fn cut(self, now: u64) -> Self {
        match self {
            Self::ComingOn { .. } | Self::Off => Self::Off,
            Self::On => Self::BeingCut { at: now.saturating_add(POWER_OFF_TIME) },
            Self::BeingCut { .. } => self,
        }
    }

    /// The time of the next change without a request.
    pub(super) fn due(self) -> Option<u64> {
        match self {
            Self::ComingOn { at } | Self::BeingCut { at } => Some(at),
            Self::Off | Self::On => None,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn it_is_on_from_the_end_of_coming_on_to_the_end_of_being_cut() {
        let coming = Power::ComingOn { at: 10 };
        assert!(!coming.is_on() && !coming.after(9, true).is_on() && coming.after(10, true).is_on());
        let cut = Power::On.cut(5);
        let off = 5 + POWER_OFF_TIME;
        assert!(cut.is_on() && cut.after(off - 1, true).is_on() && !cut.after(off, true).is_on());
    }

    #[test]
    fn a_moving_arm_keeps_its_power_until_it_stands() {
        let cut = Power::On.cut(0);
        assert_eq!(cut.after(10 * POWER_OFF_TIME, false), cut);
        assert_eq!(cut.after(10 * POWER_OFF_TIME, true), Power::Off);
    }

    #[test]
    fn power_can_be_cut_while_it_comes_on() {
        assert_eq!(Power::ComingOn { at: 9 }.cut(3), Power::Off);
        assert_eq!(Power::On.cut(3).cut(50), Power::On.cut(3));
    }
}
