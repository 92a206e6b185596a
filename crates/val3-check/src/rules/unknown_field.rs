//! V0107: a field that the type does not have.

use val3_lang::foreign_names;

use crate::{
    built_in,
    diagnostic::Wording,
    english::{a, meant},
    rule::rule,
};

rule! {
    /// The type of the value does not have this field.
    ///
    /// ## Why
    /// The fields of a structured type are fixed: a point has `trsf` and `config`, and its coordinates lie in `trsf`.
    /// The fields of a user type are the public data of the application that defines it; its private data are no fields
    /// (2.5.3, 7.2). Types such as `num` and `string` have no fields. The controller does not load an application with
    /// an unknown field.
    ///
    /// ## Bad
    /// ```val3
    /// point pPick
    ///
    /// pPick.trfs.z=100
    /// ```
    ///
    /// ## Good
    /// ```val3
    /// point pPick
    ///
    /// pPick.trsf.z=100
    /// ```
    V0107 "unknown-field" Error
}

/// Returns the wording of the finding.
pub(crate) fn word(ty: &str, field: &str, near: Option<&str>) -> Wording {
    Wording::new(
        format!("{} has no field `{field}`", a(ty)),
        format!("no field of `{ty}`"),
        habit(ty, field).unwrap_or_else(|| meant(field, near, &existing(ty))),
    )
}

/// Advice for a field of other languages, or for a field of a field.
fn habit(ty: &str, field: &str) -> Option<String> {
    if foreign_names::is_length(field) {
        let of = if ty == "string" {
            "`len(…)` counts the characters of a string"
        } else {
            "`size(…)` is the number of values"
        };
        return Some(of.to_owned());
    }
    let inner = built_in::field_names(ty)?.into_iter().find(|inner| *inner == TRSF)?;
    let has_field = built_in::field_names(TRSF)?.contains(&field);
    has_field.then(|| format!("`{field}` is a field of its `{inner}`: write `….{inner}.{field}`"))
}

/// Type of a position without a father, and the name of such fields.
const TRSF: &str = "trsf";

/// Existing fields of the type; empty for a user type.
fn existing(ty: &str) -> String {
    match built_in::field_names(ty).as_deref() {
        None => String::new(),
        Some([]) => format!("{} has no fields at all", a(ty)),
        Some([only]) => format!("its only field is `{only}`"),
        Some(names) => format!("its fields are `{}`", names.join("`, `")),
    }
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::word;

    #[test]
    fn the_message_says_what_is_wrong() {
        expect![[r#"
            a `point` has no field `trfs`
            | no field of `point`
            ? did you mean `trsf`?
        "#]]
        .assert_eq(&word("point", "trfs", Some("trsf")).to_string());
        expect![[r#"
            an `aio` has no field `value`
            | no field of `aio`
            ? an `aio` has no fields at all
        "#]]
        .assert_eq(&word("aio", "value", None).to_string());
        expect![[r#"
            a `point` has no field `x`
            | no field of `point`
            ? `x` is a field of its `trsf`: write `….trsf.x`
        "#]]
        .assert_eq(&word("point", "x", None).to_string());
        expect![[r#"
            a `Slot` has no field `nLayer`
            | no field of `Slot`
        "#]]
        .assert_eq(&word("Slot", "nLayer", None).to_string());
    }
}
