//! `$getCycleTime`: returns the cycle time of the controller.

use crate::declare::instruction;

instruction! {
    /// Returns the cycle time of the controller.
    ///
    /// - Result: the time from one commanded position to the next.
    ///
    /// ## Example
    /// ```val3
    ///   putln($getCycleTime())
    /// ```
    "$getCycleTime": AddOns, with_add_on "Motion";
    function () -> num;
}
