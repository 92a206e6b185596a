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
            program start
                file 0 stack 168
                local n num n0
                local m num n1
                local b bool n2
                local t trsf n3
                local md mdesc n9
                local d dio n17/l0
                frame n19/l1
                nums n9=100, n10=100, n11=100, n12=9999, n13=9999, n15=50, n16=50, n17=3, n18=1
            line 13
                Move n1 n17
                Move n0 n17
            line 14
                StoreElement $nA n18 n1
                StoreElement $nA n0 n1
            closing 15 at 633 636
                Return
            end
        "#]],
    );
}

#[test]
fn outputs_are_set_and_inputs_read() {
    check(
        "dOut=n==1\nb=dOut\nb=d",
        expect![[r#"
            program start
                file 0 stack 168
                local n num n0
                local m num n1
                local b bool n2
                local t trsf n3
                local md mdesc n9
                local d dio n17/l0
                frame n19/l1
                nums n9=100, n10=100, n11=100, n12=9999, n13=9999, n15=50, n16=50, n17=1
            line 13
                Equal n18 n0 n17
                Instruction assign dio bool (dio $dOut, bool n18)
            line 14
                Line
                Instruction assign bool dio (dio $dOut) -> bool n2
            line 15
                Line
                Instruction assign bool dio (dio n17/l0) -> bool n2
            closing 16 at 634 637
                Return
            end
        "#]],
    );
}

#[test]
fn constant_structures_lie_in_the_frame() {
    check(
        "t={1,2,3,,,-90}\nmd={10,20,30,,,off}",
        expect![[r#"
            program start
                file 0 stack 168
                local n num n0
                local m num n1
                local b bool n2
                local t trsf n3
                local md mdesc n9
                local d dio n17/l0
                frame n31/l1
                nums n9=100, n10=100, n11=100, n12=9999, n13=9999, n15=50, n16=50, n17=1, n18=2, n19=3, n22=-90, n23=10, n24=20, n25=30, n28=1
            line 13
                Copy trsf n3 n17/l1
            line 14
                Copy mdesc n9 n23/l1
            closing 15 at 649 652
                Return
            end
        "#]],
    );
}

#[test]
fn omitted_fields_are_zero() {
    check(
        "t={n,t.x}",
        expect![[r#"
            program start
                file 0 stack 168
                local n num n0
                local m num n1
                local b bool n2
                local t trsf n3
                local md mdesc n9
                local d dio n17/l0
                frame n24/l1
                nums n9=100, n10=100, n11=100, n12=9999, n13=9999, n15=50, n16=50
            line 13
                Move n17 n0
                Move n18 n3
                Move n19 n23
                Move n20 n23
                Move n21 n23
                Move n22 n23
                Copy trsf n3 n17
            closing 14 at 623 626
                Return
            end
        "#]],
    );
}

#[test]
fn points_and_tools_keep_their_links() {
    check(
        "pA[n]={{1,2,3,,,},{lefty}}\ntT={{,,n},dOut,1}",
        expect![[r#"
            program start
                file 0 stack 168
                local n num n0
                local m num n1
                local b bool n2
                local t trsf n3
                local md mdesc n9
                local d dio n17/l0
                frame n36/l4/p2
                nums n9=100, n10=100, n11=100, n12=9999, n13=9999, n15=50, n16=50, n17=1, n18=2, n19=3, n23=2, n35=1
            line 13
                Locate p0 $pA n0
                Copy trsf arm Rx p0 n17/l1
                Locate p1 $pA n0
                Copy config arm Rx p1+n6 n23/l1
            line 14
                Move n26 n34
                Move n27 n34
                Move n28 n0
                Move n29 n34
                Move n30 n34
                Move n31 n34
                Copy dio arm Rx n32/l3 $dOut
                Move n32 n35
                Move n33 n34
                Copy trsf arm Rx $tT n26/l2
                Copy dio arm Rx $tT+n6/l1 n32/l3
                StoreFirst $tT 6 n32
                StoreFirst $tT 7 n33
            closing 15 at 658 661
                Return
            end
        "#]],
    );
}
