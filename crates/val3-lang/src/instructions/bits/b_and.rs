use crate::declare::instruction;

instruction! {
    /// Gives the bits that are set in both of two 32-bit fields.
    ///
    /// - `nBitField1`, `nBitField2`: whole numbers from 0 to 4294967295; others are rounded into that range.
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
    function (num nBitField1, num nBitField2) -> num;
}
