use crate::declare::instruction;

instruction! {
    /// Gives the time since the controller was started.
    ///
    /// - Result: seconds, with a resolution of a millisecond. It has nothing to do with the time of day.
    ///
    /// ## Example
    /// ```val3
    /// num nStart
    ///   nStart=clock()
    ///   waitEndMove()
    ///   putln(clock()-nStart)
    /// ```
    "clock": Tasks "5.10";
    function () -> num;
}
