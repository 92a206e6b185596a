//! `isSettled` (10.6): returns whether the arm is at rest.

use crate::call::Call;
use crate::declare::instruction;

instruction! {
    /// Returns whether the arm is at rest.
    ///
    /// - Result: `true` if the position error of every axis has been within 1 % of its maximum for 50 ms.
    ///
    /// An arm can be at rest before its moves are done, for example after `stopMove`: `isEmpty` returns whether they
    /// are done.
    ///
    /// ## Example
    /// ```val3
    /// tool tGripper
    ///   waitEndMove()
    ///   wait(isSettled())
    ///   close(tGripper)
    /// ```
    "isSettled": Motion "10.6", role(Progress);
    function () -> bool = is_settled;
}

fn is_settled(call: &mut Call<'_>) -> bool {
    call.ports.is_settled()
}
