//! All kinds of errors in code, with their exact ranges. Line 0 is the line with `begin`.

use expect_test::{Expect, expect};

use crate::show::{broken_tree, faults, faults_in, program};

#[track_caller]
fn check(lines: &str, expected: Expect) {
    expected.assert_eq(&faults(lines));
}

#[track_caller]
fn check_file(text: &str, expected: Expect) {
    expected.assert_eq(&faults_in(text));
}

#[test]
fn expected_expression() {
    check(
        "x=\nx=1+\nif\nendIf\nf(1,)\nx=a[]\nx=* 2\n?",
        expect![[r#"
        1:3 "" Expected { expected: Expression, found: "" }
        2:5 "" Expected { expected: Expression, found: "" }
        3:3 "" Expected { expected: Expression, found: "" }
        5:5 ")" Expected { expected: Expression, found: ")" }
        6:5 "]" Expected { expected: Expression, found: "]" }
        7:3 "*" Expected { expected: Expression, found: "*" }
        8:2 "" Expected { expected: Expression, found: "" }
    "#]],
    );
    check(
        "x=()",
        expect![[r#"
        1:4 ")" Expected { expected: Expression, found: ")" }
    "#]],
    );
    check(
        "x=-",
        expect![[r#"
        1:4 "" Expected { expected: Expression, found: "" }
    "#]],
    );
    check(
        "while\nendWhile\nswitch\nendSwitch\ndo\nuntil",
        expect![[r#"
        1:6 "" Expected { expected: Expression, found: "" }
        3:7 "" Expected { expected: Expression, found: "" }
        6:6 "" Expected { expected: Expression, found: "" }
    "#]],
    );
}

#[test]
fn expected_name() {
    check(
        "for 1=0 to 2\nendFor\nfor =0 to 2\nendFor",
        expect![[r#"
            1:5 "1" Expected { expected: Name, found: "1" }
            3:5 "=" Expected { expected: Name, found: "=" }
        "#]],
    );
}

#[test]
fn expected_field() {
    check(
        "x=a.\nx=a.1\nx=a.if",
        expect![[r#"
        1:5 "" Expected { expected: Field, found: "" }
        2:4 ".1" TrailingText { found: ".1" }
        3:5 "if" Expected { expected: Field, found: "if" }
    "#]],
    );
}

#[test]
fn expected_program() {
    check(
        "call\ncall 1()\ncall lib:()\nx=lib:",
        expect![[r#"
        1:5 "" Expected { expected: Program, found: "" }
        2:6 "1" Expected { expected: Program, found: "1" }
        3:10 "(" Expected { expected: Program, found: "(" }
        4:7 "" Expected { expected: Program, found: "" }
    "#]],
    );
}

#[test]
fn expected_statement() {
    check(
        "*a\nbegin\n)\n= 1",
        expect![[r#"
        1:1 "*" Expected { expected: Statement, found: "*" }
        2:1 "begin" Expected { expected: Statement, found: "begin" }
        3:1 ")" Expected { expected: Statement, found: ")" }
        4:1 "=" Expected { expected: Statement, found: "=" }
    "#]],
    );
}

#[test]
fn expected_parts_of_for() {
    check(
        "for i\nendFor\nfor i=1\nendFor\nfor i=1 to 2 step\nendFor\nfor i=1 2\nendFor",
        expect![[r#"
        1:6 "" Expected { expected: ForAssign, found: "" }
        3:8 "" Expected { expected: ForTo, found: "" }
        5:18 "" Expected { expected: ForStep, found: "" }
        7:9 "2" Expected { expected: ForTo, found: "2" }
    "#]],
    );
}

#[test]
fn expected_open_paren() {
    check(
        "call p\ncall lib:p 1",
        expect![[r#"
        1:7 "" Expected { expected: OpenParen, found: "" }
        2:12 "1" Expected { expected: OpenParen, found: "1" }
    "#]],
    );
}

#[test]
fn expected_comma() {
    check(
        "taskCreate \"t\"\ntaskCreate \"t\" 10, p()\ntaskCreateSync \"t\",1,p()",
        expect![[r#"
        1:15 "" Expected { expected: Comma, found: "" }
        2:16 "10" Expected { expected: Comma, found: "10" }
        3:25 "" Expected { expected: Comma, found: "" }
    "#]],
    );
}

#[test]
fn expected_assignment_or_call() {
    check(
        "movej p, t, m\nwait 1\nx y=1\nlib:p 2",
        expect![[r#"
        1:7 "p" Expected { expected: AssignmentOrCall, found: "p" }
        2:6 "1" Expected { expected: AssignmentOrCall, found: "1" }
        3:3 "y" Expected { expected: AssignmentOrCall, found: "y" }
        4:7 "2" Expected { expected: AssignmentOrCall, found: "2" }
    "#]],
    );
}

#[test]
fn expected_case_value() {
    check(
        "switch n\ncase\nbreak\ncase 1,\nbreak\nendSwitch",
        expect![[r#"
        2:5 "" Expected { expected: CaseValue, found: "" }
        4:8 "" Expected { expected: CaseValue, found: "" }
    "#]],
    );
}

#[test]
fn invalid_character() {
    check(
        "x=1;\ny='a'\nz=é日+1\nx=a@b\nx=\u{0}",
        expect![[r#"
        1:4 ";" InvalidCharacter { character: ';' }
        2:3 "'" InvalidCharacter { character: '\'' }
        3:3 "é日" InvalidCharacter { character: 'é' }
        4:4 "@" InvalidCharacter { character: '@' }
        5:3 "\0" InvalidCharacter { character: '\0' }
    "#]],
    );
}

#[test]
fn one_message_for_the_characters_of_a_line() {
    check(
        "x=1; y=2; z=3;\ns=“a”",
        expect![[r#"
        1:4 ";" InvalidCharacter { character: ';' }
        2:3 "“" InvalidCharacter { character: '“' }
    "#]],
    );
}

#[test]
fn unclosed_bracket() {
    check(
        "x=(1\nx=a[1\nf(a, b\nx={1, 2\nif (a\nendIf\nx=a[1)\nx=f(a]",
        expect![[r#"
        1:5 "" UnclosedBracket { missing: ')' } <- 1:3 "("
        2:6 "" UnclosedBracket { missing: ']' } <- 2:4 "["
        3:7 "" UnclosedBracket { missing: ')' } <- 3:2 "("
        4:8 "" UnclosedBracket { missing: '}' } <- 4:3 "{"
        5:6 "" UnclosedBracket { missing: ')' } <- 5:4 "("
        7:6 ")" UnclosedBracket { missing: ']' } <- 7:4 "["
        8:6 "]" UnclosedBracket { missing: ')' } <- 8:4 "("
    "#]],
    );
}

#[test]
fn unmatched_bracket() {
    check(
        "x=1)\nf(a))\nx=a]\nx={1}}",
        expect![[r#"
        1:4 ")" UnmatchedBracket { bracket: ')' }
        2:5 ")" UnmatchedBracket { bracket: ')' }
        3:4 "]" UnmatchedBracket { bracket: ']' }
        4:6 "}" UnmatchedBracket { bracket: '}' }
    "#]],
    );
}

#[test]
fn numbers_beyond_the_range() {
    check(
        "n=1e400\nn=-2.5E+309+1e308\nn=1.7976931348623157e308\nn=1e-400",
        expect![[r#"
        1:3 "1e400" NumberTooLarge
        2:4 "2.5E+309" NumberTooLarge
    "#]],
    );
}

#[test]
fn unterminated_string() {
    check(
        "s=\"abc\nf(\"a, b)\nif s==\"x\n  y=1\nendIf",
        expect![[r#"
        1:3 "\"abc" UnterminatedString
        2:3 "\"a, b)" UnterminatedString
        3:7 "\"x" UnterminatedString
    "#]],
    );
    check_file(
        "<code>begin\n  s=&quot;abc\n  s=\"abc\nend</code>",
        expect![[r#"
        1:5 "&quot;abc" UnterminatedString
        2:5 "\"abc" UnterminatedString
    "#]],
    );
}

#[test]
fn break_and_case_outside_switch() {
    check(
        "break\nif a\n  break\nendIf",
        expect![[r#"
        1:1 "break" BreakOutsideSwitch
        3:3 "break" BreakOutsideSwitch
    "#]],
    );
    check(
        "case 1\n  x=1\nbreak\ndefault\nbreak\nendSwitch\ny=1",
        expect![[r#"
        1:1 "case" CaseOutsideSwitch
    "#]],
    );
}

#[test]
fn cases_out_of_order() {
    check(
        "switch n\n  default\n  break\n  case 1\n  break\n  default\n  break\nendSwitch",
        expect![[r#"
            4:3 "case" CaseAfterDefault <- 2:3 "default"
        "#]],
    );
}

#[test]
fn statement_before_case() {
    check(
        "switch n\n  x=1\n  y=1\n  case 1\n  break\nendSwitch",
        expect![[r#"
        2:3 "x" StatementBeforeCase
    "#]],
    );
    check(
        "switch n\n  x=1\n  break\n  case 1\n  break\nendSwitch",
        expect![[r#"
        2:3 "x" StatementBeforeCase
    "#]],
    );
}

#[test]
fn else_after_else() {
    check(
        "if a\nelse\nelse\nelseIf b\nendIf",
        expect![[r#"
            3:1 "else" ElseAfterElse <- 2:1 "else"
        "#]],
    );
}

#[test]
fn double_unary() {
    check(
        "x=--1\nx=!-b\nx=a - --1",
        expect![[r#"
        1:3 "--" DoubleUnary
        2:3 "!-" DoubleUnary
        3:7 "--" DoubleUnary
    "#]],
    );
}

#[test]
fn assignment_in_expression() {
    check(
        "if a=b\nendIf\nf(a=1)\nwhile (a=b)\nendWhile\nx=a[i=1]\nx=y+(z=2)",
        expect![[r#"
        1:5 "=" AssignmentInExpression
        3:4 "=" AssignmentInExpression
        4:9 "=" AssignmentInExpression
        6:6 "=" AssignmentInExpression
        7:7 "=" AssignmentInExpression
    "#]],
    );
}

#[test]
fn comment_after_code() {
    check(
        "x=1 // one\nif a // b\nendIf",
        expect![[r#"
        1:5 "// one" CommentAfterCode
        2:6 "// b" CommentAfterCode
    "#]],
    );
}

#[test]
fn reserved_word() {
    check(
        "x=if\nfor=1\nx=a+end\nf(step1, begin)",
        expect![[r#"
        1:3 "if" ReservedWord { word: "if" }
        2:4 "=" Expected { expected: Name, found: "=" }
        3:5 "end" ReservedWord { word: "end" }
        4:10 "begin" ReservedWord { word: "begin" }
        5:1 "end" UnclosedBlock { block: "for", missing: "endFor" } <- 2:1 "for"
    "#]],
    );
}

#[test]
fn foreign_spelling() {
    check(
        "if a && b || c\nendIf\nif a<>b then\nendIf\nx=not a",
        expect![[r#"
            1:6 "&&" ForeignSpelling { found: "&&", instead: "and" }
            3:5 "<>" ForeignSpelling { found: "<>", instead: "!=" }
            5:3 "not" ForeignSpelling { found: "not", instead: "!" }
        "#]],
    );
    check(
        "if a\n  x=1\nelse if b\n  x=2\nelse\n  x=3\nendIf",
        expect![[r#"
            3:1 "else if" ForeignSpelling { found: "else if", instead: "elseIf" }
        "#]],
    );
}

#[test]
fn blocks_that_end_as_in_other_languages() {
    check(
        "if a\n  x=1\nelsif (b)\n  x=2\nelif c\n  x=3\nend if\nwhile a do\nwend\nfor i=0 to 1\nEnd  For",
        expect![[r#"
            3:1 "elsif" ForeignSpelling { found: "elsif", instead: "elseIf" }
            5:1 "elif" ForeignSpelling { found: "elif", instead: "elseIf" }
            7:1 "end if" ForeignSpelling { found: "end if", instead: "endIf" }
            8:9 "do" ForeignSpelling { found: "do", instead: "" }
            9:1 "wend" ForeignSpelling { found: "wend", instead: "endWhile" }
            11:1 "End  For" ForeignSpelling { found: "End  For", instead: "endFor" }
        "#]],
    );
    check(
        "if a\n  end=1\nendIf\nelif=2\nwend[1]=2\nelsif.x=wend",
        expect![[r#"
        2:3 "end" CodeOutsideBody
    "#]],
    );
}

#[test]
fn brackets_that_do_not_match_up() {
    check(
        "x=f({1,g(a[1],2))})\ny=f(a,(b+c,d)\nz=f(a[1),b]\nx=a[f(1]+1]",
        expect![[r#"
        1:17 ")" UnmatchedBracket { bracket: ')' }
        2:11 "," UnclosedBracket { missing: ')' } <- 2:7 "("
        3:8 ")" UnclosedBracket { missing: ']' } <- 3:6 "["
        4:8 "]" UnclosedBracket { missing: ')' } <- 4:6 "("
    "#]],
    );
}

#[test]
fn foreign_spelling_in_escaped_code() {
    check_file(
        "<code>begin\nx=a &amp;&amp; b\nx=a&lt;&gt;b\nend</code>",
        expect![[r#"
            1:5 "&amp;&amp;" ForeignSpelling { found: "&&", instead: "and" }
            2:4 "&lt;&gt;" ForeignSpelling { found: "<>", instead: "!=" }
        "#]],
    );
}

#[test]
fn trailing_text() {
    check(
        "x=1 2\nf(a b)\nf(a b, c) + 1\nendIf2=1 x\nx=(1 2)\nif a do\nendIf",
        expect![[r#"
            1:5 "2" TrailingText { found: "2" }
            2:5 "b" TrailingText { found: "b" } <- 2:2 "("
            3:5 "b" TrailingText { found: "b" } <- 3:2 "("
            4:10 "x" TrailingText { found: "x" }
            5:6 "2" TrailingText { found: "2" } <- 5:3 "("
            6:6 "do" ForeignSpelling { found: "do", instead: "" }
        "#]],
    );
}

#[test]
fn return_value() {
    check(
        "return 1\nreturn (x",
        expect![[r#"
        1:8 "1" ReturnValue
        2:8 "(" ReturnValue
    "#]],
    );
}

#[test]
fn missing_begin_and_end() {
    check_file(
        &program("x=1\nend"),
        expect![[r#"
        0:44 "x" MissingBegin
    "#]],
    );
    check_file(
        &program("begin\nx=1\n"),
        expect![[r#"
        1:4 "" MissingEnd
    "#]],
    );
    check_file(
        &program("begin\nx=1\nend\nend"),
        expect![[r#"
        2:1 "end" CodeOutsideBody
    "#]],
    );
    check_file(
        &program("begin\nif a\nx=1\nend"),
        expect![[r#"
        3:1 "end" UnclosedBlock { block: "if", missing: "endIf" } <- 1:1 "if"
    "#]],
    );
}

#[test]
fn code_outside_the_body() {
    check_file(
        &program("x=1\ny=2\nbegin\nz=1\nend"),
        expect![[r#"
        0:44 "x=1\ny=2" CodeOutsideBody
    "#]],
    );
    check_file(
        &program("begin\nz=1\nend\nx=1\ny=2\n"),
        expect![[r#"
        3:1 "x=1\ny=2" CodeOutsideBody
    "#]],
    );
    check_file(
        &program("begin\nz=1\nend\nx=1\nend"),
        expect![[r#"
        2:1 "end" CodeOutsideBody
    "#]],
    );
}

#[test]
fn no_code() {
    check_file(
        &program(""),
        expect![[r#"
        0:29 "<Code" NoCode
    "#]],
    );
    check_file(
        &program("\n  // nothing\n"),
        expect![[r#"
        0:29 "<Code" NoCode
    "#]],
    );
    check_file(
        "<Code></Code>",
        expect![[r#"
        0:1 "<Code" NoCode
    "#]],
    );
}

#[test]
fn nesting_too_deep() {
    let deep = format!("x={}1{}\ny=)", "(".repeat(300), ")".repeat(300));
    check(
        &deep,
        expect![[r#"
        1:199 "(" NestingTooDeep
        2:3 ")" Expected { expected: Expression, found: ")" }
    "#]],
    );
}

#[test]
fn the_rest_of_a_broken_line_does_not_hide_the_next() {
    expect![[r#"
        (EXPR_STMT (CALL_EXPR (NAME_REF f) (ARG_LIST ( (NAME_REF a) (ERROR b , c) ))))
        (ASSIGN_STMT (NAME_REF x) = (PAREN_EXPR ( (LITERAL 1)))
        (ASSIGN_STMT (NAME_REF y) = (LITERAL 2))
        (ERROR * 3)
        (ASSIGN_STMT (NAME_REF z) = (BIN_EXPR (PAREN_EXPR ( (LITERAL 4) (ERROR 5) )) + (LITERAL 6)))
    "#]]
    .assert_eq(&broken_tree("f(a b, c)\nx=(1\ny=2\n* 3\nz=(4 5)+6"));
}
