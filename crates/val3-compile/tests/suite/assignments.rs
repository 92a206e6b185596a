//! Assignments and values between braces.

use expect_test::{Expect, expect};

use crate::show::code;

fn check(code_lines: &str, expected: Expect) {
    let data = "dio dOut\nnum nA[3]\ntool tT\npoint pA[2]\nprogram start()\n  num n\n  num m\n  bool b\n  trsf t\n  mdesc md\n  dio d\nbegin\n";
    expected.assert_eq(&code(&format!("{data}{code_lines}\nend")));
}

#[test]
fn chains() {
    check(
        "n=m=3\nnA[n]=nA[1]=m",
        expect![[r#"
            n n0/t0/l0, m n1/t0/l0, b n2/t0/l0, t n3/t0/l0, md n9/t0/l0, d n17/t0/l0, n9=100, n10=100, n11=100, n12=9999, n13=9999, n15=50, n16=50, n17=3, n18=1
               1     0  Move { to: 1, from: 17 }
                     1  Move { to: 0, from: 17 }
               2     2  StoreElement { container: Data(1), index: 18, from: 1 }
                     3  StoreElement { container: Data(1), index: 0, from: 1 }
                     4  Return
        "#]],
    );
}

#[test]
fn outputs_are_set_and_inputs_read() {
    check(
        "dOut=n==1\nb=dOut\nb=d",
        expect![[r#"
            n n0/t0/l0, m n1/t0/l0, b n2/t0/l0, t n3/t0/l0, md n9/t0/l0, d n17/t0/l0, n9=100, n10=100, n11=100, n12=9999, n13=9999, n15=50, n16=50, n17=1
               1     0  Equal { to: 18, a: 0, b: 17 }
                     1  Instruction =(dio Data(0), bool n18)
               2     2  Line
                     3  Instruction =(dio Data(0)) -> n2/t0/l0
               3     4  Line
                     5  Instruction =(dio l0) -> n2/t0/l0
                     6  Return
        "#]],
    );
}

#[test]
fn constant_structures_lie_in_the_frame() {
    check(
        "t={1,2,3,,,-90}\nmd={10,20,30,,,off}",
        expect![[r#"
            n n0/t0/l0, m n1/t0/l0, b n2/t0/l0, t n3/t0/l0, md n9/t0/l0, d n17/t0/l0, n9=100, n10=100, n11=100, n12=9999, n13=9999, n15=50, n16=50, n17=1, n18=2, n19=3, n22=-90, n23=10, n24=20, n25=30, n28=1
               1     0  Copy n3 from n17
               2     1  Copy n9 from n23
                     2  Return
        "#]],
    );
}

#[test]
fn what_is_left_out_is_zero() {
    check(
        "t={n,t.x}",
        expect![[r#"
            n n0/t0/l0, m n1/t0/l0, b n2/t0/l0, t n3/t0/l0, md n9/t0/l0, d n17/t0/l0, n9=100, n10=100, n11=100, n12=9999, n13=9999, n15=50, n16=50
               1     0  Move { to: 17, from: 0 }
                     1  Move { to: 18, from: 3 }
                     2  Move { to: 19, from: 23 }
                     3  Move { to: 20, from: 23 }
                     4  Move { to: 21, from: 23 }
                     5  Move { to: 22, from: 23 }
                     6  Copy n3 from n17
                     7  Return
        "#]],
    );
}

#[test]
fn points_and_tools_keep_their_links() {
    check(
        "pA[n]={{1,2,3,,,},{lefty}}\ntT={{,,n},dOut,1}",
        expect![[r#"
            n n0/t0/l0, m n1/t0/l0, b n2/t0/l0, t n3/t0/l0, md n9/t0/l0, d n17/t0/l0, n9=100, n10=100, n11=100, n12=9999, n13=9999, n15=50, n16=50, n17=1, n18=2, n19=3, n23=2, n35=1
               1     0  Locate { to: 0, container: Data(3), index: 0 }
                     1  Copy p0 from n17
                     2  Locate { to: 1, container: Data(3), index: 0 }
                     3  Copy p1+n6 from n23
               2     4  Move { to: 26, from: 34 }
                     5  Move { to: 27, from: 34 }
                     6  Move { to: 28, from: 0 }
                     7  Move { to: 29, from: 34 }
                     8  Move { to: 30, from: 34 }
                     9  Move { to: 31, from: 34 }
                    10  Copy l3 from Data(0)
                    11  Move { to: 32, from: 35 }
                    12  Move { to: 33, from: 34 }
                    13  Copy Data(2) from n26
                    14  Copy Data(2)+l1 from l3
                    15  StoreFirst { container: Data(2), lane: 6, from: 32 }
                    16  StoreFirst { container: Data(2), lane: 7, from: 33 }
                    17  Return
        "#]],
    );
}
