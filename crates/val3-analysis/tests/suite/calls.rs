//! Calls: overloads of instructions, programs, tasks (2.5, 5.10).

use expect_test::expect;

use crate::show::{faults, types};

#[test]
fn overloads_by_type() {
    let listing = r#"
        num nA
        string sA
        bool bA
        dio dA
        sio siA
        joint jA
        point pA
        tool tA
        mdesc mA
        frame fA
        trsf trA
        nA=movej(jA,tA,mA)
        nA=movej(pA,tA,mA)
        nA=distance(pA,pA)
        nA=distance(trA,trA)
        jA=abs(jA)
        nA=abs(nA)
        nA=len(sA)
        nA=size(pA)
        bA=insert(nA)
        sA=insert(sA,sA,1)
        put(sA)
        put(nA)
        pA=compose(pA,fA,{0,0,1,0,0,0})
        dA=bA
        bA=dA
        siA=sA
        sA=siA
        nA=siA
        wait(dA and bA)
    "#;
    expect![[r#"
        nA: num | jA: jointRx | tA: tool | mA: mdesc | movej(jA,tA,mA): num
        nA: num | pA: pointRx | tA: tool | mA: mdesc | movej(pA,tA,mA): num
        nA: num | pA: pointRx | pA: pointRx | distance(pA,pA): num
        nA: num | trA: trsf | trA: trsf | distance(trA,trA): num
        jA: jointRx | jA: jointRx | abs(jA): jointRx
        nA: num | nA: num | abs(nA): num
        nA: num | sA: string | len(sA): num
        nA: num | pA: pointRx | size(pA): num
        bA: bool | nA: num | insert(nA): bool
        sA: string | sA: string | sA: string | insert(sA,sA,1): string
        sA: string | put(sA): ?
        nA: num | put(nA): ?
        pA: pointRx | pA: pointRx | fA: frame | {0,0,1,0,0,0}: trsf | compose(pA,fA,{0,0,1,0,0,0}): pointRx
        dA: dio | bA: bool
        bA: bool | dA: dio
        siA: sio | sA: string
        sA: string | siA: sio
        nA: num | siA: sio
        dA: dio | bA: bool | dA and bA: bool | wait(dA and bA): ?
    "#]]
    .assert_eq(&types(listing));
}

#[test]
fn arguments_that_suit_no_overload_are_reported() {
    let listing = r#"
        num nA
        string sA
        bool bA
        joint jA
        tool tA
        mdesc mA
        nA=movej(nA,tA,mA)
        nA=movej(jA,mA,tA)
        nA=movej(jA,tA)
        nA=movej(jA,tA,mA,mA)
        nA=abs(sA)
        nA=abs("x")
        put(jA)
        sA=insert(sA,nA,1)
        nA=sin(bA)+cos(sA)
        wait(nA)
        bA=pointToJoint(tA,jA,jA,jA)
    "#;
    expect![[r#"
        main/start.pgx:5 `nA` ArgumentType { callee: "movej", parameter: "jPosition", expected: ["joint", "point"], found: "num" }
        main/start.pgx:6 `mA` ArgumentType { callee: "movej", parameter: "tTool", expected: ["tool"], found: "mdesc" }
        main/start.pgx:7 `movej(jA,tA)` ArgumentCount { callee: "movej", expected: [3], found: 2, forms: ["num movej(joint jPosition, tool tTool, mdesc mDesc)", "num movej(point pPosition, tool tTool, mdesc mDesc)"] }
        main/start.pgx:8 `movej(jA,tA,mA,mA)` ArgumentCount { callee: "movej", expected: [3], found: 4, forms: ["num movej(joint jPosition, tool tTool, mdesc mDesc)", "num movej(point pPosition, tool tTool, mdesc mDesc)"] }
        main/start.pgx:9 `sA` ArgumentType { callee: "abs", parameter: "nValue", expected: ["num", "joint"], found: "string" }
        main/start.pgx:10 `"x"` ArgumentType { callee: "abs", parameter: "nValue", expected: ["num", "joint"], found: "string" }
        main/start.pgx:11 `jA` ArgumentType { callee: "put", parameter: "sText", expected: ["string", "num"], found: "jointRx" }
        main/start.pgx:12 `nA` ArgumentType { callee: "insert", parameter: "sInsertion", expected: ["string"], found: "num" }
        main/start.pgx:13 `bA` ArgumentType { callee: "sin", parameter: "nAngle", expected: ["num"], found: "bool" }
        main/start.pgx:13 `sA` ArgumentType { callee: "cos", parameter: "nAngle", expected: ["num"], found: "string" }
        main/start.pgx:14 `nA` ArgumentType { callee: "wait", parameter: "bCondition", expected: ["bool"], found: "num" }
        main/start.pgx:15 `jA` ArgumentType { callee: "pointToJoint", parameter: "pPosition", expected: ["point"], found: "jointRx" }
    "#]].assert_eq(&faults(listing));
}

#[test]
fn instructions_by_reference() {
    let listing = r#"
        num nBytes[8]
        num nValue[2]
        num nC[""]
        num nG[2,2]
        num nA
        bool bA
        string sA
        nA=fromBinary(nBytes,8,"4.0l",nValue)
        nA=fromBinary(nBytes[4],4,"4.0l",nValue[1])
        nA=fromBinary(nG,8,"4.0l",nC)
        nA=fromBinary(nBytes,8,"4.0l",1)
        sA=first(nC)
        sA=first(nBytes)
        sA=next(nC["a"])
        sA=next(nC)
        nA=size(nG,2)
        nA=size(nG[0,0])
        resize(nG,1,3)
        append(nBytes)
        append(nC["a"])
        bA=isDefined(nC["a"])
        bA=isDefined(nG[0,9])
        insert(nC["b"])
        delete(nBytes[3])
    "#;
    expect![[r#"
        main/start.pgx:7 `nG` ContainerMismatch { callee: "fromBinary", parameter: "nDataByte", expected: "num[]", found: "num[,]" }
        main/start.pgx:8 `1` VariableExpected { callee: "fromBinary", parameter: "nValue" }
        main/start.pgx:10 `nBytes` ContainerMismatch { callee: "first", parameter: "variable", expected: "any type[\"\"]", found: "num[]" }
        main/start.pgx:12 `nC` IndexMissing { name: "nC", ty: "num[\"\"]" }
        main/start.pgx:14 `nG[0,0]` IndexNotAllowed { name: "nG", ty: "num", callee: Some("size") }
        main/start.pgx:17 `nC["a"]` IndexNotAllowed { name: "nC", ty: "num", callee: Some("append") }
    "#]].assert_eq(&faults(listing));
}

#[test]
fn unknown_arguments_are_silent() {
    let listing = r#"
        num nA
        nA=movej(xA,xB,xC)
        nA=abs(xA)
        call p(xA,xB)
        call p(xA.trsf[3],{xD})
        program p(num& x_n[], string x_s)
        begin
        end
    "#;
    expect![[r#"
        nA: num | xA: ? | xB: ? | xC: ? | movej(xA,xB,xC): num
        nA: num | xA: ? | abs(xA): ?
        xA: ? | xB: ? | p(xA,xB): ?
        xA: ? | xA.trsf: ? | xA.trsf[3]: ? | xD: ? | {xD}: ? | p(xA.trsf[3],{xD}): ?
        ! xA: UnknownName { name: "xA", near: Some("nA") }
        ! xB: UnknownName { name: "xB", near: None }
        ! xC: UnknownName { name: "xC", near: None }
        ! {xD}: LiteralWithoutType { expected: Some("string") }
        ! xD: UnknownName { name: "xD", near: None }
    "#]]
    .assert_eq(&types(listing));
}

#[test]
fn calls_of_other_names_are_reported() {
    let listing = r#"
        num nA
        call nA(1)
        call sin(1)
        call pik(1)
        nA=pick(1)
        pick(1)
        nA(0)=1
        call pick()
        sine(1)
        program pick(num x_n)
        begin
        end
    "#;
    expect![[r#"
        main/start.pgx:5 `nA` UnknownProgram { name: "nA", near: None, is: Some(Data) }
        main/start.pgx:6 `sin` UnknownProgram { name: "sin", near: None, is: Some(Instruction) }
        main/start.pgx:7 `pik` UnknownProgram { name: "pik", near: Some("pick"), is: None }
        main/start.pgx:8 `pick` UnknownInstruction { name: "pick", near: None, is: Some(Program) }
        main/start.pgx:10 `nA` UnknownInstruction { name: "nA", near: None, is: Some(Data) }
        main/start.pgx:11 `pick()` ArgumentCount { callee: "pick", expected: [1], found: 0, forms: ["pick(num x_n)"] }
            Declared main/pick.pgx:3 `pick`
        main/start.pgx:12 `sine` UnknownInstruction { name: "sine", near: Some("sin"), is: None }
    "#]]
    .assert_eq(&faults(listing));
}

#[test]
fn tasks() {
    let listing = r#"
        num nA
        bool bA
        string sA
        taskCreate "t",10,p(1)
        taskCreate sA+"t",nA,p(nA)
        taskCreateSync "t",0.004,bA,p(1)
        taskCreate 1,10,p(1)
        taskCreate "t","10",p(1)
        taskCreateSync "t",0.004,true,p(1)
        taskCreate "t",10,p("x")
        taskCreate "t",10,q(1)
        taskCreate "t",10,p
        program p(num x_n)
        begin
        end
    "#;
    expect![[r#"
        main/start.pgx:8 `1` ArgumentType { callee: "taskCreate", parameter: "sName", expected: ["string"], found: "num" }
        main/start.pgx:9 `"10"` ArgumentType { callee: "taskCreate", parameter: "nPriority", expected: ["num"], found: "string" }
        main/start.pgx:10 `true` VariableExpected { callee: "taskCreateSync", parameter: "bOverrun" }
        main/start.pgx:11 `"x"` ArgumentType { callee: "p", parameter: "x_n", expected: ["num"], found: "string" }
            Declared main/p.pgx:3 `p`
        main/start.pgx:12 `q` UnknownProgram { name: "q", near: Some("p"), is: None }
        main/start.pgx:13 `p` NotAValue { name: "p", is: Program }
    "#]].assert_eq(&faults(listing));
}
