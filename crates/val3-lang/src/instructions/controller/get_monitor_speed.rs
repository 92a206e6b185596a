//! `getMonitorSpeed` (8.1): returns the monitor speed, which scales every move.

use crate::call::Call;
use crate::declare::instruction;

instruction! {
    /// Returns the monitor speed, which scales every move.
    ///
    /// - Result: per cent, 0 to 100.
    ///
    /// ## Example
    /// ```val3
    ///   if getMonitorSpeed()>10
    ///     popUpMsg("First cycle: at most 10 %")
    ///     wait(getMonitorSpeed()<=10)
    ///   endIf
    /// ```
    "getMonitorSpeed": Controller "8.1";
    function () -> num = get_monitor_speed;
}

fn get_monitor_speed(call: &mut Call<'_>) -> f64 {
    call.ports.monitor_speed()
}
