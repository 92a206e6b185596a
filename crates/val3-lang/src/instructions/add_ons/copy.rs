use crate::declare::instruction;

instruction! {
    /// Copies a file or a folder.
    ///
    /// - `sFrom`, `sTo`: from where to where.
    /// - Result: `true` if it was copied.
    ///
    /// ## Example
    /// ```val3
    ///   if $copy("Disk://data/log.txt","USB0://log.txt")==false
    ///     logMsg("log not copied")
    ///   endIf
    /// ```
    "$copy": AddOns, with_add_on "Expansion";
    modifier (string sFrom, string sTo) -> bool;
}
