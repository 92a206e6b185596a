//! V0122: a name that hides a word of the language.

use val3_analysis::items::declarations::{Declared, all_locals, all_params};
use val3_lang::keywords::{Reserved, reserved};

use crate::diagnostic::Wording;
use crate::lint::{Findings, ProgramView};
use crate::rule::rule;

rule! {
    /// A local variable or a parameter has the name of an instruction, of a built-in type, of `world` or `flange`, or
    /// of a value such as `off` and `lefty`.
    ///
    /// ## Why
    /// Within the program the name means the variable: `world` is no longer the frame of the cell, and `off` no longer
    /// a blending mode. A variable with the name of an instruction makes lines with that instruction hard to read.
    ///
    /// ## Bad
    /// ```val3
    /// program show(num limit)
    /// begin
    ///   putln(limit)
    /// end
    /// ```
    ///
    /// ## Good
    /// ```val3
    /// program show(num x_nLimit)
    /// begin
    ///   putln(x_nLimit)
    /// end
    /// ```
    V0122 "hidden-word" Info, Program: check
}

fn check(program: &ProgramView<'_>, found: &mut Findings) {
    let header = program.header;
    if header.locals.iter().any(|local| meaning(&local.name).is_some()) {
        report(found, "local variable", all_locals(program.db, program.file));
    }
    if header.params.iter().any(|param| meaning(&param.name).is_some()) {
        report(found, "parameter", all_params(program.db, program.file));
    }
}

fn report(found: &mut Findings, what: &str, names: Vec<Declared>) {
    for Declared { name, range, .. } in names {
        if let Some(meaning) = meaning(&name) {
            found.report(&RULE, range, word(what, &name, meaning));
        }
    }
}

/// Meaning of the word in VAL 3. Another rule reports keywords as errors.
fn meaning(name: &str) -> Option<&'static str> {
    match reserved(name)? {
        Reserved::Keyword => None,
        Reserved::Type => Some("a type"),
        Reserved::Builtin => Some("data of VAL 3 itself"),
        Reserved::Enumerator => Some("a value of VAL 3 itself"),
        Reserved::Instruction => Some("an instruction"),
    }
}

fn word(what: &str, name: &str, meaning: &str) -> Wording {
    Wording::new(format!("the {what} `{name}` has the name of {meaning}"), meaning, "rename it")
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::*;
    use crate::lint::testing::check;

    #[test]
    fn names_of_instructions_types_and_built_in_data_are_reported() {
        expect![[r#"
            p.pgx:5 `size` the parameter `size` has the name of an instruction
              | an instruction
              ? rename it
            p.pgx:6 `off` the parameter `off` has the name of a value of VAL 3 itself
              | a value of VAL 3 itself
              ? rename it
            p.pgx:9 `world` the local variable `world` has the name of data of VAL 3 itself
              | data of VAL 3 itself
              ? rename it
            p.pgx:10 `config` the local variable `config` has the name of a type
              | a type
              ? rename it
        "#]]
        .assert_eq(&check(&RULE, "program p(num size, bool off)\n  frame world\n  num config\nbegin\nend"));
    }

    #[test]
    fn other_names_are_not_reported() {
        assert_eq!(check(&RULE, "program p(num x_nSize, num Size)\n  num sizes\nbegin\nend"), "");
    }
}
