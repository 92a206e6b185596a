//! `sin` (3.2.3): returns the sine of an angle.

use val3_geometry::degrees;

use crate::call::Call;
use crate::declare::instruction;

instruction! {
    /// Returns the sine of an angle.
    ///
    /// - `nAngle`: angle in degrees.
    /// - Result: -1 to 1.
    ///
    /// ## Example
    /// ```val3
    /// num nHeight
    /// num nAngle = 30
    ///   nHeight=200*sin(nAngle)
    /// ```
    "sin": Numbers "3.2.3";
    function (num nAngle) -> num = sin;
}

fn sin(_: &mut Call<'_>, angle: f64) -> f64 {
    degrees::sin(angle)
}

#[cfg(test)]
mod tests {
    use crate::testing::check;

    #[test]
    fn results() {
        check("sin(30)", "0.5");
        check("sin(-450)", "-1");
    }
}
