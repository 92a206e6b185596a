//! `$getJntSpeedCmd`: returns the commanded axis speeds.

use crate::declare::instruction;

instruction! {
    /// Gives the speed that each axis is commanded to have.
    ///
    /// - `nSpeed`: gets degrees (millimetres) per second, one value an axis.
    ///
    /// ## Example
    /// ```val3
    /// num nSpeed[6]
    ///   $getJntSpeedCmd(nSpeed)
    ///   putln(nSpeed[0])
    /// ```
    "$getJntSpeedCmd": AddOns, with_add_on "Motion";
    modifier (num& nSpeed[]);
}
