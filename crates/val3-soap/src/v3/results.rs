//! Results of moves, and states of the arm.

use super::{ArmConfig, Matrix};
use crate::structure::{enumeration, structure};

structure! {
    /// Answer to a move.
    MoveAnswer {
        /// Number of the move.
        id: i32 = "id",
        /// Result.
        result: MotionResult = "motRet",
    }
}

structure! {
    /// Answer to a change of the motion.
    MotionAnswer {
        /// Result.
        result: MotionResult = "motRet",
    }
}

structure! {
    /// Arm state.
    RobotPosition {
        /// Whether the arm is settled: all moves are done, and no joint moves.
        settled: bool = "settled",
        /// Joints, in rad or m.
        joints: Vec<f64> = "joint" of "item",
        /// Flange in `world`.
        position: Matrix = "position",
        /// Configuration.
        config: ArmConfig = "config",
    }
}

enumeration! {
    /// Result of a move.
    MotionResult {
        /// The move is accepted.
        NoError = "SCSV3-MOT-NO-ERR",
        /// The arm has no power or is not in the remote mode.
        NotReady = "SCSV3-MOT-NOT-READY",
        /// A parameter is invalid, or the destination cannot be reached.
        WrongParameter = "SCSV3-MOT-ERR-PARAM",
        /// The move is not permitted now.
        Misuse = "SCSV3-MOT-ERR-MISUSE",
        /// Any other reason.
        Unexpected = "SCSV3-MOT-ERR-UNEXPECTED",
    }
}

enumeration! {
    /// Result of the search for joints.
    ReversingResult {
        /// Joints were found.
        Ok = "REVERSE-OK",
        /// The computation has not converged.
        NoConvergence = "NO-CONVERGENCE",
        /// The joints would exceed their limits.
        OutOfJointRange = "OUT-OF-JNT-RANGE",
        /// The position is too far away or too near.
        OutOfWorkspace = "OUT-OF-WORKSPACE",
        /// No joints have the configuration.
        InvalidConfig = "INVALID-CONFIG",
        /// The orientation cannot be reached.
        InvalidOrientation = "INVALID-ORIENTATION",
        /// The arm has no such computation.
        UnsupportedKinematics = "UNSUPPORTED-KINEMATICS",
        /// The matrix is no frame.
        UnconstrainedFrame = "UNCONSTRAINT-FRAME",
        /// Any other reason.
        InvalidErrorCode = "INVALID-ERROR-CODE",
    }
}

enumeration! {
    /// Result of `setPower`.
    PowerResult {
        /// The power was changed.
        NoError = "POWER-NO-ERR",
        /// The arm moves.
        RobotNotStopped = "POWER-CHANGE-WHILE-ROBOT-NOT-STOPPED",
        /// The power was not switched on in time.
        EnableTimeout = "POWER-ENABLE-TIMEOUT",
        /// The power was not switched off in time.
        DisableTimeout = "POWER-DISABLE-TIMEOUT",
        /// Clients can change the power only in the remote mode.
        OnlyInRemoteMode = "POWER-CHANGE-ONLY-IN-REMOTE-MODE",
    }
}

enumeration! {
    /// Scheduler of the moves.
    SchedulingMode {
        /// The controller.
        Internal = "SCHEDULING-INTERNAL",
        /// The client.
        External = "SCHEDULING-EXTERNAL",
    }
}
