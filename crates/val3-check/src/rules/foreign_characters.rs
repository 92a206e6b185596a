//! V0718: characters on the pendant that not every controller shows.

use val3_analysis::body::Expr;
use val3_lang::instruction::Family;
use val3_syntax::TextRange;

use crate::diagnostic::Wording;
use crate::lint::{Findings, ProgramView};
use crate::rule::rule;

rule! {
    /// A text for the pendant holds a character beyond ASCII.
    ///
    /// ## Why
    /// The characters that the pendant can show depend on the controller and its language. Keep texts for people in
    /// data, where they can be translated. The rule is off by default, because it enforces a convention that not every
    /// shop has.
    ///
    /// ## Bad
    /// ```val3
    /// putln("Höhe")
    /// ```
    ///
    /// ## Good
    /// ```val3
    /// putln("Hoehe")
    /// ```
    V0718 "foreign-characters" Info off, Program: check
}

fn check(program: &ProgramView<'_>, found: &mut Findings) {
    let shown = program.calls().iter().filter(|call| call.instruction.family == Family::Screen);
    let shown: Vec<TextRange> = shown.map(|call| program.range(call.id)).collect();
    for (_, expr, range) in program.body.exprs() {
        let Expr::String(text) = expr else { continue };
        let foreign = text.chars().find(|c| !c.is_ascii());
        if let Some(foreign) = foreign.filter(|_| shown.iter().any(|call| call.contains_range(range))) {
            found.report(&RULE, range, word(foreign));
        }
    }
}

fn word(foreign: char) -> Wording {
    Wording::new(
        format!("not every pendant shows the character `{foreign}`"),
        "not ASCII",
        "write it in other letters, or take the text from data",
    )
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::*;
    use crate::lint::testing::check;

    #[test]
    fn characters_that_the_pendant_cannot_show_are_reported() {
        expect![[r#"
            start.pgx:5 `"Höhe "` not every pendant shows the character `ö`
              | not ASCII
              ? write it in other letters, or take the text from data
            start.pgx:6 `"5°"` not every pendant shows the character `°`
              | not ASCII
              ? write it in other letters, or take the text from data
        "#]]
        .assert_eq(&check(&RULE, "num nA\nput(\"Höhe \"+toString(\"\",nA))\npopUpMsg(\"5°\")"));
    }

    #[test]
    fn plain_texts_and_other_uses_are_not_reported() {
        assert_eq!(check(&RULE, "string sA\nputln(\"height\")\nsA=\"Höhe\""), "");
    }
}
