//! Findings that edits would add.

use val3_check::settings::{RuleSelection, WorkspaceSettings};

use super::*;
use crate::assists::FixContext;
use crate::data_tables::{DataFinding, data_findings};
use crate::diagnostics::{CheckSettings, project_diagnostics};

const CELL: &str = r#"
nA=nA+1
movel(pA,flange,mA)
put(nB)
=== main/main.dtx
<Database>
  <Datas>$0
    <Data name="fA" access="private" xsi:type="array" type="frame" size="1">
      <Value key="0" x="1" fatherId="world[0]" />
    </Data>
    <Data name="mA" access="private" xsi:type="array" type="mdesc" size="1" />
    <Data name="nA" access="private" xsi:type="array" type="num" size="1" />
    <Data name="nB" access="private" xsi:type="array" type="num" size="1">
      <Value key="0" value="wrong" />
    </Data>
    <Data name="pA" access="private" xsi:type="array" type="pointRx" size="1">
      <Value key="0" x="1" fatherId="fA[0]" />
    </Data>
  </Datas>
</Database>
"#;

/// Added findings as `place column: code message`, one line each.
fn added(edits: &[DataEdit]) -> String {
    let marked = MarkedListing::new(CELL);
    let (db, file) = (marked.db(), marked.at().file);
    let project = crate::owner(db, file).unwrap();
    let settings = WorkspaceSettings::new(db, &marked.workspace.projects, &RuleSelection::default()).unwrap();
    let settings = CheckSettings::new(db, settings);
    let before = project_diagnostics(db, settings, &marked.workspace.projects, project);
    let before = data_findings(db, file, before);
    let change = data_edits(db, project, file, edits).unwrap();
    let context = FixContext { db, system: &marked.system, check_cancelled: &|| {} };
    added_data_findings(context, file, &change, &before).into_iter().map(line).collect()
}

fn line(found: DataFinding) -> String {
    let (name, key) = (found.place.name, found.place.key.unwrap_or_default());
    let column = found.column.unwrap_or_default();
    format!("{name}[{key}] {column}: {} {}\n", found.diagnostic.rule.code, found.diagnostic.message)
}

#[test]
fn a_text_that_is_no_number_has_the_finding_of_the_rule() {
    expect_test::expect![[r#"
        nA[0] value: V0510 `value` of type `num` is `ten`, but must be a number
    "#]]
    .assert_eq(&added(&[set("nA[0]", "value", Some("ten"))]));
    assert_eq!(added(&[set("nA[0]", "value", Some("10"))]), "");
}

#[test]
fn findings_that_the_file_has_before_are_left_out() {
    // The new data shift the existing finding.
    let edits = [add("nC", "num", &[1], Some("fA")), set("nA[0]", "value", Some("wrong"))];
    expect_test::expect![[r#"
        nA[0] value: V0510 `value` of type `num` is `wrong`, but must be a number
    "#]]
    .assert_eq(&added(&edits));
}

#[test]
fn a_father_that_goes_is_missing() {
    expect_test::expect![[r#"
        pA[0] fatherId: V0520 the father `fA[0]` does not exist
    "#]]
    .assert_eq(&added(&[DataEdit::Delete(strings(&["fA"]))]));
    expect_test::expect![[r#"
        pA[0] fatherId: V0520 the father `fB[0]` does not exist
    "#]]
    .assert_eq(&added(&[set("pA[0]", "fatherId", Some("fB[0]"))]));
}

#[test]
fn a_new_text_replaces_the_finding_of_the_old_one() {
    expect_test::expect![[r#"
        nB[0] value: V0510 `value` of type `num` is `also wrong`, but must be a number
    "#]]
    .assert_eq(&added(&[set("nB[0]", "value", Some("also wrong"))]));
}
