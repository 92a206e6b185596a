//! V0716: a line of code that is too long.

use val3_analysis::items::layout::code;
use val3_syntax::{TextRange, TextSize, decode_entities};

use crate::diagnostic::Wording;
use crate::lint::{Findings, ProgramView};
use crate::rule::rule;

rule! {
    /// A line of code is longer than the configured limit.
    ///
    /// ## Why
    /// Long lines cannot be read on the pendant, and some tools cut them. The option `line-length` sets the maximum
    /// number of characters in a line, 259 by default. The rule is off by default, because it enforces a convention
    /// that not every shop has.
    ///
    /// ## Bad
    /// ```val3
    /// // This comment is much longer than any screen is wide, and so it goes on and on, and nobody who stands in front of the machine will ever read to its end, which is a pity, because it might say something of use at last, but no, it only tells that it is long, and then some more
    /// putln("ready")
    /// ```
    ///
    /// ## Good
    /// ```val3
    /// // This comment is short
    /// putln("ready")
    /// ```
    V0716 "long-line" Info off, Program: check
}

fn check(program: &ProgramView<'_>, found: &mut Findings) {
    let Some(code) = code(program.db, program.file) else { return };
    let limit = program.options.line_length;
    let mut start = code.start();
    for line in program.slice(code).split_inclusive('\n') {
        let text = line.trim_end_matches(['\r', '\n']);
        // A text never has more characters than bytes.
        let length = if text.len() > limit { decode_entities(text).chars().count() } else { 0 };
        if length > limit {
            found.report(&RULE, TextRange::at(start, TextSize::of(text)), word(length, limit));
        }
        start += TextSize::of(line);
    }
}

fn word(length: usize, limit: usize) -> Wording {
    Wording::new(format!("this line has {length} characters, more than {limit}"), "too long", "divide it")
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::*;
    use crate::lint::testing::check;

    #[test]
    fn the_limit_is_exact() {
        let settings = "=== val3.toml\n[lint]\nline-length = 11";
        expect![[r#"
            start.pgx:5 `putln("123")` this line has 12 characters, more than 11
              | too long
              ? divide it
            start.pgx:7 `putln("äöü")` this line has 12 characters, more than 11
              | too long
              ? divide it
        "#]]
        .assert_eq(&check(&RULE, &format!("putln(\"123\")\nputln(\"12\")\nputln(\"äöü\")\n{settings}")));
        let settings = "=== val3.toml\n[lint]\nline-length = 12";
        assert_eq!(check(&RULE, &format!("putln(\"123\")\nputln(\"äöü\")\n{settings}")), "");
    }
}
