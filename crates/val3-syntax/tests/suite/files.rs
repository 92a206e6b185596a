//! Entire files: dialects, writing tools, encodings, line ends.

use expect_test::{Expect, expect};
use val3_syntax::encoding::decode;
use val3_syntax::{SyntaxKind, SyntaxToken};

use crate::show::{faults_in, parsed};

/// Checks the entire tree with trivia.
#[track_caller]
fn check(text: &str, expected: Expect) {
    let parse = parsed(text);
    assert_eq!(faults_in(text), "");
    expected.assert_eq(&format!("{:#?}", parse.root()));
}

fn tokens(text: &str) -> Vec<SyntaxToken> {
    let parse = parsed(text);
    assert_eq!(faults_in(text), "");
    parse.root().descendants_with_tokens().filter_map(|element| element.into_token()).collect()
}

fn kinds_and_texts(text: &str, kinds: &[SyntaxKind]) -> Vec<(SyntaxKind, String)> {
    let wanted = tokens(text).into_iter().filter(|token| kinds.contains(&token.kind()));
    wanted.map(|token| (token.kind(), token.text().to_owned())).collect()
}

#[test]
fn a_program_of_the_new_dialect() {
    check(
        "\u{feff}<?xml version=\"1.0\" encoding=\"utf-8\"?>\r\n<Programs xmlns=\"x\">\r\n  <Program name=\"p\" >\r\n    <Locals />\r\n    <Code><![CDATA[begin\r\n  // c\r\n  a=1\r\nend]]></Code>\r\n  </Program>\r\n</Programs>",
        expect![[r#"
            XML_FILE@0..185
              BYTE_ORDER_MARK@0..3 "\u{feff}"
              XML_INSTRUCTION@3..41 "<?xml version=\"1.0\" e ..."
              WHITESPACE@41..43 "\r\n"
              ELEMENT@43..185
                START_TAG@43..63
                  L_ANGLE@43..44 "<"
                  XML_NAME@44..52 "Programs"
                  WHITESPACE@52..53 " "
                  ATTRIBUTE@53..62
                    XML_NAME@53..58 "xmlns"
                    XML_EQ@58..59 "="
                    XML_STRING@59..62 "\"x\""
                  R_ANGLE@62..63 ">"
                WHITESPACE@63..67 "\r\n  "
                ELEMENT@67..172
                  START_TAG@67..86
                    L_ANGLE@67..68 "<"
                    XML_NAME@68..75 "Program"
                    WHITESPACE@75..76 " "
                    ATTRIBUTE@76..84
                      XML_NAME@76..80 "name"
                      XML_EQ@80..81 "="
                      XML_STRING@81..84 "\"p\""
                    WHITESPACE@84..85 " "
                    R_ANGLE@85..86 ">"
                  WHITESPACE@86..92 "\r\n    "
                  ELEMENT@92..102
                    START_TAG@92..102
                      L_ANGLE@92..93 "<"
                      XML_NAME@93..99 "Locals"
                      WHITESPACE@99..100 " "
                      SLASH_R_ANGLE@100..102 "/>"
                  WHITESPACE@102..108 "\r\n    "
                  ELEMENT@108..158
                    START_TAG@108..114
                      L_ANGLE@108..109 "<"
                      XML_NAME@109..113 "Code"
                      R_ANGLE@113..114 ">"
                    CODE@114..151
                      CDATA_OPEN@114..123 "<![CDATA["
                      BEGIN_KW@123..128 "begin"
                      NEWLINE@128..132 "\r\n  "
                      COMMENT@132..136 "// c"
                      NEWLINE@136..140 "\r\n  "
                      BLOCK@140..143
                        ASSIGN_STMT@140..143
                          NAME_REF@140..141
                            IDENT@140..141 "a"
                          EQ@141..142 "="
                          LITERAL@142..143
                            NUMBER@142..143 "1"
                      NEWLINE@143..145 "\r\n"
                      END_KW@145..148 "end"
                      CDATA_CLOSE@148..151 "]]>"
                    END_TAG@151..158
                      L_ANGLE_SLASH@151..153 "</"
                      XML_NAME@153..157 "Code"
                      R_ANGLE@157..158 ">"
                  WHITESPACE@158..162 "\r\n  "
                  END_TAG@162..172
                    L_ANGLE_SLASH@162..164 "</"
                    XML_NAME@164..171 "Program"
                    R_ANGLE@171..172 ">"
                WHITESPACE@172..174 "\r\n"
                END_TAG@174..185
                  L_ANGLE_SLASH@174..176 "</"
                  XML_NAME@176..184 "Programs"
                  R_ANGLE@184..185 ">"
        "#]],
    );
}

#[test]
fn a_program_of_the_old_dialect() {
    check(
        "<programList>\n<source><code>begin\n  if n&lt;=1 and s!=&quot;a&lt;&quot;\n  endIf\nend\n      </code></source></programList>\n",
        expect![[r#"
            XML_FILE@0..121
              ELEMENT@0..120
                START_TAG@0..13
                  L_ANGLE@0..1 "<"
                  XML_NAME@1..12 "programList"
                  R_ANGLE@12..13 ">"
                WHITESPACE@13..14 "\n"
                ELEMENT@14..106
                  START_TAG@14..22
                    L_ANGLE@14..15 "<"
                    XML_NAME@15..21 "source"
                    R_ANGLE@21..22 ">"
                  ELEMENT@22..97
                    START_TAG@22..28
                      L_ANGLE@22..23 "<"
                      XML_NAME@23..27 "code"
                      R_ANGLE@27..28 ">"
                    CODE@28..90
                      BEGIN_KW@28..33 "begin"
                      NEWLINE@33..36 "\n  "
                      BLOCK@36..79
                        IF_STMT@36..79
                          IF_KW@36..38 "if"
                          WHITESPACE@38..39 " "
                          BIN_EXPR@39..71
                            BIN_EXPR@39..46
                              NAME_REF@39..40
                                IDENT@39..40 "n"
                              LE@40..45 "&lt;="
                              LITERAL@45..46
                                NUMBER@45..46 "1"
                            WHITESPACE@46..47 " "
                            AND_KW@47..50 "and"
                            WHITESPACE@50..51 " "
                            BIN_EXPR@51..71
                              NAME_REF@51..52
                                IDENT@51..52 "s"
                              NEQ@52..54 "!="
                              LITERAL@54..71
                                STRING@54..71 "&quot;a&lt;&quot;"
                          NEWLINE@71..74 "\n  "
                          BLOCK@74..74
                          END_IF_KW@74..79 "endIf"
                      NEWLINE@79..80 "\n"
                      END_KW@80..83 "end"
                      NEWLINE@83..90 "\n      "
                    END_TAG@90..97
                      L_ANGLE_SLASH@90..92 "</"
                      XML_NAME@92..96 "code"
                      R_ANGLE@96..97 ">"
                  END_TAG@97..106
                    L_ANGLE_SLASH@97..99 "</"
                    XML_NAME@99..105 "source"
                    R_ANGLE@105..106 ">"
                END_TAG@106..120
                  L_ANGLE_SLASH@106..108 "</"
                  XML_NAME@108..119 "programList"
                  R_ANGLE@119..120 ">"
              WHITESPACE@120..121 "\n"
        "#]],
    );
}

#[test]
fn escaped_code_and_plain_code_have_the_same_tokens() {
    use SyntaxKind::*;
    let kinds = [LT, LE, GT, GE, STRING, NEWLINE, IDENT];
    let escaped = kinds_and_texts(
        "<code>begin\na=b&lt;c\na=b&lt;=c\na=b&gt;c&#10;a=b&gt;=&quot;x&quot;+\"&amp;\"\nend</code>",
        &kinds,
    );
    let expected: Vec<_> = [
        (NEWLINE, "\n"),
        (IDENT, "a"),
        (IDENT, "b"),
        (LT, "&lt;"),
        (IDENT, "c"),
        (NEWLINE, "\n"),
        (IDENT, "a"),
        (IDENT, "b"),
        (LE, "&lt;="),
        (IDENT, "c"),
        (NEWLINE, "\n"),
        (IDENT, "a"),
        (IDENT, "b"),
        (GT, "&gt;"),
        (IDENT, "c"),
        (NEWLINE, "&#10;"),
        (IDENT, "a"),
        (IDENT, "b"),
        (GE, "&gt;="),
        (STRING, "&quot;x&quot;"),
        (STRING, "\"&amp;\""),
        (NEWLINE, "\n"),
    ]
    .map(|(kind, text)| (kind, text.to_owned()))
    .into();
    assert_eq!(escaped, expected);
}

#[test]
fn several_stretches_of_code() {
    check(
        "<Code>\n<![CDATA[begin\n  a]]><![CDATA[=1\n]]><!-- note -->  b=2\n<![CDATA[end]]>\n</Code>",
        expect![[r#"
        XML_FILE@0..85
          ELEMENT@0..85
            START_TAG@0..6
              L_ANGLE@0..1 "<"
              XML_NAME@1..5 "Code"
              R_ANGLE@5..6 ">"
            CODE@6..78
              NEWLINE@6..7 "\n"
              CDATA_OPEN@7..16 "<![CDATA["
              BEGIN_KW@16..21 "begin"
              NEWLINE@21..24 "\n  "
              BLOCK@24..61
                ASSIGN_STMT@24..39
                  NAME_REF@24..25
                    IDENT@24..25 "a"
                  CDATA_CLOSE@25..28 "]]>"
                  CDATA_OPEN@28..37 "<![CDATA["
                  EQ@37..38 "="
                  LITERAL@38..39
                    NUMBER@38..39 "1"
                NEWLINE@39..40 "\n"
                CDATA_CLOSE@40..43 "]]>"
                XML_COMMENT@43..56 "<!-- note -->"
                WHITESPACE@56..58 "  "
                ASSIGN_STMT@58..61
                  NAME_REF@58..59
                    IDENT@58..59 "b"
                  EQ@59..60 "="
                  LITERAL@60..61
                    NUMBER@60..61 "2"
              NEWLINE@61..62 "\n"
              CDATA_OPEN@62..71 "<![CDATA["
              END_KW@71..74 "end"
              CDATA_CLOSE@74..77 "]]>"
              NEWLINE@77..78 "\n"
            END_TAG@78..85
              L_ANGLE_SLASH@78..80 "</"
              XML_NAME@80..84 "Code"
              R_ANGLE@84..85 ">"
    "#]],
    );
}

#[test]
fn data_with_entities_and_both_quotes() {
    check(
        "<?xml version='1.0'?>\n<!-- c -->\n<Names><Data name='n\"' value=\"a &gt; &#x41;\"/>text &amp;<![CDATA[<raw>]]></Names>\n",
        expect![[r#"
            XML_FILE@0..115
              XML_INSTRUCTION@0..21 "<?xml version='1.0'?>"
              WHITESPACE@21..22 "\n"
              XML_COMMENT@22..32 "<!-- c -->"
              WHITESPACE@32..33 "\n"
              ELEMENT@33..114
                START_TAG@33..40
                  L_ANGLE@33..34 "<"
                  XML_NAME@34..39 "Names"
                  R_ANGLE@39..40 ">"
                ELEMENT@40..79
                  START_TAG@40..79
                    L_ANGLE@40..41 "<"
                    XML_NAME@41..45 "Data"
                    WHITESPACE@45..46 " "
                    ATTRIBUTE@46..55
                      XML_NAME@46..50 "name"
                      XML_EQ@50..51 "="
                      XML_STRING@51..55 "'n\"'"
                    WHITESPACE@55..56 " "
                    ATTRIBUTE@56..77
                      XML_NAME@56..61 "value"
                      XML_EQ@61..62 "="
                      XML_STRING@62..77 "\"a &gt; &#x41;\""
                    SLASH_R_ANGLE@77..79 "/>"
                XML_TEXT@79..84 "text "
                ENTITY_REF@84..89 "&amp;"
                CDATA_OPEN@89..98 "<![CDATA["
                XML_TEXT@98..103 "<raw>"
                CDATA_CLOSE@103..106 "]]>"
                END_TAG@106..114
                  L_ANGLE_SLASH@106..108 "</"
                  XML_NAME@108..113 "Names"
                  R_ANGLE@113..114 ">"
              WHITESPACE@114..115 "\n"
        "#]],
    );
}

#[test]
fn every_line_end_is_kept() {
    for end in ["\n", "\r\n", "\r", "\n\r\n", "\r\n\n"] {
        let text = ["<Code><![CDATA[begin", "  a=1", "  // c", "  b=2", "end]]></Code>"].join(end);
        assert_eq!(faults_in(&text), "");
        let newlines = tokens(&text).iter().filter(|token| token.kind() == SyntaxKind::NEWLINE).count();
        assert_eq!(newlines, 4, "{end:?}");
    }
}

#[test]
fn blanks_around_the_code_are_trivia() {
    assert_eq!(faults_in("<Code><![CDATA[\n\n  begin\n  a=1\nend\n\n  ]]></Code>"), "");
    assert_eq!(faults_in("<Code>\n  <![CDATA[begin end]]>\n</Code>"), "");
}

#[test]
fn latin1_files() {
    let bytes = b"<?xml version=\"1.0\" encoding=\"iso-8859-1\"?>\n<a b=\"\xa6\xe9\"/>".to_vec();
    let decoded = decode(bytes.clone());
    assert_eq!(faults_in(&decoded.text), "");
    assert_eq!(decoded.encoding.encode(&parsed(&decoded.text).root().text().to_string()), bytes);
}

#[test]
fn names_with_prefixes_and_text_in_any_script() {
    assert_eq!(faults_in("<Programs xmlns:xsi=\"x\"><Parameter xsi:type=\"élément\">日本</Parameter></Programs>"), "");
    assert_eq!(faults_in("<Code><![CDATA[begin\n// 注释\ns=\"é日\"\nend]]></Code>"), "");
}
