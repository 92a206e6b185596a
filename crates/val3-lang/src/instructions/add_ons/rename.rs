use crate::declare::instruction;

instruction! {
    /// Moves a file or a folder, or gives it another name.
    ///
    /// - `sFrom`, `sTo`: its old and its new path.
    /// - Result: `true` if it was moved.
    ///
    /// ## Example
    /// ```val3
    ///   if $rename("Disk://data/log.txt","Disk://data/old.txt")==false
    ///     logMsg("log not renamed")
    ///   endIf
    /// ```
    "$rename": AddOns, with_add_on "Expansion";
    modifier (string sFrom, string sTo) -> bool;
}
