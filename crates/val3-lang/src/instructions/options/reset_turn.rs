//! `resetTurn` (11.5.2): resets the turns of a continuous axis, after the arm has stopped and its moves are cancelled.

use crate::call::{Call, Flow, Wait};
use crate::declare::instruction;
use crate::fault::Result;
use crate::moves;
use crate::ports::{SECOND, Time};
use crate::values::JointValue;

instruction! {
    /// Resets the turns of a continuous axis, after the arm has stopped and its moves are cancelled.
    ///
    /// - `jReference`: the axis receives the equivalent position nearest to this one: 720 degrees can become 0.
    /// - Result: the resulting position of the arm.
    /// - Error 250: no licence for continuous axes.
    ///
    /// It stops the arm and cancels the moves like `resetMotion`, works with and without power, and takes about 50 ms.
    /// The continuous axis is axis 6 of a six-axis arm, or axis 4 of a SCARA arm.
    ///
    /// ## Example
    /// ```val3
    /// joint jStart
    ///   waitEndMove()
    ///   resetTurn(jStart)
    /// ```
    "resetTurn": Options "11.5.2", role(Reset), blocking, errors [250];
    modifier (joint jReference) -> joint = reset;
}

/// Parts of the instruction: the arm stops, then its axis is changed.
const STOPPING: u8 = 0;
const CHANGING: u8 = 1;

/// Duration of the change, in ns.
const CHANGE: Time = SECOND / 20;

fn reset(call: &mut Call<'_>, reference: JointValue) -> Result<Flow<JointValue>> {
    if call.is_first() {
        call.ports.reset_motion(None);
    }
    match call.part() {
        STOPPING if !call.ports.is_at_rest() => Ok(Flow::Wait(Wait::FOR_OTHERS)),
        STOPPING => Ok(call.sleep_in_part(CHANGING, CHANGE)),
        _ if call.waited() < CHANGE => Ok(call.sleep(CHANGE)),
        _ => {
            let reference = moves::to_arm(call, reference);
            let position = call.ports.reset_turn(reference)?;
            Ok(Flow::Done(moves::of_arm(call, position)))
        }
    }
}
