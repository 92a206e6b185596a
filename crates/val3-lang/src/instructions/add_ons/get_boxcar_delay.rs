//! `$getBoxcarDelay`: returns the delay caused by the smoothing filter of the motion.

use crate::declare::instruction;

instruction! {
    /// Returns the delay that the smoothing filter of the motion causes.
    ///
    /// - Result: the delay.
    ///
    /// ## Example
    /// ```val3
    ///   putln($getBoxcarDelay())
    /// ```
    "$getBoxcarDelay": AddOns, with_add_on "Motion";
    function () -> num;
}
