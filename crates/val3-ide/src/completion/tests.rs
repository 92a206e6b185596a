mod other_files;
mod places;
mod written_lines;
mod xml;

use expect_test::{Expect, expect};

use super::*;
use crate::testing::MarkedListing;

fn found(listing: &str) -> Vec<Completion> {
    let marked = MarkedListing::new(listing);
    completions(marked.db(), marked.at())
}

/// Checks the first completions.
fn check(listing: &str, expected: Expect) {
    expected.assert_eq(&found(listing).iter().take(6).map(line).collect::<String>());
}

fn line(item: &Completion) -> String {
    format!("{} {:?} {}", item.label, item.kind, item.detail).trim_end().to_owned() + "\n"
}

/// Checks the inserted text of the completion `label`, with and without placeholders, and its additional edits.
fn check_insert(listing: &str, label: &str, expected: Expect) {
    let marked = MarkedListing::new(listing);
    let found = completions(marked.db(), marked.at());
    let item = found.iter().find(|item| item.label == label).unwrap();
    let mut shown = format!("{}\n{}\n", item.insert, item.plain);
    for edit in &item.additional {
        shown += format!("{}: {}", edit.file.path(marked.db()).file_name().unwrap(), edit.text.trim()).trim_end();
        shown.push('\n');
    }
    expected.assert_eq(&shown);
}

fn check_nothing(listing: &str) {
    let labels: Vec<String> = found(listing).into_iter().map(|item| item.label).collect();
    assert!(labels.is_empty(), "{listing}: {labels:?}");
}

const LIBRARY: &str = "\n--- part\npublic num nWeight\nnum nInner\npublic program pick(num x_n)\nbegin\nend";

#[test]
fn blocks_are_closed() {
    let closing = |code: &str| found(code).first().map(|item| item.label.clone()).unwrap_or_default();
    assert_eq!(closing("if true\n  cls()\nen$0"), "endIf");
    assert_eq!(closing("if true\n  cls()\nelse\nend$0"), "endIf");
    assert_eq!(closing("while true\nx=(\n$0"), "endWhile");
    assert_eq!(closing("do\nif true\nendIf\nu$0"), "until");
    assert_eq!(closing("num nA\nfor nA=0 to 3\nEND$0"), "endFor");
    assert_eq!(closing("num nA\nswitch nA\ncase 1\nb$0"), "break");
    assert_eq!(closing("num nA\nswitch nA\ncase 1\nbreak\nca$0"), "case");
    assert_eq!(closing("num nA\nswitch nA\ncase 1\nbreak\nend$0"), "endSwitch");
    assert_ne!(closing("if true\nendIf\nen$0"), "endIf");
}

#[test]
fn a_program_begins_and_ends() {
    let labels = |code| -> Vec<String> { found(&start_with(code)).into_iter().map(|item| item.label).collect() };
    for empty in ["$0", "be$0", "\n  // why\n  BE$0\n", "\n$0\nend"] {
        assert_eq!(labels(empty), ["begin"], "{empty:?}");
    }
    check_insert(
        &start_with("be$0"),
        "begin",
        expect![[r#"
            begin
              $0
            end
            begin
        "#]],
    );
    check_insert(
        &start_with("be$0\nend"),
        "begin",
        expect![[r#"
            begin
            begin
        "#]],
    );
    for unended in ["begin\n  cls()\nen$0", "begin\n  en$0\n  // done\n", "begin\nif true\nendIf\n$0"] {
        assert_eq!(labels(unended).first().map(String::as_str), Some("end"), "{unended:?}");
    }
    for other in ["begin\nen$0\nend", "begin\nif true\nen$0", "begin\nen$0\ncls()", "begin\nend\nen$0", "cls()\nen$0"] {
        assert!(!labels(other).iter().any(|label| label == "end" || label == "begin"), "{other:?}");
    }
}

/// A cell with exactly this code in `start`.
fn start_with(code: &str) -> String {
    format!(
        "program other()\nbegin\nend\n=== main/start.pgx\n<?xml version=\"1.0\" encoding=\"utf-8\"?>\n<Programs xmlns=\"http://www.staubli.com/robotics/VAL3/Program/2\"><Program name=\"start\">\n<Code><![CDATA[{code}]]></Code></Program></Programs>"
    )
}

#[test]
fn statements_are_proposed() {
    check(
        "num nCount\nnC$0",
        expect![[r#"
            nCount Data num
            nC Data new global num
        "#]],
    );
    check(
        "wai$0",
        expect![[r#"
        wait Instruction void wait(bool bCondition)
        waitEndMove Instruction void waitEndMove()
    "#]],
    );
    check_insert(
        "num nCount\nnC$0",
        "nCount",
        expect![[r#"
        nCount
        nCount
    "#]],
    );
    check_insert(
        "wai$0",
        "wait",
        expect![[r#"
        wait(${1:bCondition})$0
        wait
    "#]],
    );
    check_insert(
        "wai$0(true)",
        "wait",
        expect![[r#"
        wait
        wait
    "#]],
    );
    check_insert(
        "fo$0",
        "for",
        expect![[r#"
        for ${1:l_nIndex}=${2:0} to ${3:nLast}
          $0
        endFor
        for
    "#]],
    );
    check_insert(
        "pi$0\nprogram pick(num x_n)\nbegin\nend",
        "pick",
        expect![[r#"
        call pick(${1:x_n})$0
        call pick
    "#]],
    );
}

#[test]
fn values_of_the_expected_type_come_first() {
    check(
        "mdesc mFast\npoint pA\ntool tGrip\nmovej(pA,tGrip,$0)",
        expect![[r#"
        mFast Data mdesc
        {0,0,0,0,0,joint,0,0} Literal mdesc
        pA Data pointRx
        tGrip Data tool
    "#]],
    );
    check(
        "mdesc mFast\npoint pA\ntool tGrip\nmovej(pA,tGrip,$0",
        expect![[r#"
        mFast Data mdesc
        {0,0,0,0,0,joint,0,0} Literal mdesc
        pA Data pointRx
        tGrip Data tool
    "#]],
    );
    check(
        "joint jHome\npoint pA\nmovej($0",
        expect![[r#"
        jHome Data jointRx
        pA Data pointRx
        {0,0,0,0,0,0} Literal joint
        {{0,0,0,0,0,0},{ssame,esame,wsame}} Literal point
        abs Instruction joint abs(joint jPosition)
        appro Instruction point appro(point pPosition, trsf trTransformation)
    "#]],
    );
    check(
        "trsf trA\nnum nA\ntrA=$0",
        expect![[r#"
        trA Data trsf
        {0,0,0,0,0,0} Literal trsf
        align Instruction trsf align(trsf trPosition, trsf trReference)
        interpolateC Instruction trsf interpolateC(trsf trStart, trsf trIntermediate, trsf trEnd, num nPosition)
        interpolateL Instruction trsf interpolateL(trsf trStart, trsf trEnd, num nPosition)
        position Instruction trsf position(frame fFrame, frame fReference)
    "#]],
    );
    check(
        "string sA\nnum nA\nif sA==$0",
        expect![[r#"
        sA Data string
        chr Instruction string chr(num nCodePoint)
        delete Instruction string delete(string sText, num nSize, num nPosition)
        first Instruction string first(T& variable[""])
        getDate Instruction string getDate(string sFormat)
        getLanguage Instruction string getLanguage()
    "#]],
    );
    check(
        "mdesc mA\nmA.blend=$0",
        expect![[r#"
        Cartesian Constant blend
        joint Constant blend
        off Constant blend
        mA Data mdesc
    "#]],
    );
    check(
        "dio diDoor\nnum nA\nif $0",
        expect![[r#"
        diDoor Data dio
        false Constant bool
        true Constant bool
        autoConnectMove Instruction bool autoConnectMove()
        delete Instruction bool delete(T variable)
        getLatch Instruction bool getLatch(joint& jPosition)
    "#]],
    );
    check(
        "num nA[4]\nstring sA\nnum nB\nnB=nA[$0",
        expect![[r#"
        nA Data num[]
        nB Data num
        abs Instruction num abs(num nValue)
        acos Instruction num acos(num nValue)
        aioGet Instruction num aioGet(aio aiInput)
        aioSet Instruction num aioSet(aio aiOutput, num nValue)
    "#]],
    );
    check(
        "num nA\nstring sA\nswitch sA\ncase $0\nbreak\nendSwitch",
        expect![[r#"
        sA Data string
        chr Instruction string chr(num nCodePoint)
        delete Instruction string delete(string sText, num nSize, num nPosition)
        first Instruction string first(T& variable[""])
        getDate Instruction string getDate(string sFormat)
        getLanguage Instruction string getLanguage()
    "#]],
    );
    check(
        "mdesc mA\nmA={0,0,0,0,0,$0",
        expect![[r#"
        Cartesian Constant blend
        joint Constant blend
        off Constant blend
        mA Data mdesc
    "#]],
    );
    check(
        "num nA\nstring sA\ncall pick($0\nprogram pick(string& x_s)\nbegin\nend",
        expect![[r#"
        sA Data string
        nA Data num
    "#]],
    );
}

#[test]
fn incomplete_lines_are_completed() {
    check(
        "point pA\nnum nA\nif pA.$0\nelse\n  nA=1\nendIf",
        expect![[r#"
        trsf Field trsf
        config Field config
    "#]],
    );
    check(
        "mdesc mA\nnum nA\nnA = = mA.$0",
        expect![[r#"
        accel Field num
        vel Field num
        decel Field num
        tvel Field num
        rvel Field num
        blend Field blend
    "#]],
    );
    check(
        "point pA\ntool tA\nmdesc mA\nmovej(pA,\nmovel(pA,tA,$0\nmovej(",
        expect![[r#"
        mA Data mdesc
        {0,0,0,0,0,joint,0,0} Literal mdesc
        pA Data pointRx
        tA Data tool
    "#]],
    );
    check(
        "num nA\nstring sA\nwhile (nA<3 and ($0",
        expect![[r#"
        false Constant bool
        true Constant bool
        autoConnectMove Instruction bool autoConnectMove()
        delete Instruction bool delete(T variable)
        getLatch Instruction bool getLatch(joint& jPosition)
        insert Instruction bool insert(T variable)
    "#]],
    );
    check(
        "num nA\nstring sA\nnA=nA+$0",
        expect![[r#"
            nA Data num
            abs Instruction num abs(num nValue)
            acos Instruction num acos(num nValue)
            aioGet Instruction num aioGet(aio aiInput)
            aioSet Instruction num aioSet(aio aiOutput, num nValue)
            asc Instruction num asc(string sText, num nPosition)
        "#]],
    );
    check(
        "num nA\nstring sA\nnA=$0\nsA=\"a\"",
        expect![[r#"
            nA Data num
            abs Instruction num abs(num nValue)
            acos Instruction num acos(num nValue)
            aioGet Instruction num aioGet(aio aiInput)
            aioSet Instruction num aioSet(aio aiOutput, num nValue)
            asc Instruction num asc(string sText, num nPosition)
        "#]],
    );
    check(
        "num nA\nnA$0",
        expect![[r#"
            nA Data num
        "#]],
    );
}

#[test]
fn operators_follow_values() {
    check(
        "bool bA\nif bA $0",
        expect![[r#"
        and Keyword
        or Keyword
        xor Keyword
    "#]],
    );
    check(
        "num nA\nfor nA=0 $0",
        expect![[r#"
        to Keyword
    "#]],
    );
    check(
        "num nA\nfor nA=0 to 3 $0",
        expect![[r#"
        step Keyword
    "#]],
    );
    check_nothing("num nA\nnA=nA $0");
}

#[test]
fn members_are_proposed_after_a_dot() {
    check(
        "point pA\npA.$0",
        expect![[r#"
            trsf Field trsf
            config Field config
            var Keyword l_pValue=pA
        "#]],
    );
    check(
        "point pA\nnum nA\nif pA.trsf.$0\nendIf\nnA=1",
        expect![[r#"
        x Field num
        y Field num
        z Field num
        rx Field num
        ry Field num
        rz Field num
    "#]],
    );
    check(
        "point pA\npA.trsf.r$0=1",
        expect![[r#"
        rx Field num
        ry Field num
        rz Field num
    "#]],
    );
    check(
        "point pA[3]\nnum nA\nnA=pA[nA].config.$0",
        expect![[r#"
        shoulder Field shoulder
        elbow Field elbow
        wrist Field wrist
    "#]],
    );
    check(
        "point pA\ntool tA\nput(here(tA,world).$0",
        expect![[r#"
            trsf Field trsf
            config Field config
        "#]],
    );
    check(
        "type Slot \"Disk://Slot/Slot.pjx\"\nSlot sA\nsA.$0\n--- Slot\npublic num nHeight",
        expect![[r#"
        nHeight Field num
    "#]],
    );
    check_nothing("num nA\nput(nA.$0");
}

#[test]
fn items_of_libraries_are_proposed() {
    let with = |line: &str| format!("library part \"Disk://part/part.pjx\"\nnum nA\n{line}{LIBRARY}");
    check(
        &with("nA=part:$0"),
        expect![[r#"
        nWeight Data num
        libLoad Instruction num library:libLoad(string sPath)
        libSave Instruction num library:libSave()
        $libClose Instruction bool library:$libClose()
        $libOpen Instruction bool library:$libOpen()
        libExist Instruction bool library:libExist(string sSymbolName)
    "#]],
    );
    check(
        &with("part:$0"),
        expect![[r#"
        nWeight Data num
        $libClose Instruction bool library:$libClose()
        $libOpen Instruction bool library:$libOpen()
        libLoad Instruction num library:libLoad(string sPath)
        libSave Instruction num library:libSave()
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
        &with("taskCreate \"a\",10,p$0"),
        expect![[r#"
        part Library library
    "#]],
    );
    check_insert(
        &with("call part:$0"),
        "pick",
        expect![[r#"
        pick(${1:x_n})$0
        pick
    "#]],
    );
}

#[test]
fn undeclared_names_can_be_created() {
    check_insert(
        "mdesc mFast\npoint pA\ntool tGrip\nmovej(pA,tGrip,mSlow$0)",
        "mSlow",
        expect![[r#"
        mSlow
        mSlow
        main.dtx: <Data name="mSlow" access="private" xsi:type="array" type="mdesc" size="1" />
    "#]],
    );
    check_insert(
        "nNew$0=1",
        "nNew",
        expect![[r#"
        nNew
        nNew
        main.dtx: <Datas>
            <Data name="nNew" access="private" xsi:type="array" type="num" size="1" />
          </Datas>
    "#]],
    );
    let without = |line: &str| format!("{line}{LIBRARY}");
    check_insert(
        &without("call pa$0"),
        "part",
        expect![[r#"
        part:
        part:
        main.pjx: <Libraries>
            <Library alias="part" path="Disk://part/part.pjx" />
          </Libraries>
    "#]],
    );
    check_insert(
        &without("call part:$0"),
        "pick",
        expect![[r#"
        pick(${1:x_n})$0
        pick
        main.pjx: <Libraries>
            <Library alias="part" path="Disk://part/part.pjx" />
          </Libraries>
    "#]],
    );
    check_insert(
        &without("put(part:$0"),
        "nWeight",
        expect![[r#"
        nWeight
        nWeight
        main.pjx: <Libraries>
            <Library alias="part" path="Disk://part/part.pjx" />
          </Libraries>
    "#]],
    );
}
