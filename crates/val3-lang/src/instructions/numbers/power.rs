//! `power` (3.2.3): returns a number raised to a power.

use crate::call::Call;
use crate::declare::instruction;
use crate::fault::Result;
use crate::values::numbers;

instruction! {
    /// Returns a number raised to a power.
    ///
    /// - `nX`: the base, above 0; (s8) also 0 with a positive exponent, and a negative number with a whole one.
    /// - `nY`: the exponent, any number.
    /// - Result: `nX` to the power of `nY`.
    /// - Error 11: any other `nX` that is 0 or negative, or the result is too large.
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

fn power(call: &mut Call<'_>, x: f64, y: f64) -> Result<f64> {
    if call.version.raises_negative_numbers() { numbers::signed_power(x, y) } else { numbers::power(x, y) }
}

#[cfg(test)]
mod tests {
    use crate::testing::{Bench, check};
    use crate::versions::Version;

    #[test]
    fn results() {
        check("power(5,7)", "78125");
        check("power(2,-1)", "0.5");
        check("power(0,2)", "error 11");
        check("power(-2,2)", "error 11");
        check("power(10,309)", "error 11");
    }

    #[test]
    fn from_s8_on_the_exponent_of_a_negative_base_is_whole() {
        let mut bench = Bench::default();
        bench.version = Version::new(8, 0, 0);
        for (call, expected) in [
            ("power(-2,2)", "4"),
            ("power(-2,3)", "-8"),
            ("power(-2,-1)", "-0.5"),
            ("power(-2,0)", "1"),
            ("power(-2,0.5)", "error 11"),
            ("power(-10,309)", "error 11"),
            ("power(0,2)", "0"),
            ("power(0,0.5)", "0"),
            ("power(0,0)", "error 11"),
            ("power(0,-1)", "error 11"),
            ("power(5,7)", "78125"),
            ("power(4,0.5)", "2"),
        ] {
            assert_eq!(bench.run(call), expected, "{call}");
        }
    }
}
