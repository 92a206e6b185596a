//! `stopMove` (10.6): stops the arm on its path.

use crate::call::Call;
use crate::declare::instruction;

instruction! {
    /// Stops the arm on its path.
    ///
    /// It returns immediately, while the arm still decelerates as set by the current move. Recorded moves are kept, and
    /// new moves can be recorded; the arm continues after `restartMove`, or on a new path after `resetMotion`. Jogging
    /// remains possible.
    ///
    /// ## Example
    /// ```val3
    /// dio diHold
    ///   wait(diHold==true)
    ///   stopMove()
    ///   wait(diHold==false)
    ///   restartMove()
    /// ```
    "stopMove": Motion "10.6", role(Stop);
    modifier () = stop;
}

fn stop(call: &mut Call<'_>) {
    call.ports.stop_move();
}
