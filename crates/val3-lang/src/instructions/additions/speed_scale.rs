//! `speedScale`: returns the speed percentage that scales every move, before s7.

use crate::call::Call;
use crate::declare::instruction;

instruction! {
    /// Returns the speed percentage that scales every move, before s7.
    ///
    /// - Result: per cent.
    ///
    /// From s7 on, `getMonitorSpeed` returns it.
    ///
    /// ## Example
    /// ```val3
    /// version s5.4
    ///   if speedScale()>10
    ///     putln("too fast to teach")
    ///   endIf
    /// ```
    "speedScale": Additions, until 6;
    function () -> num = speed_scale;
}

fn speed_scale(call: &mut Call<'_>) -> f64 {
    call.ports.monitor_speed()
}
