use expect_test::{Expect, expect};

use super::*;
use crate::testing::Marked;

/// The first completions.
fn check(listing: &str, expected: Expect) {
    let marked = Marked::new(listing);
    let found = completions(marked.db(), marked.at());
    let shown: String =
        found.iter().take(6).map(|item| format!("{} {:?} {}\n", item.label, item.kind, item.detail)).collect();
    expected.assert_eq(&shown);
}

const LIBRARY: &str = "\n--- part\npublic num nWeight\nnum nInner\npublic program pick(num x_n)\nbegin\nend";

#[test]
fn statements() {
    check(
        "num nCount\nif nCount==1\n  nCount=2\nen$0",
        expect![[r#"
        endIf Keyword ends the block
        enablePower Instruction void enablePower()
        waitEndMove Instruction void waitEndMove()
        open Instruction void open(tool tTool)
        append Instruction void append(T variable)
        return Keyword 
    "#]],
    );
    check(
        "num nCount\nnC$0",
        expect![[r#"
        nCount Data num
        taskCreateSync Keyword 
        $getJntSpeedCmd Instruction void $getJntSpeedCmd(num& nSpeed[])
        taskCreateSync Instruction taskCreateSync string sName, num nPeriod, bool& bOverrun, program(...)
        getJointForce Instruction void getJointForce(num& nForce[])
        $computeJntFrc Instruction void $computeJntFrc(joint jPosition, num& nSpeed[], num& nAcceleration[], num& nForce[])
    "#]],
    );
    check(
        "wai$0",
        expect![[r#"
        wait Instruction void wait(bool bCondition)
        waitEndMove Instruction void waitEndMove()
    "#]],
    );
}

#[test]
fn values_of_the_expected_type() {
    check(
        "mdesc mFast\npoint pA\ntool tGrip\nmovej(pA,tGrip,$0)",
        expect![[r#"
        mFast Data mdesc
        {0,0,0,0,0,joint,0,0} Literal mdesc
        pA Data pointRx
        tGrip Data tool
        $circleFind Instruction num $circleFind(trsf& trPositions[], trsf& trResult, num& nRadius)
        $compile Instruction string $compile(string sCode)
    "#]],
    );
    check(
        "trsf trA\nnum nA\ntrA=$0",
        expect![[r#"
        nA Data num
        trA Data trsf
        $circleFind Instruction num $circleFind(trsf& trPositions[], trsf& trResult, num& nRadius)
        $compile Instruction string $compile(string sCode)
        $copy Instruction bool $copy(string sFrom, string sTo)
        $delete Instruction bool $delete(string sPath)
    "#]],
    );
    check(
        "string sA\nnum nA\nif sA==$0",
        expect![[r#"
        sA Data string
        $compile Instruction string $compile(string sCode)
        $exec Instruction string $exec(string sCode)
        $getName Instruction string $getName(T variable)
        chr Instruction string chr(num nCodePoint)
        delete Instruction bool delete(T variable)
    "#]],
    );
    check(
        "mdesc mA\nmA.blend=$0",
        expect![[r#"
        mA Data mdesc
        $circleFind Instruction num $circleFind(trsf& trPositions[], trsf& trResult, num& nRadius)
        $compile Instruction string $compile(string sCode)
        $copy Instruction bool $copy(string sFrom, string sTo)
        $delete Instruction bool $delete(string sPath)
        $exec Instruction string $exec(string sCode)
    "#]],
    );
}

#[test]
fn members() {
    check("point pA\npA.$0", expect![[r#""#]]);
    check(
        "point pA\npA.trsf.r$0=1",
        expect![[r#"
        rx Field num
        ry Field num
        rz Field num
    "#]],
    );
    check("type Slot \"Disk://Slot/Slot.pjx\"\nSlot sA\nsA.$0\n--- Slot\npublic num nHeight", expect![[r#""#]]);
}

#[test]
fn libraries() {
    let with = |line: &str| format!("library part \"Disk://part/part.pjx\"\nnum nA\n{line}{LIBRARY}");
    check(
        &with("nA=part:$0"),
        expect![[r#"
        nWeight Data num
        $libClose Instruction bool library:$libClose()
        $libOpen Instruction bool library:$libOpen()
        libExist Instruction bool library:libExist(string sSymbolName)
        libLoad Instruction num library:libLoad(string sPath)
        libPath Instruction string library:libPath()
    "#]],
    );
    check(
        &with("call part:$0"),
        expect![[r#"
        pick Program public program pick(num x_n)
    "#]],
    );
    check(
        &with("call $0"),
        expect![[r#"
        part Library library
        start Program program start()
    "#]],
    );
    check(
        &with("nA=part:libLoad(\"$0\")"),
        expect![[r#"
        Disk://part Path library
    "#]],
    );
    check(
        &with("taskCreate \"a\",10,p$0"),
        expect![[r#"
        part Library library
    "#]],
    );
}

#[test]
fn nothing_where_nothing_fits() {
    check("// no$0", expect![[r#""#]]);
    check("num nA\nnA=12$0", expect![[r#""#]]);
}
