//! `sioLink` (3.7.3): links a serial channel to the line or socket of another channel.

use crate::call::{Call, IoRef, Var};
use crate::declare::instruction;
use crate::fault::Result;

instruction! {
    /// Links a serial channel to the line or socket of another channel.
    ///
    /// - `siVariable`: the variable that receives the link.
    /// - `siSource`: the variable whose link is copied.
    ///
    /// ## Example
    /// ```val3
    /// sio siHost
    /// sio siSocket
    ///   sioLink(siHost,siSocket)
    /// ```
    "sioLink": Io "3.7.3";
    modifier (sio& siVariable, sio siSource) = link;
}

/// A source without a link removes the variable's link.
fn link(call: &mut Call<'_>, variable: Var<IoRef>, source: IoRef) -> Result<()> {
    variable.set(call, source)
}
