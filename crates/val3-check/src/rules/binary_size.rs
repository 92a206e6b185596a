//! V0241: an array too small for `toBinary` or `fromBinary`.

use val3_analysis::body::ExprId;
use val3_lang::arguments::bytes;
use val3_lang::instructions::{FROM_BINARY, TO_BINARY};
use val3_lang::runtime_errors::INVALID_PARAMETER;
use val3_lang::values::printed::num;

use crate::diagnostic::Wording;
use crate::english::count;
use crate::lint::{Findings, ProgramView};
use crate::phrase::runtime_error;
use crate::rule::rule;

rule! {
    /// `toBinary` or `fromBinary` needs a larger array.
    ///
    /// ## Why
    /// Both instructions check the sizes first. If the source array has fewer values than requested, or the target
    /// array is too small for the result, they raise run-time error 70 (3.3.3). The format sets the number of bytes for
    /// each value: `8.0b` needs eight. From s8 on, `toBinary` encodes the values that exist, so a source array that is
    /// too small is not reported there.
    ///
    /// ## Bad
    /// ```val3
    /// num nPose[6]
    /// num nBytes[24]
    ///
    /// toBinary(nPose,6,"8.0b",nBytes)
    /// ```
    ///
    /// ## Good
    /// ```val3
    /// num nPose[6]
    /// num nBytes[48]
    ///
    /// toBinary(nPose,6,"8.0b",nBytes)
    /// ```
    V0241 "binary-size" Error, Program: check
}

fn check(program: &ProgramView<'_>, found: &mut Findings) {
    for (instruction, encodes) in [(TO_BINARY, true), (FROM_BINARY, false)] {
        for call in program.calls_of(instruction) {
            let [source, number, format, target] = *call.args else { continue };
            let Some(number) = program.body.number(number).filter(|number| *number > 0.0) else { continue };
            let Some(bytes) = program.body.string(format).and_then(|format| bytes(&format)).map(f64::from) else {
                continue;
            };
            let number = if encodes && program.items.version.encodes_what_exists() {
                let Some(size) = program.certain_size(source) else { continue };
                number.min(f64::from(size))
            } else {
                check_array(program, source, number, encodes.then_some(bytes), found);
                number
            };
            let results = if encodes { number * bytes } else { (number / bytes).floor() };
            check_array(program, target, results, None, found);
        }
    }
}

/// Checks an array's size. `bytes` is the size of a value, if the number counts values but is often mistaken for a
/// number of bytes.
fn check_array(program: &ProgramView<'_>, array: ExprId, needed: f64, bytes: Option<f64>, found: &mut Findings) {
    let Some(size) = program.certain_size(array).filter(|size| f64::from(*size) < needed) else { return };
    let counts_bytes = bytes.is_some_and(|bytes| needed == bytes * f64::from(size));
    found
        .report(&RULE, program.range(array), word(program.text(array), size, needed, counts_bytes))
        .related_at(program.declaration(array), "declared here");
}

fn word(array: &str, size: u32, needed: f64, counts_bytes: bool) -> Wording {
    let help = if counts_bytes { "the number counts values, not bytes" } else { "" };
    Wording::new(
        format!("`{array}` has {}, but {} are needed", count(size as usize, "value"), num(needed)),
        runtime_error(INVALID_PARAMETER),
        help,
    )
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::*;
    use crate::lint::testing::{check, levels};
    use crate::rule::Severity;

    #[test]
    fn arrays_that_are_too_small_are_reported() {
        expect![[r#"
            start.pgx:5 `nB` `nB` has 8 values, but 16 are needed
              | run-time error 70: invalid parameter
              > main.dtx:5 `nB` declared here
            start.pgx:6 `nB[7]` `nB[7]` has 1 value, but 2 are needed
              | run-time error 70: invalid parameter
              ? the number counts values, not bytes
              > main.dtx:5 `nB` declared here
            start.pgx:7 `nA` `nA` has 6 values, but 7 are needed
              | run-time error 70: invalid parameter
              > main.dtx:4 `nA` declared here
            start.pgx:8 `nB[2]` `nB[2]` has 6 values, but 7 are needed
              | run-time error 70: invalid parameter
              > main.dtx:5 `nB` declared here
            start.pgx:8 `nA` `nA` has 6 values, but 7 are needed
              | run-time error 70: invalid parameter
              > main.dtx:4 `nA` declared here
            start.pgx:9 `nA[5]` `nA[5]` has 1 value, but 2 are needed
              | run-time error 70: invalid parameter
              > main.dtx:4 `nA` declared here
        "#]]
        .assert_eq(&check(
            &RULE,
            "num nA[6]\nnum nB[8]\ntoBinary(nA,2,\"8.0b\",nB)\ntoBinary(nB[7],2,\"2l\",nB)\ntoBinary(nA,7,\"1\",nB)\n\
             fromBinary(nB[2],7,\"1\",nA)\nfromBinary(nB,8,\"4l\",nA[5])",
        ));
    }

    #[test]
    fn certain_sizes_are_errors() {
        let listing = "num nA[6]\nnum nB[8]\ntoBinary(nA,2,\"8.0b\",nB)\nfromBinary(nB,9,\"1\",nA)";
        assert_eq!(levels(&RULE, listing), [Severity::Error; 3]);
    }

    #[test]
    fn a_call_after_a_test_of_the_size_is_not_reported() {
        let listing =
            |condition: &str| format!("num nA[6]\nnum nB[8]\nnum n\nif {condition}\ntoBinary(nA,2,\"8.0b\",nB)\nendIf");
        assert_eq!(check(&RULE, &listing("size(nB)>=2*n")), "");
        assert_eq!(check(&RULE, &listing("size(nB)>=16")), "");
        assert_eq!(levels(&RULE, &listing("size(nA)>=n")), [Severity::Error]);
        assert_eq!(levels(&RULE, &listing("size(nB)>=8")), [Severity::Error]);
    }

    #[test]
    fn to_binary_encodes_what_exists_from_s8_on() {
        let listing = |version: &str| format!("version {version}\nnum nA\nnum nB[4]\ntoBinary(nA,2,\"2l\",nB)");
        assert_eq!(levels(&RULE, &listing("s7.11")), [Severity::Error]);
        assert_eq!(check(&RULE, &listing("s8.10")), "");
        assert_eq!(check(&RULE, &listing("s7.0.1Cs9")), "");
        let small = "version s8.10\nnum nA\nnum nB[4]\ntoBinary(nA,2,\"8.0l\",nB)";
        assert_eq!(levels(&RULE, small), [Severity::Error]);
    }

    #[test]
    fn large_enough_and_unknown_sizes_are_not_reported() {
        assert_eq!(
            check(
                &RULE,
                "num nA[6]\nnum nB[8]\nnum nC[1]\nnum n\npublic num nD[1]\ntoBinary(nA,1,\"8.0b\",nB)\ntoBinary(nA,n,\"1\",nB)\n\
                 fromBinary(nB,8,\"4l\",nA[4])\nresize(nC,1,n)\nfromBinary(nC,8,\"1\",nB)\ntoBinary(nA,6,\"1\",nD)"
            ),
            ""
        );
    }
}
