//! `min` (3.2.3): returns the smaller of two numbers.

use crate::call::Call;
use crate::declare::instruction;
use crate::values::numbers;

instruction! {
    /// Returns the smaller of two numbers.
    ///
    /// - `nX`, `nY`: any numbers.
    /// - Result: the smaller one.
    ///
    /// ## Example
    /// ```val3
    /// num nSpeed
    /// num nWanted = 120
    ///   nSpeed=min(nWanted,100)
    /// ```
    "min": Numbers "3.2.3";
    function (num nX, num nY) -> num = min;
}

fn min(_: &mut Call<'_>, x: f64, y: f64) -> f64 {
    numbers::min(x, y)
}

#[cfg(test)]
mod tests {
    use crate::testing::check;

    #[test]
    fn results() {
        check("min(-1,10)", "-1");
    }
}
