//! `sqrt` (3.2.3): returns the square root of a number.

use crate::call::Call;
use crate::declare::instruction;
use crate::fault::Result;
use crate::values::numbers;

instruction! {
    /// Returns the square root of a number.
    ///
    /// - `nValue`: 0 or more.
    /// - Result: the root.
    /// - Error 11: `nValue` is negative.
    ///
    /// ## Example
    /// ```val3
    /// num nDistance
    /// trsf trGap
    ///   nDistance=sqrt(trGap.x*trGap.x+trGap.y*trGap.y)
    /// ```
    "sqrt": Numbers "3.2.3", errors [11];
    function (num nValue) -> num = sqrt;
}

fn sqrt(_: &mut Call<'_>, value: f64) -> Result<f64> {
    numbers::sqrt(value)
}

#[cfg(test)]
mod tests {
    use crate::testing::check;

    #[test]
    fn results() {
        check("sqrt(9)", "3");
        check("sqrt(0)", "0");
        check("sqrt(-0.001)", "error 11");
    }
}
