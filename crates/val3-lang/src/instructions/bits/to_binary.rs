use crate::declare::instruction;

instruction! {
    /// Encodes numbers as bytes, to send them to another device.
    ///
    /// - `nValue`: the numbers; read only.
    /// - `nValueSize`: how many of them, from the first on.
    /// - `sDataFormat`: sign, bytes a number, and their order: `"1"`, `"-1"` one byte; `"2"`, `"4"` bytes, `"-"` before
    ///   them for signed; `"4.0"`, `"8.0"` floating point; then `"l"` for the low byte first, `"b"` for the high byte
    ///   first (as networks do). Example: `"-4l"`, `"8.0b"`.
    /// - `nDataByte`: gets the bytes, each 0 to 255.
    /// - Result: the number of bytes.
    /// - Error 70: more numbers asked for than `nValue` has, an unknown format, or too small a `nDataByte`.
    ///
    /// Only `"8.0l"` and `"8.0b"` keep every digit of a number.
    ///
    /// ## Example
    /// ```val3
    /// num nPose[6]
    /// num nBytes[48]
    /// sio sHost
    ///   toBinary(nPose,6,"8.0b",nBytes)
    ///   sioSet(sHost,nBytes)
    /// ```
    "toBinary": Bits "3.3.3", errors [70];
    modifier (num& nValue[], num nValueSize, string sDataFormat, num& nDataByte[]) -> num;
}
