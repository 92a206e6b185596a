//! `$getBoxcarDelay`: returns the delay caused by the smoothing filter of the motion.

use crate::declare::instruction;

instruction! {
    /// Gives the delay that the smoothing filter of the motion brings about.
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
