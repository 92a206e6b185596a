//! `$getFreeSpace`: returns the free space of a disk partition.

use crate::declare::instruction;

instruction! {
    /// Returns the free space of a disk partition.
    ///
    /// - `sPartition`: `"/sys"`, `"/usr"` or `"/log"`.
    /// - Result: the free space.
    ///
    /// ## Example
    /// ```val3
    ///   putln($getFreeSpace("/usr"))
    /// ```
    "$getFreeSpace": AddOns, with_add_on "Expansion";
    function (string sPartition) -> num;
}
