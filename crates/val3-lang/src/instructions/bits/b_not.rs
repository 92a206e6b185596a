//! `bNot` (3.3.3): inverts every bit of a 32-bit field.

use crate::call::Call;
use crate::declare::instruction;
use crate::values::bits;

instruction! {
    /// Inverts every bit of a 32-bit field.
    ///
    /// - `nBitField`: a whole number from 0 to 4294967295; other numbers are rounded and limited to this range.
    /// - Result: the number with the inverted 32 bits of `nBitField`.
    ///
    /// ## Example
    /// ```val3
    /// num nFlags = 255
    ///   // clear bit 3
    ///   nFlags=bAnd(nFlags,bNot(8))
    /// ```
    "bNot": Bits "3.3.3";
    function (num nBitField) -> num = b_not;
}

fn b_not(_: &mut Call<'_>, field: f64) -> f64 {
    bits::not(field)
}

#[cfg(test)]
mod tests {
    use crate::testing::check;

    #[test]
    fn results() {
        check("bNot(0)", "4294967295");
        check("bNot(255)", "4294967040");
        check("bNot(-1)", "4294967295");
    }
}
