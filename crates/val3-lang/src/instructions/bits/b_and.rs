//! `bAnd` (3.3.3): returns the bits that are set in both 32-bit fields.

use crate::call::Call;
use crate::declare::instruction;
use crate::values::bits;

instruction! {
    /// Returns the bits that are set in both of two 32-bit fields.
    ///
    /// - `nBitField1`, `nBitField2`: whole numbers from 0 to 4294967295; other numbers are rounded and limited to this
    ///   range.
    /// - Result: the number with the common bits.
    ///
    /// ## Example
    /// ```val3
    /// num nFlags = 12
    ///   if bAnd(nFlags,4)!=0
    ///     putln("bit 2 is set")
    ///   endIf
    /// ```
    "bAnd": Bits "3.3.3";
    function (num nBitField1, num nBitField2) -> num = b_and;
}

fn b_and(_: &mut Call<'_>, left: f64, right: f64) -> f64 {
    bits::and(left, right)
}

#[cfg(test)]
mod tests {
    use crate::testing::check;

    #[test]
    fn results() {
        check("bAnd(12,10)", "8");
        check("bAnd(2147483648,4294967295)", "2147483648");
        check("bAnd(2.5,255)", "3");
    }
}
