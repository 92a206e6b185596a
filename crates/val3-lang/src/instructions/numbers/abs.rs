use crate::declare::instruction;

instruction! {
    /// Gives the absolute value of a number, or of each axis of a joint position.
    ///
    /// - `nValue`, `jPosition`: what may be negative.
    /// - Result: the same without signs. Of a joint position, degrees and millimetres (inches) as they were.
    ///
    /// `abs(jA-jB)<jTolerance` tells whether every axis is closer than its tolerance.
    ///
    /// ## Example
    /// ```val3
    /// joint jPark
    /// joint jTolerance
    ///   jTolerance={2,2,2,5,5,5}
    ///   if abs(herej()-jPark)<jTolerance
    ///     putln("in park position")
    ///   endIf
    /// ```
    "abs": Numbers "3.2.3, 9.2.3";
    function (num nValue) -> num;
    function (joint jPosition) -> joint;
}
