//! `$jogContext`: selects the tool, the frame and the mode in which the operator jogs the arm.

use crate::declare::instruction;

instruction! {
    /// Selects the tool, the frame and the mode in which the operator jogs the arm.
    ///
    /// - `tTool`, `fReference`: the tool and the frame.
    /// - `nMode`: the jog mode, a number.
    ///
    /// ## Example
    /// ```val3
    /// tool tGripper
    ///   $jogContext(tGripper,world,0)
    /// ```
    "$jogContext": AddOns, with_add_on "Expansion";
    modifier (tool tTool, frame fReference, num nMode);
}
