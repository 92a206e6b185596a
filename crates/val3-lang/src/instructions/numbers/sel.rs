//! `sel` (3.2.3): returns one of two numbers, depending on a condition.

use crate::call::Call;
use crate::declare::instruction;
use crate::values::numbers;

instruction! {
    /// Returns one of two numbers, depending on a condition.
    ///
    /// - `bCondition`: the condition.
    /// - `nValue1`, `nValue2`: the numbers for `true` and for `false`. Both are computed in any case.
    /// - Result: the selected number.
    ///
    /// ## Example
    /// ```val3
    /// bool bFragile
    /// num nSpeed
    ///   nSpeed=sel(bFragile,20,100)
    /// ```
    "sel": Numbers "3.2.3";
    function (bool bCondition, num nValue1, num nValue2) -> num = sel;
}

fn sel(_: &mut Call<'_>, condition: bool, if_true: f64, if_false: f64) -> f64 {
    numbers::sel(condition, if_true, if_false)
}

#[cfg(test)]
mod tests {
    use crate::testing::check;

    #[test]
    fn results() {
        check("sel(true,-90,90)", "-90");
        check("sel(false,-90,90)", "90");
    }
}
