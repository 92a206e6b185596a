use crate::declare::instruction;

instruction! {
    /// Tells whether the safety circuit has a hardware fault that was found and confirmed.
    ///
    /// - `sSignalName`: gets the name of the faulty signal; unchanged without a fault.
    /// - Result: `true` if there is a fault.
    ///
    /// ## Example
    /// ```val3
    /// string sSignal
    ///   if safetyFault(sSignal)
    ///     logMsg("safety fault: "+sSignal)
    ///   endIf
    /// ```
    "safetyFault": Controller "8.1";
    modifier (string& sSignalName) -> bool;
}
