//! Expressions and operators.

use expect_test::{Expect, expect};

use crate::show::code;

fn check(code_lines: &str, expected: Expect) {
    let data = "dio dIn\nprogram start()\n  num n\n  num m\n  bool b\n  string s\n  trsf t\n  joint j\n  frame f\n  config c\nbegin\n";
    expected.assert_eq(&code(&format!("{data}{code_lines}\nend")));
}

#[test]
fn results_go_where_they_are_wanted() {
    check(
        "n=n+m*2\ns=s+\"a\"\nn=-(2+3)",
        expect![[r#"
            program start
                file 0 stack 356
                local n num n0
                local m num n1
                local b bool n2
                local s string n3/t0
                local t trsf n3/t1
                local j joint n9/t1
                local f frame n15/t1/l0
                local c config n21/t1/l1
                frame n27/t1/l1
                nums n24=2, n26=-5
            line 15
                Multiply n25 n1 n24
                Add n0 n0 n25
            line 16
                Concatenate t0 t0 "a"
            line 17
                Move n0 n26
            closing 18 at 769 772
                Return
            end
        "#]],
    );
}

#[test]
fn truth_values() {
    check(
        "b=n<m and m>=2\nb=b xor !b\nb=s!=\"x\"\nb=dIn and dIn==true",
        expect![[r#"
            program start
                file 0 stack 356
                local n num n0
                local m num n1
                local b bool n2
                local s string n3/t0
                local t trsf n3/t1
                local j joint n9/t1
                local f frame n15/t1/l0
                local c config n21/t1/l1
                frame n28/t1/l1
                nums n25=2, n27=1
            line 15
                Less n24 n0 n1
                JumpUnless n24 L3
                LessEqual n24 n25 n1
            L3:
                Move n2 n24
            line 16
                Not n24 n2
                NotEqual n2 n2 n24
            line 17
                TextEqual n2 t0 "x"
                Not n2 n2
            line 18
                Line
                Instruction assign bool dio (dio $dIn) -> bool n24
                JumpUnless n24 L13
                Instruction assign bool dio (dio $dIn) -> bool n26
                Equal n24 n26 n27
            L13:
                Move n2 n24
            closing 19 at 799 802
                Return
            end
        "#]],
    );
}

#[test]
fn structures() {
    check(
        "t=t*!t\nj=j+j-j\nb=j<j\nb=f!=f\nb=t==t\nb=c!=c\nn=(t*t).x",
        expect![[r#"
            program start
                file 0 stack 356
                local n num n0
                local m num n1
                local b bool n2
                local s string n3/t0
                local t trsf n3/t1
                local j joint n9/t1
                local f frame n15/t1/l0
                local c config n21/t1/l1
                frame n30/t1/l1
            line 15
                Line
                Instruction unary "!" trsf (trsf n3/t1) -> trsf n24
                Instruction binary "*" trsf (trsf n3/t1, trsf n24) -> trsf n3/t1
            line 16
                Line
                Instruction binary "+" joint (joint n9/t1, joint n9/t1) -> joint n24
                Instruction binary "-" joint (joint n24, joint n9/t1) -> joint n9/t1
            line 17
                Line
                Instruction binary "<" joint (joint n9/t1, joint n9/t1) -> bool n2
            line 18
                Line
                Instruction binary "!=" frame (frame n15/t1/l0, frame n15/t1/l0) -> bool n2
            line 19
                Compare n2 trsf n3/t1 n3/t1
            line 20
                Compare n2 config n21/t1/l1 n21/t1/l1
                Not n2 n2
            line 21
                Line
                Instruction binary "*" trsf (trsf n3/t1, trsf n3/t1) -> trsf n24
                Move n0 n24
            closing 22 at 796 799
                Return
            end
        "#]],
    );
}

#[test]
fn a_left_side_is_read_before_the_right_one_changes_it() {
    check(
        "n=n+get(n)",
        expect![[r#"
            program start
                file 0 stack 356
                local n num n0
                local m num n1
                local b bool n2
                local s string n3/t0
                local t trsf n3/t1
                local j joint n9/t1
                local f frame n15/t1/l0
                local c config n21/t1/l1
                frame n26/t1/l1
            line 15
                Move n24 n0
                Instruction get#2 (num n0) -> num n25
                Add n0 n24 n25
            closing 16 at 755 758
                Return
            end
        "#]],
    );
}
