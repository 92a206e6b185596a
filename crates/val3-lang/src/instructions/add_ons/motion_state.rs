//! `$motionState`: returns the state of the motion.

use crate::declare::instruction;

instruction! {
    /// Returns the state of the motion.
    ///
    /// - Result: a field of 16 bits; read it with `bAnd`.
    ///
    /// ## Example
    /// ```val3
    ///   if bAnd($motionState(),1)!=0
    ///     putln("bit 0 is set")
    ///   endIf
    /// ```
    "$motionState": AddOns, with_add_on "Motion";
    function () -> num;
}
