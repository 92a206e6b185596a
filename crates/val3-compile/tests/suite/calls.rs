//! Calls of programs and creation of tasks (2.6, 5.10).

use expect_test::{Expect, expect};

use crate::show::{code, image, program};

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
            l_n n0/t0/l0, n1=1, n3=2
               1     0  Add { to: 2, a: 0, b: 1 }
                     1  Locate { to: 0, container: Data(0), index: 0 }
                     2  Call program 1(num n2, num p0, Data(0) from n3, Data(3), user Data(1))
               2     3  TextMove { to: Register(0), from: Constant(0) }
                     4  Call import 0(string t0)
                     5  Return
        "#]],
    );
}

#[test]
fn parameters() {
    let image = image(&format!("{PROGRAMS}call pick(1,nA,nA,sColl,tS)\nend\n{OTHERS}"));
    let pick = program(&image, "pick");
    let passing: Vec<String> = pick.params.iter().map(|param| format!("{} {:?}", param.name, param.storage)).collect();
    let shown = format!("{}\n{}", passing.join("\n"), val3_bytecode::disassemble(pick));
    expect![[r#"
        x_n Value(Lanes { num: 0, text: 0, link: 0, part: 0 })
        x_r Place(0)
        x_a View(0)
        x_c View(1)
        x_t Part(0)
           1     0  Store { place: 0, lane: 0, from: 0 }
           2     1  FirstField { to: 2, container: Part(0), field: 0 }
                 2  LoadFirst { to: 2, container: View(2), lane: 0 }
                 3  StoreElement { container: View(0), index: 1, from: 2 }
           3     4  LocateKey { to: 1, container: View(1), key: Constant(0) }
                 5  TextMove { to: Place(1), from: Constant(1) }
           4     6  Load { to: 2, place: 0, lane: 0 }
                 7  StoreFirst { container: Part(1), lane: 0, from: 2 }
                 8  Call program 0(Part(1))
                 9  LoadFirst { to: 3, container: Part(1), lane: 0 }
                10  Store { place: 0, lane: 0, from: 3 }
           5    11  StoreFirst { container: Part(2), lane: 0, from: 0 }
                12  Call program 0(Part(2))
                13  LoadFirst { to: 0, container: Part(2), lane: 0 }
           6    14  Call program 0(View(0) from n4)
                15  Return
    "#]]
    .assert_eq(&shown);
}

#[test]
fn tasks() {
    check(
        "taskCreate \"t\"+\"1\", 10, forward(nA)\ntaskCreateSync \"s\", 0.004, bLate, part:tell(\"x\")",
        expect![[r#"
            l_n n0/t0/l0, n1=10, n2=0.004
               1     0  Concatenate { to: Register(0), a: Constant(0), b: Constant(1) }
                     1  CreateTask t0, n1, program 0(Data(0))
               2     2  TextMove { to: Register(0), from: Constant(3) }
                     3  CreateTask constant 2, n2, Data(2), import 0(string t0)
                     4  Return
        "#]],
    );
}
