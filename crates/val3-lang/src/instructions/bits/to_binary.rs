//! `toBinary` (3.3.3): encodes numbers as bytes, to send them to another device.

use crate::call::{Arr, Call};
use crate::declare::instruction;
use crate::fault::Result;
use crate::values::{Text, binary};

instruction! {
    /// Encodes numbers as bytes, to send them to another device.
    ///
    /// - `nValue`: the numbers; read only.
    /// - `nValueSize`: how many numbers to encode, from the first one on.
    /// - `sDataFormat`: sign, bytes per number, and byte order: `"1"`, `"-1"` one byte; `"2"`, `"4"` bytes, `"-"`
    ///   before them for signed numbers; `"4.0"`, `"8.0"` floating point; then `"l"` for the low byte first, `"b"` for
    ///   the high byte first (as networks do). Example: `"-4l"`, `"8.0b"`.
    /// - `nDataByte`: receives the bytes, each 0 to 255.
    /// - Result: the number of bytes.
    /// - Error 70: an unknown format, a `nDataByte` that is too small, or (up to s7) more numbers requested than
    ///   `nValue` contains. From s8 on, only the existing numbers are encoded.
    ///
    /// Only `"8.0l"` and `"8.0b"` preserve every digit of a number.
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
    modifier (num& nValue[], num nValueSize, string sDataFormat, num& nDataByte[]) -> num = to_binary;
}

fn to_binary(call: &mut Call<'_>, values: Arr<f64>, size: f64, format: Text, bytes: Arr<f64>) -> Result<f64> {
    let mut encoded = bytes.all(call)?;
    let values = values.all(call)?;
    let size = if call.version.encodes_what_exists() { size.min(values.len() as f64) } else { size };
    let count = binary::to_binary(&values, size, &format, &mut encoded)?;
    bytes.set_all(call, encoded)?;
    Ok(count)
}

#[cfg(test)]
mod tests {
    use crate::testing::Bench;
    use crate::versions::Version;

    #[test]
    fn bytes_come_to_the_start_of_the_array() {
        let mut bench = Bench::default().global("num nValue[3]; num nByte[6]").with("nValue", &[1.0, -2.0, 258.0]);
        bench.set("nByte", &[9.0; 6]);
        assert_eq!(bench.run(r#"toBinary(nValue,2,"-2b",nByte)"#), "4");
        assert_eq!(bench.show("nByte"), "0, 1, 255, 254, 9, 9");
        assert_eq!(bench.run(r#"toBinary(nValue[2],1,"2l",nByte[4])"#), "2");
        assert_eq!(bench.show("nByte"), "0, 1, 255, 254, 2, 1");
    }

    #[test]
    fn nothing_is_written_where_something_does_not_fit() {
        let mut bench = Bench::default().global("num nValue[3]; num nByte[6]");
        assert_eq!(bench.run(r#"toBinary(nValue,4,"1",nByte)"#), "error 70");
        assert_eq!(bench.run(r#"toBinary(nValue,3,"3b",nByte)"#), "error 70");
        assert_eq!(bench.run(r#"toBinary(nValue,2,"4b",nByte)"#), "error 70");
        assert_eq!(bench.run(r#"toBinary(nValue,3,"2b",nByte)"#), "6");
    }

    #[test]
    fn from_s8_on_the_numbers_that_exist_are_encoded() {
        let mut bench = Bench::default().global("num nValue; num nByte[6]").with("nValue", &[258.0]);
        bench.version = Version::new(8, 10, 0);
        assert_eq!(bench.run(r#"toBinary(nValue,2,"2l",nByte)"#), "2");
        assert_eq!(bench.show("nByte"), "2, 1, 0, 0, 0, 0");
        assert_eq!(bench.run(r#"toBinary(nValue,-1,"2l",nByte)"#), "error 70");
        assert_eq!(bench.run(r#"toBinary(nValue,2,"8.0l",nByte)"#), "error 70");
    }
}
