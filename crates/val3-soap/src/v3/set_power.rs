//! `setPower`: switches the power of the arm.

use super::PowerResult;
use crate::structure::{operation, structure};

structure! {
    /// Request `setPower`.
    SetPower {
        /// Whether power is switched on.
        power: bool = "power",
    }
}

structure! {
    /// Answer of `setPower`.
    SetPowerAnswer {
        /// Result.
        code: PowerResult = "code",
    }
}

operation!(SetPower: V3 "setPower" => SetPowerAnswer, "setPowerResponse");
