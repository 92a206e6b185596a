//! `alterStopTime` (11.2.6): returns the time until a stop freezes the deviation.

use crate::call::Call;
use crate::declare::instruction;

instruction! {
    /// Returns the time until a stop freezes the deviation.
    ///
    /// - Result: seconds; negative if no stop is requested; 0 if the deviation is frozen or not active.
    ///
    /// Within this time the program should bring the deviation to rest.
    ///
    /// ## Example
    /// ```val3
    /// trsf trShift
    /// num nLeft
    ///   nLeft=alterStopTime()
    ///   if nLeft<0
    ///     trShift.z=trShift.z+0.01
    ///     alter(trShift)
    ///   endIf
    /// ```
    "alterStopTime": Options "11.2.6";
    function () -> num = stop_time;
}

fn stop_time(call: &mut Call<'_>) -> f64 {
    call.ports.alter_stop_time()
}
