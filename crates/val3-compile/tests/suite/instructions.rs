//! Instruction calls.

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
            program start
                file 0 stack 172
                local n num n0
                local l_n num n1
                local b bool n2
                local s string n3/t0
                frame n11/t2/p1
                nums n3=1, n5=1, n6=2, n7=3, n8=4, n9=5, n10=6
            line 11
                Add n4 n0 n3
                Function Sin n0 n4 n4 n4
            line 12
                Line
                Instruction toNum (string n3/t0, num n0, bool n2) -> string n3/t0
            line 13
                Concatenate t1 t0 "!"
                Instruction putln (string t1)
            line 14
                Line
                Instruction movej#1 (point $pA, tool $tT, mdesc $mN)
            line 15
                LocateFirst p0 flange
                Instruction movej (joint n5/t2, tool p0, mdesc $mN)
            closing 16 at 576 579
                Return
            end
        "#]],
    );
}

#[test]
fn containers_and_slots() {
    check(
        "n=size(nA)\nn=size(nA[2])\ninsert(nA[n])\nb=isDefined(sColl[s])\nb=isDefined(part:nW)\ns=first(sColl)\nresize(nA,1,9)\nn=size(l_n)",
        expect![[r#"
            program start
                file 0 stack 188
                local n num n0
                local l_n num c0
                local b bool n1
                local s string n2/t0
                frame n5/t1
                nums n2=2, n3=1, n4=9
                container num[1]
            line 11
                Line
                Instruction size (view $nA) -> num n0
            line 12
                Line
                Instruction size (view $nA from n2) -> num n0
            line 13
                Line
                Instruction insert (slot $nA[n0])
            line 14
                Line
                Instruction isDefined (slot $sColl[t0]) -> bool n1
            line 15
                Line
                Instruction isDefined (slot i0) -> bool n1
            line 16
                Line
                Instruction first (view $sColl) -> string n2/t0
            line 17
                Line
                Instruction resize (view $nA, num n3, num n4)
            line 18
                Line
                Instruction size (view c0) -> num n0
            closing 19 at 614 617
                Return
            end
        "#]],
    );
}

#[test]
fn single_values_are_passed_in_containers() {
    check(
        "toBinary(pA.trsf.x,1,\"4.0l\",nA)",
        expect![[r#"
            program start
                file 0 stack 172
                local n num n0
                local l_n num n1
                local b bool n2
                local s string n3/t0
                frame n6/t2
                nums n4=1
                container num[1]
            line 11
                LoadFirst n3 $pA 0
                StoreFirst c0 0 n3
                TextMove t1 "4.0l"
                Instruction toBinary (view c0, num n4, string t1, view $nA)
                LoadFirst n5 c0 0
                StoreFirst $pA 0 n5
            closing 12 at 522 525
                Return
            end
        "#]],
    );
}

#[test]
fn libraries() {
    check(
        "n=part:libLoad(\"Disk://part\")\npart:libSave()",
        expect![[r#"
            program start
                file 0 stack 172
                local n num n0
                local l_n num n1
                local b bool n2
                local s string n3/t0
                frame n3/t2
            line 11
                TextMove t1 "Disk://part"
                Instruction libLoad (library part, string t1) -> num n0
            line 12
                Line
                Instruction libSave (library part)
            closing 13 at 535 538
                Return
            end
        "#]],
    );
}

#[test]
fn truth_values_are_read_from_inputs() {
    check(
        "n=sel(dOut,1,2)",
        expect![[r#"
            program start
                file 0 stack 172
                local n num n0
                local l_n num n1
                local b bool n2
                local s string n3/t0
                frame n6/t1
                nums n4=1, n5=2
            line 11
                Line
                Instruction assign bool dio (dio $dOut) -> bool n3
                Function Sel n0 n3 n4 n5
            closing 12 at 506 509
                Return
            end
        "#]],
    );
}

#[test]
fn printing() {
    check(
        "? n\n? s\n? pA\n? dOut",
        expect![[r#"
            program start
                file 0 stack 172
                local n num n0
                local l_n num n1
                local b bool n2
                local s string n3/t0
                frame n3/t1
            line 11
                Line
                Instruction print arm Rx (num n0)
            line 12
                Line
                Instruction print arm Rx (string n3/t0)
            line 13
                Line
                Instruction print arm Rx (point $pA)
            line 14
                Line
                Instruction print arm Rx (dio $dOut)
            closing 15 at 510 513
                Return
            end
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
    let names: Vec<&str> = sites.iter().map(|site| site.callee.name()).collect();
    assert_eq!(names, ["$fileExists", "$odd"]);
    assert!(sites[1].run.is_none());
}
