//! Status of inputs and outputs, and access errors (3.5.3, 12.1).

use val3_lang::runtime_errors::{NO_ANSWER, PROTECTED_OUTPUT, UNLINKED, WRITE_TO_INPUT};

/// Status of a signal; the number is the result of `ioStatus`.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[repr(i8)]
pub enum IoStatus {
    /// The signal works.
    Works = 0,
    /// The signal works; the operator has locked it at a value.
    Locked = 1,
    /// The signal is simulated: it has no hardware.
    Simulated = 2,
    /// The variable has no link.
    Unlinked = -1,
    /// The link has no target, or names a device that is not installed.
    Absent = -2,
    /// The device has failed.
    Failed = -3,
}

impl IoStatus {
    /// The number, -3 to 2.
    #[must_use]
    pub fn number(self) -> i8 {
        self as i8
    }
}

/// Fault of a signal.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum SignalFault {
    /// The device is not installed, or could not be initialised: status -2.
    Absent,
    /// The device has failed: status -3.
    Failed,
}

impl SignalFault {
    /// The fault of a status: -2 or -3.
    #[must_use]
    pub fn from_number(number: i8) -> Option<Self> {
        match number {
            -2 => Some(Self::Absent),
            -3 => Some(Self::Failed),
            _ => None,
        }
    }
}

/// Reason why a signal cannot be read or written.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum IoError {
    /// 122: an input is written.
    WriteToInput,
    /// 123: the variable has no link to an input or output with the right type.
    Unlinked,
    /// 124: an output of the system is written.
    Protected,
    /// 125: the device does not respond.
    NoAnswer,
}

impl IoError {
    /// The number of the run-time error.
    #[must_use]
    pub fn number(self) -> u16 {
        match self {
            Self::WriteToInput => WRITE_TO_INPUT,
            Self::Unlinked => UNLINKED,
            Self::Protected => PROTECTED_OUTPUT,
            Self::NoAnswer => NO_ANSWER,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn errors_have_the_numbers_of_the_manual() {
        let errors = [IoError::WriteToInput, IoError::Unlinked, IoError::Protected, IoError::NoAnswer];
        assert_eq!(errors.map(IoError::number), [122, 123, 124, 125]);
    }

    #[test]
    fn only_two_states_are_faults_of_a_device() {
        assert_eq!(SignalFault::from_number(IoStatus::Absent.number()), Some(SignalFault::Absent));
        assert_eq!(SignalFault::from_number(IoStatus::Failed.number()), Some(SignalFault::Failed));
        assert!([-4, -1, 0, 1, 2].into_iter().all(|number| SignalFault::from_number(number).is_none()));
    }
}
