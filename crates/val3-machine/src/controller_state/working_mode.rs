//! Working modes and the activities of the arm in them (`workingMode`, 8.1).

/// A working mode; the number is the result of `workingMode`.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
#[repr(u8)]
pub enum WorkingMode {
    /// 0: invalid, or changing.
    Changing = 0,
    /// 1: the operator moves the arm, slowly.
    Manual = 1,
    /// 2: programs move the arm, the operator holds a key.
    Test = 2,
    /// 3: programs move the arm, the operator starts and holds it at the pendant.
    Local = 3,
    /// 4: programs move the arm and switch its power on.
    #[default]
    Remote = 4,
}

/// The activity of the arm.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Activity {
    /// Follows the moves of programs; in test mode below 250 mm/s.
    Programmed,
    /// Moves back to the point at which it left its path.
    Connection,
    /// Manual mode: the operator moves single axes.
    JointJog,
    /// Manual mode: the operator moves it along the axes of a frame.
    FrameJog,
    /// Manual mode: the operator moves it along the axes of the tool.
    ToolJog,
    /// Manual mode: the operator moves it to a point.
    PointJog,
    /// Test mode: it follows the moves of programs above 250 mm/s.
    FastProgrammed,
    /// Held.
    Hold,
}

impl Activity {
    /// Whether recorded moves may move the arm.
    #[must_use]
    pub fn lets_programs_move(self) -> bool {
        matches!(self, Self::Programmed | Self::FastProgrammed | Self::Connection)
    }
}

impl WorkingMode {
    /// The mode of this number.
    #[must_use]
    pub fn from_number(number: u8) -> Option<Self> {
        let modes = [Self::Changing, Self::Manual, Self::Test, Self::Local, Self::Remote];
        modes.into_iter().find(|mode| mode.number() == number)
    }

    /// 0 to 4.
    #[must_use]
    pub fn number(self) -> u8 {
        self as u8
    }

    /// Returns the name.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Changing => "changing",
            Self::Manual => "manual",
            Self::Test => "test",
            Self::Local => "local",
            Self::Remote => "remote",
        }
    }

    /// The activities that are possible in this mode. Their indexes are the states that `workingMode` returns.
    fn activities(self) -> &'static [Activity] {
        use Activity::{Connection, FastProgrammed, FrameJog, Hold, JointJog, PointJog, Programmed, ToolJog};
        match self {
            Self::Changing => &[],
            Self::Manual => &[Programmed, Connection, JointJog, FrameJog, ToolJog, PointJog, Hold],
            Self::Test => &[Programmed, Connection, FastProgrammed, Hold],
            Self::Local | Self::Remote => &[Programmed, Connection, Hold],
        }
    }

    /// State that `workingMode(nStatus)` returns: 0 in a changing mode; an activity that is impossible in this mode
    /// counts as held.
    #[must_use]
    pub fn state(self, activity: Activity) -> u8 {
        let place = |wanted| self.activities().iter().position(|known| *known == wanted);
        let state = place(activity).or_else(|| place(Activity::Hold));
        state.and_then(|state| u8::try_from(state).ok()).unwrap_or(0)
    }

    /// The activity when this mode is entered. In remote mode no enabling device is held.
    pub(super) fn first_activity(self) -> Activity {
        if self == Self::Remote { Activity::Programmed } else { Activity::Hold }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_table_of_the_manual() {
        use Activity::{Connection, FastProgrammed, FrameJog, Hold, JointJog, PointJog, Programmed, ToolJog};
        assert_eq!(states(0, &[Programmed, Hold]), [0, 0]);
        let manual = [Programmed, Connection, JointJog, FrameJog, ToolJog, PointJog, Hold];
        assert_eq!(states(1, &manual), [0, 1, 2, 3, 4, 5, 6]);
        assert_eq!(states(2, &[Programmed, Connection, FastProgrammed, Hold]), [0, 1, 2, 3]);
        assert_eq!(states(3, &[Programmed, Connection, Hold]), [0, 1, 2]);
        assert_eq!(states(4, &[Programmed, Connection, Hold]), [0, 1, 2]);
    }

    fn states(mode: u8, activities: &[Activity]) -> Vec<u8> {
        activities.iter().map(|activity| WorkingMode::from_number(mode).unwrap().state(*activity)).collect()
    }

    #[test]
    fn there_are_five_modes() {
        assert_eq!(WorkingMode::from_number(5), None);
        assert_eq!(WorkingMode::default().number(), 4);
    }
}
