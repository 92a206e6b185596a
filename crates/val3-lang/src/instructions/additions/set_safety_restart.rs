//! `setSafetyRestart`: requests a restart of the safety controller after a safety stop.

use crate::call::Call;
use crate::declare::instruction;

instruction! {
    /// Requests a restart of the safety controller after a safety stop.
    ///
    /// - Result: `true` if the restart was accepted.
    ///
    /// On CS9 controllers.
    ///
    /// ## Example
    /// ```val3
    /// version s8.10
    ///   if setSafetyRestart()==false
    ///     logMsg("safety restart refused")
    ///   endIf
    /// ```
    "setSafetyRestart": Additions, since 8;
    modifier () -> bool = set_safety_restart;
}

fn set_safety_restart(call: &mut Call<'_>) -> bool {
    call.ports.restart_safety()
}
