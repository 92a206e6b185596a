//! V0717: a program with too many parameters.

use val3_analysis::items::declarations;

use crate::diagnostic::Wording;
use crate::lint::{Findings, ProgramView};
use crate::rule::rule;

rule! {
    /// A program has more parameters than the configured limit.
    ///
    /// ## Why
    /// In a call with many arguments it is easy to swap two of the same type. A user type groups them under names. The
    /// option `parameters` sets the maximum number, 10 by default. The rule is off by default, because it enforces a
    /// convention that not every shop has.
    ///
    /// ## Bad
    /// ```val3
    /// program p(num x_nA, num x_nB, num x_nC, num x_nD, num x_nE, num x_nF, num x_nG, num x_nH, num x_nI, num x_nJ, num x_nK)
    /// begin
    ///   putln(x_nA+x_nB+x_nC+x_nD+x_nE+x_nF+x_nG+x_nH+x_nI+x_nJ+x_nK)
    /// end
    /// ```
    ///
    /// ## Good
    /// ```val3
    /// program p(num x_nA, num x_nB)
    /// begin
    ///   putln(x_nA+x_nB)
    /// end
    /// ```
    V0717 "many-parameters" Info off, Program: check
}

fn check(program: &ProgramView<'_>, found: &mut Findings) {
    let (number, limit) = (program.header.params.len(), program.options.parameters);
    if number > limit
        && let Some(place) = declarations::program(program.db, program.file)
    {
        found.report(&RULE, place.range, word(program.name(), number, limit));
    }
}

fn word(name: &str, number: usize, limit: usize) -> Wording {
    Wording::new(
        format!("the program `{name}` has {number} parameters, more than {limit}"),
        "too many parameters",
        "group related parameters in a user type",
    )
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::*;
    use crate::lint::testing::check;

    #[test]
    fn the_limit_is_exact() {
        let settings = "=== val3.toml\n[lint]\nparameters = 1";
        expect![[r#"
            p.pgx:3 `p` the program `p` has 2 parameters, more than 1
              | too many parameters
              ? group related parameters in a user type
        "#]]
        .assert_eq(&check(&RULE, &format!("program p(num x_nA, num x_nB)\nbegin\nend\n{settings}")));
        assert_eq!(check(&RULE, &format!("program p(num x_nA)\nbegin\nend\n{settings}")), "");
    }
}
