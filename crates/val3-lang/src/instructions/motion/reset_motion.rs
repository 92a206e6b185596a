//! `resetMotion` (10.6): stops the arm and discards all recorded moves.

use crate::call::Call;
use crate::declare::instruction;
use crate::moves;
use crate::values::JointValue;

instruction! {
    /// Stops the arm and discards all recorded moves.
    ///
    /// - `jStartingPoint`: the start of the next move, which the arm first has to reach by a connection move. Without
    ///   it, the next move starts at the current position of the arm.
    ///
    /// It returns immediately, sets the move id to 0 and cancels a `stopMove`.
    ///
    /// ## Example
    /// ```val3
    ///   if isEmpty()==false
    ///     resetMotion()
    ///     putln("moves cancelled")
    ///   endIf
    /// ```
    "resetMotion": Motion "10.6", role(Reset);
    modifier () = reset;
    modifier (joint jStartingPoint) = reset_to;
}

fn reset(call: &mut Call<'_>) {
    call.ports.reset_motion(None);
}

fn reset_to(call: &mut Call<'_>, start: JointValue) {
    let start = moves::to_arm(call, start);
    call.ports.reset_motion(Some(start));
}
