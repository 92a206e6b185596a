//! All kinds of errors in XML, with their exact ranges. Line 0 is the first line of the file.

use expect_test::{Expect, expect};

use crate::show::faults_in;

#[track_caller]
fn check_file(text: &str, expected: Expect) {
    expected.assert_eq(&faults_in(text));
}

#[test]
fn unclosed_element() {
    check_file(
        "<a>\n<b>\n</a>\n",
        expect![[r#"
        1:1 "<b" UnclosedElement { name: "b" } <- 1:4 ""
    "#]],
    );
    check_file(
        "<a>\n<b><c/>\n",
        expect![[r#"
        1:1 "<b" UnclosedElement { name: "b" } <- 1:8 ""
    "#]],
    );
}

#[test]
fn a_truncated_file_has_one_fault() {
    for text in [
        "<Programs><Program><Code><![CDATA[begin\nif a\n  x=1\n",
        "<Programs><Program><Code>begin\nif a\n  x=(1\n",
        "<Programs><Program name=\"p",
        "<Programs><Program",
        "<Programs><Program><!-- ",
        "<Programs><Program",
        "<Programs></Program",
        "<Programs><Description><![CDATA[ text",
        "<Programs><Program></Program></Programs",
    ] {
        assert_eq!(faults_in(text).lines().count(), 1, "{text}\n{}", faults_in(text));
    }
}

#[test]
fn unmatched_end_tag() {
    check_file(
        "<a>\n  </b>\n</a>",
        expect![[r#"
        1:3 "</b" UnmatchedEndTag { name: "b" }
    "#]],
    );
    check_file(
        "<a/>\n</a>",
        expect![[r#"
        1:1 "</a" UnmatchedEndTag { name: "a" }
    "#]],
    );
}

#[test]
fn misspelt_tags() {
    check_file(
        "<Programs>\n<Program>\n</Programm>\n</Programs>",
        expect![[r#"
            2:1 "</Programm" UnmatchedEndTag { name: "Programm" } <- 1:1 "<Program"
        "#]],
    );
    check_file(
        "<Programs>\n<Locals>\n</locals>\n<Code/>\n</Programs>",
        expect![[r#"
            2:1 "</locals" UnmatchedEndTag { name: "locals" } <- 1:1 "<Locals"
        "#]],
    );
    check_file(
        "<Programs>\n<Codes>\n</Code>\n<a/>\n</Programs>",
        expect![[r#"
            2:1 "</Code" UnmatchedEndTag { name: "Code" } <- 1:1 "<Codes"
        "#]],
    );
    check_file(
        "<Programs>\n</Project>",
        expect![[r#"
            1:1 "</Project" UnmatchedEndTag { name: "Project" } <- 0:1 "<Programs"
        "#]],
    );
    check_file(
        "<Programs a=\"b\"\n<Program>\n</Program>\n</Programs>",
        expect![[r#"
        0:1 "<Programs" Unterminated(Tag)
    "#]],
    );
}

#[test]
fn unterminated_parts() {
    check_file(
        "<a>\n<!-- b -- </a>",
        expect![[r#"
        1:1 "<!" Unterminated(Comment)
    "#]],
    );
    check_file(
        "<a>\n<![CDATA[ b ]> </a>",
        expect![[r#"
        1:1 "<![CDATA[" Unterminated(CData)
    "#]],
    );
    check_file(
        "<?xml version=\n<a/>",
        expect![[r#"
            0:1 "<?" Unterminated(ProcessingInstruction)
        "#]],
    );
    check_file(
        "<a>\n<b c=\"d\" \n</a>",
        expect![[r#"
            1:1 "<b" Unterminated(Tag)
        "#]],
    );
    check_file(
        "<a>\n<b/>\n</a ",
        expect![[r#"
        2:3 "a" Unterminated(Tag) <- 0:1 "<"
    "#]],
    );
    check_file(
        "<a b=\"c>\n</a>",
        expect![[r#"
            0:6 "\"" Unterminated(AttributeValue)
        "#]],
    );
    check_file(
        "<a b=\"c\n d=\"e\"/>",
        expect![[r#"
            1:6 "\"" Unterminated(AttributeValue)
        "#]],
    );
}

#[test]
fn code_in_an_unterminated_section_ends_before_the_end_tag() {
    check_file(
        "<Code><![CDATA[begin\n  a=1\nend]></Code>",
        expect![[r#"
            0:7 "<![CDATA[" Unterminated(CData)
        "#]],
    );
}

#[test]
fn malformed_attribute() {
    check_file(
        "<a b c=d/e \"f\"/>",
        expect![[r#"
            0:4 "b" MalformedAttribute { name: "b" }
        "#]],
    );
    check_file(
        "<a b/>",
        expect![[r#"
        0:4 "b" MalformedAttribute { name: "b" }
    "#]],
    );
    check_file(
        "<a b=\u{c}/>",
        expect![[r#"
        0:4 "b" MalformedAttribute { name: "b" }
    "#]],
    );
    check_file(
        "<a b=/>",
        expect![[r#"
        0:4 "b" MalformedAttribute { name: "b" }
    "#]],
    );
}

#[test]
fn duplicate_attribute() {
    check_file(
        "<a b=\"1\" c=\"2\" b=\"3\"/>",
        expect![[r#"
        0:16 "b" DuplicateAttribute { name: "b" } <- 0:4 "b"
    "#]],
    );
}

#[test]
fn unknown_entity() {
    check_file(
        "<a b=\"x &nbsp; y\">\n1 & 2\n&#0;</a>",
        expect![[r#"
        0:9 "&nbsp;" UnknownEntity { text: "&nbsp;" }
        1:3 "&" UnknownEntity { text: "&" }
        2:1 "&#0;" UnknownEntity { text: "&#0;" }
    "#]],
    );
    check_file(
        "<code>begin\n  a=b &and; c\n  s=\"R&D\"\n  // R&D\nend</code>",
        expect![[r#"
        1:7 "&and;" UnknownEntity { text: "&and;" }
        2:7 "&D" UnknownEntity { text: "&D" }
        3:7 "&D" UnknownEntity { text: "&D" }
    "#]],
    );
}

#[test]
fn unexpected_text() {
    check_file(
        "a <b/> c d",
        expect![[r#"
        0:1 "a " UnexpectedText
    "#]],
    );
    check_file(
        "<a>< b</a>",
        expect![[r#"
        0:4 "<" UnexpectedText
    "#]],
    );
    check_file(
        "<code>begin\n  if a<b\n  endIf\nend</code>",
        expect![[r#"
        1:7 "<" UnexpectedText
    "#]],
    );
    check_file(
        "<a b=\"c\" ?/>",
        expect![[r#"
        0:10 "?" UnexpectedText
    "#]],
    );
}

#[test]
fn root_element() {
    check_file(
        "",
        expect![[r#"
        0:1 "" RootElement
    "#]],
    );
    check_file(
        "<a/>\n<b/>\n<c/>",
        expect![[r#"
        1:1 "<" RootElement
    "#]],
    );
}

#[test]
fn doctype() {
    check_file(
        "<!DOCTYPE a SYSTEM \"b\">\n<a/>",
        expect![[r#"
        0:1 "<!" Doctype
    "#]],
    );
}

#[test]
fn conflict_markers() {
    check_file(
        "<Code><![CDATA[begin\n<<<<<<< HEAD\n  a=1\n=======\n  a=(2\n>>>>>>> b\nend]]></Code>",
        expect![[r#"
            1:1 "<<<<<<< HEAD" ConflictMarker
        "#]],
    );
    check_file(
        "<a>\n<<<<<<< HEAD\n<b>\n=======\n<c>\n>>>>>>> b\n</a>",
        expect![[r#"
        1:1 "<<<<<<< HEAD" ConflictMarker
    "#]],
    );
    check_file(
        "<code>begin\n<<<<<<< HEAD\n a=1\n=======\n a=2\n>>>>>>> b\nend</code>",
        expect![[r#"
        1:1 "<<<<<<< HEAD" ConflictMarker
    "#]],
    );
    check_file(
        "<code>begin\n&lt;&lt;&lt;&lt;&lt;&lt;&lt; HEAD\n a=1\n=======\n a=2\n&gt;&gt;&gt;&gt;&gt;&gt;&gt; b\nend</code>",
        expect![[r#"
        1:1 "&lt;&lt;&lt;&lt;&lt;&lt;&lt; HEAD" ConflictMarker
    "#]],
    );
    check_file(
        "<a>\n  <!-- <<<<<<< conflict\n<b/>\n>>>>>>> -->\n<!-- note -->\n<b/>\n<!-- <<<<<<< other -->\n</a>",
        expect![[r#"
            1:3 "<!-- <<<<<<< conflict" ConflictMarker
            6:1 "<!-- <<<<<<< other -->" ConflictMarker
        "#]],
    );
    check_file(
        "<a>\n>>>>>>> b\n</a>",
        expect![[r#"
        1:1 ">>>>>>> b" ConflictMarker
    "#]],
    );
}

#[test]
fn an_end_tag_too_many() {
    // The start tag was closed with `/>`.
    check_file(
        "<Datas>\n<Data/>\n<Value/>\n</Data>\n<Data/>\n</Datas>",
        expect![[r#"
        3:1 "</Data" UnmatchedEndTag { name: "Data" }
    "#]],
    );
    check_file(
        "<Datas>\n<Data/>\n</Data>\n</Datas>",
        expect![[r#"
        2:1 "</Data" UnmatchedEndTag { name: "Data" }
    "#]],
    );
    // The start tag is missing.
    check_file(
        "<Database>\n<Data/>\n</Datas>\n</Database>",
        expect![[r#"
        2:1 "</Datas" UnmatchedEndTag { name: "Datas" }
    "#]],
    );
}

#[test]
fn text_between_elements() {
    check_file(
        "<Datas>\nj<Data/> k\n</Datas>",
        expect![[r#"
        1:1 "j" UnexpectedText
    "#]],
    );
    check_file("<Program><Description>text</Description></Program>", expect![[r#""#]]);
}

#[test]
fn an_unescaped_character_in_a_value() {
    check_file(
        "<a b=\"x < y\" c=\"<z\"/>",
        expect![[r#"
        0:9 "<" UnexpectedText
    "#]],
    );
    check_file(
        "<a>\n<b c=\"1/><b c=\"2\"/>\n</a>",
        expect![[r#"
        1:6 "\"" Unterminated(AttributeValue)
    "#]],
    );
}

#[test]
fn a_cdata_section_without_its_start() {
    check_file(
        "<Code>begin\nend]]></Code>",
        expect![[r#"
        1:4 "]]>" UnexpectedText
    "#]],
    );
    check_file(
        "<Code><!CDATA[begin\nend]]></Code>",
        expect![[r#"
        0:7 "<" UnexpectedText
    "#]],
    );
    check_file("<code>begin\n  x=a[b[1]]>3\nend</code>", expect![[r#""#]]);
}
