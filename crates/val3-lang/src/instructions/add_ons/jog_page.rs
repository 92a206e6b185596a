//! `$jogPage`: shows or hides the jog page of the pendant.

use crate::declare::instruction;

instruction! {
    /// Shows or hides the jog page of the pendant.
    ///
    /// - `bShown`: `true` shows it.
    ///
    /// ## Example
    /// ```val3
    ///   $jogPage(false)
    /// ```
    "$jogPage": AddOns, with_add_on "Expansion";
    modifier (bool bShown);
}
