//! `cos` (3.2.3): returns the cosine of an angle.

use val3_geometry::degrees;

use crate::call::Call;
use crate::declare::instruction;

instruction! {
    /// Returns the cosine of an angle.
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
    function (num nAngle) -> num = cos;
}

fn cos(_: &mut Call<'_>, angle: f64) -> f64 {
    degrees::cos(angle)
}

#[cfg(test)]
mod tests {
    use crate::testing::check;

    #[test]
    fn results() {
        check("cos(60)", "0.5");
        check("cos(180)", "-1");
    }
}
