//! `asin` (3.2.3): returns the angle with this sine.

use val3_geometry::degrees;

use crate::call::Call;
use crate::declare::instruction;
use crate::fault::{Fault, Result};
use crate::runtime_errors::INVALID_NUMBER;

instruction! {
    /// Returns the angle that has a given sine.
    ///
    /// - `nValue`: the sine, -1 to 1.
    /// - Result: angle in degrees, -90 to 90.
    /// - Error 11: `nValue` is outside -1 to 1. A quotient can exceed 1 by a rounding error: `limit` it.
    ///
    /// ## Example
    /// ```val3
    /// num nAngle
    /// num nHeight = 40
    ///   nAngle=asin(limit(nHeight/80,-1,1))
    /// ```
    "asin": Numbers "3.2.3", errors [11];
    function (num nValue) -> num = asin;
}

fn asin(_: &mut Call<'_>, value: f64) -> Result<f64> {
    degrees::asin(value).ok_or(Fault(INVALID_NUMBER))
}

#[cfg(test)]
mod tests {
    use crate::testing::check;

    #[test]
    fn results() {
        check("asin(0.5)", "30");
        check("asin(-1)", "-90");
        check("asin(1.0000001)", "error 11");
        check("asin(-1.0000001)", "error 11");
    }
}
