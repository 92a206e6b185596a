//! `$getJntSpeedFbk`: returns the axis speeds as measured by the encoders.

use crate::declare::instruction;

instruction! {
    /// Returns the speed of each axis as measured by the encoders.
    ///
    /// - `nSpeed`: receives the speeds in degrees (millimetres) per second, one value per axis.
    ///
    /// ## Example
    /// ```val3
    /// num nSpeed[6]
    ///   $getJntSpeedFbk(nSpeed)
    ///   putln(nSpeed[0])
    /// ```
    "$getJntSpeedFbk": AddOns, with_add_on "Motion";
    modifier (num& nSpeed[]);
}
