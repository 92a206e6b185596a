//! `tan` (3.2.3): returns the tangent of an angle.

use val3_geometry::degrees;

use crate::call::Call;
use crate::declare::instruction;

instruction! {
    /// Returns the tangent of an angle.
    ///
    /// - `nAngle`: angle in degrees.
    /// - Result: the tangent; very large near 90 degrees.
    ///
    /// ## Example
    /// ```val3
    /// num nHeight
    /// num nSlope = 12
    ///   nHeight=500*tan(nSlope)
    /// ```
    "tan": Numbers "3.2.3";
    function (num nAngle) -> num = tan;
}

fn tan(_: &mut Call<'_>, angle: f64) -> f64 {
    degrees::tan(angle)
}

#[cfg(test)]
mod tests {
    use crate::testing::check;

    #[test]
    fn results() {
        check("tan(45)", "1");
        check("tan(90)", "1.6331239353195e16");
    }
}
