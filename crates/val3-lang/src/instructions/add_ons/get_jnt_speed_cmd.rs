//! `$getJntSpeedCmd`: returns the commanded axis speeds.

use crate::declare::instruction;

instruction! {
    /// Returns the commanded speed of each axis.
    ///
    /// - `nSpeed`: receives the speeds in degrees (millimetres) per second, one value per axis.
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
