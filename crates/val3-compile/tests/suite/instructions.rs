//! Calls of instructions.

use expect_test::{Expect, expect};

use crate::show::{code, image, program};

fn check(code_lines: &str, expected: Expect) {
    let data = "library part \"Disk://part/part.pjx\"\nnum nA[3]\nstring sColl[\"\"]\ndio dOut\npoint pA\ntool tT\nmdesc mN\njoint jA\n\
                program start()\n  num n\n  num l_n\n  bool b\n  string s\nbegin\n";
    expected.assert_eq(&code(&format!("{data}{code_lines}\nend\n--- part\npublic num nW")));
}

#[test]
fn values_and_references() {
    check(
        "n=sin(n+1)\ns=toNum(s,n,b)\nputln(s+\"!\")\nmovej(pA,tT,mN)\nmovej({1,2,3,4,5,6},flange,mN)",
        expect![[r#"
            n n0/t0/l0, l_n n1/t0/l0, b n2/t0/l0, s n3/t0/l0, n3=1, n5=1, n6=2, n7=3, n8=4, n9=5, n10=6
               1     0  Add { to: 4, a: 0, b: 3 }
                     1  Function { function: Sin, to: 0, a: 4, b: 4, c: 4 }
               2     2  Line
                     3  Instruction toNum(string t0, num n0, bool n2) -> n3/t0/l0
               3     4  Concatenate { to: Register(1), a: Register(0), b: Constant(0) }
                     5  Instruction putln(string t1)
               4     6  Line
                     7  Instruction movej(point Data(3), tool Data(4), mdesc Data(5))
               5     8  LocateFirst { to: 0, container: Builtin(1) }
                     9  Instruction movej(joint n5, tool p0, mdesc Data(5))
                    10  Return
        "#]],
    );
}

#[test]
fn containers_and_slots() {
    check(
        "n=size(nA)\nn=size(nA[2])\ninsert(nA[n])\nb=isDefined(sColl[s])\nb=isDefined(part:nW)\ns=first(sColl)\nresize(nA,1,9)\nn=size(l_n)",
        expect![[r#"
            n n0/t0/l0, l_n Part(0), b n1/t0/l0, s n2/t0/l0, n2=2, n3=1, n4=9
               1     0  Line
                     1  Instruction size(Data(0)) -> n0/t0/l0
               2     2  Line
                     3  Instruction size(Data(0) from n2) -> n0/t0/l0
               3     4  Line
                     5  Instruction insert(Data(0)[n0])
               4     6  Line
                     7  Instruction isDefined(Data(1)[t0]) -> n1/t0/l0
               5     8  Line
                     9  Instruction isDefined(Import(0)) -> n1/t0/l0
               6    10  Line
                    11  Instruction first(Data(1)) -> n2/t0/l0
               7    12  Line
                    13  Instruction resize(Data(0), num n3, num n4)
               8    14  Line
                    15  Instruction size(Part(0)) -> n0/t0/l0
                    16  Return
        "#]],
    );
}

#[test]
fn what_is_no_container_is_passed_in_one() {
    check(
        "toBinary(pA.trsf.x,1,\"4.0l\",nA)",
        expect![[r#"
            n n0/t0/l0, l_n n1/t0/l0, b n2/t0/l0, s n3/t0/l0, n4=1
               1     0  LoadFirst { to: 3, container: Data(3), lane: 0 }
                     1  StoreFirst { container: Part(0), lane: 0, from: 3 }
                     2  TextMove { to: Register(1), from: Constant(0) }
                     3  Instruction toBinary(Part(0), num n4, string t1, Data(0))
                     4  LoadFirst { to: 5, container: Part(0), lane: 0 }
                     5  StoreFirst { container: Data(3), lane: 0, from: 5 }
                     6  Return
        "#]],
    );
}

#[test]
fn libraries() {
    check(
        "n=part:libLoad(\"Disk://part\")\npart:libSave()",
        expect![[r#"
            n n0/t0/l0, l_n n1/t0/l0, b n2/t0/l0, s n3/t0/l0
               1     0  TextMove { to: Register(1), from: Constant(0) }
                     1  Instruction libLoad(library 0, string t1) -> n0/t0/l0
               2     2  Line
                     3  Instruction libSave(library 0)
                     4  Return
        "#]],
    );
}

#[test]
fn truth_values_are_read_from_inputs() {
    check(
        "n=sel(dOut,1,2)",
        expect![[r#"
            n n0/t0/l0, l_n n1/t0/l0, b n2/t0/l0, s n3/t0/l0, n4=1, n5=2
               1     0  Line
                     1  Instruction =(dio Data(2)) -> n3/t0/l0
                     2  Function { function: Sel, to: 0, a: 3, b: 4, c: 5 }
                     3  Return
        "#]],
    );
}

#[test]
fn printing() {
    check(
        "? n\n? s\n? pA\n? dOut",
        expect![[r#"
            n n0/t0/l0, l_n n1/t0/l0, b n2/t0/l0, s n3/t0/l0
               1     0  Line
                     1  Instruction ?(num n0)
               2     2  Line
                     3  Instruction ?(string t0)
               3     4  Line
                     5  Instruction ?(point Data(3))
               4     6  Line
                     7  Instruction ?(dio Data(2))
                     8  Return
        "#]],
    );
}

#[test]
fn instructions_of_add_ons() {
    let table = r#"=== /app/val3.files.anthro.cfx
<Language xmlns="http://www.staubli.com/robotics/VAL3/1"><Version>s7.8</Version><Functions>
<Func><Name>$odd</Name><Return>num</Return><Param index="0" type="string" dataRef="false" array="false" arrayDim="0" /><Lib>false</Lib><Class>Modifier</Class></Func>
<Func><Name>$fileExists</Name><Return>bool</Return><Param index="0" type="string" dataRef="false" array="false" arrayDim="0" /><Lib>false</Lib><Class>Function</Class></Func>
</Functions></Language>
=== /configs/arm.cfx
<?xml version="1.0"?><Arm></Arm>"#;
    let image = image(&format!("program start()\nbool b\nbegin\nb=$fileExists(\"a\")\n$odd(\"b\")\nend\n{table}"));
    let sites = &program(&image, "start").instructions;
    let names: Vec<&str> = sites.iter().map(|site| site.name.as_ref()).collect();
    assert_eq!(names, ["$fileExists", "$odd"]);
    assert!(sites[1].run.is_none());
}
