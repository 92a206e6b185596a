//! `autoConnectMove` (10.6): sets or returns whether connection moves are automatic in remote mode.

use crate::call::Call;
use crate::declare::instruction;

instruction! {
    /// Sets or returns whether connection moves are automatic in remote mode.
    ///
    /// - `bActive`: `true` for an automatic connection move, `false` (initial value) for a connection move that the
    ///   operator commands. An arm that has hardly left its path is connected automatically in either case.
    /// - Result without argument: the current setting.
    ///
    /// ## Example
    /// ```val3
    ///   if autoConnectMove()==false
    ///     autoConnectMove(true)
    ///   endIf
    /// ```
    "autoConnectMove": Motion "10.6";
    modifier (bool bActive) = choose;
    function () -> bool = choice;
}

fn choose(call: &mut Call<'_>, active: bool) {
    call.ports.connect_by_itself(active);
}

fn choice(call: &mut Call<'_>) -> bool {
    call.ports.connects_by_itself()
}
