//! V0003: an attribute that XML does not allow.

use crate::{diagnostic::Wording, phrase::shortened, rule::rule};

rule! {
    /// An XML attribute has no value in quotes, or occurs twice in one tag.
    ///
    /// ## Why
    /// XML requires attributes of the form `name="value"`, each only once in a tag. Otherwise the controller rejects
    /// the whole file. A duplicate attribute usually comes from a merge in which both sides changed the same
    /// declaration.
    ///
    /// ## Bad
    /// ```val3
    /// num nCount
    ///
    /// === main/start.pgx
    /// <?xml version="1.0" encoding="utf-8"?>
    /// <Programs xmlns="http://www.staubli.com/robotics/VAL3/Program/2">
    ///   <Program name="start" access="private" access="public">
    ///     <Code><![CDATA[begin
    ///   nCount=nCount+1
    /// end]]></Code>
    ///   </Program>
    /// </Programs>
    /// ```
    ///
    /// ## Good
    /// ```val3
    /// num nCount
    ///
    /// === main/start.pgx
    /// <?xml version="1.0" encoding="utf-8"?>
    /// <Programs xmlns="http://www.staubli.com/robotics/VAL3/Program/2">
    ///   <Program name="start" access="public">
    ///     <Code><![CDATA[begin
    ///   nCount=nCount+1
    /// end]]></Code>
    ///   </Program>
    /// </Programs>
    /// ```
    V0003 "xml-attribute" Error
}

/// Returns the wording for an attribute without `=` or without a value in quotes. `name` is a character or a value if
/// there is no name before it.
pub(crate) fn malformed(name: &str) -> Wording {
    if !name.starts_with(|first: char| first.is_alphabetic() || first == '_') {
        return Wording::new(
            format!("`{}` has no attribute before it", shortened(name)),
            "expected `name=\"value\"`",
            "",
        );
    }
    Wording::new(format!("the attribute `{name}` has no value in quotes"), format!("expected `{name}=\"…\"`"), "")
}

/// Returns the wording for a repeated attribute.
pub(crate) fn duplicate(name: &str) -> Wording {
    Wording::new(
        format!("the attribute `{name}` appears twice in one tag"),
        format!("the second `{name}`"),
        "remove one of the two",
    )
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::*;

    #[test]
    fn a_value_without_quotes_is_reported() {
        expect![[r#"
            the attribute `size` has no value in quotes
            | expected `size="…"`
        "#]]
        .assert_eq(&malformed("size").to_string());
    }

    #[test]
    fn a_value_without_name_is_reported() {
        expect![[r#"
            `=` has no attribute before it
            | expected `name="value"`
        "#]]
        .assert_eq(&malformed("=").to_string());
    }

    #[test]
    fn a_repeated_attribute_is_reported() {
        expect![[r#"
            the attribute `access` appears twice in one tag
            | the second `access`
            ? remove one of the two
        "#]]
        .assert_eq(&duplicate("access").to_string());
    }
}
