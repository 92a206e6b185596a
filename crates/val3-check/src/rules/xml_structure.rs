//! V0001: XML elements that are not nested properly.

use val3_syntax::error::XmlPart;

use crate::{diagnostic::Wording, phrase::xml_part, rule::rule};

rule! {
    /// The XML elements of a file are not nested properly: a tag, a comment or a value has no end, or an end tag closes
    /// nothing.
    ///
    /// ## Why
    /// The controller reads project, data and program files as XML. It stops at the first element that is not nested
    /// properly, and the application does not load. The usual causes are an edit by hand, a text replacement in many
    /// files, and a merge in version control.
    ///
    /// ## Bad
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
    V0001 "xml-structure" Error
}

/// Returns the wording for the element `name` without an end tag.
pub(crate) fn unclosed(name: &str) -> Wording {
    Wording::new(
        format!("the element `<{name}>` is not closed"),
        format!("`</{name}>` is missing"),
        "an element without content is closed in its own tag with `/>`",
    )
}

/// Returns the wording for an end tag `name` without an open element.
pub(crate) fn unmatched(name: &str) -> Wording {
    Wording::new(
        format!("the end tag `</{name}>` closes nothing"),
        format!("no `<{name}>` is open here"),
        format!("remove it, or add the start tag `<{name} …>` above"),
    )
}

/// Returns the wording for an XML part without an end mark.
pub(crate) fn unterminated(part: XmlPart) -> Wording {
    let (end, help) = match part {
        XmlPart::Comment => ("`-->`", ""),
        XmlPart::CData => ("`]]>`", "the code of a program ends with `]]></Code>`"),
        XmlPart::ProcessingInstruction => ("`?>`", ""),
        XmlPart::Tag => ("`>`", ""),
        XmlPart::AttributeValue => ("the closing quote", ""),
    };
    Wording::new(format!("{} has no end", xml_part(part)), format!("{end} is missing"), help)
}

/// Returns the wording for no root element, or several.
pub(crate) fn root_element() -> Wording {
    Wording::new(
        "an XML file has exactly one root element",
        "",
        "the root is `<Project>` in a `.pjx`, `<Database>` in a `.dtx` and `<Programs>` in a `.pgx` file",
    )
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::*;

    #[test]
    fn an_open_element_says_where_its_end_belongs() {
        expect![[r#"
            the element `<Data>` is not closed
            | `</Data>` is missing
            ? an element without content is closed in its own tag with `/>`
        "#]]
        .assert_eq(&unclosed("Data").to_string());
    }

    #[test]
    fn an_end_tag_too_many_is_reported() {
        expect![[r#"
            the end tag `</Datas>` closes nothing
            | no `<Datas>` is open here
            ? remove it, or add the start tag `<Datas …>` above
        "#]]
        .assert_eq(&unmatched("Datas").to_string());
    }

    #[test]
    fn a_code_section_without_end_is_reported() {
        expect![[r#"
            the code section has no end
            | `]]>` is missing
            ? the code of a program ends with `]]></Code>`
        "#]]
        .assert_eq(&unterminated(XmlPart::CData).to_string());
    }

    #[test]
    fn a_value_without_end_is_reported() {
        expect![[r#"
            the value of the attribute has no end
            | the closing quote is missing
        "#]]
        .assert_eq(&unterminated(XmlPart::AttributeValue).to_string());
    }

    #[test]
    fn a_file_without_root_is_reported() {
        expect![[r#"
            an XML file has exactly one root element
            ? the root is `<Project>` in a `.pjx`, `<Database>` in a `.dtx` and `<Programs>` in a `.pgx` file
        "#]]
        .assert_eq(&root_element().to_string());
    }
}
