//! `opcuaExport`: publishes a variable on the OPC UA server of the controller.

use crate::call::Call;
use crate::declare::instruction;
use crate::memory::View;

instruction! {
    /// Publishes a variable on the OPC UA server of the controller.
    ///
    /// - `variable`: the variable.
    /// - `bWritable`: `true` if clients may also write the variable.
    ///
    /// On CS9 controllers.
    ///
    /// ## Example
    /// ```val3
    /// version s8.10
    /// num nDone
    ///   opcuaExport(nDone,false)
    /// ```
    "opcuaExport": Additions, since 8;
    modifier (any& variable, bool bWritable) = export;
}

/// Has no effect, because the virtual controller has no OPC UA clients.
fn export(_: &mut Call<'_>, _: View, _: bool) {}
