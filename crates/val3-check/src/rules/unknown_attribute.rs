//! V0535: an attribute that the element does not have.

use crate::{diagnostic::Wording, phrase::did_you_mean, rule::rule};

rule! {
    /// The file format has no such attribute for this element.
    ///
    /// ## Why
    /// The attribute has no effect. If it is misspelt, the intended setting keeps its default: a program with
    /// `acces="public"` is private, and libraries that call it fail. Letter case matters.
    ///
    /// Two similar faults have rules of their own: a misspelt attribute that the element requires is reported by
    /// `V0505`, and an attribute that does not belong to the type of a value by `V0511`.
    ///
    /// ## Bad
    /// ```val3
    /// call run()
    ///
    /// === main/run.pgx
    /// <?xml version="1.0" encoding="utf-8"?>
    /// <Programs xmlns="http://www.staubli.com/robotics/VAL3/Program/2">
    ///   <Program name="run" acces="public">
    ///     <Code><![CDATA[begin
    ///   putln("ready")
    /// end]]></Code>
    ///   </Program>
    /// </Programs>
    /// ```
    ///
    /// ## Good
    /// ```val3
    /// call run()
    ///
    /// === main/run.pgx
    /// <?xml version="1.0" encoding="utf-8"?>
    /// <Programs xmlns="http://www.staubli.com/robotics/VAL3/Program/2">
    ///   <Program name="run" access="public">
    ///     <Code><![CDATA[begin
    ///   putln("ready")
    /// end]]></Code>
    ///   </Program>
    /// </Programs>
    /// ```
    V0535 "unknown-attribute" Warning
}

/// Returns the wording of the finding.
pub(crate) fn word(element: &str, attribute: &str, near: Option<&str>) -> Wording {
    Wording::new(
        format!("the element `{element}` has no attribute `{attribute}`"),
        "it has no effect",
        did_you_mean(near),
    )
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::*;

    #[test]
    fn the_help_proposes_a_similar_name() {
        expect![[r#"
            the element `Program` has no attribute `acces`
            | it has no effect
            ? did you mean `access`?
        "#]]
        .assert_eq(&word("Program", "acces", Some("access")).to_string());
    }

    #[test]
    fn an_unknown_attribute_is_reported() {
        expect![[r#"
            the element `Data` has no attribute `colour`
            | it has no effect
        "#]]
        .assert_eq(&word("Data", "colour", None).to_string());
    }
}
