//! V0306: a `case` value that occurs twice.

use rustc_hash::FxHashMap;
use val3_analysis::body::{ExprId, StmtKind};

use crate::diagnostic::Wording;
use crate::lint::{Findings, ProgramView};
use crate::rule::rule;

rule! {
    /// Two branches of a `switch` have the same value.
    ///
    /// ## Why
    /// The first `case` with the value is always taken, so the second one never runs. One of them was meant for another
    /// value.
    ///
    /// ## Bad
    /// ```val3
    /// num nKey
    ///
    /// switch nKey
    ///   case 271
    ///     putln("start")
    ///   break
    ///   case 272,271
    ///     putln("stop")
    ///   break
    /// endSwitch
    /// ```
    ///
    /// ## Good
    /// ```val3
    /// num nKey
    ///
    /// switch nKey
    ///   case 271
    ///     putln("start")
    ///   break
    ///   case 272
    ///     putln("stop")
    ///   break
    /// endSwitch
    /// ```
    V0306 "duplicate-case" Warning, Program: check
}

fn check(program: &ProgramView<'_>, found: &mut Findings) {
    for stmt in program.stmts() {
        let StmtKind::Switch { cases, .. } = &stmt.kind else { continue };
        let mut seen: FxHashMap<String, ExprId> = FxHashMap::default();
        for value in cases.iter().flat_map(|(values, _)| values).copied().filter(|value| program.is_pure(*value)) {
            let first = *seen.entry(program.body.normal_form(value)).or_insert(value);
            if first != value {
                found
                    .report(&RULE, program.range(value), word(program.text(value)))
                    .related(program.range(first), "this `case` is taken");
            }
        }
    }
}

fn word(value: &str) -> Wording {
    Wording::new(
        format!("an earlier `case` already has the value `{value}`"),
        "never taken",
        "remove it, or write the value that was meant",
    )
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::*;
    use crate::lint::testing::check;

    fn switch(first: &str, second: &str) -> String {
        format!("num n\nnum m[3]\nswitch n\ncase {first}\nput(1)\nbreak\ncase {second}\nput(2)\nbreak\nendSwitch")
    }

    #[test]
    fn repeated_values_are_reported() {
        expect![[r#"
            start.pgx:9 `2` an earlier `case` already has the value `2`
              | never taken
              ? remove it, or write the value that was meant
              > start.pgx:6 `2` this `case` is taken
            start.pgx:9 `1+0` an earlier `case` already has the value `1+0`
              | never taken
              ? remove it, or write the value that was meant
              > start.pgx:6 `1` this `case` is taken
        "#]]
        .assert_eq(&check(&RULE, &switch("1,2", "3,2,1+0")));
        expect![[r#"
            start.pgx:9 `m[1]` an earlier `case` already has the value `m[1]`
              | never taken
              ? remove it, or write the value that was meant
              > start.pgx:6 `m[1]` this `case` is taken
        "#]]
        .assert_eq(&check(&RULE, &switch("m[1]", "m[1]")));
    }

    #[test]
    fn different_values_are_not_reported() {
        for (first, second) in [("1", "2"), ("1", "-1"), ("m[1]", "m[2]"), ("n", "m[0]"), ("getKey()", "getKey()")] {
            assert_eq!(check(&RULE, &switch(first, second)), "", "{first} {second}");
        }
    }

    #[test]
    fn repeated_strings_are_reported() {
        expect![[r#"
            start.pgx:9 `"a"` an earlier `case` already has the value `"a"`
              | never taken
              ? remove it, or write the value that was meant
              > start.pgx:6 `"a"` this `case` is taken
        "#]]
        .assert_eq(&check(
            &RULE,
            "string s\nswitch s\ncase \"a\"\nput(1)\nbreak\ncase \"b\",\"a\"\nput(2)\nbreak\nendSwitch",
        ));
    }
}
