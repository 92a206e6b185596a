use crate::declare::instruction;

instruction! {
    /// Deletes a library from a disk.
    ///
    /// - `sPath`: where it is (`libLoad` describes paths).
    /// - Result: 0 deleted, also if there was none; every other number says why not.
    ///
    /// ## Example
    /// ```val3
    ///   if libDelete("USB0://backup")==0 and libSave("USB0://backup")==0
    ///     popUpMsg("saved")
    ///   endIf
    /// ```
    "libDelete": Libraries "6.7", blocking;
    modifier (string sPath) -> num;
}
