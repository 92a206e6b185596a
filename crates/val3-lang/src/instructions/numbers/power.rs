use crate::call::Call;
use crate::declare::instruction;
use crate::fault::Result;
use crate::values::numbers;

instruction! {
    /// Gives a number raised to a power.
    ///
    /// - `nX`: the base, above 0.
    /// - `nY`: the exponent, any number.
    /// - Result: `nX` to the power of `nY`.
    /// - Error 11: `nX` is 0 or negative, or the result is too large.
    ///
    /// ## Example
    /// ```val3
    /// num nMask
    /// num nBit = 5
    ///   nMask=power(2,nBit)
    /// ```
    "power": Numbers "3.2.3", errors [11];
    function (num nX, num nY) -> num = power;
}

fn power(_: &mut Call<'_>, x: f64, y: f64) -> Result<f64> {
    numbers::power(x, y)
}

#[cfg(test)]
mod tests {
    use crate::testing::check;

    #[test]
    fn results() {
        check("power(5,7)", "78125");
        check("power(2,-1)", "0.5");
        check("power(0,2)", "error 11");
        check("power(-2,2)", "error 11");
        check("power(10,309)", "error 11");
    }
}
