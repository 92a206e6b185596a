//! `$getJntSpeedFbk`: returns the axis speeds as measured by the encoders.

use crate::declare::instruction;

instruction! {
    /// Gives the speed that each axis has, as the encoders measure it.
    ///
    /// - `nSpeed`: gets degrees (millimetres) per second, one value an axis.
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
