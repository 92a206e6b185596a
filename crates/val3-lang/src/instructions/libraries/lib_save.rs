use crate::declare::instruction;

instruction! {
    /// Saves programs and data of a library, or of the application itself.
    ///
    /// - Called on an identifier it saves the library that is loaded there, else the application it stands in.
    /// - `sPath`: where to save; without it, where it was loaded from.
    /// - Result: 0 saved; every other number says why not: 10 nothing is loaded under the identifier, 31 there is a
    ///   library at `sPath` already.
    ///
    /// It never raises a run-time error. Flash memory wears out: not once a minute or more often.
    ///
    /// ## Example
    /// ```val3
    /// public point pPick
    ///   if libSave()!=0
    ///     popUpMsg("Points are not saved")
    ///   endIf
    /// ```
    "libSave": Libraries "6.7", blocking;
    modifier () -> num on library;
    modifier (string sPath) -> num on library;
    modifier () -> num;
    modifier (string sPath) -> num;
}
