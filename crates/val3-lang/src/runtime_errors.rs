//! Run-time errors: why a task was stopped, and the remedy (5.10, 12.1).
//!
//! `taskStatus` returns the number of the error that stopped a task, and `help` explains it. Numbers from 50 on that
//! are not in the manual's tables come from messages of the controller.

/// A run-time error.
#[derive(Debug, PartialEq, Eq)]
pub struct RuntimeError {
    /// Number, as returned by `taskStatus`.
    pub number: u16,
    /// Cause, in a few words.
    pub short: &'static str,
    /// Explanation and remedy.
    pub long: &'static str,
}

/// Result of `taskStatus` for a task that no error has stopped.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum TaskStatusCode {
    /// -1: the library or application has no task with this name.
    Absent,
    /// 0: halted, by `taskSuspend` or a debugger.
    Halted,
    /// 1: running, including waiting.
    Running,
}

impl TaskStatusCode {
    /// Number that `taskStatus` returns.
    #[must_use]
    pub fn number(self) -> i16 {
        match self {
            Self::Absent => -1,
            Self::Halted => 0,
            Self::Running => 1,
        }
    }

    /// Description in the table of 12.1, which `help` returns.
    #[must_use]
    pub fn meaning(self) -> &'static str {
        match self {
            Self::Absent => "no task of this name",
            Self::Halted => "task suspended",
            Self::Running => "task running",
        }
    }
}

/// An input, output or serial line without a link is used (3.5 to 3.7).
pub const UNLINKED: u16 = 123;

/// A number is outside of an instruction's domain, or a result is too large (3.2.3).
pub const INVALID_NUMBER: u16 = 11;

/// A system input is written (3.5, 3.6).
pub const WRITE_TO_INPUT: u16 = 122;

/// A program writes a system output (3.5, 3.6).
pub const PROTECTED_OUTPUT: u16 = 124;

/// The device for an input, output or serial line does not respond (3.5 to 3.7).
pub const NO_ANSWER: u16 = 125;

const fn row(number: u16, short: &'static str, long: &'static str) -> RuntimeError {
    RuntimeError { number, short, long }
}

/// A division by zero (3.2.2).
pub const DIVISION_BY_ZERO: u16 = 10;

/// An index is not below the size, or a key does not exist in the collection (2.5.3).
pub const INDEX_TOO_LARGE: u16 = 20;

/// An index is below zero (2.5.3).
pub const INDEX_NEGATIVE: u16 = 21;

/// There is no memory left, or a variable would exceed its maximum number of elements (2.5.4).
pub const NO_MEMORY: u16 = 40;

/// The stack of a task is full.
pub const STACK_FULL: u16 = 41;

/// The interpreter cannot continue.
pub const INTERPRETER: u16 = 61;

/// Data or a program do not exist in a library, or the library is not loaded (6.4).
pub const LIBRARY_ITEM_MISSING: u16 = 80;

/// The father of a variable is in a library that is not declared, or is private in it (12.1).
pub const REFERENCE_OUT_OF_REACH: u16 = 82;

/// The name of a task is invalid (5.10).
pub const BAD_TASK_NAME: u16 = 29;

/// There is no task with this name (5.10).
pub const NO_TASK: u16 = 30;

/// A task with this name already exists (5.10).
pub const TASK_EXISTS: u16 = 31;

/// Synchronous tasks have more than two different periods (5.10).
pub const PERIODS: u16 = 32;

/// A task cannot continue at the line that `taskResume` requests (5.10).
pub const NO_LINE: u16 = 90;

/// An argument is invalid for the instruction.
pub const INVALID_PARAMETER: u16 = 70;

/// A position belongs to another kind of arm (12.1).
pub const ANOTHER_ARM: u16 = 81;

/// `vel` of a motion descriptor is invalid (10.5).
pub const BAD_VEL: u16 = 100;

/// `accel` of a motion descriptor is invalid (10.5).
pub const BAD_ACCEL: u16 = 101;

/// `decel` of a motion descriptor is invalid (10.5).
pub const BAD_DECEL: u16 = 102;

/// `tvel` of a motion descriptor is invalid (10.5).
pub const BAD_TVEL: u16 = 103;

/// `rvel` of a motion descriptor is invalid (10.5).
pub const BAD_RVEL: u16 = 104;

/// `reach` of a motion descriptor is invalid (10.5).
pub const BAD_REACH: u16 = 105;

/// `leave` of a motion descriptor is invalid (10.5).
pub const BAD_LEAVE: u16 = 106;

/// A move that was recorded before cannot be executed (10.6).
pub const MOTION_FAULT: u16 = 150;

/// The target or the path of a move is impossible (10.6).
pub const IMPOSSIBLE_MOVE: u16 = 154;

/// An option's licence is missing (11).
pub const NO_LICENCE: u16 = 250;

/// The position of `flange` is not 0 (9.5.1).
pub const FLANGE_CHANGED: u16 = 160;

/// The position of `world` is not 0 (9.4.1).
pub const WORLD_CHANGED: u16 = 161;

/// A point has no father (9.6.1).
pub const POINT_WITHOUT_REFERENCE: u16 = 162;

/// A frame has no father (9.4.1).
pub const FRAME_WITHOUT_REFERENCE: u16 = 163;

/// A tool has no father (9.5.1).
pub const TOOL_WITHOUT_REFERENCE: u16 = 164;

/// The father of a global variable is local.
pub const GLOBAL_REFERS_TO_LOCAL: u16 = 165;

/// Whether it is an error of moves (10.6), of motion descriptors (10.5) or of frames that move with the motion.
#[must_use]
pub const fn is_motion(number: u16) -> bool {
    matches!(number, BAD_VEL..=BAD_LEAVE | MOTION_FAULT | 153 | IMPOSSIBLE_MOVE | 170 | 171)
}

/// Finds an error by number.
#[must_use]
pub fn find(number: u16) -> Option<&'static RuntimeError> {
    RUNTIME_ERRORS.binary_search_by_key(&number, |row| row.number).ok().and_then(|at| RUNTIME_ERRORS.get(at))
}

/// All run-time errors, ascending.
#[rustfmt::skip]
pub static RUNTIME_ERRORS: [RuntimeError; 50] = [
    row(10, "division by zero", "The right side of / or % is 0. Test it before, or keep it away from 0."),
    row(11, "invalid numeric value", "The instruction is not defined for this number: the root or logarithm of a \
        negative number, asin or acos beyond 1, or a result too large. Limit the argument before."),
    row(20, "index too large", "A line uses an element of an array whose index is not below the size of the array, or \
        of a collection that does not have the key. Compare the index with size, or ask isDefined for the key."),
    row(21, "index negative", "A line uses an element of an array with an index below 0. The first element has the \
        index 0, and an index that is no whole number is rounded to the nearest one. Look for a counter that runs \
        below 0, for a difference such as nIndex-1 where nIndex is 0, and for the result of find, which is -1 where \
        nothing was found. Test the index before the line that uses it."),
    row(29, "bad task name", "The name of a task has 1 to 15 letters, digits and underscores."),
    row(30, "no such task", "This application or library has created no task of this name, or it has ended. Ask \
        taskStatus before; a task of another library cannot be reached."),
    row(31, "task name in use", "A task of this name exists already. Wait for its end, kill it, or choose another \
        name."),
    row(32, "too many periods", "All synchronous tasks together may have two different periods. Give the new task \
        one of them."),
    row(35, "another task moves the arm", "Another task is recording moves for this arm (s8). Let one task record all \
        moves, or protect the moves with a mutex."),
    row(40, "out of data memory", "There is no memory left for data. Reduce arrays and libraries, or stop making \
        containers larger in a loop."),
    row(41, "out of task memory", "The stack of the task is full: calls nested too deeply, or too many and too \
        large locals. Raise the application's stack size or use globals."),
    row(50, "name in use", "Something of this name exists already."),
    row(60, "instruction took too long", "An instruction did not end within the time the controller allows."),
    row(61, "interpreter fault", "The controller cannot execute a line that it has accepted. Note the line and \
        what led to it, and ask the maker of the controller."),
    row(70, "invalid parameter", "An argument has a value that the instruction does not take; the page of the \
        instruction tells its range."),
    row(80, "item of a library missing", "The line uses data or a program of a library that is not loaded, or that \
        the loaded library does not have. Check what libLoad returned; ask libExist or isDefined before."),
    row(81, "data for another arm", "A point, joint or config was made for another kind of arm than the one that \
        is connected."),
    row(82, "reference out of reach", "The reference frame or tool of a variable belongs to a library that is not \
        declared here, or it is private there. Declare the library or make the reference public."),
    row(90, "no line to resume at", "taskResume leads beyond the beginning or the end of the program. Count \
        instruction lines only: comments and blank lines are none."),
    row(100, "bad vel in the mdesc", "The joint speed of the motion descriptor is zero, negative or too large; it is a \
        percentage."),
    row(101, "bad accel in the mdesc", "The acceleration of the motion descriptor is zero, negative or too large; it is \
        a percentage."),
    row(102, "bad decel in the mdesc", "The deceleration of the motion descriptor is zero, negative or too large; it is \
        a percentage."),
    row(103, "bad tvel in the mdesc", "The speed of the tool centre point is zero, negative or too large; it counts \
        millimetres or inches per second."),
    row(104, "bad rvel in the mdesc", "The turning speed of the tool centre point is zero, negative or too large; it \
        counts degrees per second."),
    row(105, "bad reach in the mdesc", "The distance at which blending ends is negative."),
    row(106, "bad leave in the mdesc", "The distance at which blending starts is negative."),
    row(122, "write to an input", "The variable is linked to an input. Link it to an output, or write another one."),
    row(123, "input or output not linked", "The variable has no link to an input or output of this controller. \
        Link it in the data editor, or with dioLink, aioLink or sioLink."),
    row(124, "protected output", "The output belongs to the system and programs may not write it."),
    row(125, "input or output does not answer", "Reading or writing failed: the field bus or the device is down. \
        ioStatus and ioBusStatus tell more."),
    row(150, "motion cannot go on", "A move recorded before cannot be done: out of reach, a singularity, a \
        configuration that the path cannot change. Correct that move; resetMotion clears the queue."),
    row(153, "move not supported", "This arm or this option does not know the move."),
    row(154, "move not possible", "The target, or the line or circle to it, is out of reach or out of the limits, or \
        the motion descriptor does not suit it."),
    row(160, "flange was changed", "The position of flange is fixed. Define a tool of your own on it."),
    row(161, "world was changed", "The position of world is fixed. Define a frame of your own in it."),
    row(162, "point without reference", "The point has no reference frame. Give it one with link or by an \
        assignment; local points have none at first."),
    row(163, "frame without reference", "The frame has no reference frame. Give it one with link, setFrame or by \
        an assignment; local frames have none at first. References that form a circle count as none."),
    row(164, "tool without reference", "The tool has no reference tool. Give it one with link or by an assignment; \
        local tools have none at first. References that form a circle count as none."),
    row(165, "global refers to local", "A global variable cannot have a local one as its reference, because the \
        local one ends with its program."),
    row(170, "bad mobile frame", "A frame that moves with the motion is not usable as it was defined."),
    row(171, "mobile frame fault", "A frame that moves with the motion failed while it was followed."),
    row(200, "Ethernet fault", "The network connection failed. Check cable, address and peer."),
    row(250, "licence missing or trial over", "The instruction needs a licence that is not installed, or whose \
        trial has ended. getVersion tells the state of a licence."),
    row(270, "bad file path", "The path of the file names no reachable place."),
    row(271, "file cannot be read", "The file is missing, damaged or in use."),
    row(290, "bad trajectory id", "No trajectory has this id."),
    row(520, "joint position out of limits", "A joint position is beyond the software limits of an axis (s8). Correct \
        the position or the limits; val3 check --motion reports such positions."),
    row(531, "point beyond the limits of the axes", "The arm would reach the point only with axes beyond their limits \
        (s8). Correct the point, its frame or its tool; val3 check --motion reports such points."),
    row(534, "orientation not reachable", "No configuration of this arm reaches the orientation of the point (s8). \
        Correct the orientation of the point, its frame or its tool; val3 check --motion reports such points."),
    row(999, "other fault", "A fault without a number of its own. The event log tells more."),
];

#[cfg(test)]
mod tests {
    use super::{RUNTIME_ERRORS, find};
    use crate::instructions;

    const MANUAL: [u16; 36] = [
        10, 11, 20, 21, 29, 30, 31, 32, 40, 41, 60, 61, 70, 80, 81, 82, 90, 100, 101, 102, 103, 104, 105, 106, 122,
        123, 124, 125, 150, 153, 154, 160, 161, 162, 163, 164,
    ];
    const MESSAGES: [u16; 15] = [35, 50, 165, 170, 171, 200, 250, 270, 271, 290, 520, 531, 534, 999, 41];

    #[test]
    fn every_known_number_is_explained() {
        for number in MANUAL.into_iter().chain(MESSAGES) {
            let error = find(number);
            assert!(error.is_some_and(|row| !row.short.is_empty() && row.long.ends_with('.')), "{number}");
        }
    }

    #[test]
    fn numbers_ascend() {
        assert!(RUNTIME_ERRORS.iter().map(|row| row.number).is_sorted_by(|a, b| a < b));
    }

    #[test]
    fn instructions_raise_known_errors() {
        for instruction in instructions::all() {
            assert!(instruction.errors.iter().all(|&number| find(number).is_some()), "{}", instruction.name);
            assert!(instruction.errors.is_sorted(), "{}", instruction.name);
        }
    }
}
