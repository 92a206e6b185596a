//! `restartMove` (10.6): releases the arm after `stopMove`.

use crate::call::Call;
use crate::declare::instruction;

instruction! {
    /// Lets the arm continue after `stopMove`.
    ///
    /// Without an earlier `stopMove`, it has no effect.
    ///
    /// ## Example
    /// ```val3
    /// dio diHold
    ///   stopMove()
    ///   wait(diHold==false)
    ///   restartMove()
    /// ```
    "restartMove": Motion "10.6", role(Restart);
    modifier () = restart;
}

fn restart(call: &mut Call<'_>) {
    call.ports.restart_move();
}
