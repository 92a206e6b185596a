//! `workingMode` (8.1): returns the working mode of the robot.

use crate::call::{Call, Var};
use crate::declare::instruction;
use crate::fault::Result;

instruction! {
    /// Returns the working mode of the robot.
    ///
    /// - `nStatus`: receives the state within the mode. Manual: 0 programmed motion, 1 connection move, 2 joint, 3
    ///   frame, 4 tool and 5 point jog, 6 hold. Test: 0 programmed motion and 1 connection move (below 250 mm/s), 2
    ///   fast motion, 3 hold. Local and remote: 0 programmed motion, 1 connection move, 2 hold.
    /// - Result: 0 changing or invalid, 1 manual, 2 test, 3 local, 4 remote.
    ///
    /// ## Example
    /// ```val3
    /// num nState
    ///   if workingMode(nState)==4 and nState==0
    ///     putln("remote, moving")
    ///   endIf
    /// ```
    "workingMode": Controller "8.1";
    function () -> num = mode;
    modifier (num& nStatus) -> num = mode_and_state;
}

fn mode(call: &mut Call<'_>) -> f64 {
    call.ports.working_mode().0.into()
}

fn mode_and_state(call: &mut Call<'_>, status: Var<f64>) -> Result<f64> {
    let (mode, state) = call.ports.working_mode();
    status.set(call, state.into())?;
    Ok(mode.into())
}
