//! `safetyFault` (8.1): returns whether the safety circuit has a hardware fault that was found and confirmed.

use crate::call::{Call, Var};
use crate::declare::instruction;
use crate::fault::Result;
use crate::values::Text;

instruction! {
    /// Returns whether the safety circuit has a hardware fault that was found and confirmed.
    ///
    /// - `sSignalName`: receives the name of the faulty signal; unchanged without a fault.
    /// - Result: `true` if there is a fault.
    ///
    /// ## Example
    /// ```val3
    /// string sSignal
    ///   if safetyFault(sSignal)
    ///     logMsg("safety fault: "+sSignal)
    ///   endIf
    /// ```
    "safetyFault": Controller "8.1";
    modifier (string& sSignalName) -> bool = safety_fault;
}

fn safety_fault(call: &mut Call<'_>, signal: Var<Text>) -> Result<bool> {
    let fault = call.ports.safety_fault();
    if let Some(name) = fault {
        signal.set(call, name)?;
    }
    Ok(fault.is_some())
}
