//! `atan` (3.2.3): returns the angle with this tangent.

use val3_geometry::degrees;

use crate::call::Call;
use crate::declare::instruction;

instruction! {
    /// Returns the angle that has a given tangent.
    ///
    /// - `nValue`: the tangent, any number.
    /// - Result: angle in degrees, -90 to 90.
    ///
    /// There is no form with two arguments: for a full circle, add 180 degrees if the x side is negative.
    ///
    /// ## Example
    /// ```val3
    /// num nAngle
    /// trsf trSide
    ///   if trSide.x!=0
    ///     nAngle=atan(trSide.y/trSide.x)
    ///   endIf
    /// ```
    "atan": Numbers "3.2.3";
    function (num nValue) -> num = atan;
}

fn atan(_: &mut Call<'_>, value: f64) -> f64 {
    degrees::atan(value)
}

#[cfg(test)]
mod tests {
    use crate::testing::check;

    #[test]
    fn results() {
        check("atan(1)", "45");
        check("atan(-1e300)", "-90");
    }
}
