//! Statements that jump, and their instruction lines (2.2.5).

use expect_test::{Expect, expect};

use crate::show::code;

fn check(code_lines: &str, expected: Expect) {
    let data = "num nX\nprogram start()\n  num i\n  bool b\n  string s\nbegin\n";
    expected.assert_eq(&code(&format!("{data}{code_lines}\nend")));
}

#[test]
fn conditions_jump_where_they_are_decided() {
    check(
        "if i>3 and nX!=4\ni=1\nelseIf i==2 or b\ni=2\nelse\ni=3\nendIf",
        expect![[r#"
            i n0/t0/l0, b n1/t0/l0, s n2/t0/l0, n2=3, n4=4, n5=1, n6=2
               1     0  UnlessLess { a: 2, b: 0, to: 5 }
                     1  LoadFirst { to: 3, container: Data(0), lane: 0 }
                     2  IfEqual { a: 3, b: 4, to: 5 }
               2     3  Move { to: 0, from: 5 }
                     4  Jump { to: 10 }
               3     5  IfEqual { a: 0, b: 6, to: 7 }
                     6  JumpUnless { condition: 1, to: 9 }
               4     7  Move { to: 0, from: 6 }
                     8  Jump { to: 10 }
               5     9  Move { to: 0, from: 2 }
                    10  Return
        "#]],
    );
}

#[test]
fn contraries_cost_nothing() {
    check(
        "if !(i<3)\ni=1\nendIf\nif b==false\ni=2\nendIf\nif !(b or i>=1)\ni=3\nendIf",
        expect![[r#"
            i n0/t0/l0, b n1/t0/l0, s n2/t0/l0, n2=3, n3=1, n4=2
               1     0  IfLess { a: 0, b: 2, to: 2 }
               2     1  Move { to: 0, from: 3 }
               3     2  JumpIf { condition: 1, to: 4 }
               4     3  Move { to: 0, from: 4 }
               5     4  JumpIf { condition: 1, to: 7 }
                     5  IfLessEqual { a: 3, b: 0, to: 7 }
               6     6  Move { to: 0, from: 2 }
                     7  Return
        "#]],
    );
}

#[test]
fn loops() {
    check(
        "while i<5\ni=i+1\nendWhile\ndo\ni=i-1\nuntil i<=0",
        expect![[r#"
            i n0/t0/l0, b n1/t0/l0, s n2/t0/l0, n2=1, n3=5
                     0  Jump { to: 2 }
               2     1  Add { to: 0, a: 0, b: 2 }
               1     2  IfLess { a: 0, b: 3, to: 1 }
               3     3  Subtract { to: 0, a: 0, b: 2 }
               4     4  UnlessLessEqual { a: 0, b: 4, to: 3 }
                     5  Return
        "#]],
    );
}

#[test]
fn the_counter_of_a_loop_may_be_any_variable() {
    check(
        "for i=1 to nX step -2\nb=true\nendFor",
        expect![[r#"
            i n0/t0/l0, b n1/t0/l0, s n2/t0/l0, n4=1, n5=-2
               1     0  LoadFirst { to: 2, container: Data(0), lane: 0 }
                     1  Move { to: 3, from: 5 }
                     2  Move { to: 0, from: 4 }
                     3  ForTest { counter: 0, limit: 2, exit: 6 }
               2     4  Move { to: 1, from: 4 }
                     5  ForNext { counter: 0, limit: 2, body: 4 }
                     6  Return
        "#]],
    );
    check(
        "for nX=1 to 10\nb=true\nendFor",
        expect![[r#"
            i n0/t0/l0, b n1/t0/l0, s n2/t0/l0, n2=10, n3=1, n5=1
               1     0  Move { to: 4, from: 5 }
                     1  ForTest { counter: 4, limit: 2, exit: 7 }
                     2  StoreFirst { container: Data(0), lane: 0, from: 4 }
               2     3  Move { to: 1, from: 5 }
                     4  LoadFirst { to: 6, container: Data(0), lane: 0 }
                     5  Move { to: 4, from: 6 }
                     6  ForNextUp { counter: 4, limit: 2, body: 2 }
                     7  StoreFirst { container: Data(0), lane: 0, from: 4 }
                     8  Return
        "#]],
    );
}

#[test]
fn cases_are_compared_one_after_the_other() {
    check(
        "switch i+1\ncase 1,2\nreturn\nbreak\ncase -3\ni=0\nbreak\ndefault\nb=true\nbreak\nendSwitch",
        expect![[r#"
            i n0/t0/l0, b n1/t0/l0, s n2/t0/l0, n2=1, n4=2, n5=-3
               1     0  Add { to: 3, a: 0, b: 2 }
                     1  IfEqual { a: 3, b: 2, to: 5 }
                     2  IfEqual { a: 3, b: 4, to: 5 }
                     3  IfEqual { a: 3, b: 5, to: 7 }
                     4  Jump { to: 9 }
               2     5  Return
                     6  Jump { to: 11 }
               3     7  Move { to: 0, from: 6 }
                     8  Jump { to: 11 }
               4     9  Move { to: 1, from: 2 }
                    10  Jump { to: 11 }
                    11  Return
        "#]],
    );
    check(
        "switch s\ncase \"a\"\ni=0\nbreak\nendSwitch",
        expect![[r#"
            i n0/t0/l0, b n1/t0/l0, s n2/t0/l0
               1     0  IfTextEqual { a: Register(0), b: Constant(0), to: 2 }
                     1  Jump { to: 4 }
               2     2  Move { to: 0, from: 2 }
                     3  Jump { to: 4 }
                     4  Return
        "#]],
    );
}

#[test]
fn waiting_computes_the_condition_anew() {
    check(
        "wait(i>3 or b)\nb=watch(nX==2,i+1)\nwatch(b,0)",
        expect![[r#"
            i n0/t0/l0, b n1/t0/l0, s n2/t0/l0, n3=3, n4=1, n7=2
               1     0  Line
                     1  Less { to: 2, a: 3, b: 0 }
                     2  JumpIf { condition: 2, to: 4 }
                     3  Move { to: 2, from: 1 }
                     4  WaitUntil { condition: 2, retry: 1 }
               2     5  Add { to: 2, a: 0, b: 4 }
                     6  Move { to: 5, from: 2 }
                     7  LoadFirst { to: 6, container: Data(0), lane: 0 }
                     8  Equal { to: 8, a: 6, b: 7 }
                     9  Watch { to: 1, condition: 8, seconds: 5, retry: 7 }
               3    10  Move { to: 2, from: 9 }
                    11  Watch { to: 5, condition: 1, seconds: 2, retry: 11 }
                    12  Return
        "#]],
    );
}
