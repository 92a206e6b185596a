//! Formatting of code.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::indexing_slicing, reason = "a test may fail loudly")]

use expect_test::{Expect, expect};
use val3_fmt::{CodeStyle, Indent, format, format_range};
use val3_syntax::{TextEdit, TextRange, TextSize, parse};

fn formatted(text: &str, style: &CodeStyle) -> String {
    let parse = parse(text);
    let once = TextEdit::apply_all(text, &format(text, &parse, style));
    let again = TextEdit::apply_all(&once, &format(&once, &val3_syntax::parse(&once), style));
    assert_eq!(again, once, "formatting twice changes it again");
    once
}

/// Formats code in a CDATA section.
fn check(code: &str, expected: Expect) {
    check_in(code, &CodeStyle::default(), expected);
}

fn check_in(code: &str, style: &CodeStyle, expected: Expect) {
    let (head, tail) = ("<Programs><Program name=\"a\"><Code><![CDATA[", "]]></Code></Program></Programs>\n");
    let text = formatted(&format!("{head}{code}{tail}"), style);
    let code = text.strip_prefix(head).and_then(|text| text.strip_suffix(tail)).expect("the XML stays");
    expected.assert_eq(&code.lines().map(|line| visible(line) + "\n").collect::<String>());
}

/// The line with its trailing whitespace as dots.
fn visible(line: &str) -> String {
    let content = line.trim_end();
    content.to_owned() + &"·".repeat(line.len() - content.len())
}

#[test]
fn blocks() {
    check(
        "begin\nif a==1\nb=1\nelseIf a==2\n      b=2\n else\nwhile true\nfor i=0 to 3 step 2\ndo\nx()\nuntil c\nendFor\nendWhile\nendIf\nend",
        expect![[r#"
            begin
              if a==1
                b=1
              elseIf a==2
                b=2
              else
                while true
                  for i=0 to 3 step 2
                    do
                      x()
                    until c
                  endFor
                endWhile
              endIf
            end
        "#]],
    );
}

#[test]
fn switch() {
    check(
        "begin\nswitch a\ncase 1,2\nb=1\nbreak\n// other\ndefault\nb=2\n// done\nbreak\nendSwitch\nend",
        expect![[r#"
            begin
              switch a
                case 1,2
                  b=1
                break
                // other
                default
                  b=2
                // done
                break
              endSwitch
            end
        "#]],
    );
}

#[test]
fn blanks_within_a_line() {
    check(
        "begin\nput ( \"x\" )\na [ 1 ] . x = b+ c *-d - -1\nif(a==1)and  !b or(c)\nendIf\ncall  lib : p ( a , b )\n?  a\nt={1 , ,2}\ntaskCreate  \"n\" , 10 ,p( )\ncase1=true\nend",
        expect![[r#"
            begin
              put("x")
              a[1].x=b+c*-d- -1
              if (a==1) and !b or (c)
              endIf
              call lib:p(a,b)
              ? a
              t={1,,2}
              taskCreate "n",10,p()
              case1=true
            end
        "#]],
    );
}

#[test]
fn keywords_get_their_letter_case() {
    check(
        "BEGIN\nIF TRUE\nWHILE a AND b\nENDWHILE\nElse\nEndif\nEND",
        expect![[r#"
            begin
              if true
                while a and b
                endWhile
              else
              endIf
            end
        "#]],
    );
}

#[test]
fn comments_stay_as_they_are() {
    check(
        "begin\n//  first  \n\n\n\n\n      // second\nif a\n  b=1\n    // in the block\nendIf\nif a\n  b=1\n// before the end\nendIf\n  // last\nend",
        expect![[r#"
            begin
              //  first··


              // second
              if a
                b=1
                // in the block
              endIf
              if a
                b=1
              // before the end
              endIf
              // last
            end
        "#]],
    );
}

#[test]
fn comments_in_the_first_column_are_not_indented() {
    check(
        "begin\n    if a\n//    if b\n//      x = 1\n//    endIf\n  b = 1\n//  b = 2\n    endIf\n//  c = 1\nend",
        expect![[r#"
            begin
              if a
            //    if b
            //      x = 1
            //    endIf
                b=1
            //  b = 2
              endIf
            //  c = 1
            end
        "#]],
    );
}

#[test]
fn comments_of_code_without_indentation_are_indented_with_it() {
    check(
        "begin\n// one\nif a\n// two\nb=1\nendIf\nend",
        expect![[r#"
            begin
              // one
              if a
                // two
                b=1
              endIf
            end
        "#]],
    );
}

#[test]
fn lines_with_syntax_errors_are_kept() {
    check(
        "begin\na = 1\n   b =  = 2 \nc = 3  \nend",
        expect![[r#"
            begin
              a=1
               b =  = 2·
              c=3
            end
        "#]],
    );
}

#[test]
fn unmatched_blocks_keep_their_indentation() {
    check(
        "begin\nif a\n b = 1\nend",
        expect![[r#"
            begin
            if a
             b=1
            end
        "#]],
    );
}

#[test]
fn the_style_can_be_configured() {
    let style = CodeStyle {
        indent: Indent::Blanks(4),
        around_assignment: true,
        around_operators: true,
        after_comma: true,
        blank_lines: 0,
    };
    check_in(
        "begin\n\nfor i=0 to n-1\na=b+f(c,-d)\n\nendFor\nend",
        &style,
        expect![[r#"
            begin
                for i = 0 to n - 1
                    a = b + f(c, -d)
                endFor
            end
        "#]],
    );
    let tabs = CodeStyle { indent: Indent::Tab, ..CodeStyle::default() };
    check_in(
        "begin\n  a=1\nend",
        &tabs,
        expect![[r#"
        begin
        	a=1
        end
    "#]],
    );
}

#[test]
fn escaped_code_and_line_ends_are_kept() {
    let text = "<program><source><code>begin\r\nif a &lt; 1 and s == &quot;x&quot;\r\n b = 1\rendIf\nend</code></source></program>";
    let expected = "<program><source><code>begin\r\n  if a&lt;1 and s==&quot;x&quot;\r\n    b=1\r  endIf\nend</code></source></program>";
    assert_eq!(formatted(text, &CodeStyle::default()), expected);
}

#[test]
fn the_xml_before_the_code_is_kept() {
    let text = "<Programs><Program name=\"a\"><Code><![CDATA[ \n begin\na = 1\nend \n\n]]></Code></Program></Programs>";
    let expected =
        "<Programs><Program name=\"a\"><Code><![CDATA[ \n begin\n  a=1\nend \n\n]]></Code></Program></Programs>";
    assert_eq!(formatted(text, &CodeStyle::default()), expected);
}

#[test]
fn only_lines_of_the_range_change() {
    assert_eq!(formatted_part("2"), "begin\n a = 1\n  b=2\n c = 3\nend");
    assert_eq!(formatted_part(" b = 2\n"), "begin\n a = 1\n  b=2\n c = 3\nend");
    assert_eq!(formatted_part("1\n b"), "begin\n  a=1\n  b=2\n c = 3\nend");
}

/// Code of a program after formatting the range of `part`.
fn formatted_part(part: &str) -> String {
    let text = "<Programs><Program name=\"a\"><Code><![CDATA[begin\n a = 1\n b = 2\n c = 3\nend]]></Code></Program></Programs>";
    let start = TextSize::try_from(text.find(part).unwrap()).unwrap();
    let edits = format_range(text, &parse(text), &CodeStyle::default(), TextRange::at(start, TextSize::of(part)));
    TextEdit::apply_all(text, &edits).split_once("CDATA[").unwrap().1.replace("]]></Code></Program></Programs>", "")
}
