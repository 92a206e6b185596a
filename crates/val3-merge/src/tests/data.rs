//! Data files.

use expect_test::{Expect, expect};

use super::merged;
use crate::{MergedKind, merge};

const POINTS: &str = r#"<Database>
  <Datas>
    <Data name="pPts" access="private" xsi:type="array" type="pointRx" size="3">
      <Value key="0" x="1" fatherId="world[0]" />
      <Value key="1" x="2" fatherId="world[0]" />
      <Value key="2" x="3" fatherId="world[0]" />
    </Data>
  </Datas>
</Database>"#;

#[track_caller]
fn check(base: &str, ours: &str, theirs: &str, expected: &Expect) {
    expected.assert_eq(&merged(MergedKind::Data, base, ours, theirs));
}

/// Returns the points after text replacements, for example of the size.
fn points(edits: &[(&str, &str)]) -> String {
    edits.iter().fold(POINTS.to_owned(), |text, (from, to)| {
        assert!(text.contains(from), "{from}");
        text.replace(from, to)
    })
}

const END: &str = "\n    </Data>";
const LAST: &str = "\n  </Datas>";

#[test]
fn both_append_points_and_a_variable() {
    let ours = points(&[
        ("size=\"3\"", "size=\"4\""),
        (END, "\n      <Value key=\"3\" x=\"100\" fatherId=\"world[0]\" />\n    </Data>"),
        (
            LAST,
            "\n    <Data name=\"nOurs\" access=\"private\" xsi:type=\"array\" type=\"num\" size=\"1\" />\n  </Datas>",
        ),
    ]);
    let theirs = points(&[
        ("size=\"3\"", "size=\"5\""),
        (
            END,
            "\n      <Value key=\"3\" x=\"200\" fatherId=\"world[0]\" />\n      <Value key=\"4\" x=\"201\" fatherId=\"world[0]\" />\n    </Data>",
        ),
        (
            LAST,
            "\n    <Data name=\"nTheirs\" access=\"private\" xsi:type=\"array\" type=\"num\" size=\"1\" />\n  </Datas>",
        ),
    ]);
    check(
        POINTS,
        &ours,
        &theirs,
        &expect![[r#"
        <Database>
          <Datas>
            <Data name="pPts" access="private" xsi:type="array" type="pointRx" size="6">
              <Value key="0" x="1" fatherId="world[0]" />
              <Value key="1" x="2" fatherId="world[0]" />
              <Value key="2" x="3" fatherId="world[0]" />
              <Value key="3" x="100" fatherId="world[0]" />
              <Value key="4" x="200" fatherId="world[0]" />
              <Value key="5" x="201" fatherId="world[0]" />
            </Data>
            <Data name="nOurs" access="private" xsi:type="array" type="num" size="1" />
            <Data name="nTheirs" access="private" xsi:type="array" type="num" size="1" />
          </Datas>
        </Database>
        # `pPts`: indexes 3 to 4 of theirs became 4 to 5
    "#]],
    );
}

#[test]
fn a_point_with_default_values_is_not_lost() {
    let ours = points(&[("size=\"3\"", "size=\"4\"")]);
    let theirs = points(&[
        ("size=\"3\"", "size=\"4\""),
        (END, "\n      <Value key=\"3\" x=\"777\" fatherId=\"world[0]\" />\n    </Data>"),
    ]);
    check(
        POINTS,
        &ours,
        &theirs,
        &expect![[r#"
        <Database>
          <Datas>
            <Data name="pPts" access="private" xsi:type="array" type="pointRx" size="5">
              <Value key="0" x="1" fatherId="world[0]" />
              <Value key="1" x="2" fatherId="world[0]" />
              <Value key="2" x="3" fatherId="world[0]" />
              <Value key="4" x="777" fatherId="world[0]" />
            </Data>
          </Datas>
        </Database>
        # `pPts`: index 3 of theirs became 4
    "#]],
    );
    check(
        POINTS,
        &theirs,
        &ours,
        &expect![[r#"
        <Database>
          <Datas>
            <Data name="pPts" access="private" xsi:type="array" type="pointRx" size="5">
              <Value key="0" x="1" fatherId="world[0]" />
              <Value key="1" x="2" fatherId="world[0]" />
              <Value key="2" x="3" fatherId="world[0]" />
              <Value key="3" x="777" fatherId="world[0]" />
            </Data>
          </Datas>
        </Database>
        # `pPts`: index 3 of theirs became 4
    "#]],
    );
}

#[test]
fn the_same_appended_points_are_one_change() {
    let both = points(&[
        ("size=\"3\"", "size=\"4\""),
        (END, "\n      <Value key=\"3\" x=\"777\" fatherId=\"world[0]\" />\n    </Data>"),
    ]);
    let theirs = both.replace("x=\"1\"", "x=\"1.5\"");
    assert_eq!(merge(MergedKind::Data, POINTS, &both, &theirs).text, theirs);
    let more = both
        .replace("size=\"4\"", "size=\"5\"")
        .replace(END, "\n      <Value key=\"4\" x=\"778\" fatherId=\"world[0]\" />\n    </Data>");
    assert_eq!(merge(MergedKind::Data, POINTS, &both, &more).text, more);
    assert_eq!(merge(MergedKind::Data, POINTS, &more, &both).text, more);
}

#[test]
fn two_default_values_are_two_elements() {
    let value = |value: &str, index: usize| format!("      <valueNum index=\"{index}\" value=\"{value}\" />\n");
    let end = "    </num>";
    let ours = OLD.replace(end, &format!("{}{end}", value("0", 2)));
    let theirs = OLD.replace(end, &format!("{}{}{end}", value("0", 2), value("9", 3)));
    let found = merge(MergedKind::Data, OLD, &ours, &theirs).text;
    assert_eq!(found, OLD.replace(end, &format!("{}{}{}{end}", value("0", 2), value("0", 3), value("9", 4))));
}

fn with_second_frame(file: &str, x: &str) -> String {
    let first = "<Value key=\"0\" fatherId=\"world[0]\" />";
    let both = format!("{first}\n      <Value key=\"1\" x=\"{x}\" fatherId=\"fA[0]\" />");
    file.replace("type=\"frame\" size=\"1\"", "type=\"frame\" size=\"2\"").replace(first, &both)
}

#[test]
fn references_follow_elements_that_move() {
    let base = r#"<Database>
  <Datas>
    <Data name="fA" access="private" xsi:type="array" type="frame" size="1">
      <Value key="0" fatherId="world[0]" />
    </Data>
    <Data name="pA" access="private" xsi:type="array" type="pointRx" size="1">
      <Value key="0" x="1" fatherId="fA[0]" />
    </Data>
  </Datas>
</Database>"#;
    let theirs = with_second_frame(base, "20").replace("x=\"1\" fatherId=\"fA[0]\"", "x=\"1\" fatherId=\"fA[1]\"");
    check(
        base,
        &with_second_frame(base, "10"),
        &theirs,
        &expect![[r#"
        <Database>
          <Datas>
            <Data name="fA" access="private" xsi:type="array" type="frame" size="3">
              <Value key="0" fatherId="world[0]" />
              <Value key="1" x="10" fatherId="fA[0]" />
              <Value key="2" x="20" fatherId="fA[0]" />
            </Data>
            <Data name="pA" access="private" xsi:type="array" type="pointRx" size="1">
              <Value key="0" x="1" fatherId="fA[2]" />
            </Data>
          </Datas>
        </Database>
        # `fA`: index 1 of theirs became 2
    "#]],
    );
}

#[test]
fn different_values_are_a_conflict_that_names_the_datum() {
    let ours = points(&[("x=\"2\"", "x=\"20\""), ("x=\"1\"", "x=\"1.5\"")]);
    let theirs = points(&[("x=\"2\"", "x=\"2\" y=\"7\""), ("x=\"3\"", "x=\"3.5\"")]);
    check(
        POINTS,
        &ours,
        &theirs,
        &expect![[r#"
        <Database>
          <Datas>
            <Data name="pPts" access="private" xsi:type="array" type="pointRx" size="3">
              <Value key="0" x="1.5" fatherId="world[0]" />
              <!-- <<<<<<< conflict in `pPts[1]`: x is "20" in ours and "2" in theirs, y is omitted in ours and "7" in theirs
        ||||||| base
        <Value key="1" x="2" fatherId="world[0]" />
        ======= theirs
        <Value key="1" x="2" y="7" fatherId="world[0]" />
        >>>>>>> ours follows this comment: choose a version, and remove the comment -->
              <Value key="1" x="20" fatherId="world[0]" />
              <Value key="2" x="3.5" fatherId="world[0]" />
            </Data>
          </Datas>
        </Database>
        ! conflict in `pPts[1]`: x is "20" in ours and "2" in theirs, y is omitted in ours and "7" in theirs
    "#]],
    );
}

#[test]
fn removed_on_one_side_and_changed_on_the_other() {
    let gone = "<Database>\n  <Datas>\n  </Datas>\n</Database>";
    let changed = points(&[("x=\"2\"", "x=\"20\"")]);
    check(
        POINTS,
        gone,
        &changed,
        &expect![[r#"
        <Database>
          <Datas>
            <!-- <<<<<<< conflict in `pPts`: ours has removed it, and theirs has changed it
        ||||||| base
        <Data name="pPts" access="private" xsi:type="array" type="pointRx" size="3">
          <Value key="0" x="1" fatherId="world[0]" />
          <Value key="1" x="2" fatherId="world[0]" />
          <Value key="2" x="3" fatherId="world[0]" />
        </Data>
        ======= theirs
        <Data name="pPts" access="private" xsi:type="array" type="pointRx" size="3">
          <Value key="0" x="1" fatherId="world[0]" />
          <Value key="1" x="20" fatherId="world[0]" />
          <Value key="2" x="3" fatherId="world[0]" />
        </Data>
        >>>>>>> ours has removed it: choose a version, and remove the comment -->
          </Datas>
        </Database>
        ! conflict in `pPts`: ours has removed it, and theirs has changed it
    "#]],
    );
    check(
        POINTS,
        &changed,
        gone,
        &expect![[r#"
        <Database>
          <Datas>
            <!-- <<<<<<< conflict in `pPts`: ours has changed it, and theirs has removed it
        ||||||| base
        <Data name="pPts" access="private" xsi:type="array" type="pointRx" size="3">
          <Value key="0" x="1" fatherId="world[0]" />
          <Value key="1" x="2" fatherId="world[0]" />
          <Value key="2" x="3" fatherId="world[0]" />
        </Data>
        ======= theirs
        (none)
        >>>>>>> ours follows this comment: choose a version, and remove the comment -->
            <Data name="pPts" access="private" xsi:type="array" type="pointRx" size="3">
              <Value key="0" x="1" fatherId="world[0]" />
              <Value key="1" x="20" fatherId="world[0]" />
              <Value key="2" x="3" fatherId="world[0]" />
            </Data>
          </Datas>
        </Database>
        ! conflict in `pPts`: ours has changed it, and theirs has removed it
    "#]],
    );
    let commented = changed.replace("<Database>", "<!-- a -->\n<Database>");
    assert_eq!(merge(MergedKind::Data, &changed, gone, &commented).text, format!("<!-- a -->\n{gone}"));
}

#[test]
fn an_element_inserted_in_the_middle_keeps_changes_after_it_apart() {
    let inserted = points(&[
        ("size=\"3\"", "size=\"4\""),
        ("key=\"2\"", "key=\"3\""),
        ("key=\"1\"", "key=\"2\""),
        (
            "\n      <Value key=\"2\"",
            "\n      <Value key=\"1\" x=\"9\" fatherId=\"world[0]\" />\n      <Value key=\"2\"",
        ),
    ]);
    let before = points(&[("x=\"1\"", "x=\"1.5\"")]);
    assert!(merge(MergedKind::Data, POINTS, &inserted, &before).is_clean());
    let after = points(&[("x=\"3\"", "x=\"30\"")]);
    let found = merge(MergedKind::Data, POINTS, &inserted, &after);
    assert_eq!(found.conflicts.len(), 1, "{}", found.text);
    assert!(found.text.contains("x=\"30\"") && found.text.contains("x=\"9\""));
}

#[test]
fn a_changed_type_and_changed_values_are_a_conflict() {
    let base = "<Database><Datas><Data name=\"a\" xsi:type=\"array\" type=\"num\" size=\"1\"><Value key=\"0\" value=\"1\"/></Data></Datas></Database>";
    let text = base.replace("\"num\"", "\"string\"");
    let value = base.replace("value=\"1\"", "value=\"2\"");
    assert_eq!(merge(MergedKind::Data, base, &text, &value).conflicts.len(), 1);
    assert_eq!(merge(MergedKind::Data, base, &value, &text).conflicts.len(), 1);
    assert_eq!(merge(MergedKind::Data, base, &base.replace("\"1\"/", "\"1.0\"/"), &text).text, text);
}

const OLD: &str = r#"<dataList xmlns="DataNameSpace" >
  <numSection>
    <num name="nA" public="false" >
      <valueNum index="0" value="1" />
      <valueNum index="1" value="2" />
    </num>
  </numSection>
  <dioSection>
    <dio name="dA" public="false" size="1" />
  </dioSection>
  <pointSection>
    <point name="pA" public="false" >
      <pFather alias="" name="world" fatherIndex="0" />
      <valuePoint index="0" >
        <tpValue x="0" y="0" z="0" rx="0" ry="0" rz="0" />
        <cpValue shoulder="ssame" elbow="esame" wrist="wsame" />
      </valuePoint>
    </point>
  </pointSection>
</dataList>"#;

#[test]
fn the_old_dialect_counts_its_values() {
    let value = |value: &str| format!("value=\"2\" />\n      <valueNum index=\"2\" value=\"{value}\" />");
    let ours = OLD.replace("value=\"2\" />", &value("30")).replace("size=\"1\"", "size=\"2\"");
    let theirs = OLD.replace("value=\"2\" />", &value("40")).replace("size=\"1\"", "size=\"3\"");
    check(
        OLD,
        &ours,
        &theirs,
        &expect![[r#"
        <dataList xmlns="DataNameSpace" >
          <numSection>
            <num name="nA" public="false" >
              <valueNum index="0" value="1" />
              <valueNum index="1" value="2" />
              <valueNum index="2" value="30" />
              <valueNum index="3" value="40" />
            </num>
          </numSection>
          <dioSection>
            <dio name="dA" public="false" size="4" />
          </dioSection>
          <pointSection>
            <point name="pA" public="false" >
              <pFather alias="" name="world" fatherIndex="0" />
              <valuePoint index="0" >
                <tpValue x="0" y="0" z="0" rx="0" ry="0" rz="0" />
                <cpValue shoulder="ssame" elbow="esame" wrist="wsame" />
              </valuePoint>
            </point>
          </pointSection>
        </dataList>
        # `dA`: indexes 1 to 2 of theirs became 2 to 3

        # `nA`: index 2 of theirs became 3
    "#]],
    );
}

#[test]
fn the_old_dialect_writes_a_point_in_parts_that_belong_together() {
    let ours = OLD.replace("x=\"0\"", "x=\"5\"");
    let theirs = OLD.replace("ssame", "lefty");
    let found = merge(MergedKind::Data, OLD, &ours, &theirs);
    assert_eq!(found.conflicts.len(), 1, "{}", found.text);
    assert!(found.text.contains("x=\"5\"") && found.text.contains("lefty"));
    let moved = ours.replace("name=\"nA\"", "name=\"nB\"");
    assert_eq!(merge(MergedKind::Data, OLD, &moved, &OLD.replace("value=\"1\"", "value=\"7\"")).conflicts.len(), 1);
}

#[test]
fn a_name_in_two_sections_is_a_conflict() {
    let with = |section: &str, element: &str| OLD.replace(section, &format!("  {element}\n  {section}"));
    let ours = with("</numSection>", "<num name=\"x\" public=\"false\" >\n    </num>");
    let theirs = with("</dioSection>", "<dio name=\"x\" public=\"false\" size=\"1\" />");
    assert_eq!(merge(MergedKind::Data, OLD, &ours, &theirs).conflicts.len(), 1);
    assert_eq!(merge(MergedKind::Data, OLD, &theirs, &ours).conflicts.len(), 1);
    let changed = theirs.replace("    <num name=\"nA\"", "    <num name=\"nB\"");
    assert!(
        merge(MergedKind::Data, &ours, &ours.replace("value=\"1\"", "value=\"5\""), &changed.replace("nB", "nA"))
            .is_clean()
    );
}

#[test]
fn fields_are_merged_by_name() {
    let base = r#"<Database>
  <Datas>
    <Data name="tSlot" access="public" xsi:type="collection" type="Slot">
      <Value key="a">
        <Field name="nX" xsi:type="array" type="num" size="1" />
        <Field name="sY" xsi:type="array" type="string" size="1" />
      </Value>
    </Data>
  </Datas>
</Database>"#;
    let ours = base.replace(
        "type=\"num\" size=\"1\" />",
        "type=\"num\" size=\"2\">\n          <Value key=\"1\" value=\"5\" />\n        </Field>",
    );
    let theirs = base
        .replace("type=\"num\" size=\"1\" />", "type=\"num\" size=\"2\" />")
        .replace("</Data>", "  <Value key=\"b\" />\n    </Data>")
        .replace(
            "size=\"1\" />\n      </Value>",
            "size=\"1\">\n          <Value key=\"0\" value=\"text\" />\n        </Field>\n      </Value>",
        );
    check(
        base,
        &ours,
        &theirs,
        &expect![[r#"
        <Database>
          <Datas>
            <Data name="tSlot" access="public" xsi:type="collection" type="Slot">
              <Value key="a">
                <Field name="nX" xsi:type="array" type="num" size="3">
                  <Value key="1" value="5" />
                </Field>
                <Field name="sY" xsi:type="array" type="string" size="1">
                  <Value key="0" value="text" />
                </Field>
              </Value>
              <Value key="b" />
            </Data>
          </Datas>
        </Database>
        # `tSlot[a].nX`: index 1 of theirs became 2
    "#]],
    );
}

#[test]
fn a_file_that_is_no_xml_is_merged_by_lines() {
    check(
        "<a>\nx\n",
        "<a>\ny\n",
        "<a>\nz\n",
        &expect![[r#"
        <a>
        <<<<<<< ours
        y
        ||||||| base
        x
        =======
        z
        >>>>>>> theirs

        ! conflict in `line 2`: both sides have changed it

        ! by lines: BASE is not well-formed XML
    "#]],
    );
    let found = merge(MergedKind::Data, POINTS, &OLD.replace("1", "2"), &points(&[("x=\"1\"", "x=\"7\"")]));
    assert!(found.by_lines.is_some_and(|reason| reason.contains("root")));
}
