//! `exp` (3.2.3): returns the power of e, the base of the natural logarithm.

use crate::call::Call;
use crate::declare::instruction;
use crate::fault::Result;
use crate::values::numbers;

instruction! {
    /// Returns a power of e, the base of the natural logarithm.
    ///
    /// - `nValue`: the exponent.
    /// - Result: e to the power of `nValue`.
    /// - Error 11: the result is too large for a number.
    ///
    /// ## Example
    /// ```val3
    /// num nGain
    /// num nSeconds = 2
    ///   nGain=1-exp(-nSeconds/5)
    /// ```
    "exp": Numbers "3.2.3", errors [11];
    function (num nValue) -> num = exp;
}

fn exp(_: &mut Call<'_>, value: f64) -> Result<f64> {
    numbers::exp(value)
}

#[cfg(test)]
mod tests {
    use crate::testing::check;

    #[test]
    fn results() {
        check("exp(1)", "2.718281828459");
        check("exp(709)", "8.218407461555e307");
        check("exp(710)", "error 11");
    }
}
