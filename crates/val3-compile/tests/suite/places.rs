//! Variables, elements and fields.

use expect_test::{Expect, expect};

use crate::show::{code, image};

const TYPES: &str = "
type Slot \"Disk://Slot/Slot.pjx\"
library part \"Disk://part/part.pjx\"
public Slot tSlot[2]
num nG[3,4]
num nC[2,3,4]
string sColl[\"\"]
point pA[5]
program start()
  num i
  num l_a
  num l_b[3]
  Slot l_t
begin
";

const OTHERS: &str = "
--- Slot
public num nCount
public point pPick[2]
num nPrivate
--- part
public num nWeight = 7
";

fn check(code_lines: &str, expected: Expect) {
    expected.assert_eq(&code(&format!("{TYPES}{code_lines}\nend\n{OTHERS}")));
}

#[test]
fn elements() {
    check(
        "nG[i,2]=nC[1,i,3]\nl_b[i]=l_b[2]\nsColl[\"a\"]=sColl[\"b\"]+\"c\"",
        expect![[r#"
            i n0/t0/l0, l_a n1/t0/l0, l_b Part(0), l_t Part(1), n2=2, n6=1, n7=3
               1     0  Move { to: 3, from: 6 }
                     1  Move { to: 4, from: 0 }
                     2  Move { to: 5, from: 7 }
                     3  Locate3 { to: 0, container: Data(2), i: 3 }
                     4  Load { to: 8, place: 0, lane: 0 }
                     5  StoreElement2 { container: Data(1), i: 0, j: 2, from: 8 }
               2     6  LoadElement { to: 3, container: Part(0), index: 2 }
                     7  StoreElement { container: Part(0), index: 0, from: 3 }
               3     8  LocateKey { to: 0, container: Data(3), key: Constant(1) }
                     9  Concatenate { to: Register(0), a: Place(0), b: Constant(2) }
                    10  LocateKey { to: 1, container: Data(3), key: Constant(0) }
                    11  TextMove { to: Place(1), from: Register(0) }
                    12  Return
        "#]],
    );
}

#[test]
fn a_single_local_used_with_an_index_is_an_array() {
    check(
        "l_a[0]=i",
        expect![[r#"
            i n0/t0/l0, l_a Part(0), l_b Part(1), l_t Part(2)
               1     0  StoreElement { container: Part(0), index: 1, from: 0 }
                     1  Return
        "#]],
    );
}

#[test]
fn fields() {
    check(
        "pA[i].trsf.x=pA.trsf.y\npA.config.shoulder=lefty\nl_t.nCount=tSlot[i].pPick[1].trsf.rz",
        expect![[r#"
            i n0/t0/l0, l_a n1/t0/l0, l_b Part(0), l_t Part(1), n3=2, n4=1
               1     0  Locate { to: 0, container: Data(4), index: 0 }
                     1  LoadFirst { to: 2, container: Data(4), lane: 1 }
                     2  Store { place: 0, lane: 0, from: 2 }
               2     3  StoreFirst { container: Data(4), lane: 6, from: 3 }
               3     4  FirstField { to: 0, container: Part(1), field: 0 }
                     5  ElementField { to: 1, container: Data(0), index: 0, field: 1 }
                     6  Locate { to: 0, container: View(1), index: 4 }
                     7  Load { to: 2, place: 0, lane: 5 }
                     8  StoreFirst { container: View(0), lane: 0, from: 2 }
                     9  Return
        "#]],
    );
}

#[test]
fn values_of_user_types() {
    check(
        "l_t=tSlot[1]=tSlot[i]",
        expect![[r#"
            i n0/t0/l0, l_a n1/t0/l0, l_b Part(0), l_t Part(1), n2=1
               1     0  Locate { to: 0, container: Data(0), index: 0 }
                     1  Locate { to: 1, container: Data(0), index: 2 }
                     2  Copy p1 from p0
                     3  Locate { to: 2, container: Data(0), index: 0 }
                     4  Copy Part(1) from p2
                     5  Return
        "#]],
    );
}

#[test]
fn what_is_built_in_and_what_libraries_have() {
    check(
        "i=world.trsf.x+flange.trsf.z+part:nWeight\npart:nWeight=i+part:nWeight",
        expect![[r#"
            i n0/t0/l0, l_a n1/t0/l0, l_b Part(0), l_t Part(1)
               1     0  LoadFirst { to: 2, container: Builtin(0), lane: 0 }
                     1  LoadFirst { to: 3, container: Builtin(1), lane: 2 }
                     2  Add { to: 4, a: 2, b: 3 }
                     3  LoadFirst { to: 5, container: Import(0), lane: 0 }
                     4  Add { to: 0, a: 4, b: 5 }
               2     5  LoadFirst { to: 2, container: Import(0), lane: 0 }
                     6  Add { to: 3, a: 0, b: 2 }
                     7  StoreFirst { container: Import(0), lane: 0, from: 3 }
                     8  Return
        "#]],
    );
    let image = image(&format!("{TYPES}i=part:nWeight+part:nWeight\nend\n{OTHERS}"));
    let imports: Vec<_> = image.imports.iter().map(|import| (import.library, import.name.as_str())).collect();
    assert_eq!(imports, [(0, "nWeight")]);
}
