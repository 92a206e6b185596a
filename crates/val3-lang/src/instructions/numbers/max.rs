//! `max` (3.2.3): returns the larger of two numbers.

use crate::call::Call;
use crate::declare::instruction;
use crate::values::numbers;

instruction! {
    /// Returns the larger of two numbers.
    ///
    /// - `nX`, `nY`: any numbers.
    /// - Result: the larger one.
    ///
    /// ## Example
    /// ```val3
    /// num nLeft
    /// num nDone = 7
    ///   nLeft=max(0,10-nDone)
    /// ```
    "max": Numbers "3.2.3";
    function (num nX, num nY) -> num = max;
}

fn max(_: &mut Call<'_>, x: f64, y: f64) -> f64 {
    numbers::max(x, y)
}

#[cfg(test)]
mod tests {
    use crate::testing::check;

    #[test]
    fn results() {
        check("max(-1,10)", "10");
    }
}
