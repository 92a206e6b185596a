//! V0002: text that XML does not allow.

use val3_syntax::{TextRange, TextSize};

use crate::{
    diagnostic::{Fix, Wording},
    fix::Site,
    rule::rule,
};

rule! {
    /// A file contains text that XML does not allow: a bare `&` or `<`, an unknown entity, or words between the
    /// elements.
    ///
    /// ## Why
    /// In XML the characters `&` and `<` begin an entity and a tag. As plain characters they are
    /// written `&amp;` and `&lt;`, in the values of a `.dtx` file just as in code outside a
    /// `<![CDATA[ … ]]>` section. A file with a bare one is no XML, and the controller does not load the application.
    ///
    /// ## Bad
    /// ```val3
    /// num nCount
    ///
    /// === main/start.pgx
    /// <?xml version="1.0" encoding="utf-8"?>
    /// <Programs xmlns="http://www.staubli.com/robotics/VAL3/Program/2">
    ///   <Program name="start" access="public">
    ///     <Description>Pick & place</Description>
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
    ///     <Description>Pick &amp; place</Description>
    ///     <Code><![CDATA[begin
    ///   nCount=nCount+1
    /// end]]></Code>
    ///   </Program>
    /// </Programs>
    /// ```
    V0002 "xml-text" Error
}

/// Returns the wording for a stray `<`, or for text where only elements are allowed.
pub(crate) fn stray_text() -> Wording {
    Wording::new(
        "this text does not belong in the XML of the file",
        "stray text",
        "remove it; the character `<` itself is written `&lt;`",
    )
}

/// Returns the wording for `&name;` that XML does not define, or for a bare `&`.
pub(crate) fn unknown_entity(text: &str) -> Wording {
    if text.starts_with("&#") && text.ends_with(';') {
        return Wording::new(
            format!("XML does not allow the character `{text}`"),
            "not a character of XML",
            "the only control characters in XML are `&#9;`, `&#10;` and `&#13;`; programs make others with `chr(…)`",
        );
    }
    if text.len() > 1 && text.ends_with(';') {
        return Wording::new(
            format!("XML does not define the entity `{text}`"),
            "unknown entity",
            "XML defines `&amp;`, `&lt;`, `&gt;`, `&quot;` and `&apos;`; write other characters themselves",
        );
    }
    Wording::new("`&` has a special meaning in XML and must be escaped", "write `&amp;`", "")
}

/// Returns the wording for a document type declaration.
pub(crate) fn doctype() -> Wording {
    Wording::new(
        "a document type declaration does not belong in a VAL 3 file",
        "not allowed",
        "remove it, and write out the entities that it declares: they are never expanded",
    )
}

/// Returns the wording for `]]>` in a line of code.
pub(crate) fn early_section_end() -> Wording {
    Wording::new(
        "`]]>` ends the code section in the middle of a line",
        "the code ends here",
        "write a blank between the brackets, or in a string two parts: `\"]]\"+\">\"`",
    )
}

/// Escapes a bare `&`.
pub(crate) fn fix(site: &Site<'_>, text: &str) -> Option<Fix> {
    let ampersand = TextRange::at(site.range.start(), TextSize::of('&'));
    let is_bare = !text.ends_with(';');
    is_bare.then(|| Fix::safe("write `&amp;`", vec![site.write(ampersand, "&amp;")]))
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::*;

    #[test]
    fn words_between_elements_are_reported() {
        expect![[r#"
            this text does not belong in the XML of the file
            | stray text
            ? remove it; the character `<` itself is written `&lt;`
        "#]]
        .assert_eq(&stray_text().to_string());
    }

    #[test]
    fn a_bare_ampersand_is_reported() {
        expect![[r#"
            `&` has a special meaning in XML and must be escaped
            | write `&amp;`
        "#]]
        .assert_eq(&unknown_entity("& lid").to_string());
    }

    #[test]
    fn an_entity_of_another_language_is_reported() {
        expect![[r#"
            XML does not define the entity `&nbsp;`
            | unknown entity
            ? XML defines `&amp;`, `&lt;`, `&gt;`, `&quot;` and `&apos;`; write other characters themselves
        "#]]
        .assert_eq(&unknown_entity("&nbsp;").to_string());
    }

    #[test]
    fn a_control_character_by_number_is_reported() {
        expect![[r#"
            XML does not allow the character `&#7;`
            | not a character of XML
            ? the only control characters in XML are `&#9;`, `&#10;` and `&#13;`; programs make others with `chr(…)`
        "#]]
        .assert_eq(&unknown_entity("&#7;").to_string());
    }

    #[test]
    fn the_end_of_a_section_in_code_is_reported() {
        expect![[r#"
            `]]>` ends the code section in the middle of a line
            | the code ends here
            ? write a blank between the brackets, or in a string two parts: `"]]"+">"`
        "#]]
        .assert_eq(&early_section_end().to_string());
    }

    #[test]
    fn a_document_type_is_reported() {
        expect![[r#"
            a document type declaration does not belong in a VAL 3 file
            | not allowed
            ? remove it, and write out the entities that it declares: they are never expanded
        "#]]
        .assert_eq(&doctype().to_string());
    }
}
