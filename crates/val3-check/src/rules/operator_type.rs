//! V0201: an operator that is not defined for its operands.

use crate::{conversion, diagnostic::Wording, english::a, rule::rule};

rule! {
    /// An operator is not defined for the types of its operands.
    ///
    /// ## Why
    /// Each operator is defined for certain types only, and both sides usually have the same type. `+` adds two numbers
    /// or two joint positions, or joins two strings. VAL 3 never converts numbers to text or text to numbers
    /// automatically. Transformations are chained with `*` and inverted with `!`. The logical operators take `bool`
    /// values, such as the results of comparisons.
    ///
    /// ## Bad
    /// ```val3
    /// num nCount
    ///
    /// putln("parts: "+nCount)
    /// ```
    ///
    /// ## Good
    /// ```val3
    /// num nCount
    ///
    /// putln("parts: "+toString("",nCount))
    /// ```
    V0201 "operator-type" Error
}

/// Returns the wording of the finding.
pub(crate) fn word(op: &str, left: Option<&str>, right: &str) -> Wording {
    match left {
        Some(left) => Wording::new(
            format!("`{op}` is not defined between {} and {}", a(left), a(right)),
            format!("`{left}` {op} `{right}`"),
            binary_advice(op, left, right),
        ),
        None => Wording::new(
            format!("`{op}` is not defined for {}", a(right)),
            format!("this is {}", a(right)),
            unary_advice(op, right),
        ),
    }
}

fn binary_advice(op: &str, left: &str, right: &str) -> String {
    let advice = match (op, left, right) {
        ("and" | "or" | "xor", _, _) => "both sides must be `bool`: compare first, as in `nCount>0`",
        ("+" | "-", "trsf", _) | ("+" | "-", _, "trsf") => {
            "transformations are chained with `*`; fields such as `.z` can be added as numbers"
        }
        ("*", other, "trsf") | ("*", "trsf", other) if has_transformation(other) => {
            "the field `.trsf` of a point, frame or tool is its transformation"
        }
        ("<" | ">" | "<=" | ">=", "string", "string") => "strings are only compared with `==` and `!=`",
        ("+", _, "string") => return conversion::advice(left, right),
        ("+", "string", _) => return conversion::advice(right, left),
        ("==" | "!=", _, _) => return conversion::advice(left, right),
        _ => "",
    };
    advice.to_owned()
}

/// Whether values of the type have a field `trsf`.
fn has_transformation(ty: &str) -> bool {
    matches!(ty, "point" | "pointRx" | "pointRs" | "frame" | "tool")
}

fn unary_advice(op: &str, operand: &str) -> &'static str {
    match (op, operand) {
        ("!", "num") => "`!` inverts a `bool` or a transformation; `bNot(…)` inverts the bits of a number",
        ("!", _) => "`!` inverts a `bool` or a transformation",
        ("-", "trsf") => "`!` inverts a transformation",
        _ => "",
    }
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::word;

    #[test]
    fn the_message_names_both_types() {
        expect![[r#"
            `+` is not defined between a `string` and a `num`
            | `string` + `num`
            ? `toString("", …)` turns a number into text
        "#]]
        .assert_eq(&word("+", Some("string"), "num").to_string());
        expect![[r#"
            `and` is not defined between a `bool` and a `num`
            | `bool` and `num`
            ? both sides must be `bool`: compare first, as in `nCount>0`
        "#]]
        .assert_eq(&word("and", Some("bool"), "num").to_string());
        expect![[r#"
            `+` is not defined between a `trsf` and a `trsf`
            | `trsf` + `trsf`
            ? transformations are chained with `*`; fields such as `.z` can be added as numbers
        "#]]
        .assert_eq(&word("+", Some("trsf"), "trsf").to_string());
        expect![[r#"
            `*` is not defined between a `pointRx` and a `trsf`
            | `pointRx` * `trsf`
            ? the field `.trsf` of a point, frame or tool is its transformation
        "#]]
        .assert_eq(&word("*", Some("pointRx"), "trsf").to_string());
        expect![[r#"
            `==` is not defined between a `num` and a `string`
            | `num` == `string`
            ? `toString("", …)` turns a number into text
        "#]]
        .assert_eq(&word("==", Some("num"), "string").to_string());
        expect![[r#"
            `*` is not defined between a `screen` and a `num`
            | `screen` * `num`
        "#]]
        .assert_eq(&word("*", Some("screen"), "num").to_string());
    }

    #[test]
    fn the_message_names_the_type_of_a_single_operand() {
        expect![[r#"
            `!` is not defined for a `num`
            | this is a `num`
            ? `!` inverts a `bool` or a transformation; `bNot(…)` inverts the bits of a number
        "#]]
        .assert_eq(&word("!", None, "num").to_string());
        expect![[r#"
            `-` is not defined for a `string`
            | this is a `string`
        "#]]
        .assert_eq(&word("-", None, "string").to_string());
    }
}
