//! V0239: a number with more bits than there are outputs.

use val3_lang::arguments::bits;
use val3_lang::instructions::DIO_SET;
use val3_lang::values::printed::num;

use crate::diagnostic::Wording;
use crate::english::count;
use crate::lint::{Findings, ProgramView};
use crate::rule::rule;

rule! {
    /// A number is written to fewer outputs than its bits need.
    ///
    /// ## Why
    /// `dioSet` writes one bit to each output of the array and silently ignores the other bits (3.5.3): 26 on four
    /// outputs gives 10.
    ///
    /// ## Bad
    /// ```val3
    /// dio doLamps[4]
    ///
    /// dioSet(doLamps,26)
    /// ```
    ///
    /// ## Good
    /// ```val3
    /// dio doLamps[5]
    ///
    /// dioSet(doLamps,26)
    /// ```
    V0239 "outputs-too-few" Warning, Program: check
}

fn check(program: &ProgramView<'_>, found: &mut Findings) {
    for call in program.calls_of(DIO_SET) {
        let [outputs, number] = *call.args else { continue };
        let (Some(size), Some(value)) = (program.certain_size(outputs), program.body.number(number)) else { continue };
        if value >= bits(size) {
            found
                .report(&RULE, program.range(number), word(program.text(outputs), size, value))
                .related_at(program.declaration(outputs), "declared here");
        }
    }
}

fn word(outputs: &str, size: u32, value: f64) -> Wording {
    Wording::new(
        format!("`{outputs}` has {}, too few to show {}", count(size as usize, "output"), num(value)),
        format!("there is room for 0 to {}", bits(size) - 1.0),
        "",
    )
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::*;
    use crate::lint::testing::check;

    #[test]
    fn dropped_bits_are_reported() {
        expect![[r#"
            start.pgx:5 `16` `d` has 4 outputs, too few to show 16
              | there is room for 0 to 15
              > main.dtx:4 `d` declared here
            start.pgx:6 `2` `e` has 1 output, too few to show 2
              | there is room for 0 to 1
              > main.dtx:5 `e` declared here
            start.pgx:7 `9` `d[1]` has 3 outputs, too few to show 9
              | there is room for 0 to 7
              > main.dtx:4 `d` declared here
        "#]]
        .assert_eq(&check(&RULE, "dio d[4]\ndio e\ndioSet(d,16)\ndioSet(e,2)\ndioSet(d[1],9)"));
    }

    #[test]
    fn bits_that_fit_are_not_reported() {
        assert_eq!(
            check(&RULE, "dio d[4]\npublic dio e[2]\nnum n\ndioSet(d,15)\ndioSet(d,n)\ndioSet(d[1],7)\ndioSet(e,9)"),
            ""
        );
    }
}
