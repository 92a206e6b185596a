//! `round` (3.2.3): returns the whole number nearest to a number.

use crate::call::Call;
use crate::declare::instruction;
use crate::values::numbers;

instruction! {
    /// Returns the whole number nearest to a number.
    ///
    /// - `nValue`: any number.
    /// - Result: halves are rounded up: `round(7.8)` is 8, `round(0.5)` is 1, `round(-0.5)` is 0.
    ///
    /// The index of an array is rounded in the same way.
    ///
    /// ## Example
    /// ```val3
    /// num nWhole
    /// num nMeasured = 12.7
    ///   nWhole=round(nMeasured)
    /// ```
    "round": Numbers "3.2.3";
    function (num nValue) -> num = round;
}

fn round(_: &mut Call<'_>, value: f64) -> f64 {
    numbers::round(value)
}

#[cfg(test)]
mod tests {
    use crate::testing::check;

    #[test]
    fn results() {
        check("round(7.8)", "8");
        check("round(-7.8)", "-8");
        check("round(0.5)", "1");
        check("round(-0.5)", "0");
    }
}
