//! `dioLink` (3.5.3): links a digital signal to the input or output of another signal.

use crate::call::{Call, IoRef, Var};
use crate::declare::instruction;
use crate::fault::Result;

instruction! {
    /// Links a digital signal to the input or output of another signal.
    ///
    /// - `diVariable`: the variable that receives the link.
    /// - `diSource`: the variable whose link is copied.
    ///
    /// One program can thus serve cells with different hardware.
    ///
    /// ## Example
    /// ```val3
    /// dio diGripped
    /// dio diBoard
    /// dio diFieldbus
    ///   if ioStatus(diFieldbus)>=0
    ///     dioLink(diGripped,diFieldbus)
    ///   else
    ///     dioLink(diGripped,diBoard)
    ///   endIf
    /// ```
    "dioLink": Io "3.5.3";
    modifier (dio& diVariable, dio diSource) = link;
}

fn link(call: &mut Call<'_>, variable: Var<IoRef>, source: IoRef) -> Result<()> {
    variable.set(call, source)
}
