//! `acos` (3.2.3): returns the angle with this cosine.

use val3_geometry::degrees;

use crate::call::Call;
use crate::declare::instruction;
use crate::fault::{Fault, Result};
use crate::runtime_errors::INVALID_NUMBER;

instruction! {
    /// Returns the angle that has a given cosine.
    ///
    /// - `nValue`: the cosine, -1 to 1.
    /// - Result: angle in degrees, 0 to 180.
    /// - Error 11: `nValue` is outside -1 to 1. A quotient can exceed 1 by a rounding error: `limit` it.
    ///
    /// ## Example
    /// ```val3
    /// num nAngle
    /// num nReach = 40
    ///   nAngle=acos(limit(nReach/80,-1,1))
    /// ```
    "acos": Numbers "3.2.3", errors [11];
    function (num nValue) -> num = acos;
}

fn acos(_: &mut Call<'_>, value: f64) -> Result<f64> {
    degrees::acos(value).ok_or(Fault(INVALID_NUMBER))
}

#[cfg(test)]
mod tests {
    use crate::testing::check;

    #[test]
    fn results() {
        check("acos(0.5)", "60");
        check("acos(-1)", "180");
        check("acos(1.0000001)", "error 11");
        check("acos(-1.0000001)", "error 11");
    }
}
