//! `$libClose`: closes the library under an identifier, or the application itself, after `$libOpen`.

use crate::declare::instruction;

instruction! {
    /// Closes the library under an identifier, or the application itself, after `$libOpen`.
    ///
    /// - Result: `true` if it was closed.
    ///
    /// ## Example
    /// ```val3
    /// library part "Disk://part/part.pjx"
    ///   part:$libClose()
    /// --- part
    /// public num nWeight
    /// ```
    "$libClose": AddOns, with_add_on "Expansion";
    modifier () -> bool;
    modifier () -> bool on library;
}
