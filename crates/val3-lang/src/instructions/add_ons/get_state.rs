//! `$getState`: returns the system state that the display on the controller's board shows.

use crate::declare::instruction;

instruction! {
    /// Returns the system state that the display on the controller's board shows.
    ///
    /// - Result: the number on the display.
    ///
    /// ## Example
    /// ```val3
    /// num nState
    ///   nState=$getState()
    ///   putln(nState)
    /// ```
    "$getState": AddOns, with_add_on "Expansion";
    modifier () -> num;
}
