use crate::declare::instruction;

instruction! {
    /// Gives the cosine of an angle.
    ///
    /// - `nAngle`: angle in degrees.
    /// - Result: -1 to 1. Test it with a tolerance: `abs(cos(n))<1e-10`, not `cos(n)==0`.
    ///
    /// ## Example
    /// ```val3
    /// num nReach
    /// num nAngle = 60
    ///   nReach=200*cos(nAngle)
    /// ```
    "cos": Numbers "3.2.3";
    function (num nAngle) -> num;
}
