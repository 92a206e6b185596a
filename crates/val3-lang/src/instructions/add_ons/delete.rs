use crate::declare::instruction;

instruction! {
    /// Deletes a file or a folder.
    ///
    /// - `sPath`: where it is.
    /// - Result: `true` if it was deleted.
    ///
    /// ## Example
    /// ```val3
    ///   $delete("Disk://data/log.txt")
    /// ```
    "$delete": AddOns, with_add_on "Expansion";
    modifier (string sPath) -> bool;
}
