//! Program calls, and creation of tasks (2.6, 5.10).

use expect_test::{Expect, expect};

use crate::show::{code, image, text_of};

const PROGRAMS: &str = "
type Slot \"Disk://Slot/Slot.pjx\"
library part \"Disk://part/part.pjx\"
num nA[5]
Slot tS
bool bLate
string sColl[\"\"]
program pick(num x_n, num& x_r, num& x_a[], string& x_c[\"\"], Slot x_t)
begin
  x_r=x_n
  x_a[1]=x_t.nCount
  x_c[\"k\"]=\"v\"
  call forward(x_r)
  call forward(x_n)
  call forward(x_a[2])
end
program forward(num& x_a[])
begin
end
program start()
  num l_n
begin
";

const OTHERS: &str = "
--- Slot
public num nCount
--- part
public program tell(string x_s)
begin
end
";

fn check(code_lines: &str, expected: Expect) {
    expected.assert_eq(&code(&format!("{PROGRAMS}{code_lines}\nend\n{OTHERS}")));
}

#[test]
fn arguments() {
    check(
        "call pick(l_n+1,nA[l_n],nA[2],sColl,tS)\ncall part:tell(\"a\")",
        expect![[r#"
            program start
                file 2 stack 24
                local l_n num n0
                frame n4/t1/p1
                nums n1=1, n3=2
            line 8
                Add n2 n0 n1
                Locate p0 $nA n0
                Call pick (num n2, num p0, view $nA from n3, view $sColl, user $tS)
            line 9
                TextMove t0 "a"
                Call import 0 (string t0)
            closing 10 at 360 363
                Return
            end
        "#]],
    );
}

#[test]
fn parameters() {
    let image = image(&format!("{PROGRAMS}call pick(1,nA,nA,sColl,tS)\nend\n{OTHERS}"));
    expect![[r#"
        program pick
            file 1 stack 112
            param x_n num n0
            param x_r num p0
            param x_a num[] v0
            param x_c string[""] v1
            param x_t @Slot c0
            frame n5/p2/v3
            nums n1=1, n4=2
            container @Slot[1]
            container num[1]
            container num[1]
        line 12
            Store p0 0 n0
        line 13
            FirstField v2 c0 0
            LoadFirst n2 v2 0
            StoreElement v0 n1 n2
        line 14
            LocateKey p1 v1 "k"
            TextMove p1 "v"
        line 15
            Load n2 p0 0
            StoreFirst c1 0 n2
            Call forward (view c1)
            LoadFirst n3 c1 0
            Store p0 0 n3
        line 16
            StoreFirst c2 0 n0
            Call forward (view c2)
            LoadFirst n0 c2 0
        line 17
            Call forward (view v0 from n4)
        closing 18 at 762 765
            Return
        end
    "#]]
    .assert_eq(&text_of(&image, "pick"));
}

#[test]
fn tasks() {
    check(
        "taskCreate \"t\"+\"1\", 10, forward(nA)\ntaskCreateSync \"s\", 0.004, bLate, part:tell(\"x\")",
        expect![[r#"
            program start
                file 2 stack 24
                local l_n num n0
                frame n3/t1
                nums n1=10, n2=0.004
                texts "t", "1", "s", "x"
            line 8
                Concatenate t0 "t" "1"
                CreateTask t0 n1 forward (view $nA)
            line 9
                TextMove t0 "x"
                CreateTask "s" n2 overrun $bLate import 0 (string t0)
            closing 10 at 385 388
                Return
            end
        "#]],
    );
}
