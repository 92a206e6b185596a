//! `bOr` (3.3.3): returns the bits that are set in at least one of two 32-bit fields.

use crate::call::Call;
use crate::declare::instruction;
use crate::values::bits;

instruction! {
    /// Returns the bits that are set in at least one of two 32-bit fields.
    ///
    /// - `nBitField1`, `nBitField2`: whole numbers from 0 to 4294967295; other numbers are rounded and limited to this
    ///   range.
    /// - Result: the number with all these bits.
    ///
    /// ## Example
    /// ```val3
    /// num nFlags = 8
    ///   // set bit 2
    ///   nFlags=bOr(nFlags,4)
    /// ```
    "bOr": Bits "3.3.3";
    function (num nBitField1, num nBitField2) -> num = b_or;
}

fn b_or(_: &mut Call<'_>, left: f64, right: f64) -> f64 {
    bits::or(left, right)
}

#[cfg(test)]
mod tests {
    use crate::testing::check;

    #[test]
    fn results() {
        check("bOr(12,10)", "14");
        check("bOr(0,1e12)", "4294967295");
    }
}
