//! `val3 test --mutate`: mistakes in tested programs, and the mistakes that no test finds.

use std::collections::BTreeSet;
use std::fs;

use camino::{Utf8Path, Utf8PathBuf};
use expect_test::expect;
use serde_json::Value;

use crate::support::{CommandOutput, Folder};

/// No test asserts the values that `pal` stores in `nState` and `sShown`.
const CELL: &str = r#"
--- palTest
library pal "Disk://pal/pal.pjx"
library assert "Disk://val3assert/val3assert.pjx"
num nSum
program testTotal()
begin
  call pal:total(3,nSum)
  call assert:equalNum(nSum,6,0)
end

--- pal
num nState
string sShown
public program total(num x_nCount, num& x_nSum)
  num l_i
begin
  x_nSum=0
  l_i=1
  while l_i<=x_nCount
    x_nSum=x_nSum+l_i
    l_i=l_i+1
  endWhile
  nState=2
  if x_nCount>100
    sShown="many"
  endIf
end
public program idle()
begin
  nState=1
end
"#;

/// The test asserts every effect of `pal`.
const GOOD: &str = r#"
--- palTest
library pal "Disk://pal/pal.pjx"
library assert "Disk://val3assert/val3assert.pjx"
num nSum
string sText
program testTotal()
begin
  nSum=5
  call pal:total(3,nSum)
  call assert:equalNum(nSum,6,0)
  call pal:text(4,sText)
  call assert:equalString(sText,"n4")
end

--- pal
public program total(num x_nCount, num& x_nSum)
begin
  x_nSum=3
  x_nSum=x_nSum+x_nCount
end
public program text(num x_nCount, string& x_sText)
begin
  x_sText=toString("",x_nCount)
  x_sText="n"+x_sText
end
public program idle(num& x_nCount)
begin
  x_nCount=1
end
"#;

fn cell(listing: &str) -> Folder {
    let folder = Folder::with(listing);
    let written = folder.val3(&["test", "--init", "usrapp/pal"]);
    assert_eq!(written.code, 0, "{written:?}");
    folder
}

fn mutated(folder: &Folder, options: &[&str]) -> CommandOutput {
    folder.val3(&[&["test", "--mutate", "usrapp/palTest/testTotal.pgx"], options].concat())
}

fn report(folder: &Folder, options: &[&str]) -> Value {
    let run = mutated(folder, &[&["--format", "json"], options].concat());
    assert_eq!(run.code, 1, "{run:?}");
    serde_json::from_str(&run.stdout).unwrap()
}

#[test]
fn surviving_mistakes_name_what_no_assertion_looks_at() {
    let run = mutated(&cell(CELL), &[]);
    assert_eq!((run.code, run.stderr.as_str()), (1, ""), "{run:?}");
    expect![[r#"
        usrapp/pal/total.pgx:12: survived: `x_nSum=0` is removed
           12 │ x_nSum=0
                executed by palTest:testTotal
                nothing that can be asserted differs at the end of a test
        usrapp/pal/total.pgx:13: survived: `l_i=1` is removed
           13 │ l_i=1
                executed by palTest:testTotal
                nothing that can be asserted differs at the end of a test
        usrapp/pal/total.pgx:18: survived: `nState=2` is removed
           18 │ nState=2
                executed by palTest:testTotal
                pal:nState is 0 instead of 2 at the end of palTest:testTotal: no assertion looks at it
        usrapp/pal/total.pgx:18: survived: `2` becomes `3`
           18 │ nState=2
                executed by palTest:testTotal
                pal:nState is 3 instead of 2 at the end of palTest:testTotal: no assertion looks at it
        usrapp/pal/total.pgx:19: survived: `x_nCount>100` becomes `!(x_nCount>100)`
           19 │ if x_nCount>100
                executed by palTest:testTotal
                pal:sShown is "many" instead of "" at the end of palTest:testTotal: no assertion looks at it
        usrapp/pal/total.pgx:19: survived: `>` becomes `>=`
           19 │ if x_nCount>100
                executed by palTest:testTotal
                nothing that can be asserted differs at the end of a test
        usrapp/pal/total.pgx:19: survived: `100` becomes `101`
           19 │ if x_nCount>100
                executed by palTest:testTotal
                nothing that can be asserted differs at the end of a test
        mutants: 16, found 9, survived 7, not compiled 0
        not covered: 2 lines, which got no mistakes (`val3 test --coverage` shows them)
    "#]]
    .assert_eq(&run.stdout);
}

#[test]
fn each_mistake_has_its_verdict() {
    let report = report(&cell(CELL), &[]);
    let shown = report["mutants"].as_array().unwrap().iter().map(|mutant| {
        format!(
            "{}: {} -> {}: {} {}\n",
            mutant["line"], mutant["found"], mutant["replacement"], mutant["verdict"], mutant["foundBy"]
        )
    });
    expect![[r#"
        12: "x_nSum=0" -> "": "survived" null
        12: "0" -> "1": "found" "palTest:testTotal"
        13: "l_i=1" -> "": "survived" null
        13: "1" -> "2": "found" "palTest:testTotal"
        14: "l_i<=x_nCount" -> "!(l_i<=x_nCount)": "found" "palTest:testTotal"
        14: "<=" -> "<": "found" "palTest:testTotal"
        15: "x_nSum=x_nSum+l_i" -> "": "found" "palTest:testTotal"
        15: "+" -> "-": "found" "palTest:testTotal"
        16: "l_i=l_i+1" -> "": "found" "palTest:testTotal"
        16: "+" -> "-": "found" "palTest:testTotal"
        16: "1" -> "2": "found" "palTest:testTotal"
        18: "nState=2" -> "": "survived" null
        18: "2" -> "3": "survived" null
        19: "x_nCount>100" -> "!(x_nCount>100)": "survived" null
        19: ">" -> ">=": "survived" null
        19: "100" -> "101": "survived" null
    "#]]
    .assert_eq(&shown.collect::<String>());
    expect![[r#"
        {
          "difference": null,
          "file": "usrapp/pal/total.pgx",
          "found": "100",
          "foundBy": null,
          "line": 19,
          "path": null,
          "replacement": "101",
          "source": "if x_nCount>100",
          "tests": [
            "palTest:testTotal"
          ],
          "verdict": "survived"
        }"#]]
    .assert_eq(&format!("{:#}", report["mutants"].as_array().unwrap().last().unwrap()));
}

#[test]
fn a_seed_and_a_number_choose_mistakes() {
    let folder = cell(CELL);
    let chosen = |options: &[&str]| mistakes(&report(&folder, options));
    let all = chosen(&[]);
    let some = chosen(&["--mutations", "13"]);
    assert_eq!(some.len(), 13);
    assert!(some.is_subset(&all));
    assert_eq!(some, chosen(&["--mutations", "13", "--seed", "1", "--jobs", "1"]));
    assert_ne!(some, chosen(&["--mutations", "13", "--seed", "2"]));
}

/// Lines, texts and replacements of the mistakes in the report.
fn mistakes(report: &Value) -> BTreeSet<String> {
    let mutants = report["mutants"].as_array().unwrap().iter();
    mutants.map(|mutant| format!("{}{}{}", mutant["line"], mutant["found"], mutant["replacement"])).collect()
}

#[test]
fn no_mistake_survives_good_tests() {
    let folder = cell(GOOD);
    let run = mutated(&folder, &[]);
    assert_eq!((run.code, run.stderr.as_str()), (0, ""), "{run:?}");
    expect![[r#"
        mutants: 6, found 6, survived 0, not compiled 1
        not covered: 1 line, which got no mistakes (`val3 test --coverage` shows it)
    "#]]
    .assert_eq(&run.stdout);
}

#[test]
fn tests_that_fail_get_no_mistakes() {
    let folder = cell(&CELL.replace("nSum,6,0", "nSum,7,0"));
    let run = mutated(&folder, &[]);
    assert_eq!(run.code, 1, "{run:?}");
    assert_eq!(run.stderr, "error: no mistake was seeded, because the tests must pass without one\n");
    assert!(run.stdout.contains("6 instead of 7") && !run.stdout.contains("mutants"), "{run:?}");
}

#[test]
fn no_file_is_changed() {
    let folder = cell(CELL);
    let before = files(&folder);
    mutated(&folder, &[]);
    assert!(files(&folder) == before);
}

/// All files of the applications.
fn files(folder: &Folder) -> Vec<(Utf8PathBuf, Vec<u8>)> {
    let applications = Utf8Path::from_path(folder.path()).unwrap().join("usrapp");
    let folders = ["pal", "palTest", "val3assert"].map(|name| applications.join(name));
    let files = folders.iter().flat_map(|folder| folder.read_dir_utf8().unwrap());
    let paths = files.map(|file| file.unwrap().into_path());
    paths.map(|path| (path.clone(), fs::read(path).unwrap())).collect()
}

#[test]
fn other_formats_are_refused() {
    let run = mutated(&cell(CELL), &["--format", "junit"]);
    assert_eq!(run.code, 2, "{run:?}");
    assert!(run.stderr.contains("--format json"), "{run:?}");
    let run = mutated(&cell(CELL), &["--fail-fast"]);
    assert_eq!(run.code, 2, "{run:?}");
}

#[test]
fn tests_that_execute_no_tested_line_prove_nothing() {
    let folder = Folder::with("num nUnused\n--- palTest\nnum nSum\nprogram testNothing()\nbegin\n  nSum=1\nend\n");
    let run = folder.val3(&["test", ".", "--mutate"]);
    assert!(run.code == 2 && run.stderr.contains("the tests execute no line of a tested program"), "{run:?}");
}

/// The point is in a frame, and no program uses `nUnused`.
const DATA: &str = r#"
--- palTest
library pal "Disk://pal/pal.pjx"
library assert "Disk://val3assert/val3assert.pjx"
num nHeight
program testHeight()
begin
  call pal:height(nHeight)
  call assert:equalNum(nHeight,530,0)
end

--- pal
public program height(num& x_nHeight)
begin
  x_nHeight=position(pPick,world).z
  sState="done "+sName
  popUpMsg(sName)
end
=== pal/pal.dtx
<?xml version="1.0" encoding="utf-8"?>
<Database xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance" xmlns="http://www.staubli.com/robotics/VAL3/Data/2">
  <Datas>
    <Data name="fTray" access="private" xsi:type="array" type="frame" size="1"><Value key="0" z="500" fatherId="world[0]" /></Data>
    <Data name="nUnused" access="private" xsi:type="array" type="num" size="1"><Value key="0" value="3" /></Data>
    <Data name="pPick" access="private" xsi:type="array" type="pointRx" size="1"><Value key="0" z="30" wrist="wpositive" fatherId="fTray[0]" /></Data>
    <Data name="sName" access="private" xsi:type="array" type="string" size="1"><Value key="0" value="box" /></Data>
    <Data name="sState" access="private" xsi:type="array" type="string" size="1" />
  </Datas>
</Database>
"#;

#[test]
fn values_of_data_files_get_mistakes() {
    let folder = cell(DATA);
    let run = folder.val3(&["test", "--mutate", "usrapp/palTest/testHeight.pgx"]);
    assert_eq!((run.code, run.stderr.as_str()), (1, ""), "{run:?}");
    expect![[r#"
        usrapp/pal/height.pgx:9: survived: `sState="done "+sName` is removed
            9 │ sState="done "+sName
                executed by palTest:testHeight
                pal:sState is "" instead of "done box" at the end of palTest:testHeight: no assertion looks at it
        usrapp/pal/height.pgx:10: survived: `popUpMsg(sName)` is removed
           10 │ popUpMsg(sName)
                executed by palTest:testHeight
                message 1 is missing instead of "box" at the end of palTest:testHeight: no assertion looks at it
        usrapp/pal/pal.dtx:6: survived: pPick.config.wrist: `wpositive` becomes `wnegative`
            6 │ <Data name="pPick" access="private" xsi:type="array" type="pointRx" size="1"><Value key="0" z="30" wrist="wpositive" fatherId="fTray[0]" /></Data>
                used by palTest:testHeight
                nothing else that can be asserted differs at the end of a test
        usrapp/pal/pal.dtx:7: survived: sName: `box` becomes `boxx`
            7 │ <Data name="sName" access="private" xsi:type="array" type="string" size="1"><Value key="0" value="box" /></Data>
                used by palTest:testHeight
                pal:sState is "done boxx" instead of "done box" at the end of palTest:testHeight: no assertion looks at it
        mutants: 7, found 3, survived 4, not compiled 1
        not used: pal:nUnused, which got no mistakes
    "#]].assert_eq(&run.stdout);
}

/// `rec` has only data, `pal:nLimit` shares a name with used data, and `"nText"` is only a string.
const LIBRARIES: &str = r#"
--- palTest
library pal "Disk://pal/pal.pjx"
library assert "Disk://val3assert/val3assert.pjx"
num nSum
program testSum()
begin
  call pal:sum(nSum)
  call assert:equalNum(nSum,7,0)
end

--- pal
library rec "Disk://rec/rec.pjx"
public program sum(num& x_nSum)
begin
  x_nSum=rec:nLimit+nOffset
  logMsg("nText")
  logMsg("again")
  logMsg("again")
end
=== pal/pal.dtx
<?xml version="1.0" encoding="utf-8"?>
<Database xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance" xmlns="http://www.staubli.com/robotics/VAL3/Data/2">
  <Datas>
    <Data name="nLimit" access="private" xsi:type="array" type="num" size="1"><Value key="0" value="1" /></Data>
    <Data name="nOffset" access="private" xsi:type="array" type="num" size="1"><Value key="0" value="2" /></Data>
    <Data name="nText" access="private" xsi:type="array" type="num" size="1"><Value key="0" value="3" /></Data>
  </Datas>
</Database>

--- rec
=== rec/rec.dtx
<?xml version="1.0" encoding="utf-8"?>
<Database xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance" xmlns="http://www.staubli.com/robotics/VAL3/Data/2">
  <Datas>
    <Data name="nLimit" access="public" xsi:type="array" type="num" size="1"><Value key="0" value="5" /></Data>
    <Data name="nIdle" access="public" xsi:type="array" type="num" size="1"><Value key="0" value="6" /></Data>
  </Datas>
</Database>
"#;

#[test]
fn data_of_libraries_are_used_where_code_names_them() {
    let folder = cell(LIBRARIES);
    let run = folder.val3(&["test", "--mutate", "usrapp/palTest/testSum.pgx", "--format", "json"]);
    let report: Value = serde_json::from_str(&run.stdout).unwrap();
    assert_eq!(report["notUsed"], serde_json::json!(["pal:nLimit", "pal:nText", "rec:nIdle"]), "{run:?}");
    let mutants = report["mutants"].as_array().unwrap();
    let data: Vec<&str> = mutants.iter().filter_map(|mutant| mutant["path"].as_str()).collect();
    assert_eq!(data, ["nOffset", "nLimit"]);
    let repeated = mutants.iter().filter(|mutant| mutant["found"] == "logMsg(\"again\")");
    let differences: Vec<&Value> = repeated.map(|mutant| &mutant["difference"]["value"]).collect();
    assert_eq!(differences.len(), 2);
    assert!(differences.iter().all(|value| value.is_string()), "{differences:?}");
}
