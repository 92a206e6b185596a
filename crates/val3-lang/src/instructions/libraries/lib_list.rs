use crate::declare::instruction;

instruction! {
    /// Lists what a folder contains.
    ///
    /// - `sPath`: the folder (`libLoad` describes paths).
    /// - `sContents`: gets the names; all its values are emptied first, so the first `""` marks the end. A global
    ///   array grows as needed.
    /// - Result: `false` if the array is too small for the whole list.
    ///
    /// ## Example
    /// ```val3
    /// string sNames[1]
    /// num nIndex
    ///   libList("Disk://parts",sNames)
    ///   for nIndex=0 to size(sNames)-1
    ///     putln(sNames[nIndex])
    ///   endFor
    /// ```
    "libList": Libraries "6.7", blocking;
    modifier (string sPath, string& sContents[]) -> bool;
}
