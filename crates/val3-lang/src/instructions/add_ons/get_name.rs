//! `$getName`: returns the name of a variable.

use crate::declare::instruction;

instruction! {
    /// Returns the name of a variable.
    ///
    /// - `variable`: the variable.
    /// - Result: its name.
    ///
    /// ## Example
    /// ```val3
    /// point pPick
    ///   putln($getName(pPick))
    /// ```
    "$getName": AddOns, with_add_on "Expansion";
    function (any variable) -> string;
}
