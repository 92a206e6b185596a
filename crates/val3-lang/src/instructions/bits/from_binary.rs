use crate::declare::instruction;

instruction! {
    /// Decodes numbers from bytes that another device sent.
    ///
    /// - `nDataByte`: the bytes, each 0 to 255; read only.
    /// - `nDataSize`: how many of them, from the first on.
    /// - `sDataFormat`: as for `toBinary`: `"-4l"`, `"8.0b"`.
    /// - `nValue`: gets the numbers.
    /// - Result: how many numbers were decoded; negative if bytes are corrupt: the count of those decoded before,
    ///   with a minus sign.
    /// - Error 70: more bytes asked for than `nDataByte` has, an unknown format, or too small a `nValue`.
    ///
    /// ## Example
    /// ```val3
    /// num nPose[6]
    /// num nBytes[48]
    ///   if fromBinary(nBytes,48,"8.0b",nPose)!=6
    ///     logMsg("corrupt pose")
    ///   endIf
    /// ```
    "fromBinary": Bits "3.3.3", errors [70];
    modifier (num& nDataByte[], num nDataSize, string sDataFormat, num& nValue[]) -> num;
}
