//! `{…}`: the type is given by the context (2.4.2, 9.2.1 to 9.7.1, 10.5.1).

use expect_test::expect;

use crate::show::{faults, types};

#[test]
fn nested_braces_select_the_form_of_an_instruction() {
    let declarations = "point pA\njoint jA\nmdesc mA\n";
    for target in ["{{400,0,300,0,180,0},{ssame,esame,wsame}}", "{{400},{}}", "{,{ssame}}", "{1,2,3}", "{}", "jA"] {
        let line = format!("movej({target},flange,mA)");
        assert_eq!(faults(&format!("{declarations}{line}\n")), "", "{target}");
    }
    expect![[r#"
        main/start.pgx:5 `1` LiteralFieldType { ty: "point", field: "trsf", expected: "trsf", found: "num" }
        main/start.pgx:5 `2` LiteralFieldType { ty: "config", field: "shoulder", expected: "shoulder", found: "num" }
        main/start.pgx:6 `{1,2,3,4,5,6,7}` LiteralWithoutType { expected: None }
    "#]]
    .assert_eq(&faults(&format!("{declarations}movej({{1,{{2}}}},flange,mA)\nmovej({{1,2,3,4,5,6,7}},flange,mA)\n")));
}

#[test]
fn every_structured_type() {
    let listing = r#"
        trsf trA
        frame fA
        tool tA
        point pA
        joint jA
        config cA
        mdesc mA
        trA={100,-50,200,0,0,0}
        fA.trsf={1,2,3,4,5,6}
        tA={{0,0,150,0,0,0},dMissing,0.1,0.2}
        pA={{100,-50,200,0,0,0},{sfree,efree,wfree}}
        pA.trsf={100,-50,200,,,}
        jA={0,10,20,30,40,50}
        cA={lefty,epositive,wnegative}
        mA={100,100,100,9999,9999,off,50,50}
        trA={}
        jA={,,90}
    "#;
    expect![[r#"
        trA: trsf | -50: num | {100,-50,200,0,0,0}: trsf
        fA: frame | fA.trsf: trsf | {1,2,3,4,5,6}: trsf
        tA: tool | {0,0,150,0,0,0}: trsf | dMissing: ? | {{0,0,150,0,0,0},dMissing,0.1,0.2}: tool
        pA: pointRx | -50: num | {100,-50,200,0,0,0}: trsf | sfree: shoulder | efree: elbow | wfree: wrist | {sfree,efree,wfree}: configRx | {{100,-50,200,0,0,0},{sfree,efree,wfree}}: pointRx
        pA: pointRx | pA.trsf: trsf | -50: num | {100,-50,200,,,}: trsf
        jA: jointRx | {0,10,20,30,40,50}: jointRx
        cA: configRx | lefty: shoulder | epositive: elbow | wnegative: wrist | {lefty,epositive,wnegative}: configRx
        mA: mdesc | off: blend | {100,100,100,9999,9999,off,50,50}: mdesc
        trA: trsf | {}: trsf
        jA: jointRx | {,,90}: jointRx
        ! dMissing: UnknownName { name: "dMissing", near: None }
    "#]]
    .assert_eq(&types(listing));
}

#[test]
fn braces_are_allowed_where_a_type_is_known() {
    let listing = r#"
        trsf trA[2]
        point pA
        bool bA
        tool tA
        mdesc mA
        trA[0]=trA[1]*{0,0,10,0,0,0}
        trA[0]={0,0,10,0,0,0}*trA[1]
        bA=trA[0]=={1,2,3}
        pA=appro(pA,{0,0,-100,0,0,0})
        movej({0,0,0,0,0,0},tA,mA)
        call p({1,2,3,4,5,6},{0,0,0,0,0,0})
        switch pA.config
          case {sfree,efree,wfree}
          break
        endSwitch
        program p(trsf x_tr, joint x_j)
        begin
        end
    "#;
    expect![[r#"
        trA: trsf[] | trA[0]: trsf | trA: trsf[] | trA[1]: trsf | {0,0,10,0,0,0}: trsf | trA[1]*{0,0,10,0,0,0}: trsf
        trA: trsf[] | trA[0]: trsf | {0,0,10,0,0,0}: trsf | trA: trsf[] | trA[1]: trsf | {0,0,10,0,0,0}*trA[1]: trsf
        bA: bool | trA: trsf[] | trA[0]: trsf | {1,2,3}: trsf | trA[0]=={1,2,3}: bool
        pA: pointRx | pA: pointRx | -100: num | {0,0,-100,0,0,0}: trsf | appro(pA,{0,0,-100,0,0,0}): pointRx
        {0,0,0,0,0,0}: jointRx | tA: tool | mA: mdesc | movej({0,0,0,0,0,0},tA,mA): num
        {1,2,3,4,5,6}: trsf | {0,0,0,0,0,0}: jointRx | p({1,2,3,4,5,6},{0,0,0,0,0,0}): ?
        pA: pointRx | pA.config: configRx
        sfree: shoulder | efree: elbow | wfree: wrist | {sfree,efree,wfree}: configRx
    "#]]
    .assert_eq(&types(listing));
}

/// Only transformations can be multiplied, so both `{…}` are transformations.
#[test]
fn two_braces_are_multiplied_as_transformations() {
    expect![[r#"
        {0,0,1}: trsf | {0,0,2}: trsf | {0,0,1}*{0,0,2}: trsf
        {1,2}: ? | {1,2}: ? | {1,2}=={1,2}: bool
        ! {1,2}: LiteralWithoutType { expected: None }
    "#]]
    .assert_eq(&types("? {0,0,1}*{0,0,2}\n? {1,2}=={1,2}\n"));
}

#[test]
fn joints_follow_the_arm() {
    let listing = r#"
        jointRs jA
        configRs cA
        jA={1,2,3,4}
        jA={1,2,3,4,5}
        cA={righty}
        cA={righty,efree}
    "#;
    expect![[r#"
        jA: jointRs | {1,2,3,4}: jointRs
        jA: jointRs | {1,2,3,4,5}: jointRs
        cA: configRs | righty: shoulder | {righty}: configRs
        cA: configRs | righty: shoulder | efree: elbow | {righty,efree}: configRs
        ! {1,2,3,4,5}: LiteralFieldCount { ty: "jointRs", expected: 4, found: 5 }
        ! {righty,efree}: LiteralFieldCount { ty: "configRs", expected: 1, found: 2 }
    "#]]
    .assert_eq(&types(listing));
}

#[test]
fn misplaced_braces_are_reported() {
    let listing = r#"
        num nA
        num nG[2,2]
        trsf trA
        dio dA
        nA={1}
        trA={1,2,3,4,5,6,7}
        trA={1,"two",true,{1},5,6}
        nG={1,2}
        sin(1)={1,2}
        {1,2}={3,4}
        ? {1,2}
        dA={1}
        putln({1})
        nA=sin({1})
        call p({1,2,3})
        program p(trsf& x_tr)
        begin
        end
    "#;
    expect![[r#"
        main/start.pgx:5 `{1}` LiteralWithoutType { expected: Some("num") }
        main/start.pgx:6 `{1,2,3,4,5,6,7}` LiteralFieldCount { ty: "trsf", expected: 6, found: 7 }
        main/start.pgx:7 `"two"` LiteralFieldType { ty: "trsf", field: "y", expected: "num", found: "string" }
        main/start.pgx:7 `true` LiteralFieldType { ty: "trsf", field: "z", expected: "num", found: "bool" }
        main/start.pgx:7 `{1}` LiteralWithoutType { expected: Some("num") }
        main/start.pgx:8 `nG` IndexMissing { name: "nG", ty: "num[,]" }
            Declared main/main.dtx:5 `nG`
        main/start.pgx:9 `sin(1)` NotAssignable
        main/start.pgx:10 `{1,2}` LiteralWithoutType { expected: None }
        main/start.pgx:11 `{1,2}` LiteralWithoutType { expected: None }
        main/start.pgx:12 `{1}` LiteralWithoutType { expected: Some("dio") }
        main/start.pgx:13 `{1}` LiteralWithoutType { expected: None }
        main/start.pgx:14 `{1}` LiteralWithoutType { expected: Some("num") }
        main/start.pgx:15 `{1,2,3}` VariableExpected { callee: "p", parameter: "x_tr" }
            Declared main/p.pgx:3 `p`
    "#]]
    .assert_eq(&faults(listing));
}

#[test]
fn user_types_take_anything() {
    let listing = r#"
        type Slot "Disk://Slot/Slot.pjx"
        Slot tA
        tA={1,"two",{3,4}}
        tA={nMissing}
        --- Slot
        public num nA
    "#;
    expect![[r#"
        tA: Slot | {3,4}: ? | {1,"two",{3,4}}: Slot
        tA: Slot | nMissing: ? | {nMissing}: Slot
        ! nMissing: UnknownName { name: "nMissing", near: None }
    "#]]
    .assert_eq(&types(listing));
}

#[test]
fn braces_on_both_sides_of_an_operator() {
    let listing = r#"
        point pA
        bool bA
        pA.trsf={0,0,0,0,0,90}*{0,0,1,0,0,0}*!{0,0,2,0,0,0}
        bA={1,2}=={1,2}
    "#;
    expect![[r#"
        main/start.pgx:6 `{1,2}` LiteralWithoutType { expected: None }
    "#]]
    .assert_eq(&faults(listing));
}

#[test]
fn a_tool_takes_its_valve() {
    let listing = r#"
        tool tA
        dio diA
        num nA
        tA={{0,0,150,0,0,0},diA,0.1,0.2}
        tA={{0,0,150,0,0,0},nA}
    "#;
    expect![[r#"
        main/start.pgx:6 `nA` LiteralFieldType { ty: "tool", field: "gripper", expected: "dio", found: "num" }
    "#]]
    .assert_eq(&faults(listing));
}
