//! Statements and the types that they require; unused values; assignments (2.1 to 2.4, 3).

use expect_test::expect;

use crate::show::{faults, types};

#[test]
fn conditions() {
    let listing = r#"
        num nA
        bool bA
        dio dA
        string sA
        if bA
        elseIf dA
        elseIf nA
        elseIf sA=="x"
        endIf
        while nA
        endWhile
        do
        until sA
        while true
        endWhile
    "#;
    expect![[r#"
        main/start.pgx:7 `nA` ConditionType { keyword: "elseIf", found: "num" }
        main/start.pgx:10 `nA` ConditionType { keyword: "while", found: "num" }
        main/start.pgx:13 `sA` ConditionType { keyword: "until", found: "string" }
    "#]]
    .assert_eq(&faults(listing));
}

#[test]
fn loops() {
    let listing = r#"
        num nA
        num nG[2,2]
        string sA
        bool bA
        for nA=1 to 3 step 0.5
        endFor
        for nG[0,1]=nA to nA
        endFor
        for sA=1 to 3
        endFor
        for nA="1" to bA step sA
        endFor
        for nG=1 to 2
        endFor
        for 1=1 to 2
        endFor
    "#;
    expect![[r#"
        main/start.pgx:9 `sA` ForCounter { found: "string" }
        main/start.pgx:11 `"1"` ForBound { keyword: "=", found: "string" }
        main/start.pgx:11 `bA` ForBound { keyword: "to", found: "bool" }
        main/start.pgx:11 `sA` ForBound { keyword: "step", found: "string" }
        main/start.pgx:13 `nG` IndexMissing { name: "nG", ty: "num[,]" }
            Declared main/main.dtx:5 `nG`
    "#]]
    .assert_eq(&faults(listing));
}

#[test]
fn switches() {
    let listing = r#"
        num nA
        string sA
        bool bA
        screen scA
        dio dA
        switch nA
          case 1,2,nA
            nA=1
          break
          case "x"
          break
          default
            nA=2
          break
        endSwitch
        switch sA
          case 1,"a"
          break
        endSwitch
        switch scA
          case 1
          break
        endSwitch
        switch dA
          case true
          break
        endSwitch
        switch nMissing
          case 1,"a"
          break
        endSwitch
    "#;
    expect![[r#"
        main/start.pgx:9 `"x"` CaseType { expected: "num", found: "string" }
        main/start.pgx:16 `1` CaseType { expected: "string", found: "num" }
        main/start.pgx:19 `scA` SwitchType { found: "screen" }
        main/start.pgx:27 `nMissing` UnknownName { name: "nMissing", near: None }
    "#]]
    .assert_eq(&faults(listing));
}

#[test]
fn assignments() {
    let listing = r#"
        num nA
        num nB
        string sA
        bool bA
        dio dA
        dio dB
        aio aA
        sio siA
        screen scA
        nA=nB=3
        sA=nA=3
        nA=sA="x"
        nA=sA
        dA=true
        dA=dB
        bA=dA
        aA=3
        siA=3
        siA="x"
        scA=scA
        1=nA
        nA+1=2
        sin(1)=2
    "#;
    expect![[r#"
        nA: num | nB: num | nB=3: num
        sA: string | nA: num | nA=3: num
        nA: num | sA: string | sA="x": string
        nA: num | sA: string
        dA: dio
        dA: dio | dB: dio
        bA: bool | dA: dio
        aA: aio
        siA: sio
        siA: sio
        scA: screen | scA: screen
        nA: num
        nA: num | nA+1: num
        sin(1): num
        ! nA=3: AssignmentType { target: "string", value: "num" }
        ! sA="x": AssignmentType { target: "num", value: "string" }
        ! sA: AssignmentType { target: "num", value: "string" }
        ! dB: AssignmentType { target: "dio", value: "dio" }
        ! 3: AssignmentType { target: "aio", value: "num" }
        ! scA: AssignmentType { target: "screen", value: "screen" }
        ! 1: NotAssignable
        ! nA+1: NotAssignable
        ! sin(1): NotAssignable
    "#]]
    .assert_eq(&types(listing));
}

#[test]
fn lines_without_effect() {
    let listing = r#"
        num nA
        bool bA
        nA
        nA==1
        sin(nA)
        insert("a","b",1)
        nA=cls()
        nA=sin(cls())
        cls()
        movej(here(flange,world),flange,{})
        nMissing
    "#;
    expect![[r#"
        main/start.pgx:5 `nA` NoEffect
        main/start.pgx:6 `nA==1` NoEffect
        main/start.pgx:7 `sin(nA)` NoEffect
        main/start.pgx:8 `insert("a","b",1)` NoEffect
        main/start.pgx:9 `cls()` NoValue { callee: "cls" }
        main/start.pgx:10 `cls()` NoValue { callee: "cls" }
        main/start.pgx:13 `nMissing` UnknownName { name: "nMissing", near: None }
    "#]]
    .assert_eq(&faults(listing));
}

#[test]
fn print_shows_any_value() {
    let listing = r#"
        num nA[3]
        point pA
        num nG[2,2]
        ? nA[1]+2
        ? pA.trsf
        ? "a"+"b"
        ? nG
        ? nMissing
    "#;
    expect![[r#"
        nA: num[] | nA[1]: num | nA[1]+2: num
        pA: pointRx | pA.trsf: trsf
        "a"+"b": string
        nG: num[,]
        nMissing: ?
        ! nMissing: UnknownName { name: "nMissing", near: None }
    "#]]
    .assert_eq(&types(listing));
}

#[test]
fn long_strings() {
    let (fits, too_long) = ("é".repeat(64), "é".repeat(65));
    let listing = format!("string sA\nsA=\"{fits}\"\nsA=\"{too_long}\"\n");
    let found = faults(&listing).replace(&too_long, "…");
    expect![[r#"
        main/start.pgx:6 `"…"` StringTooLong(130)
    "#]]
    .assert_eq(&found);
}

fn add_on_table(functions: &str) -> String {
    format!(
        "<Language xmlns=\"http://www.staubli.com/robotics/VAL3/1\"><Version>s7.8</Version><Data></Data><Functions>{functions}</Functions></Language>"
    )
}

#[test]
fn instructions_of_add_ons() {
    let one = r#"<Func><Name>$thing</Name><Return>num</Return><Param index="0" type="num" dataRef="false" collectionName="false" subCollection="false" array="false" dictionary="false" arrayDim="1" /><Lib>false</Lib><Class>Function</Class></Func>"#;
    let other = one.replace("type=\"num\"", "type=\"string\"").replace("<Return>num", "<Return>string");
    let listing = format!(
        "num nA\nstring sA\nnA=$thing(1)\nsA=$thing(\"x\")\nnA=$thing(true)\nnA=$nothing(1)\n$fileOpen(1)\n\
         === /app/val3.One.anthro.cfx\n{}\n=== /app/val3.Two.anthro.cfx\n{}\n=== /app/val3.Two.scara.cfx\n<Language />",
        add_on_table(one),
        add_on_table(&other),
    );
    expect![[r#"
        nA: num | $thing(1): num
        sA: string | $thing("x"): string
        nA: num | $thing(true): ?
        nA: num | $nothing(1): ?
        $fileOpen(1): ?
        ! true: ArgumentType { callee: "$thing", parameter: "n1", expected: ["num", "string"], found: "bool" }
        ! $nothing: MissingAddOn { name: "$nothing", add_on: None, lists_others: true, other_forms: [] }
        ! $fileOpen: MissingAddOn { name: "$fileOpen", add_on: Some("Expansion"), lists_others: true, other_forms: ["num $fileOpen(string sPath, string sMode)"] }
    "#]]
    .assert_eq(&types(&listing));
}

#[test]
fn arguments_of_add_on_instructions_without_a_table_are_compared_with_the_known_forms() {
    let listing = "num nF\nstring sA[2]\nnF=$fileOpen(\"a\",\"r\",1)\nnF=$fileOpen(\"a\",nWrong)\nnF=$fileOpen(\"a\",1)\n\
                   nF=$fileOpen(sA[0],\"r\")\nnF=$fileOpen(sA[nNo],\"r\",1)\n";
    expect![[r#"
        nF: num | $fileOpen("a","r",1): ?
        nF: num | nWrong: ? | $fileOpen("a",nWrong): ?
        nF: num | $fileOpen("a",1): ?
        nF: num | sA: string[] | sA[0]: string | $fileOpen(sA[0],"r"): num
        nF: num | sA: string[] | nNo: ? | sA[nNo]: string | $fileOpen(sA[nNo],"r",1): ?
        ! $fileOpen: MissingAddOn { name: "$fileOpen", add_on: Some("Expansion"), lists_others: false, other_forms: ["num $fileOpen(string sPath, string sMode)"] }
        ! $fileOpen: MissingAddOn { name: "$fileOpen", add_on: Some("Expansion"), lists_others: false, other_forms: [] }
        ! nWrong: UnknownName { name: "nWrong", near: None }
        ! $fileOpen: MissingAddOn { name: "$fileOpen", add_on: Some("Expansion"), lists_others: false, other_forms: ["num $fileOpen(string sPath, string sMode)"] }
        ! $fileOpen: MissingAddOn { name: "$fileOpen", add_on: Some("Expansion"), lists_others: false, other_forms: [] }
        ! $fileOpen: MissingAddOn { name: "$fileOpen", add_on: Some("Expansion"), lists_others: false, other_forms: ["num $fileOpen(string sPath, string sMode)"] }
        ! nNo: UnknownName { name: "nNo", near: None }
    "#]].assert_eq(&types(listing));
}
