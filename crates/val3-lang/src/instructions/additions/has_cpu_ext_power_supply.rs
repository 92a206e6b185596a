//! `hasCpuExtPowerSupply`: returns whether the processor of the controller has a separate power supply.

use crate::call::Call;
use crate::declare::instruction;

instruction! {
    /// Returns whether the processor of the controller has a separate power supply.
    ///
    /// - Result: `true` if it has one.
    ///
    /// On CS9 controllers.
    ///
    /// ## Example
    /// ```val3
    /// version s8.10
    ///   if hasCpuExtPowerSupply()
    ///     putln("external supply")
    ///   endIf
    /// ```
    "hasCpuExtPowerSupply": Additions, since 8;
    function () -> bool = has_cpu_ext_power_supply;
}

fn has_cpu_ext_power_supply(call: &mut Call<'_>) -> bool {
    call.ports.has_external_supply()
}
