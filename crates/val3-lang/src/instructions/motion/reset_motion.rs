//! `resetMotion` (10.6): stops the arm and discards all recorded moves.

use crate::call::Call;
use crate::declare::instruction;

instruction! {
    /// Stops the arm and forgets every recorded move.
    ///
    /// - `jStartingPoint`: where the next move starts: the arm first has to get there by a connection move. Without it,
    ///   the next move starts wherever the arm is.
    ///
    /// It returns at once, sets the move id to 0 and undoes a `stopMove`.
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

fn reset_to(call: &mut Call<'_>, start: [f64; 6]) {
    call.ports.reset_motion(Some(start));
}
