//! Variables: containers, indexes, keys, fields, scopes, constants (2.3, 2.5, 3, 9, 10.5).

use expect_test::expect;
use val3_analysis::body::{Constant, Expr, body};

use crate::show::{faults, program, project, types, workspace};

#[test]
fn containers() {
    let listing = r#"
        num nA
        num n1[3]
        num n2[2,3]
        num n3[2,3,4]
        num nC["a"]
        string sKey
        nA=n1
        nA=n1[2]
        nA=n2[1,2]
        nA=n3[1,2,3]
        nA=nC["a"]
        nA=nC[sKey+"b"]
        nA=nA[0]
    "#;
    expect![[r#"
        nA: num[]
        n1: num[]
        nA: num[]
        n1: num[]
        n1[2]: num
        nA: num[]
        n2: num[,]
        n2[1,2]: num
        nA: num[]
        n3: num[,,]
        n3[1,2,3]: num
        nA: num[]
        nC: num[""]
        nC["a"]: num
        nA: num[]
        nC: num[""]
        sKey: string[]
        sKey+"b": string
        nC[sKey+"b"]: num
        nA: num[]
        nA: num[]
        nA[0]: num
    "#]].assert_eq(&types(listing));
}

#[test]
fn wrong_indexes() {
    let listing = r#"
        num nA
        num n1[3]
        num n2[2,3]
        num nC["a"]
        string sA
        bool bA
        nA=n1[1,2]
        nA=n2[1]
        nA=n2
        n2=1
        nA=nC
        nA=nC["a","b"]
        nA=nC[1]
        nA=n1[sA]
        nA=n2[1,bA]
        nA=n1[1][0]
        nA=(n1)[1]
        nA=sin(1)[0]
        bA=sA[0]==sA["x"]
        nA=n1[n2]
    "#;
    expect![[r#"
        main/start.pgx:5 `n1` IndexCount { name: "n1", expected: 1, found: 2 }
            Declared main/main.dtx:5 `n1`
        main/start.pgx:6 `n2` IndexCount { name: "n2", expected: 2, found: 1 }
            Declared main/main.dtx:6 `n2`
        main/start.pgx:7 `n2` IndexMissing { name: "n2", ty: "num[,]" }
            Declared main/main.dtx:6 `n2`
        main/start.pgx:8 `n2` IndexMissing { name: "n2", ty: "num[,]" }
            Declared main/main.dtx:6 `n2`
        main/start.pgx:9 `nC` IndexMissing { name: "nC", ty: "num[\"\"]" }
            Declared main/main.dtx:7 `nC`
        main/start.pgx:10 `nC` IndexCount { name: "nC", expected: 1, found: 2 }
            Declared main/main.dtx:7 `nC`
        main/start.pgx:11 `1` IndexType { name: "nC", expected: "string", found: "num" }
        main/start.pgx:12 `sA` IndexType { name: "n1", expected: "num", found: "string" }
        main/start.pgx:13 `bA` IndexType { name: "n2", expected: "num", found: "bool" }
        main/start.pgx:14 `n1[1]` IndexNotAllowed { name: "n1", ty: "num", callee: None }
        main/start.pgx:15 `(n1)` IndexNotAllowed { name: "n1", ty: "num", callee: None }
        main/start.pgx:16 `sin(1)` IndexNotAllowed { name: "sin", ty: "num", callee: None }
        main/start.pgx:17 `"x"` IndexType { name: "sA", expected: "num", found: "string" }
        main/start.pgx:18 `n2` IndexMissing { name: "n2", ty: "num[,]" }
            Declared main/main.dtx:6 `n2`
    "#]].assert_eq(&faults(listing));
}

#[test]
fn constant_indexes() {
    let listing = r#"
        num nA
        num nPrivate[3]
        num nGrown[3]
        num nPassed[3]
        public num nPublic[3]
        num nGrid[2,3]
        nA=nPrivate[2]
        nA=nPrivate[2.4]
        nA=nPrivate[2.5]
        nA=nPrivate[1+2]
        nA=nPrivate[-0.5]
        nA=nPrivate[-1]
        nA=nGrown[7]
        nA=nGrown[-1]
        nA=nPassed[7]
        nA=nPublic[7]
        nA=nPublic[-1]
        nA=nGrid[1,3]
        nA=nGrid[2,2]
        nA=nA[1]
        append(nGrown)
        call grow(nPassed)
        program grow(num& x_n[])
          num l_n[2]
        begin
          x_n[9]=0
          l_n[1]=l_n[2]
          if isDefined(l_n[5]) or !isDefined(nPrivate[5])
            x_n[0]=1
          endIf
        end
    "#;
    expect![[r#"
        main/grow.pgx:12 `2` IndexOutOfBounds { name: "l_n", index: 2, size: 2 }
        main/start.pgx:10 `-1` IndexOutOfBounds { name: "nPrivate", index: -1, size: 3 }
        main/start.pgx:12 `-1` IndexOutOfBounds { name: "nGrown", index: -1, size: 3 }
        main/start.pgx:15 `-1` IndexOutOfBounds { name: "nPublic", index: -1, size: 0 }
        main/start.pgx:16 `3` IndexOutOfBounds { name: "nGrid", index: 3, size: 3 }
        main/start.pgx:17 `2` IndexOutOfBounds { name: "nGrid", index: 2, size: 2 }
        main/start.pgx:18 `1` IndexOutOfBounds { name: "nA", index: 1, size: 1 }
    "#]].assert_eq(&faults(listing));
}

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
        nA: num[]
        pA: pointRx[]
        pA.trsf: trsf
        pA.trsf.x: num
        pB: pointRx[]
        pB[1]: pointRx
        pB[1].trsf: trsf
        pB[1].trsf.rz: num
        pA.trsf.x+pB[1].trsf.rz: num
        nA: num[]
        tA: tool[]
        tA.trsf: trsf
        tA.trsf.y: num
        tA: tool[]
        tA.otime: num
        tA.trsf.y+tA.otime: num
        tA: tool[]
        tA.ctime: num
        tA.trsf.y+tA.otime+tA.ctime: num
        nA: num[]
        jA: jointRx[]
        jA.j1: num
        jA: jointRx[]
        jA.j6: num
        jA.j1+jA.j6: num
        nA: num[]
        mA: mdesc[]
        mA.vel: num
        mA: mdesc[]
        mA.tvel: num
        mA.vel+mA.tvel: num
        mA: mdesc[]
        mA.blend: blend
        Cartesian: blend
        cA: configRx[]
        cA.shoulder: shoulder
        ssame: shoulder
        pA: pointRx[]
        pA.config: configRx
        pA.config.wrist: wrist
        wfree: wrist
        tA: tool[]
        tA.gripper: dio
        nA: num[]
        fA: frame[]
        fA.trsf: trsf
        fA.trsf.x: num
        nA: num[]
        tA: tool[]
        world: frame[]
        here(tA,world): pointRx
        here(tA,world).trsf: trsf
        here(tA,world).trsf.x: num
    "#]].assert_eq(&types(listing));
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
    "#]].assert_eq(&faults(listing));
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
        nA: num[]
        jA: jointRs[]
        jA.j4: num
        nA: num[]
        jA: jointRs[]
        jA.j5: ?
        ! j5: UnknownField { ty: "jointRs", field: "j5", near: Some("j1") }
    "#]].assert_eq(&types(listing));
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
    "#]].assert_eq(&faults(listing));
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
        nA: num[]
        tA: Slot[]
        tA.nCount: num[]
        nA: num[]
        tB: Slot[]
        tB[1]: Slot
        tB[1].nCount: num[]
        tB: Slot[]
        tB.nCount: num[]
        tB[1].nCount+tB.nCount: num
        nA: num[]
        tTray: Tray[""]
        tTray["a"]: Tray
        tTray["a"].tSlots: Slot[]
        tTray["a"].tSlots[2]: Slot
        tTray["a"].tSlots[2].nCount: num[]
        nA: num[]
        tTray: Tray[""]
        tTray["a"]: Tray
        tTray["a"].nByName: num[""]
        tTray["a"].nByName["x"]: num
        nA: num[]
        tTray: Tray[""]
        tTray["a"]: Tray
        tTray["a"].nGrid: num[,]
        tTray["a"].nGrid[1,0]: num
        tTray: Tray[""]
        tTray["a"]: Tray
        tTray["a"].tSlots: Slot[]
        tTray["a"].tSlots[0]: Slot
        tB: Slot[]
        tB[2]: Slot
        bA: bool[]
        tA: Slot[]
        tB: Slot[]
        tB[0]: Slot
        tA==tB[0]: bool
    "#]].assert_eq(&types(listing));
}

#[test]
fn wrong_use_of_user_types() {
    let listing = r#"
        type Slot "Disk://Slot/Slot.pjx"
        type Other "Disk://Other/Other.pjx"
        num nA
        Slot tA
        Other tO
        Slot tC[""]
        nA=tA.nCuont
        nA=tA.nPrivate
        nA=tA.nGrid
        nA=tA
        tA=tO
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
        main/main.dtx:6 `tO` ReservedName { name: "tO" }
        main/start.pgx:5 `nCuont` UnknownField { ty: "Slot", field: "nCuont", near: Some("nCount") }
        main/start.pgx:6 `nPrivate` UnknownField { ty: "Slot", field: "nPrivate", near: None }
            Declared Slot/Slot.dtx:6 `nPrivate`
        main/start.pgx:7 `tA.nGrid` IndexMissing { name: "tA.nGrid", ty: "num[,]" }
            Declared Slot/Slot.dtx:5 `nGrid`
        main/start.pgx:8 `tA` AssignmentType { target: "num", value: "Slot" }
        main/start.pgx:10 `tC` IndexMissing { name: "tC", ty: "Slot[\"\"]" }
            Declared main/main.dtx:7 `tC`
        main/start.pgx:11 `tA+tA` OperatorType { op: "+", left: Some("Slot"), right: "Slot" }
        main/start.pgx:12 `tA` ConditionType { keyword: "if", found: "Slot" }
        main/start.pgx:14 `1` AssignmentType { target: "Slot", value: "num" }
    "#]].assert_eq(&faults(listing));
}

#[test]
fn locals_hide_parameters_hide_data() {
    let listing = r#"
        num nA
        string sB
        program start(bool x_b)
          string nA
          bool world
        begin
          nA="text"
          sB=nA
          x_b=world
        end
    "#;
    expect![[r#"
        nA: string
        sB: string[]
        nA: string
        x_b: bool
        world: bool
    "#]].assert_eq(&types(listing));
}

#[test]
fn built_in_names() {
    let listing = r#"
        point pA
        frame fA
        tool tA
        bool bA
        pA=here(flange,world)
        tA=flange
        fA=world
        bA=true
        true=bA
        joint=1
    "#;
    expect![[r#"
        pA: pointRx[]
        flange: tool[]
        world: frame[]
        here(flange,world): pointRx
        tA: tool[]
        flange: tool[]
        fA: frame[]
        world: frame[]
        bA: bool[]
        bA: bool[]
        joint: blend
        ! true: NotAssignable
        ! joint: NotAssignable
    "#]].assert_eq(&types(listing));
}

#[test]
fn names_that_are_no_values() {
    let listing = r#"
        library part "Disk://part/part.pjx"
        type Slot "Disk://Slot/Slot.pjx"
        num nA
        nA=other
        nA=part
        nA=Slot
        nA=sin
        nA=nB
        nB=1
        program other()
        begin
        end
        --- part
        public num nX
        --- Slot
        public num nX
    "#;
    expect![[r#"
        main/start.pgx:5 `other` NotAValue { name: "other", is: Program }
        main/start.pgx:6 `part` NotAValue { name: "part", is: Library }
        main/start.pgx:7 `Slot` NotAValue { name: "Slot", is: Type }
        main/start.pgx:8 `sin` NotAValue { name: "sin", is: Instruction }
        main/start.pgx:9 `nB` UnknownName { name: "nB", near: Some("nA") }
    "#]].assert_eq(&faults(listing));
}

#[test]
fn constants() {
    let expressions = [
        "1+2*3", "(1+2)*3", "-4%3", "1/0", "5%0", "1==1.0", "2>=3", "!true", "\"a\"+\"b\"", "\"a\"!=\"b\"",
        "true xor true", "true and nA==1", "nA", "-\"a\"", "\"a\"<\"b\"",
    ];
    let lines: String = expressions.iter().map(|text| format!("? {text}\n")).collect();
    let workspace = workspace(&format!("num nA\n{lines}"));
    let (db, main) = (&workspace.db, project(&workspace, "main"));
    let body = body(db, program(db, main, "start"));
    let constants = body.block.iter().zip(expressions).map(|(stmt, text)| {
        let val3_analysis::body::StmtKind::Print(id) = stmt.kind else { panic!("{stmt:?}") };
        assert!(*body.expr(id) != Expr::Missing, "{text}");
        let shown = match body.constant(id) {
            Some(Constant::Number(number)) => number.to_string(),
            Some(Constant::String(text)) => format!("{text:?}"),
            Some(Constant::Bool(value)) => value.to_string(),
            None => "not constant".to_owned(),
        };
        format!("{text} = {shown}\n")
    });
    expect![[r#"
        1+2*3 = 7
        (1+2)*3 = 9
        -4%3 = -1
        1/0 = not constant
        5%0 = not constant
        1==1.0 = true
        2>=3 = false
        !true = false
        "a"+"b" = "ab"
        "a"!="b" = true
        true xor true = false
        true and nA==1 = not constant
        nA = not constant
        -"a" = not constant
        "a"<"b" = not constant
    "#]].assert_eq(&constants.collect::<String>());
}
