//! Unbalanced blocks: one mistake causes one error, where a person would correct it.

use expect_test::{Expect, expect};

use crate::show::{broken_tree, faults};

/// All kinds of blocks, nested.
const NESTED: &str = "\
  a=1
  while a
    if b
      x=1
    elseIf c
      x=2
    else
      for i=0 to 9
        y=1
        if d
          z=1
        endIf
      endFor
      u=1
    endIf
    switch n
      case 1
        do
          v=1
          if e
            v=2
          endIf
        until f
      break
      case 2,3
        switch m
          case 1
            w=1
          break
          default
            w=2
          break
        endSwitch
        w=3
      break
      default
        if g
          w=4
        endIf
      break
    endSwitch
    x=3
  endWhile
  y=2";

fn lines() -> Vec<&'static str> {
    NESTED.lines().collect()
}

fn flush_left(lines: &[&str]) -> String {
    lines.iter().map(|line| line.trim_start()).collect::<Vec<_>>().join("\n")
}

fn keyword(line: &str) -> &str {
    line.trim_start().split([' ', '(']).next().unwrap()
}

fn is_end(line: &str) -> bool {
    ["endIf", "endWhile", "endFor", "endSwitch", "until", "break"].contains(&keyword(line))
}

fn is_block_line(line: &str) -> bool {
    is_end(line) || ["if", "elseIf", "else", "while", "do", "for", "switch", "case", "default"].contains(&keyword(line))
}

/// Returns the lines of the errors, from 1.
fn fault_lines(text: &str) -> Vec<usize> {
    faults(text).lines().map(|fault| fault.split(':').next().unwrap().parse().unwrap()).collect()
}

#[test]
fn matching_blocks_have_no_fault_in_any_layout() {
    assert_eq!(faults(NESTED), "");
    assert_eq!(faults(&flush_left(&lines())), "");
    let zigzag: Vec<_> =
        lines().iter().enumerate().map(|(at, line)| format!("{:1$}{2}", "", at * 7 % 5, line.trim_start())).collect();
    assert_eq!(faults(&zigzag.join("\n")), "");
}

#[test]
fn a_missing_end_is_reported_where_it_was() {
    for at in (0..lines().len()).filter(|&at| is_end(lines()[at])) {
        let mut rest = lines();
        let gone = rest.remove(at);
        let text = rest.join("\n");
        assert_eq!(fault_lines(&text), [at + 1], "without {gone:?}\n{}", faults(&text));
    }
}

#[test]
fn a_missing_block_line_causes_one_message() {
    // Without an `elseIf`, `else` or second `case` line, the program is different but correct.
    let needed = |line: &&str| is_block_line(line) && !["elseIf", "else"].contains(&keyword(line));
    for at in (0..lines().len()).filter(|&at| needed(&lines()[at])) {
        let mut rest = lines();
        let gone = rest.remove(at);
        assert_eq!(fault_lines(&rest.join("\n")).len(), 1, "without {gone:?}\n{}", faults(&rest.join("\n")));
        let flat = flush_left(&rest);
        assert_eq!(fault_lines(&flat).len(), 1, "flush left without {gone:?}\n{}", faults(&flat));
    }
}

#[test]
fn a_doubled_end_causes_one_message() {
    for at in (0..lines().len()).filter(|&at| is_end(lines()[at])) {
        let mut more = lines();
        more.insert(at, more[at]);
        let text = more.join("\n");
        let found = fault_lines(&text);
        assert!(found == [at + 1] || found == [at + 2], "{:?} twice\n{}", more[at], faults(&text));
        let flat = flush_left(&more);
        assert_eq!(fault_lines(&flat).len(), 1, "flush left {:?} twice\n{}", more[at], faults(&flat));
    }
}

#[test]
fn a_stray_end_causes_one_message() {
    for stray in ["endIf", "endWhile", "endFor", "endSwitch", "until x", "break", "else", "elseIf x"] {
        for (at, line) in lines().iter().enumerate().filter(|(_, line)| line.trim_start().contains('=')) {
            let indent = line.len() - line.trim_start().len();
            let stray = format!("{:indent$}{stray}", "");
            let mut more = lines();
            more.insert(at, &stray);
            let text = more.join("\n");
            // Some insertions are no syntax error, for example an `else` directly in an `if`.
            let found = fault_lines(&text);
            assert!(found.len() <= 1, "{stray:?} before line {}\n{}", at + 1, faults(&text));
        }
    }
}

#[test]
fn a_wrong_end_causes_one_message() {
    for at in (0..lines().len()).filter(|&at| is_end(lines()[at]) && keyword(lines()[at]) != "break") {
        for wrong in ["endIf", "endWhile", "endFor", "endSwitch"] {
            let indent = lines()[at].len() - lines()[at].trim_start().len();
            let wrong = format!("{:indent$}{wrong}", "");
            let mut other = lines();
            let right = std::mem::replace(&mut other[at], &wrong);
            let text = other.join("\n");
            if keyword(right) != keyword(&wrong) {
                assert_eq!(fault_lines(&text), [at + 1], "{wrong:?} for {right:?}\n{}", faults(&text));
            }
        }
    }
}

#[track_caller]
fn check(lines: &str, expected: Expect) {
    expected.assert_eq(&faults(lines));
}

#[test]
fn the_inner_block_is_the_open_one_if_the_end_lines_up_with_the_outer() {
    check(
        "if a\n  if b\n    x=1\n  y=1\nendIf\nz=1",
        expect![[r#"
        4:3 "y" UnclosedBlock { block: "if", missing: "endIf" } <- 2:3 "if"
    "#]],
    );
    check(
        "if a\n  if b\n    x=1\nendIf\nz=1",
        expect![[r#"
        4:1 "endIf" UnclosedBlock { block: "if", missing: "endIf" } <- 2:3 "if"
    "#]],
    );
}

#[test]
fn an_end_for_a_program_in_the_place_of_a_block_end() {
    check(
        "if a\n  x=1\nend\ny=1",
        expect![[r#"
        3:1 "end" UnclosedBlock { block: "if", missing: "endIf" } <- 1:1 "if"
    "#]],
    );
    check(
        "while a\n  if b\n    x=1\n  end\nendWhile",
        expect![[r#"
        4:3 "end" UnclosedBlock { block: "if", missing: "endIf" } <- 2:3 "if"
    "#]],
    );
}

#[test]
fn an_unclosed_block_at_the_end() {
    check(
        "while a\n  x=1\n",
        expect![[r#"
        4:1 "end" UnclosedBlock { block: "while", missing: "endWhile" } <- 1:1 "while"
    "#]],
    );
    check(
        "x=1\nif a",
        expect![[r#"
        3:1 "end" UnclosedBlock { block: "if", missing: "endIf" } <- 2:1 "if"
    "#]],
    );
    check(
        "switch n\n  case 1\n    x=1\n",
        expect![[r#"
        5:1 "end" MissingBreak <- 2:3 "case"
        5:1 "end" UnclosedBlock { block: "switch", missing: "endSwitch" } <- 1:1 "switch"
    "#]],
    );
}

#[test]
fn two_mistakes_cause_two_messages() {
    check(
        "if a\n  x=1\n\nwhile b\n  y=1\nendWhile\nfor i=0 to 1\n  z=1\n",
        expect![[r#"
        4:1 "while" UnclosedBlock { block: "if", missing: "endIf" } <- 1:1 "if"
        10:1 "end" UnclosedBlock { block: "for", missing: "endFor" } <- 7:1 "for"
    "#]],
    );
}

#[test]
fn a_broken_head_still_opens_its_block() {
    check(
        "if a b\n  x=1\nendIf\nwhile (a\nendWhile\nfor i=\nendFor\nswitch\ncase 1\nbreak\nendSwitch",
        expect![[r#"
        1:6 "b" TrailingText { found: "b" }
        4:9 "" UnclosedBracket { missing: ')' } <- 4:7 "("
        6:7 "" Expected { expected: Expression, found: "" }
        8:7 "" Expected { expected: Expression, found: "" }
    "#]],
    );
}

#[test]
fn a_broken_line_affects_only_that_line() {
    check(
        "a=1\n)x\nb=2\nc=(\nd=4\ne=\"\nf=6",
        expect![[r#"
        2:1 ")" Expected { expected: Statement, found: ")" }
        4:4 "" Expected { expected: Expression, found: "" }
        6:3 "\"" UnterminatedString
    "#]],
    );
    expect![[r#"
        (ASSIGN_STMT (NAME_REF a) = (LITERAL 1))
        (ERROR ) x)
        (ASSIGN_STMT (NAME_REF b) = (LITERAL 2))
        (ASSIGN_STMT (NAME_REF c) = (PAREN_EXPR ())
        (ASSIGN_STMT (NAME_REF d) = (LITERAL 4))
        (ASSIGN_STMT (NAME_REF e) = (LITERAL "))
        (ASSIGN_STMT (NAME_REF f) = (LITERAL 6))
    "#]]
    .assert_eq(&broken_tree("a=1\n)x\nb=2\nc=(\nd=4\ne=\"\nf=6"));
}

#[test]
fn the_tree_of_headless_blocks() {
    expect![[r#"
        (ASSIGN_STMT (NAME_REF x) = (LITERAL 1))
        (IF_STMT
          (ELSE_CLAUSE else
            (BLOCK
              (ASSIGN_STMT (NAME_REF y) = (LITERAL 1)))) endIf)
        (SWITCH_STMT
          (CASE_CLAUSE case (LITERAL 1)
            (BLOCK
              (ASSIGN_STMT (NAME_REF z) = (LITERAL 1))) break) endSwitch)
        (ASSIGN_STMT (NAME_REF u) = (LITERAL 1))
    "#]]
    .assert_eq(&broken_tree("x=1\nelse\n  y=1\nendIf\ncase 1\n  z=1\nbreak\nendSwitch\nu=1"));
}

#[test]
fn one_mistake_causes_one_message() {
    check(
        "f((\"abc",
        expect![[r#"
        1:4 "\"abc" UnterminatedString
    "#]],
    );
    check(
        "if (a and (b\n  x=1 // c\nendIf",
        expect![[r#"
        1:13 "" UnclosedBracket { missing: ')' } <- 1:11 "("
        2:7 "// c" CommentAfterCode
    "#]],
    );
    check(
        "x=(1+[2",
        expect![[r#"
        1:6 "[" Expected { expected: Expression, found: "[" }
    "#]],
    );
    check(
        "movej(pA, tTool, mDesc;",
        expect![[r#"
        1:23 ";" InvalidCharacter { character: ';' }
    "#]],
    );
    check(
        "if a = b then",
        expect![[r#"
        1:6 "=" AssignmentInExpression
        2:1 "end" UnclosedBlock { block: "if", missing: "endIf" } <- 1:1 "if"
    "#]],
    );
    check(
        "call f(1, 2\nx=1",
        expect![[r#"
        1:12 "" UnclosedBracket { missing: ')' } <- 1:7 "("
    "#]],
    );
}

#[test]
fn programs_of_one_file_are_parsed_separately() {
    let extra_end = "<Program><Code><![CDATA[begin\nwhile a\nif b\nendWhile\nendIf\nendWhile\nend]]></Code></Program>";
    let missing_end = "<Program><Code><![CDATA[begin\nif a\n  if b\n    x=1\n  y=1\nendIf\nend]]></Code></Program>";
    let both = format!("<Programs>\n{extra_end}\n{missing_end}\n</Programs>");
    expect![[r#"
        4:1 "endWhile" UnmatchedBlockEnd { found: "endWhile", opener: "while" }
        12:3 "y" UnclosedBlock { block: "if", missing: "endIf" } <- 10:3 "if"
    "#]]
    .assert_eq(&crate::show::faults_in(&both));
}
