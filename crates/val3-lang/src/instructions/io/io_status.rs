use crate::declare::instruction;

instruction! {
    /// Tells whether an input or output works.
    ///
    /// - `diInputOutput`, `aiInputOutput`: the signal.
    /// - `sDescription`: gets the free text that describes it.
    /// - `sPhysicalPath`: gets what it is linked to, as a rule `device\module\address`.
    /// - Result: 0 it works, 1 it is held at a value by the operator, 2 it is simulated in software, -1 no link,
    ///   -2 no such device or signal, -3 its device has failed.
    ///
    /// It never raises an error, so it can be asked before the signal is used.
    ///
    /// ## Example
    /// ```val3
    /// dio diGripped
    /// string sText
    /// string sPath
    ///   if ioStatus(diGripped,sText,sPath)<0
    ///     logMsg(sPath+" failed: "+sText)
    ///   endIf
    /// ```
    "ioStatus": Io "3.5.3, 3.6.2";
    function (dio diInputOutput) -> num;
    modifier (dio diInputOutput, string& sDescription, string& sPhysicalPath) -> num;
    function (aio aiInputOutput) -> num;
    modifier (aio aiInputOutput, string& sDescription, string& sPhysicalPath) -> num;
}
