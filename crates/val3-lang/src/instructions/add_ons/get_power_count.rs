//! `$getPowerCount`: returns the total time for which the arm has had power.

use crate::declare::instruction;

instruction! {
    /// Gives for how long the arm has had power in its life.
    ///
    /// - Result: hours.
    ///
    /// ## Example
    /// ```val3
    ///   putln($getPowerCount())
    /// ```
    "$getPowerCount": AddOns, with_add_on "Expansion";
    function () -> num;
}
