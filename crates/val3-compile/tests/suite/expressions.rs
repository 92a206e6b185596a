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
            n n0/t0/l0, m n1/t0/l0, b n2/t0/l0, s n3/t0/l0, t n3/t1/l0, j n9/t1/l0, f n15/t1/l0, c n21/t1/l1, n24=2, n26=-5
               1     0  Multiply { to: 25, a: 1, b: 24 }
                     1  Add { to: 0, a: 0, b: 25 }
               2     2  Concatenate { to: Register(0), a: Register(0), b: Constant(0) }
               3     3  Move { to: 0, from: 26 }
                     4  Return
        "#]],
    );
}

#[test]
fn truth_values() {
    check(
        "b=n<m and m>=2\nb=b xor !b\nb=s!=\"x\"\nb=dIn and dIn==true",
        expect![[r#"
            n n0/t0/l0, m n1/t0/l0, b n2/t0/l0, s n3/t0/l0, t n3/t1/l0, j n9/t1/l0, f n15/t1/l0, c n21/t1/l1, n25=2, n27=1
               1     0  Less { to: 24, a: 0, b: 1 }
                     1  JumpUnless { condition: 24, to: 3 }
                     2  LessEqual { to: 24, a: 25, b: 1 }
                     3  Move { to: 2, from: 24 }
               2     4  Not { to: 24, a: 2 }
                     5  NotEqual { to: 2, a: 2, b: 24 }
               3     6  TextEqual { to: 2, a: Register(0), b: Constant(0) }
                     7  Not { to: 2, a: 2 }
               4     8  Line
                     9  Instruction =(dio Data(0)) -> n24/t0/l0
                    10  JumpUnless { condition: 24, to: 13 }
                    11  Instruction =(dio Data(0)) -> n26/t0/l0
                    12  Equal { to: 24, a: 26, b: 27 }
                    13  Move { to: 2, from: 24 }
                    14  Return
        "#]],
    );
}

#[test]
fn structures() {
    check(
        "t=t*!t\nj=j+j-j\nb=j<j\nb=f!=f\nb=t==t\nb=c!=c\nn=(t*t).x",
        expect![[r#"
            n n0/t0/l0, m n1/t0/l0, b n2/t0/l0, s n3/t0/l0, t n3/t1/l0, j n9/t1/l0, f n15/t1/l0, c n21/t1/l1
               1     0  Line
                     1  Instruction !(trsf n3) -> n24/t0/l0
                     2  Instruction *(trsf n3, trsf n24) -> n3/t1/l0
               2     3  Line
                     4  Instruction +(joint n9, joint n9) -> n24/t0/l0
                     5  Instruction -(joint n24, joint n9) -> n9/t1/l0
               3     6  Line
                     7  Instruction <(joint n9, joint n9) -> n2/t0/l0
               4     8  Line
                     9  Instruction !=(frame n15/l0, frame n15/l0) -> n2/t0/l0
               5    10  Compare n2, n3 from n3
               6    11  Compare n2, n21 from n21
                    12  Not { to: 2, a: 2 }
               7    13  Line
                    14  Instruction *(trsf n3, trsf n3) -> n24/t0/l0
                    15  Move { to: 0, from: 24 }
                    16  Return
        "#]],
    );
}

#[test]
fn a_left_side_is_read_before_the_right_one_changes_it() {
    check(
        "n=n+get(n)",
        expect![[r#"
            n n0/t0/l0, m n1/t0/l0, b n2/t0/l0, s n3/t0/l0, t n3/t1/l0, j n9/t1/l0, f n15/t1/l0, c n21/t1/l1
               1     0  Move { to: 24, from: 0 }
                     1  Instruction get(num n0) -> n25/t0/l0
                     2  Add { to: 0, a: 24, b: 25 }
                     3  Return
        "#]],
    );
}
