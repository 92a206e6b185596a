//! Fields of built-in types and of user types, and arms (2.3.3, 9, 10.5, 6.8).

use expect_test::expect;

use crate::show::{faults, types};

#[test]
fn fields() {
    let listing = r#"
        num nA
        point pA
        point pB[2]
        tool tA
        joint jA
        mdesc mA
        config cA
        frame fA
        nA=pA.trsf.x+pB[1].trsf.rz
        nA=tA.trsf.y+tA.otime+tA.ctime
        nA=jA.j1+jA.j6
        nA=mA.vel+mA.tvel
        mA.blend=Cartesian
        cA.shoulder=ssame
        pA.config.wrist=wfree
        tA.gripper=true
        nA=fA.trsf.x
        nA=here(tA,world).trsf.x
    "#;
    expect![[r#"
        nA: num | pA: pointRx | pA.trsf: trsf | pA.trsf.x: num | pB: pointRx[] | pB[1]: pointRx | pB[1].trsf: trsf | pB[1].trsf.rz: num | pA.trsf.x+pB[1].trsf.rz: num
        nA: num | tA: tool | tA.trsf: trsf | tA.trsf.y: num | tA: tool | tA.otime: num | tA.trsf.y+tA.otime: num | tA: tool | tA.ctime: num | tA.trsf.y+tA.otime+tA.ctime: num
        nA: num | jA: jointRx | jA.j1: num | jA: jointRx | jA.j6: num | jA.j1+jA.j6: num
        nA: num | mA: mdesc | mA.vel: num | mA: mdesc | mA.tvel: num | mA.vel+mA.tvel: num
        mA: mdesc | mA.blend: blend | Cartesian: blend
        cA: configRx | cA.shoulder: shoulder | ssame: shoulder
        pA: pointRx | pA.config: configRx | pA.config.wrist: wrist | wfree: wrist
        tA: tool | tA.gripper: dio
        nA: num | fA: frame | fA.trsf: trsf | fA.trsf.x: num
        nA: num | tA: tool | world: frame | here(tA,world): pointRx | here(tA,world).trsf: trsf | here(tA,world).trsf.x: num
    "#]]
    .assert_eq(&types(listing));
}

#[test]
fn wrong_fields() {
    let listing = r#"
        num nA
        point pA
        joint jA
        mdesc mA
        point pG[2,2]
        nA=pA.x
        nA=pA.trs.x
        nA=jA.j7
        nA=nA.x
        nA=pG.trsf.x
        mA.blend=joint
        mA.blend=ssame
        mA.tmax=1
        sin(1).x=2
        pA.config=mA.blend
    "#;
    expect![[r#"
        main/start.pgx:5 `x` UnknownField { ty: "pointRx", field: "x", near: None }
        main/start.pgx:6 `trs` UnknownField { ty: "pointRx", field: "trs", near: Some("trsf") }
        main/start.pgx:7 `j7` UnknownField { ty: "jointRx", field: "j7", near: Some("j1") }
        main/start.pgx:8 `x` UnknownField { ty: "num", field: "x", near: None }
        main/start.pgx:9 `pG` IndexMissing { name: "pG", ty: "pointRx[,]" }
            Declared main/main.dtx:10 `pG`
        main/start.pgx:11 `ssame` AssignmentType { target: "blend", value: "shoulder" }
        main/start.pgx:12 `tmax` UnknownField { ty: "mdesc", field: "tmax", near: None }
        main/start.pgx:13 `x` UnknownField { ty: "num", field: "x", near: None }
        main/start.pgx:14 `mA.blend` AssignmentType { target: "configRx", value: "blend" }
    "#]]
    .assert_eq(&faults(listing));
}

#[test]
fn joints_of_a_scara() {
    let listing = r#"
        num nA
        jointRs jA
        nA=jA.j4
        nA=jA.j5
    "#;
    expect![[r#"
        nA: num | jA: jointRs | jA.j4: num
        nA: num | jA: jointRs | jA.j5: ?
        ! j5: UnknownField { ty: "jointRs", field: "j5", near: Some("j1") }
    "#]]
    .assert_eq(&types(listing));
}

#[test]
fn positions_of_another_arm() {
    let listing = r#"
        joint jA
        jointRs jB
        point pA
        pointRs pB
        bool bA
        tool tA
        mdesc mA
        jA=jB
        pA=pB
        bA=jA==jB
        movej(jA,tA,mA)
        movej(jB,tA,mA)
        call p(jB)
        program p(jointRx x_j)
        begin
        end
    "#;
    expect![[r#"
        main/start.pgx:5 `jB` WrongArm { found: "jointRs", expected: "jointRx" }
        main/start.pgx:6 `pB` WrongArm { found: "pointRs", expected: "pointRx" }
        main/start.pgx:7 `jB` WrongArm { found: "jointRs", expected: "jointRx" }
        main/start.pgx:10 `jB` WrongArm { found: "jointRs", expected: "jointRx" }
            Declared main/p.pgx:3 `p`
    "#]]
    .assert_eq(&faults(listing));
}

#[test]
fn user_types() {
    let listing = r#"
        type Slot "Disk://Slot/Slot.pjx"
        type Tray "Disk://Tray/Tray.pjx"
        num nA
        Slot tA
        Slot tB[3]
        Tray tTray[""]
        bool bA
        nA=tA.nCount
        nA=tB[1].nCount+tB.nCount
        nA=tTray["a"].tSlots[2].nCount
        nA=tTray["a"].nByName["x"]
        nA=tTray["a"].nGrid[1,0]
        tTray["a"].tSlots[0]=tB[2]
        bA=tA==tB[0]
        --- Slot
        public num nCount
        num nPrivate
        --- Tray
        type Slot "Disk://Slot/Slot.pjx"
        public Slot tSlots[4]
        public num nByName[""]
        public num nGrid[2,2]
    "#;
    expect![[r#"
        nA: num | tA: Slot | tA.nCount: num
        nA: num | tB: Slot[] | tB[1]: Slot | tB[1].nCount: num | tB: Slot[] | tB.nCount: num | tB[1].nCount+tB.nCount: num
        nA: num | tTray: Tray[""] | tTray["a"]: Tray | tTray["a"].tSlots: Slot[] | tTray["a"].tSlots[2]: Slot | tTray["a"].tSlots[2].nCount: num
        nA: num | tTray: Tray[""] | tTray["a"]: Tray | tTray["a"].nByName: num[""] | tTray["a"].nByName["x"]: num
        nA: num | tTray: Tray[""] | tTray["a"]: Tray | tTray["a"].nGrid: num[,] | tTray["a"].nGrid[1,0]: num
        tTray: Tray[""] | tTray["a"]: Tray | tTray["a"].tSlots: Slot[] | tTray["a"].tSlots[0]: Slot | tB: Slot[] | tB[2]: Slot
        bA: bool | tA: Slot | tB: Slot[] | tB[0]: Slot | tA==tB[0]: bool
    "#]]
    .assert_eq(&types(listing));
}

#[test]
fn wrong_use_of_user_types() {
    let listing = r#"
        type Slot "Disk://Slot/Slot.pjx"
        type Other "Disk://Other/Other.pjx"
        num nA
        Slot tA
        Other tOther
        Slot tC[""]
        nA=tA.nCuont
        nA=tA.nPrivate
        nA=tA.nGrid
        nA=tA
        tA=tOther
        nA=tC.nCount
        nA=tA+tA
        if tA
        endIf
        tA=1
        --- Slot
        public num nCount
        public num nGrid[2,2]
        num nPrivate
        --- Other
        public num nCount
    "#;
    expect![[r#"
        main/start.pgx:5 `nCuont` UnknownField { ty: "Slot", field: "nCuont", near: Some("nCount") }
        main/start.pgx:6 `nPrivate` UnknownField { ty: "Slot", field: "nPrivate", near: None }
            Declared Slot/Slot.dtx:6 `nPrivate`
        main/start.pgx:7 `tA.nGrid` IndexMissing { name: "tA.nGrid", ty: "num[,]" }
            Declared Slot/Slot.dtx:5 `nGrid`
        main/start.pgx:8 `tA` AssignmentType { target: "num", value: "Slot" }
        main/start.pgx:9 `tOther` AssignmentType { target: "Slot", value: "Other" }
        main/start.pgx:10 `tC` IndexMissing { name: "tC", ty: "Slot[\"\"]" }
            Declared main/main.dtx:7 `tC`
        main/start.pgx:11 `tA+tA` OperatorType { op: "+", left: Some("Slot"), right: "Slot" }
        main/start.pgx:12 `tA` ConditionType { keyword: "if", found: "Slot" }
        main/start.pgx:14 `1` AssignmentType { target: "Slot", value: "num" }
    "#]]
    .assert_eq(&faults(listing));
}
