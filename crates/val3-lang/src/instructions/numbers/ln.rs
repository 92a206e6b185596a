//! `ln` (3.2.3): returns the natural logarithm of a number.

use crate::call::Call;
use crate::declare::instruction;
use crate::fault::Result;
use crate::values::numbers;

instruction! {
    /// Returns the natural logarithm of a number.
    ///
    /// - `nValue`: above 0.
    /// - Result: the logarithm to the base e.
    /// - Error 11: `nValue` is 0 or negative.
    ///
    /// ## Example
    /// ```val3
    /// num nTime
    /// num nLevel = 0.5
    ///   nTime=-5*ln(nLevel)
    /// ```
    "ln": Numbers "3.2.3", errors [11];
    function (num nValue) -> num = ln;
}

fn ln(_: &mut Call<'_>, value: f64) -> Result<f64> {
    numbers::ln(value)
}

#[cfg(test)]
mod tests {
    use crate::testing::check;

    #[test]
    fn results() {
        check("ln(2.718281828)", "0.99999999983113");
        check("ln(0)", "error 11");
        check("ln(-1)", "error 11");
    }
}
