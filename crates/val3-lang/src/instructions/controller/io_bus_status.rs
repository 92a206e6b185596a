//! `ioBusStatus` (8.1): counts the field bus devices that have failed.

use crate::call::{Arr, Call};
use crate::declare::instruction;
use crate::fault::Result;
use crate::memory::View;
use crate::values::Text;

instruction! {
    /// Counts the field bus devices that have failed.
    ///
    /// - `sErrorDescription`: receives a text for each failed device: error number, device and module
    ///   (`number:device\module`). A global array grows as needed.
    /// - Result: the number of failed devices.
    ///
    /// ## Example
    /// ```val3
    /// string sFaults[1]
    ///   if ioBusStatus(sFaults)>0
    ///     logMsg(sFaults[0])
    ///   endIf
    /// ```
    "ioBusStatus": Controller "8.1";
    modifier (string& sErrorDescription[]) -> num = bus_status;
}

/// Fills the array from its first element; elements after the last text are unchanged. A local array does not grow, so
/// further texts are omitted.
fn bus_status(call: &mut Call<'_>, texts: Arr<Text>) -> Result<f64> {
    let faults = call.ports.failed_devices();
    if !call.memory.is_local(texts.view.store) {
        grow(call, texts.view, faults.len())?;
    }
    for (index, fault) in faults.iter().enumerate().take(texts.len(call)?) {
        texts.set(call, index, *fault)?;
    }
    Ok(faults.len() as f64)
}

fn grow(call: &mut Call<'_>, view: View, wanted: usize) -> Result<()> {
    let limit = call.version.container_limit();
    while (call.memory.len(view)? as usize) < wanted {
        call.memory.append(view.store, limit)?;
    }
    Ok(())
}
