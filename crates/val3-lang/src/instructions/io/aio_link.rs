//! `aioLink` (3.6.2): links a numerical signal to the input or output of another signal.

use crate::call::{Call, IoRef, Var};
use crate::declare::instruction;
use crate::fault::Result;

instruction! {
    /// Links a numerical signal to the input or output of another signal.
    ///
    /// - `aiVariable`: the variable that receives the link.
    /// - `aiSource`: the variable whose link is copied.
    ///
    /// ## Example
    /// ```val3
    /// aio aiPressure
    /// aio aiBoard
    ///   if ioStatus(aiBoard)>=0
    ///     aioLink(aiPressure,aiBoard)
    ///   endIf
    /// ```
    "aioLink": Io "3.6.2";
    modifier (aio& aiVariable, aio aiSource) = link;
}

fn link(call: &mut Call<'_>, variable: Var<IoRef>, source: IoRef) -> Result<()> {
    variable.set(call, source)
}
