//! `fromBinary` (3.3.3): decodes numbers from bytes that another device sent.

use crate::call::{Arr, Call};
use crate::declare::instruction;
use crate::fault::Result;
use crate::values::{Text, binary};

instruction! {
    /// Decodes numbers from bytes that another device sent.
    ///
    /// - `nDataByte`: the bytes, each 0 to 255; read only.
    /// - `nDataSize`: the number of bytes to decode, from the first byte on.
    /// - `sDataFormat`: as for `toBinary`: `"-4l"`, `"8.0b"`.
    /// - `nValue`: receives the numbers.
    /// - Result: the number of decoded numbers. If bytes are corrupt, the number decoded before them, with a minus
    ///   sign.
    /// - Error 70: more bytes requested than `nDataByte` contains, an unknown format, or a `nValue` that is too small.
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
    modifier (num& nDataByte[], num nDataSize, string sDataFormat, num& nValue[]) -> num = from_binary;
}

fn from_binary(call: &mut Call<'_>, bytes: Arr<f64>, size: f64, format: Text, values: Arr<f64>) -> Result<f64> {
    let mut decoded = values.all(call)?;
    let count = binary::from_binary(&bytes.all(call)?, size, &format, &mut decoded)?;
    values.set_all(call, decoded)?;
    Ok(count)
}

#[cfg(test)]
mod tests {
    use crate::testing::Bench;

    /// Both programs of the manual: a trsf is sent and received.
    #[test]
    fn a_transformation_comes_back() {
        let mut bench = Bench::default().global("num nTrsfOut[6]; num nByteOut[48]; num nTrsfIn[6]");
        bench.set("nTrsfOut", &[100.5, -50.0, 200.0, 0.1, 0.0, -179.999]);
        assert_eq!(bench.run(r#"toBinary(nTrsfOut,6,"8.0b",nByteOut)"#), "48");
        assert_eq!(bench.run(r#"fromBinary(nByteOut,48,"8.0b",nTrsfIn)"#), "6");
        assert_eq!(bench.show("nTrsfIn"), bench.show("nTrsfOut"));
    }

    #[test]
    fn a_corrupt_byte_ends_the_decoding() {
        let mut bench = Bench::default().global("num nByte[4]; num nValue[4]").with("nByte", &[1.0, 2.0, 256.0, 4.0]);
        assert_eq!(bench.run(r#"fromBinary(nByte,4,"1",nValue)"#), "-2");
        assert_eq!(bench.show("nValue"), "1, 2, 0, 0");
    }

    #[test]
    fn nothing_is_written_where_something_does_not_fit() {
        let mut bench = Bench::default().global("num nByte[4]; num nValue");
        assert_eq!(bench.run(r#"fromBinary(nByte,5,"1",nValue)"#), "error 70");
        assert_eq!(bench.run(r#"fromBinary(nByte,4,"2b",nValue)"#), "error 70");
        assert_eq!(bench.run(r#"fromBinary(nByte,4,"4",nValue)"#), "error 70");
        assert_eq!(bench.run(r#"fromBinary(nByte,4,"4b",nValue)"#), "1");
    }
}
