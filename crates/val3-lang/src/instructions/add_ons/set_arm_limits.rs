//! `$setArmLimits`: sets the software limits of the arm.

use crate::declare::instruction;

instruction! {
    /// Sets the software limits of the arm.
    ///
    /// - `jMin`, `jMax`: the lowest and highest position of each axis.
    /// - Result: `true` if the limits were accepted.
    ///
    /// ## Example
    /// ```val3
    /// joint jMin
    /// joint jMax
    ///   if $setArmLimits(jMin,jMax)==false
    ///     logMsg("limits refused")
    ///   endIf
    /// ```
    "$setArmLimits": AddOns, with_add_on "Expansion";
    modifier (joint jMin, joint jMax) -> bool;
}
