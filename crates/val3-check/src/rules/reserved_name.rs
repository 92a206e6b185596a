//! V0111: a word of the language used as a name.

use val3_lang::keywords::{Reserved, canonical, reserved};

use crate::{diagnostic::Wording, rule::rule};

rule! {
    /// A word of VAL 3 is used as a name.
    ///
    /// ## Why
    /// Keywords such as `if`, `step` and `and` have their meaning everywhere and in any letter case: `dO` is `do`. The
    /// names of built-in types, instructions, data (`world`) and values (`off`) have it in their own letter case:
    /// `Movej` is no instruction. Data, variables, parameters and programs with such a name would be ambiguous, so the
    /// controller does not load the application.
    ///
    /// ## Bad
    /// ```val3
    /// num step
    /// ```
    ///
    /// ## Good
    /// ```val3
    /// num nStep
    /// ```
    V0111 "reserved-name" Error
}

/// Returns the wording of the finding.
pub(crate) fn word(name: &str) -> Wording {
    Wording::new(
        format!("`{name}` is {} and cannot be used as a name{}", meaning(name), other_spelling(name)),
        "reserved",
        "choose another name, for example with the first letter of the type: `n` for a `num`",
    )
}

/// The meaning of the word in VAL 3.
fn meaning(name: &str) -> &'static str {
    match reserved(name) {
        Some(Reserved::Keyword) => "a keyword of VAL 3",
        Some(Reserved::Type) => "a type of VAL 3",
        Some(Reserved::Builtin) => "data of VAL 3 itself",
        Some(Reserved::Enumerator) => "a value of VAL 3 itself",
        Some(Reserved::Instruction) => "an instruction of VAL 3",
        None => "a word of VAL 3",
    }
}

/// Explains a keyword in an unusual letter case.
fn other_spelling(name: &str) -> String {
    match canonical(name) {
        Some(keyword) if keyword != name => format!(": it means `{keyword}`, because keywords have any letter case"),
        _ => String::new(),
    }
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::word;

    #[test]
    fn the_message_says_what_is_wrong() {
        expect![[r#"
            `step` is a keyword of VAL 3 and cannot be used as a name
            | reserved
            ? choose another name, for example with the first letter of the type: `n` for a `num`
        "#]]
        .assert_eq(&word("step").to_string());
        expect![[r#"
            `dO` is a keyword of VAL 3 and cannot be used as a name: it means `do`, because keywords have any letter case
            | reserved
            ? choose another name, for example with the first letter of the type: `n` for a `num`
        "#]]
        .assert_eq(&word("dO").to_string());
        expect![[r#"
            `joint` is a type of VAL 3 and cannot be used as a name
            | reserved
            ? choose another name, for example with the first letter of the type: `n` for a `num`
        "#]]
        .assert_eq(&word("joint").to_string());
        expect![[r#"
            `world` is data of VAL 3 itself and cannot be used as a name
            | reserved
            ? choose another name, for example with the first letter of the type: `n` for a `num`
        "#]]
        .assert_eq(&word("world").to_string());
        expect![[r#"
            `lefty` is a value of VAL 3 itself and cannot be used as a name
            | reserved
            ? choose another name, for example with the first letter of the type: `n` for a `num`
        "#]]
        .assert_eq(&word("lefty").to_string());
        expect![[r#"
            `movej` is an instruction of VAL 3 and cannot be used as a name
            | reserved
            ? choose another name, for example with the first letter of the type: `n` for a `num`
        "#]]
        .assert_eq(&word("movej").to_string());
    }
}
