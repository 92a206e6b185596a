//! `isEmpty` (10.6): returns whether every recorded move is done.

use crate::call::Call;
use crate::declare::instruction;

instruction! {
    /// Returns whether every recorded move is done.
    ///
    /// - Result: `false` while a move remains.
    ///
    /// ## Example
    /// ```val3
    /// dio doIdle
    ///   doIdle=isEmpty()
    /// ```
    "isEmpty": Motion "10.6", role(Progress);
    function () -> bool = is_empty;
}

fn is_empty(call: &mut Call<'_>) -> bool {
    call.ports.is_empty()
}
