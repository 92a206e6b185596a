//! `bXor` (3.3.3): returns the bits in which two 32-bit fields differ.

use crate::call::Call;
use crate::declare::instruction;
use crate::values::bits;

instruction! {
    /// Returns the bits in which two 32-bit fields differ.
    ///
    /// - `nBitField1`, `nBitField2`: whole numbers from 0 to 4294967295; other numbers are rounded and limited to this
    ///   range.
    /// - Result: the number with the bits that are set in exactly one of the fields.
    ///
    /// ## Example
    /// ```val3
    /// num nFlags = 12
    ///   // toggle bit 2
    ///   nFlags=bXor(nFlags,4)
    /// ```
    "bXor": Bits "3.3.3";
    function (num nBitField1, num nBitField2) -> num = b_xor;
}

fn b_xor(_: &mut Call<'_>, left: f64, right: f64) -> f64 {
    bits::xor(left, right)
}

#[cfg(test)]
mod tests {
    use crate::testing::check;

    #[test]
    fn results() {
        check("bXor(12,10)", "6");
        check("bXor(165,15)", "170");
    }
}
