//! V0225: a constant argument that stops the task.

use val3_lang::arguments::OutOfRange;

use crate::diagnostic::Wording;
use crate::lint::ranges::out_of_range;
use crate::lint::{Findings, ProgramView};
use crate::phrase::runtime_error;
use crate::rule::rule;

rule! {
    /// An argument is a constant number that the instruction rejects with a run-time error.
    ///
    /// ## Why
    /// The line stops its task whenever it runs. Error 11 means that the function is not defined for the number
    /// (3.2.3), error 70 that a parameter is out of its range. Up to s7 `power` accepts no base of 0 or below, whatever
    /// the exponent. From s8 on it accepts a negative base with a whole exponent, and a base of 0 with a positive one.
    /// `resize` accepts a dimension that the array has and a size of at least 1. Numbers that count or select something
    /// are rounded first, so a size of 0.7 is 1.
    ///
    /// ## Bad
    /// ```val3
    /// num nRoot
    ///
    /// nRoot=sqrt(-2)
    /// ```
    ///
    /// ## Good
    /// ```val3
    /// num nRoot
    ///
    /// nRoot=-sqrt(2)
    /// ```
    V0225 "argument-out-of-range" Error, Program: check
}

fn check(program: &ProgramView<'_>, found: &mut Findings) {
    for fault in out_of_range(program) {
        if let OutOfRange::Fails(number) = fault.range.beyond {
            let wording = Wording::new(fault.message(), runtime_error(number), "");
            found.report(&RULE, program.range(fault.argument), wording);
        }
    }
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::*;
    use crate::lint::testing::check;

    #[test]
    fn arguments_outside_the_domain_of_a_function_are_reported() {
        expect![[r#"
            start.pgx:5 `-1` `sqrt` takes at least 0 for `nValue`, not -1
              | run-time error 11: invalid numeric value
            start.pgx:6 `1.5` `asin` takes -1 to 1 for `nValue`, not 1.5
              | run-time error 11: invalid numeric value
            start.pgx:7 `-2` `acos` takes -1 to 1 for `nValue`, not -2
              | run-time error 11: invalid numeric value
            start.pgx:8 `0` `ln` takes more than 0 for `nValue`, not 0
              | run-time error 11: invalid numeric value
            start.pgx:9 `-1` `log` takes more than 0 for `nValue`, not -1
              | run-time error 11: invalid numeric value
            start.pgx:10 `-2` `power` takes more than 0 for `nX`, not -2
              | run-time error 11: invalid numeric value
            start.pgx:11 `1000` `exp` takes less than 709.8 for `nValue`, not 1000
              | run-time error 11: invalid numeric value
        "#]]
        .assert_eq(&check(
            &RULE,
            "num n\nn=sqrt(-1)\nn=asin(1.5)\nn=acos(-2)\nn=ln(0)\nn=log(-1)\nn=power(-2,3)\nn=exp(1000)",
        ));
        assert_eq!(check(&RULE, "num n\nn=sqrt(0)\nn=asin(1)\nn=acos(-1)\nn=ln(0.1)\nn=power(2,-3)\nn=exp(700)"), "");
    }

    #[test]
    fn long_numbers_have_an_exponent() {
        let report = check(&RULE, "num n\nn=exp(1e300)\nn=sqrt(-1e-7)");
        assert!(report.contains("not 1e300\n") && report.contains("not -1e-7\n"), "{report}");
    }

    #[test]
    fn parameters_out_of_range_are_reported() {
        expect![[r#"
            start.pgx:5 `-1` `left` takes at least 0 for `nSize`, not -1
              | run-time error 70: invalid parameter
            start.pgx:6 `-1` `mid` takes at least 0 for `nPosition`, not -1
              | run-time error 70: invalid parameter
            start.pgx:7 `-1` `insert` takes at least 0 for `nPosition`, not -1
              | run-time error 70: invalid parameter
            start.pgx:8 `4` `setTextMode` takes 0 to 3 for `nMode`, not 4
              | run-time error 70: invalid parameter
            start.pgx:9 `2` `interpolateL` takes more than -1 and less than 2 for `nPosition`, not 2
              | run-time error 70: invalid parameter
            start.pgx:10 `1001` `movejf` takes -1000 to 1000 for `nForce`, not 1001
              | run-time error 70: invalid parameter
            start.pgx:11 `4` `resize` takes 1 to 3 for `nDimension`, not 4
              | run-time error 70: invalid parameter
            start.pgx:12 `0` `resize` takes at least 1 for `nSize`, not 0
              | run-time error 70: invalid parameter
        "#]]
        .assert_eq(&check(
            &RULE,
            "string s\ntrsf t\nnum n\njoint j\ntool tT\nmdesc m\ns=left(s,-1)\ns=mid(s,2,-1)\ns=insert(s,\"a\",-1)\n\
             setTextMode(4)\nt=interpolateL(t,t,2)\nmovejf(j,tT,m,1001)\nresize(n,4,1)\nresize(n,1,0)",
        ));
        assert_eq!(
            check(
                &RULE,
                "string s\ntrsf t\nnum n\nresize(n,1,1)\ns=left(s,0)\nsetTextMode(3)\nt=interpolateL(t,t,1.9)\n\
                 t=interpolateC(t,t,t,-0.9)"
            ),
            ""
        );
    }

    #[test]
    fn the_range_of_power_depends_on_the_version() {
        expect![[r#"
            start.pgx:5 `-2` `power` takes at least 0 for `nX`, not -2
              | run-time error 11: invalid numeric value
            start.pgx:6 `0` `power` takes more than 0 for `nX`, not 0
              | run-time error 11: invalid numeric value
        "#]]
        .assert_eq(&check(
            &RULE,
            "version s8.10\nnum n\nn=power(-2,0.5)\nn=power(0,-1)\nn=power(-2,3)\nn=power(0,2)\nn=power(-2,n)\nn=power(n,-1)",
        ));
    }

    #[test]
    fn dimensions_that_the_array_lacks_are_reported() {
        expect![[r#"
            start.pgx:5 `2` `resize` takes 1 for `nDimension`, not 2
              | run-time error 70: invalid parameter
            start.pgx:6 `3` `resize` takes 1 to 2 for `nDimension`, not 3
              | run-time error 70: invalid parameter
            start.pgx:7 `0` `resize` takes 1 to 3 for `nDimension`, not 0
              | run-time error 70: invalid parameter
        "#]]
        .assert_eq(&check(
            &RULE,
            "num nA[2]\nnum nGrid[2,3]\nresize(nA,2,5)\nresize(nGrid,3,5)\nresize(nA,0,5)\nresize(nA,1,5)\nresize(nGrid,2,5)",
        ));
    }

    #[test]
    fn sizes_are_rounded_as_the_instructions_do() {
        expect![[r#"
            start.pgx:10 `0.4` `resize` takes at least 1 for `nSize`, not 0.4
              | run-time error 70: invalid parameter
            start.pgx:11 `1.5` `resize` takes 1 for `nDimension`, not 1.5
              | run-time error 70: invalid parameter
            start.pgx:12 `3.5` `resize` takes 1 to 3 for `nDimension`, not 3.5
              | run-time error 70: invalid parameter
            start.pgx:13 `-0.6` `left` takes at least 0 for `nSize`, not -0.6
              | run-time error 70: invalid parameter
        "#]]
        .assert_eq(&check(
            &RULE,
            "num nA[2]\nnum nGrid[2,3]\nstring s\nresize(nA,1,0.7)\nresize(nA,0.5,1)\nresize(nGrid,2.4,1)\ns=left(s,-0.5)\n\
             s=mid(s,-0.4,-0.4)\nresize(nA,1,0.4)\nresize(nA,1.5,1)\nresize(nGrid,3.5,1)\ns=left(s,-0.6)",
        ));
    }

    #[test]
    fn only_constants_are_known() {
        assert_eq!(check(&RULE, "num n\nn=sqrt(n-1)"), "");
    }
}
