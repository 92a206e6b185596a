//! `alter` (11.2.6): changes the deviation of the path.

use val3_geometry::Trsf;

use crate::call::Call;
use crate::declare::instruction;
use crate::moves;

instruction! {
    /// Sets the deviation of the path from now on.
    ///
    /// - `trAlteration`: the deviation in the reference that `alterBegin` has selected: rotation about its origin, then
    ///   translation.
    /// - Result: 1 done, 0 waits until the motion continues, -1 not started or ended, -2 no alter option, -3 a motion
    ///   error: `resetMotion` is needed.
    ///
    /// It takes effect every 4 ms, so it belongs in a synchronous task of that period. The deviation has to change
    /// smoothly: a change that would exceed a limit stops the arm immediately.
    ///
    /// ## Example
    /// ```val3
    /// trsf trShift
    /// aio aiSensor
    ///   trShift.z=aioGet(aiSensor)
    ///   alter(trShift)
    /// ```
    "alter": Options "11.2.6";
    modifier (trsf trAlteration) -> num = alter;
}

fn alter(call: &mut Call<'_>, alteration: Trsf) -> f64 {
    let alteration = moves::in_millimetres(call, &alteration);
    call.ports.alter(&alteration).into()
}
