//! `log` (3.2.3): returns the decimal logarithm of a number.

use crate::call::Call;
use crate::declare::instruction;
use crate::fault::Result;
use crate::values::numbers;

instruction! {
    /// Returns the decimal logarithm of a number.
    ///
    /// - `nValue`: above 0.
    /// - Result: the logarithm to the base 10.
    /// - Error 11: `nValue` is 0 or negative.
    ///
    /// ## Example
    /// ```val3
    /// num nDigits
    /// num nCount = 4711
    ///   nDigits=roundDown(log(nCount))+1
    /// ```
    "log": Numbers "3.2.3", errors [11];
    function (num nValue) -> num = log;
}

fn log(_: &mut Call<'_>, value: f64) -> Result<f64> {
    numbers::log(value)
}

#[cfg(test)]
mod tests {
    use crate::testing::check;

    #[test]
    fn results() {
        check("log(1000)", "3");
        check("log(0)", "error 11");
        check("log(-1)", "error 11");
    }
}
