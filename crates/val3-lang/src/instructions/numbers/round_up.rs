//! `roundUp` (3.2.3): returns the smallest whole number that is at least a number.

use crate::call::Call;
use crate::declare::instruction;
use crate::values::numbers;

instruction! {
    /// Returns the smallest whole number that is not below a number.
    ///
    /// - `nValue`: any number.
    /// - Result: `roundUp(7.8)` is 8, `roundUp(-7.8)` is -7.
    ///
    /// ## Example
    /// ```val3
    /// num nLayers
    /// num nParts = 25
    ///   nLayers=roundUp(nParts/12)
    /// ```
    "roundUp": Numbers "3.2.3";
    function (num nValue) -> num = round_up;
}

fn round_up(_: &mut Call<'_>, value: f64) -> f64 {
    numbers::round_up(value)
}

#[cfg(test)]
mod tests {
    use crate::testing::check;

    #[test]
    fn results() {
        check("roundUp(7.8)", "8");
        check("roundUp(-7.8)", "-7");
    }
}
