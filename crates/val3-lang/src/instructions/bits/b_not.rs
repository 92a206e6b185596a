use crate::declare::instruction;

instruction! {
    /// Inverts every bit of a 32-bit field.
    ///
    /// - `nBitField`: a whole number from 0 to 4294967295; others are rounded into that range.
    /// - Result: the number whose bits are the contrary of the 32 bits of `nBitField`.
    ///
    /// ## Example
    /// ```val3
    /// num nFlags = 255
    ///   // clear bit 3
    ///   nFlags=bAnd(nFlags,bNot(8))
    /// ```
    "bNot": Bits "3.3.3";
    function (num nBitField) -> num;
}
