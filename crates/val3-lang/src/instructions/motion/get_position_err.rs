use crate::declare::instruction;

instruction! {
    /// Gives how far each axis is from where it should be.
    ///
    /// - Result: the difference between commanded and measured position, degrees or millimetres (inches).
    ///
    /// ## Example
    /// ```val3
    /// joint jError
    ///   jError=getPositionErr()
    ///   if abs(jError.j1)>0.5
    ///     logMsg("axis 1 lags behind")
    ///   endIf
    /// ```
    "getPositionErr": Motion "10.6";
    function () -> joint;
}
