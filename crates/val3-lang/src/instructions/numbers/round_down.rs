//! `roundDown` (3.2.3): returns the largest whole number that is at most a number.

use crate::call::Call;
use crate::declare::instruction;
use crate::values::numbers;

instruction! {
    /// Returns the largest whole number that is not above a number.
    ///
    /// - `nValue`: any number.
    /// - Result: `roundDown(7.8)` is 7, `roundDown(-7.8)` is -8.
    ///
    /// ## Example
    /// ```val3
    /// num nRow
    /// num nPart = 25
    ///   nRow=roundDown(nPart/12)
    /// ```
    "roundDown": Numbers "3.2.3";
    function (num nValue) -> num = round_down;
}

fn round_down(_: &mut Call<'_>, value: f64) -> f64 {
    numbers::round_down(value)
}

#[cfg(test)]
mod tests {
    use crate::testing::check;

    #[test]
    fn results() {
        check("roundDown(7.8)", "7");
        check("roundDown(-7.8)", "-8");
    }
}
