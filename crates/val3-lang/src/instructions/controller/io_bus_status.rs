use crate::declare::instruction;

instruction! {
    /// Counts the field bus devices that have failed.
    ///
    /// - `sErrorDescription`: gets a text for each of them: error number, device and module (`number:device\module`). A
    ///   global array grows as needed.
    /// - Result: how many devices have failed.
    ///
    /// ## Example
    /// ```val3
    /// string sFaults[1]
    ///   if ioBusStatus(sFaults)>0
    ///     logMsg(sFaults[0])
    ///   endIf
    /// ```
    "ioBusStatus": Controller "8.1";
    modifier (string& sErrorDescription[]) -> num;
}
