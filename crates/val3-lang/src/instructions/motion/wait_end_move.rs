//! `waitEndMove` (10.6): waits until every recorded move is done.

use crate::call::{Call, Flow, Wait};
use crate::declare::instruction;
use crate::fault::Result;

instruction! {
    /// Waits until every recorded move is done.
    ///
    /// It also ends blending: the last move stops at its target as if its `blend` were `off`. It waits until the
    /// commanded position is reached, not until the arm is at rest. To wait for that, use `wait(isSettled())`.
    ///
    /// - Error 150: a recorded move cannot be executed.
    ///
    /// ## Example
    /// ```val3
    /// point pPlace
    /// tool tGripper
    /// mdesc mSlow
    /// dio doLamp
    ///   movel(pPlace,tGripper,mSlow)
    ///   waitEndMove()
    ///   doLamp=true
    /// ```
    "waitEndMove": Motion "10.6", role(Arrive), blocking, errors [150];
    modifier () = wait;
}

fn wait(call: &mut Call<'_>) -> Result<Flow<()>> {
    Ok(if call.ports.arrive()? { Flow::Done(()) } else { Flow::Wait(Wait::FOR_OTHERS) })
}
