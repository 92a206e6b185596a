//! V0222: a position for another kind of arm.

use crate::{diagnostic::Wording, english::a, rule::rule};

rule! {
    /// A joint position, point or configuration belongs to another kind of arm.
    ///
    /// ## Why
    /// The types end in `Rx` for arms with six axes, in `Rs` for arms with four axes (SCARA), and in `Vrb` for any
    /// other arm. They have different fields, so they cannot be assigned to each other, compared or passed for each
    /// other, and an arm only moves to positions of the same kind. In code, `joint`, `point` and `config` mean the kind
    /// of the arm that is installed.
    ///
    /// ## Bad
    /// ```val3
    /// jointRx jHome
    /// jointRs jSmall
    ///
    /// jHome=jSmall
    /// ```
    ///
    /// ## Good
    /// ```val3
    /// jointRx jHome
    /// jointRx jSmall
    ///
    /// jHome=jSmall
    /// ```
    V0222 "wrong-arm" Error
}

/// Returns the wording of the finding.
pub(crate) fn word(found: &str, expected: &str) -> Wording {
    Wording::new(
        format!("{} is needed here, not {}", a(expected), a(found)),
        arm(found).map_or_else(|| format!("this is {}", a(found)), |arm| format!("this is for {arm}")),
        arm(expected).map(|arm| format!("`{expected}` is for {arm}")).unwrap_or_default(),
    )
}

/// Kind of arm to which a type belongs.
fn arm(ty: &str) -> Option<&'static str> {
    match ty {
        _ if ty.ends_with("Rx") => Some("an arm with six axes"),
        _ if ty.ends_with("Rs") => Some("an arm with four axes (SCARA)"),
        _ if ty.ends_with("Vrb") => Some("another kind of arm"),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::word;

    #[test]
    fn the_message_says_what_is_wrong() {
        expect![[r#"
            a `jointRx` is needed here, not a `jointRs`
            | this is for an arm with four axes (SCARA)
            ? `jointRx` is for an arm with six axes
        "#]]
        .assert_eq(&word("jointRs", "jointRx").to_string());
        expect![[r#"
            a `point` is needed here, not a `pointRx`
            | this is for an arm with six axes
        "#]]
        .assert_eq(&word("pointRx", "point").to_string());
    }
}
