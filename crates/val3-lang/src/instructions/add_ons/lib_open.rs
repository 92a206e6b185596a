//! `$libOpen`: opens the library under an identifier, or the application itself.

use crate::declare::instruction;

instruction! {
    /// Opens the library under an identifier, or the application itself.
    ///
    /// - Result: `true` if it was opened. `$libClose` closes it again.
    ///
    /// ## Example
    /// ```val3
    /// library part "Disk://part/part.pjx"
    ///   if part:$libOpen()
    ///     part:$libClose()
    ///   endIf
    /// --- part
    /// public num nWeight
    /// ```
    "$libOpen": AddOns, with_add_on "Expansion";
    modifier () -> bool;
    modifier () -> bool on library;
}
