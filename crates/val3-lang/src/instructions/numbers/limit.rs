//! `limit` (3.2.3): limits a number to a range.

use crate::call::Call;
use crate::declare::instruction;
use crate::values::numbers;

instruction! {
    /// Limits a number to a range.
    ///
    /// - `nValue`: any number.
    /// - `nMin`, `nMax`: the bounds.
    /// - Result: `nValue`, or the bound that it exceeds.
    ///
    /// ## Example
    /// ```val3
    /// num nSpeed
    /// num nWanted = 140
    ///   nSpeed=limit(nWanted,1,100)
    /// ```
    "limit": Numbers "3.2.3";
    function (num nValue, num nMin, num nMax) -> num = limit;
}

fn limit(_: &mut Call<'_>, value: f64, min: f64, max: f64) -> f64 {
    numbers::limit(value, min, max)
}

#[cfg(test)]
mod tests {
    use crate::testing::check;

    #[test]
    fn results() {
        check("limit(30,-90,90)", "30");
        check("limit(100,-90,90)", "90");
        check("limit(-100,-90,90)", "-90");
    }
}
