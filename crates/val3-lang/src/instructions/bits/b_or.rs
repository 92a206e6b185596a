use crate::declare::instruction;

instruction! {
    /// Gives the bits that are set in at least one of two 32-bit fields.
    ///
    /// - `nBitField1`, `nBitField2`: whole numbers from 0 to 4294967295; others are rounded into that range.
    /// - Result: the number with all these bits.
    ///
    /// ## Example
    /// ```val3
    /// num nFlags = 8
    ///   // set bit 2
    ///   nFlags=bOr(nFlags,4)
    /// ```
    "bOr": Bits "3.3.3";
    function (num nBitField1, num nBitField2) -> num;
}
