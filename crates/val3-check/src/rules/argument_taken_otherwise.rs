//! V0226: a constant argument that the instruction changes or ignores.

use val3_lang::arguments::OutOfRange;

use crate::diagnostic::Wording;
use crate::lint::ranges::out_of_range;
use crate::lint::{Findings, ProgramView};
use crate::rule::rule;

rule! {
    /// A constant argument is out of range, and the instruction silently uses another value or does nothing.
    ///
    /// ## Why
    /// Some instructions raise no error for such a value. `gotoxy` counts columns modulo 40 and lines modulo 14, so
    /// that line 14 is line 0 (4.3). `setMonitorSpeed` changes nothing (8.1). `delay` and `watch` do not wait (5.10).
    /// The program continues with a wrong result.
    ///
    /// ## Bad
    /// ```val3
    /// gotoxy(0,14)
    /// put("last line")
    /// ```
    ///
    /// ## Good
    /// ```val3
    /// gotoxy(0,13)
    /// put("last line")
    /// ```
    V0226 "argument-taken-otherwise" Warning, Program: check
}

fn check(program: &ProgramView<'_>, found: &mut Findings) {
    for fault in out_of_range(program) {
        if let OutOfRange::Instead(what) = fault.range.beyond {
            found.report(&RULE, program.range(fault.argument), Wording::new(fault.message(), what, ""));
        }
    }
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::*;
    use crate::lint::testing::check;

    #[test]
    fn numbers_beyond_their_range_are_reported() {
        expect![[r#"
            start.pgx:5 `40` `gotoxy` takes 0 to 39 for `nX`, not 40
              | the column is taken modulo 40
            start.pgx:6 `-1` `gotoxy` takes 0 to 13 for `nY`, not -1
              | the line is taken modulo 14
            start.pgx:7 `-1` `delay` takes at least 0 for `nSeconds`, not -1
              | the task does not wait
            start.pgx:8 `120` `setMonitorSpeed` takes 0 to 100 for `nSpeed`, not 120
              | nothing changes and the result is -3
            start.pgx:9 `-1` `bAnd` takes 0 to 4294967295 for `nBitField2`, not -1
              | the number is forced into a bit field of 32 bits
            start.pgx:10 `-1` `asc` takes 0 to 127 for `nPosition`, not -1
              | the result is -1
            start.pgx:11 `-2` `watch` takes at least 0 for `nSeconds`, not -2
              | the task does not wait
            start.pgx:12 `4` `size` takes 1 to 3 for `nDimension`, not 4
              | the result is 0
            start.pgx:13 `-3` `dioSet` takes at least 0 for `nValue`, not -3
              | a negative number has no pattern of bits
        "#]]
        .assert_eq(&check(
            &RULE,
            "num n\nbool b\ndio d\nscreen sc\ngotoxy(40,0)\ngotoxy(sc,0,-1)\ndelay(-1)\nsetMonitorSpeed(120)\n\
             n=bAnd(n,-1)\nn=asc(\"a\",-1)\nb=watch(b,-2)\nn=size(n,4)\ndioSet(d,-3)",
        ));
    }

    #[test]
    fn numbers_within_their_range_are_not_reported() {
        assert_eq!(
            check(&RULE, "num n\ngotoxy(39,13)\ndelay(0)\nsetMonitorSpeed(100)\nn=bAnd(n,255)\nn=asc(\"a\",0)"),
            ""
        );
    }
}
