//! `toNum` (3.4.3): parses the number at the start of a string, and returns the remaining string.

use crate::call::{Call, Var};
use crate::declare::instruction;
use crate::fault::Result;
use crate::values::Text;
use crate::values::number_reading::{self, NumberReading};

instruction! {
    /// Parses the number at the start of a string, and returns the remaining string.
    ///
    /// - `sString`: the string.
    /// - `nValue`: receives the number; unchanged if the string does not start with a number.
    /// - `bReport`: receives `true` if the string starts with a number, otherwise `false`.
    /// - Result: the string from the next number on, `""` if none follows; the whole string if it does not start with a
    ///   number.
    ///
    /// ## Example
    /// ```val3
    /// string sBuffer = "+90 0.0 -7.6"
    /// num nValue
    /// bool bOk
    ///   do
    ///     sBuffer=toNum(sBuffer,nValue,bOk)
    ///     if bOk
    ///       putln(nValue)
    ///     endIf
    ///   until sBuffer=="" or bOk==false
    /// ```
    "toNum": Strings "3.4.3";
    modifier (string sString, num& nValue, bool& bReport) -> string = to_num;
}

fn to_num(call: &mut Call<'_>, text: Text, value: Var<f64>, report: Var<bool>) -> Result<Text> {
    let NumberReading { value: found, rest } = number_reading::to_num(&text);
    report.set(call, found.is_some())?;
    if let Some(found) = found {
        value.set(call, found)?;
    }
    Ok(rest)
}

#[cfg(test)]
mod tests {
    use crate::testing::Bench;

    #[track_caller]
    fn check(text: &str, rest: &str, value: &str, report: &str) {
        let mut bench = Bench::default().global("num nVal; bool bOk").with("nVal", &[5.0]);
        assert_eq!(bench.run(&format!("toNum(\"{text}\",nVal,bOk)")), format!("\"{rest}\""));
        assert_eq!([bench.show("nVal"), bench.show("bOk")], [value, report]);
    }

    #[test]
    fn the_examples_of_the_manual() {
        check("10 20 30", "20 30", "10", "true");
        check("a10 20 30", "a10 20 30", "5", "false");
        check("10 end", "", "10", "true");
    }

    #[test]
    fn reads_number_by_number() {
        let bench = Bench::default().global("string sBuffer; num nVal; bool bOk");
        let mut bench = bench.with_texts("sBuffer", &["+90 0.0 -7.6 17.3"]);
        let values = [(); 4].map(|()| {
            bench.run("sBuffer=toNum(sBuffer,nVal,bOk)");
            bench.show("nVal")
        });
        assert_eq!(values, ["90", "0", "-7.6", "17.3"]);
        assert_eq!([bench.show("sBuffer"), bench.show("bOk")], ["\"\"", "true"]);
    }
}
