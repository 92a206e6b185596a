//! V0203: an argument of the wrong type.

use smol_str::SmolStr;
use val3_lang::instructions::{DELAY, LEN, SIZE, WAIT};

use crate::{
    conversion,
    diagnostic::Wording,
    english::{a, container, or},
    rule::rule,
};

rule! {
    /// The type of an argument is not accepted by the parameter.
    ///
    /// ## Why
    /// Each argument of an instruction or program must have the type of its parameter. VAL 3 performs no automatic
    /// conversions. Many instructions have several forms, such as `movej` for a joint position and for a point; the
    /// arguments together must fit one of them. The controller does not load an application with a call that fits no
    /// form.
    ///
    /// ## Bad
    /// ```val3
    /// trsf trPick
    /// mdesc mFast
    ///
    /// movej(trPick,flange,mFast)
    /// ```
    ///
    /// ## Good
    /// ```val3
    /// point pPick
    /// mdesc mFast
    ///
    /// movej(pPick,flange,mFast)
    /// ```
    V0203 "argument-type" Error
}

/// Returns the wording of the finding.
pub(crate) fn word(callee: &str, parameter: &str, expected: &[SmolStr], found: &str) -> Wording {
    let types: Vec<_> = expected.iter().map(|ty| a(ty)).collect();
    if callee == WAIT && found == "num" {
        return Wording::new(
            format!("`{callee}` takes a condition as `{parameter}`, not {}", a(found)),
            format!("this is {}", a(found)),
            format!("`{DELAY}(nSeconds)` waits for a time"),
        );
    }
    if callee == LEN && found.contains('[') {
        return Wording::new(
            format!("`{callee}` takes {} as `{parameter}`, not {} (`{found}`)", or(&types), container(found)),
            format!("this is {}", container(found)),
            format!("`{SIZE}(…)` returns the number of elements"),
        );
    }
    let mut advice = expected.iter().map(|wanted| conversion::advice(found, wanted));
    Wording::new(
        format!("`{callee}` takes {} as `{parameter}`, not {}", or(&types), a(found)),
        format!("this is {}", a(found)),
        advice.find(|advice| !advice.is_empty()).unwrap_or_default(),
    )
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::word;

    #[test]
    fn the_message_names_the_expected_type() {
        expect![[r#"
            `appro` takes a `trsf` as `trTransformation`, not a `point`
            | this is a `point`
            ? append `.trsf` to get its transformation
        "#]]
        .assert_eq(&word("appro", "trTransformation", &["trsf".into()], "point").to_string());
    }

    #[test]
    fn the_number_of_elements_is_suggested_for_an_array() {
        expect![[r#"
            `len` takes a `string` as `sText`, not a one-dimensional array (`num[]`)
            | this is a one-dimensional array
            ? `size(…)` returns the number of elements
        "#]]
        .assert_eq(&word("len", "sText", &["string".into()], "num[]").to_string());
    }

    #[test]
    fn the_message_lists_several_expected_types() {
        let types = ["joint".into(), "point".into()];
        expect![[r#"
            `movej` takes a `joint` or a `point` as `jPosition`, not a `trsf`
            | this is a `trsf`
            ? assign it to the field `.trsf` of a point; `compose(…)` returns a point with it
        "#]]
        .assert_eq(&word("movej", "jPosition", &types, "trsf").to_string());
    }
}
