//! `setMonitorSpeed` (8.1): changes the monitor speed, which scales every move.

use crate::call::Call;
use crate::declare::instruction;

instruction! {
    /// Changes the monitor speed, which scales every move.
    ///
    /// - `nSpeed`: per cent, 0 to 100. It can always be lowered. It can be raised only in remote mode, and only if the
    ///   operator does not control the speed.
    /// - Result: 0 done, -1 not in remote mode, -2 the operator controls the speed, -3 outside of 0 to 100.
    ///
    /// ## Example
    /// ```val3
    ///   if setMonitorSpeed(20)!=0
    ///     logMsg("speed not changed")
    ///   endIf
    /// ```
    "setMonitorSpeed": Controller "8.1";
    modifier (num nSpeed) -> num = set_monitor_speed;
}

fn set_monitor_speed(call: &mut Call<'_>, speed: f64) -> f64 {
    call.ports.set_monitor_speed(speed).into()
}
