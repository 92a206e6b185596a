//! Formatting during typing.

#![allow(clippy::unwrap_used, clippy::expect_used, reason = "a test may fail loudly")]

use expect_test::{Expect, expect};
use val3_fmt::{CodeStyle, Indent, on_type};
use val3_syntax::{TextEdit, TextSize, parse};

/// Types the character before `$0` in code in a CDATA section.
fn check(code: &str, expected: Expect) {
    check_in(code, &CodeStyle::default(), expected);
}

fn check_in(code: &str, style: &CodeStyle, expected: Expect) {
    let (head, tail) = ("<Programs>\n  <Program name=\"a\">\n    <Code><![CDATA[", "]]></Code></Program></Programs>\n");
    let marked = format!("{head}{code}{tail}");
    let offset = marked.find("$0").expect("a cursor");
    let text = marked.replacen("$0", "", 1);
    let typed = text[..offset].chars().next_back().unwrap();
    let edits = on_type(&text, &parse(&text), style, TextSize::try_from(offset).unwrap(), typed);
    let changed = TextEdit::apply_all(&text, &edits);
    let code = changed.strip_prefix(head).and_then(|text| text.strip_suffix(tail)).expect("the XML stays");
    expected.assert_eq(&(code.replace(' ', "·").replace('\r', "␍").replace('\t', "→") + "\n"));
}

#[test]
fn a_line_after_an_opening_keyword_is_indented() {
    check(
        "begin\n  if a\n$0\nend",
        expect![[r#"
        begin
        ··if·a
        ····
        end
    "#]],
    );
    check(
        "begin\n$0end",
        expect![[r#"
        begin
        end
    "#]],
    );
    check(
        "begin\n  a=1\n$0  b=2\nend",
        expect![[r#"
        begin
        ··a=1
        ··b=2
        end
    "#]],
    );
    check(
        "begin\n  switch a\n    case 1\n$0",
        expect![[r#"
        begin
        ··switch·a
        ····case·1
        ······
    "#]],
    );
    check_in(
        "begin\n\twhile a\n$0",
        &CodeStyle { indent: Indent::Tab, ..CodeStyle::default() },
        expect![[r#"
            begin
            →while·a
            →→
        "#]],
    );
}

#[test]
fn the_completed_line_is_formatted() {
    check(
        "begin\n  If a = =1\n$0\nend",
        expect![[r#"
        begin
        ··If·a·=·=1
        ····
        end
    "#]],
    );
    check(
        "begin\n  a = b +1\n$0\nend",
        expect![[r#"
        begin
        ··a=b+1
        ··
        end
    "#]],
    );
    check(
        "begin\n  if a\n    b=1\n    EndIf\n$0\nend",
        expect![[r#"
        begin
        ··if·a
        ····b=1
        ··endIf
        ··
        end
    "#]],
    );
    check(
        "begin\n  if a\n    b=1\n    end\n$0",
        expect![[r#"
        begin
        ··if·a
        ····b=1
        end

    "#]],
    );
}

#[test]
fn closing_keywords_align_with_their_block() {
    check(
        "begin\n  if a\n    while b\n    endWhile\n    endif$0\nend",
        expect![[r#"
        begin
        ··if·a
        ····while·b
        ····endWhile
        ··endIf
        end
    "#]],
    );
    check(
        "begin\n  if a\n    if b\n    endIf\n    else$0\n  endIf\nend",
        expect![[r#"
        begin
        ··if·a
        ····if·b
        ····endIf
        ··else
        ··endIf
        end
    "#]],
    );
    check(
        "begin\n  do\n    a=1\n    until$0\nend",
        expect![[r#"
        begin
        ··do
        ····a=1
        ··until
        end
    "#]],
    );
    check(
        "begin\n  switch a\n    case 1\n      b=1\n      break$0\nend",
        expect![[r#"
        begin
        ··switch·a
        ····case·1
        ······b=1
        ····break
        end
    "#]],
    );
    check(
        "begin\n  switch a\n    case 1\n      switch c\n        case 1\n        break\n      endSwitch\n    break\n  case$0\nend",
        expect![[r#"
        begin
        ··switch·a
        ····case·1
        ······switch·c
        ········case·1
        ········break
        ······endSwitch
        ····break
        ····case
        end
    "#]],
    );
    check(
        "begin\n  switch a\n    case 1\n    break\n    endswitch$0\nend",
        expect![[r#"
        begin
        ··switch·a
        ····case·1
        ····break
        ··endSwitch
        end
    "#]],
    );
}

#[test]
fn other_words_keep_their_indentation() {
    check(
        "begin\n  if a\n    nElse$0\nend",
        expect![[r#"
        begin
        ··if·a
        ····nElse
        end
    "#]],
    );
    check(
        "begin\n  if a\n    // else$0\nend",
        expect![[r#"
        begin
        ··if·a
        ····//·else
        end
    "#]],
    );
    check(
        "begin\n  if a\n    put(\"else$0\")\nend",
        expect![[r#"
        begin
        ··if·a
        ····put("else")
        end
    "#]],
    );
    check(
        "begin\n  if a\n    endif$0 b\nend",
        expect![[r#"
        begin
        ··if·a
        ····endif·b
        end
    "#]],
    );
    check(
        "begin\n  if a\n    end$0\nend",
        expect![[r#"
        begin
        ··if·a
        ····end
        end
    "#]],
    );
}

#[test]
fn other_lines_are_indented_like_the_line_above() {
    check(
        "begin\n    a=1\n  endif$0\nend",
        expect![[r#"
        begin
        ····a=1
        ····endif
        end
    "#]],
    );
}

#[test]
fn windows_line_ends_are_kept() {
    check(
        "begin\r\n  if a\r\n$0\r\nend",
        expect![[r#"
        begin␍
        ··if·a␍
        ····␍
        end
    "#]],
    );
}

#[test]
fn xml_is_not_changed() {
    let text = "<Programs>\n\n<Program name=\"a\"><Code><![CDATA[begin\nend]]></Code></Program></Programs>\n\n";
    for offset in [11, 12, text.len()] {
        let offset = TextSize::try_from(offset).unwrap();
        assert_eq!(on_type(text, &parse(text), &CodeStyle::default(), offset, '\n'), []);
    }
}
