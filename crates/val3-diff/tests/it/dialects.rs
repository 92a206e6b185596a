//! The same application in files of s6 and s7.

use val3_diff::{FileTree, compare};

use crate::support::human;

pub(crate) const OLD_DATA: &str = "<?xml version=\"1.0\" encoding=\"iso-8859-1\"?>
<dataList xmlns=\"DataNameSpace\">
  <frameSection>
    <frame name=\"world\" public=\"false\"><fFather alias=\"\" name=\"\" fatherIndex=\"0\"/><valueFrame index=\"0\"><tfValue x=\"0\"/></valueFrame></frame>
    <frame name=\"fTable\" public=\"false\"><fFather alias=\"\" name=\"world\" fatherIndex=\"0\"/>
      <valueFrame index=\"0\"><tfValue x=\"500\" y=\"0\" z=\"0\" rx=\"0\" ry=\"0\" rz=\"0\"/></valueFrame></frame>
  </frameSection>
  <numSection><num name=\"nA\" public=\"true\"><valueNum index=\"0\" value=\"3\"/><valueNum index=\"1\" value=\"0\"/></num></numSection>
  <pointSection><point name=\"pA\" public=\"false\"><pFather alias=\"\" name=\"fTable\" fatherIndex=\"0\"/>
    <valuePoint index=\"0\"><tpValue x=\"10\" y=\"0\" z=\"0\" rx=\"0\" ry=\"0\" rz=\"0\"/>
    <cpValue shoulder=\"lefty\" elbow=\"esame\" wrist=\"wsame\"/></valuePoint></point></pointSection>
</dataList>";

const NEW_DATA: &str = "<?xml version=\"1.0\" encoding=\"utf-8\"?>
<Database xmlns:xsi=\"http://www.w3.org/2001/XMLSchema-instance\" xmlns=\"http://www.staubli.com/robotics/VAL3/Data/2\"><Datas>
  <Data name=\"fTable\" access=\"private\" xsi:type=\"array\" type=\"frame\" size=\"1\"><Value key=\"0\" x=\"500\" fatherId=\"world[0]\"/></Data>
  <Data name=\"nA\" access=\"public\" xsi:type=\"array\" type=\"num\" size=\"2\"><Value key=\"0\" value=\"3\"/></Data>
  <Data name=\"pA\" access=\"private\" xsi:type=\"array\" type=\"pointRx\" size=\"1\"><Value key=\"0\" x=\"10\" shoulder=\"lefty\" fatherId=\"fTable[0]\"/></Data>
</Datas></Database>";

pub(crate) const OLD_PROGRAM: &str = "<programList xmlns=\"ProgramNameSpace\"><program name=\"p\" public=\"true\"><description></description><paramSection>\
    <param name=\"x\" type=\"num\" byVal=\"true\"/></paramSection><source><code>begin\r\n  if x&lt;1\r\n  endIf\r\nend\r\n</code></source></program></programList>";

const NEW_PROGRAM: &str = "<Programs xmlns=\"http://www.staubli.com/robotics/VAL3/Program/2\"><Program name=\"p\" access=\"public\"><Parameters>\
    <Parameter name=\"x\" type=\"num\" xsi:type=\"element\"/></Parameters><Code><![CDATA[begin\n  if x<1\n  endIf\nend]]></Code></Program></Programs>";

#[test]
fn a_conversion_changes_nothing() {
    let old = FileTree::new([("a/a.dtx", OLD_DATA), ("a/p.pgx", OLD_PROGRAM)]);
    let new = FileTree::new([("a/a.dtx", NEW_DATA), ("a/p.pgx", NEW_PROGRAM)]);
    assert_eq!(human(&compare(&old, &new)), "no differences in 1 application\n");
}

#[test]
fn the_old_dialect_has_movements_too() {
    let old = FileTree::new([("a.dtx", OLD_DATA)]);
    let new = FileTree::new([(
        "a.dtx",
        OLD_DATA.replace("tfValue x=\"500\"", "tfValue x=\"501\"").replace("value=\"3\"", "value=\"4\""),
    )]);
    expect_test::expect![[r#"
        a.dtx
          Points, frames and tools
              Position     Moved  Turned  In world  Values
            ~ fTable    1.000 mm          1.000 mm  x 500 → 501
            ~ fTable  1 position moves with it
                pA  1.000 mm
          Data
            ~ nA  3 → 4

        1 application differs: 1 position, 1 position that moved along, 1 value
    "#]]
    .assert_eq(&human(&compare(&old, &new)));
}
