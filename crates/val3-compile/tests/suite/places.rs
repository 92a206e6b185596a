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
            program start
                file 0 stack 304
                local i num n0
                local l_a num n1
                local l_b num[] c0
                local l_t @Slot c1
                frame n9/t1/p2
                nums n2=2, n6=1, n7=3
                container num[3]
                container @Slot[1]
                texts "a", "b", "c"
            line 11
                Move n3 n6
                Move n4 n0
                Move n5 n7
                Locate3 p0 $nC n3
                Load n8 p0 0
                StoreElement2 $nG n0 n2 n8
            line 12
                LoadElement n3 c0 n2
                StoreElement c0 n0 n3
            line 13
                LocateKey p0 $sColl "b"
                Concatenate t0 p0 "c"
                LocateKey p1 $sColl "a"
                TextMove p1 t0
            closing 14 at 549 552
                Return
            end
        "#]],
    );
}

#[test]
fn a_single_local_used_with_an_index_is_an_array() {
    check(
        "l_a[0]=i",
        expect![[r#"
            program start
                file 0 stack 320
                local i num n0
                local l_a num c0
                local l_b num[] c1
                local l_t @Slot c2
                frame n2
                container num[1]
                container num[3]
                container @Slot[1]
            line 11
                StoreElement c0 n1 n0
            closing 12 at 500 503
                Return
            end
        "#]],
    );
}

#[test]
fn fields() {
    check(
        "pA[i].trsf.x=pA.trsf.y\npA.config.shoulder=lefty\nl_t.nCount=tSlot[i].pPick[1].trsf.rz",
        expect![[r#"
            program start
                file 0 stack 304
                local i num n0
                local l_a num n1
                local l_b num[] c0
                local l_t @Slot c1
                frame n5/p1/v2
                nums n3=2, n4=1
                container num[3]
                container @Slot[1]
            line 11
                Locate p0 $pA n0
                LoadFirst n2 $pA 1
                Store p0 0 n2
            line 12
                StoreFirst $pA 6 n3
            line 13
                FirstField v0 c1 0
                ElementField v1 $tSlot n0 1
                Locate p0 v1 n4
                Load n2 p0 5
                StoreFirst v0 0 n2
            closing 14 at 576 579
                Return
            end
        "#]],
    );
}

#[test]
fn values_of_user_types() {
    check(
        "l_t=tSlot[1]=tSlot[i]",
        expect![[r#"
            program start
                file 0 stack 304
                local i num n0
                local l_a num n1
                local l_b num[] c0
                local l_t @Slot c1
                frame n3/p3
                nums n2=1
                container num[3]
                container @Slot[1]
            line 11
                Locate p0 $tSlot n0
                Locate p1 $tSlot n2
                Copy @Slot p1 p0
                Locate p2 $tSlot n0
                Copy @Slot c1 p2
            closing 12 at 513 516
                Return
            end
        "#]],
    );
}

#[test]
fn built_in_data_and_data_of_libraries_are_accessed() {
    check(
        "i=world.trsf.x+flange.trsf.z+part:nWeight\npart:nWeight=i+part:nWeight",
        expect![[r#"
            program start
                file 0 stack 304
                local i num n0
                local l_a num n1
                local l_b num[] c0
                local l_t @Slot c1
                frame n6
                container num[3]
                container @Slot[1]
            line 11
                LoadFirst n2 world 0
                LoadFirst n3 flange 2
                Add n4 n2 n3
                LoadFirst n5 i0 0
                Add n0 n4 n5
            line 12
                LoadFirst n2 i0 0
                Add n3 n0 n2
                StoreFirst i0 0 n3
            closing 13 at 561 564
                Return
            end
        "#]],
    );
    let image = image(&format!("{TYPES}i=part:nWeight+part:nWeight\nend\n{OTHERS}"));
    let imports: Vec<_> = image.imports.iter().map(|import| (import.library, import.name.as_str())).collect();
    assert_eq!(imports, [(0, "nWeight")]);
}
