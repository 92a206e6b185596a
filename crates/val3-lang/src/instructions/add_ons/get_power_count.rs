//! `$getPowerCount`: returns the total time for which the arm has had power.

use crate::declare::instruction;

instruction! {
    /// Returns the total time for which the arm has had power.
    ///
    /// - Result: the time in hours.
    ///
    /// ## Example
    /// ```val3
    ///   putln($getPowerCount())
    /// ```
    "$getPowerCount": AddOns, with_add_on "Expansion";
    function () -> num;
}
