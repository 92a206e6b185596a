//! Completions in XML at many positions of files in both dialects, and their inserted text.

use expect_test::expect;

use super::{check, check_insert, check_nothing, found};

/// Cell of the tests: libraries, a user type, a collection, frames, inputs, unresolved names.
const CELL: &str = r#"
    library part "Disk://part/part.pjx"
    type Slot "Disk://Slot/Slot.pjx"
    frame fTable
    frame fRow[3]
    tool tGrip
    dio dIn["door"]
    private Slot sSlot
    nCount=nMissing+x_nOut+dLamp["red"]+dLamp["green"]+box:nWeight

    --- part
    public num nWeight
    public program pick(num x_n)
    begin
    end
    --- Slot
    version s7.8.3
    public num nHeight[2]
    public frame fPick
    public pointRx pDrop
    --- tray
    public num nPlace
    public program fill()
    begin
    end
    === /configs/bio.cfx
    <bio><bioDin index="0" /><bioDout index="1" /></bio>
    === main/loose.pgx
    <Programs />
    === main/spare.dtx
    <Database />
"#;

/// The cell with an additional file that contains the cursor.
fn with(path: &str, text: &str) -> String {
    let cell: String = CELL.lines().map(|line| line.strip_prefix("    ").unwrap_or(line).to_owned() + "\n").collect();
    format!("{cell}=== {path}\n{text}\n")
}

const MANIFEST: &str = r#"<?xml version="1.0" encoding="utf-8"?>
<Project xmlns="http://www.staubli.com/robotics/VAL3/Project/3">
  <Parameters version="s7.11" stackSize="5000" millimeterUnit="true" />
  <Programs>
    <Program file="start.pgx" />
  </Programs>
  <Database>
    <Data file="main.dtx" />
  </Database>
  <Libraries>
    <Library alias="part" path="Disk://part/part.pjx" />
  </Libraries>
  <Types>
    <Type name="Slot" path="Disk://Slot/Slot.pjx" />
  </Types>
</Project>"#;

/// The project file with `old` replaced by `new`.
fn manifest(old: &str, new: &str) -> String {
    assert!(MANIFEST.contains(old), "{old}");
    with("main/main.pjx", &MANIFEST.replacen(old, new, 1))
}

/// A data file of the application, in addition to `main.dtx`.
fn data(inner: &str) -> String {
    let manifest =
        MANIFEST.replacen("<Data file=\"main.dtx\" />", "<Data file=\"main.dtx\" /><Data file=\"more.dtx\" />", 1);
    let cell = with("main/main.pjx", &manifest);
    format!("{cell}=== main/more.dtx\n<Database xmlns:xsi=\"i\">\n  <Datas>\n{inner}\n  </Datas>\n</Database>\n")
}

/// A program of the application.
fn program(inner: &str) -> String {
    with(
        "main/other.pgx",
        &format!(
            "<Programs>\n  <Program name=\"other\">\n{inner}\n    <Code><![CDATA[begin\n  l_n=x_nOut\nend]]></Code>\n  </Program>\n</Programs>"
        ),
    )
}

/// A program of s6.
fn old_program(inner: &str) -> String {
    with(
        "main/other.pgx",
        &format!(
            "<programList xmlns=\"ProgramNameSpace\">\n  <program name=\"other\" public=\"false\">\n{inner}\n    <source><code>begin\n  l_n=x_nOut\nend</code></source>\n  </program>\n</programList>"
        ),
    )
}

/// An application of s6: its project file and its data file.
fn old(manifest: &str, data: &str) -> String {
    let manifest = format!(
        "<project xmlns=\"ProjectNameSpace\">\n  <parameters version=\"s6.8\" stackSize=\"5000\" millimeterUnit=\"true\" />\n  \
         <programSection><program file=\"start.pgx\" /></programSection>\n  <dataSection><data file=\"main.dtx\" /></dataSection>\n{manifest}\n</project>"
    );
    let cell = with("main/main.pjx", &manifest);
    format!("{cell}=== main/main.dtx\n<dataList xmlns=\"DataNameSpace\">\n{data}\n</dataList>\n")
}

/// Positions, each with the expected first completion.
fn places() -> Vec<(String, &'static str)> {
    vec![
        // Project files of s7 and s8.
        (manifest("  <Types>\n    <Type name=\"Slot\" path=\"Disk://Slot/Slot.pjx\" />\n  </Types>", "  <$0"), "Types"),
        (
            manifest(
                "  <Libraries>\n    <Library alias=\"part\" path=\"Disk://part/part.pjx\" />\n  </Libraries>",
                "  <$0",
            ),
            "Libraries",
        ),
        (manifest("    <Program file=\"start.pgx\" />", "    <Program file=\"start.pgx\" />\n    $0"), "Program"),
        (manifest("<Program file=\"start.pgx\" />", "<Program $0 />"), "file"),
        (
            manifest("<Program file=\"start.pgx\" />", "<Program file=\"start.pgx\" /><Program file=\"$0\" />"),
            "loose.pgx",
        ),
        (manifest("file=\"main.dtx\"", "file=\"$0\""), "main.dtx"),
        (manifest("version=\"s7.11\"", "version=\"$0\""), "s7.11"),
        (manifest("version=\"s7.11\"", "version=\"s8$0\""), "s8.20"),
        (manifest("stackSize=\"5000\" ", "$0 "), "stackSize"),
        (manifest("stackSize=\"5000\"", "stackSize=\"$0\""), "5000"),
        (manifest("millimeterUnit=\"true\"", "millimeterUnit=\"$0\""), "true"),
        (manifest("<Library alias", "<Lib$0\n    <Library alias"), "Library"),
        (
            manifest(
                "    <Library alias",
                "    <Library alias=\"$0\" path=\"Disk://tray/tray.pjx\" />\n    <Library alias",
            ),
            "tray",
        ),
        (manifest("    <Library alias", "    <Library alias=\"$0\" />\n    <Library alias"), "box"),
        (
            manifest("    <Library alias", "    <Library alias=\"tray\" path=\"$0\" />\n    <Library alias"),
            "Disk://tray/tray.pjx",
        ),
        (manifest("path=\"Disk://part/part.pjx\"", "path=\"Disk://part/part.pjx\" $0"), "autoload"),
        (manifest("path=\"Disk://part/part.pjx\"", "path=\"Disk://part/part.pjx\" autoload=\"$0\""), "false"),
        (manifest("name=\"Slot\" path=\"Disk://Slot/Slot.pjx\"", "name=\"Slot\" path=\"$0\""), "Disk://Slot/Slot.pjx"),
        (manifest("name=\"Slot\" path", "name=\"$0\" path"), "Slot"),
        (manifest("</Types>", "</$0"), "Types"),
        (
            manifest("Project/3\"", "Project/3\" $0").replacen(
                " xmlns=\"http://www.staubli.com/robotics/VAL3/Project/3\"",
                "",
                1,
            ),
            "xmlns",
        ),
        // Data files of s7 and s8.
        (data("    <$0"), "Data"),
        (data("    <Data name=\"$0\" />"), "nCount"),
        (data("    <Data name=\"a\" $0 />"), "type"),
        (data("    <Data name=\"a\" access=\"$0\" />"), "private"),
        (data("    <Data name=\"a\" xsi:type=\"$0\" />"), "array"),
        (data("    <Data name=\"a\" type=\"fr$0\" />"), "frame"),
        (data("    <Data name=\"a\" type=\"Sl$0\" />"), "Slot"),
        (data("    <Data name=\"a\" xsi:type=\"array\" type=\"num\" size=\"$0\" />"), "1"),
        (data("    <Data name=\"a\" xsi:type=\"array\" type=\"num\" size=\"3\">\n      <$0\n    </Data>"), "Value"),
        (
            data(
                "    <Data name=\"a\" xsi:type=\"array\" type=\"num\" size=\"3\">\n      <Value key=\"0\" value=\"1\" />\n      <Value key=\"$0\" />\n    </Data>",
            ),
            "1",
        ),
        (
            data(
                "    <Data name=\"a\" xsi:type=\"array\" type=\"num\" size=\"2 2\">\n      <Value key=\"0,0\" value=\"1\" />\n      <Value key=\"$0\" />\n    </Data>",
            ),
            "0,1",
        ),
        (
            data(
                "    <Data name=\"dLamp\" xsi:type=\"collection\" type=\"dio\">\n      <Value key=\"$0\" />\n    </Data>",
            ),
            "green",
        ),
        (data("    <Data name=\"a\" type=\"bool\" size=\"1\"><Value key=\"0\" value=\"$0\" /></Data>"), "true"),
        (data("    <Data name=\"a\" type=\"num\" size=\"1\"><Value key=\"0\" $0 /></Data>"), "value"),
        (data("    <Data name=\"a\" type=\"pointRx\" size=\"1\"><Value key=\"0\" x=\"1\" $0 /></Data>"), "fatherId"),
        (data("    <Data name=\"a\" type=\"pointRx\" size=\"1\"><Value key=\"0\" sh$0 /></Data>"), "shoulder"),
        (
            data("    <Data name=\"a\" type=\"pointRx\" size=\"1\"><Value key=\"0\" fatherId=\"$0\" /></Data>"),
            "fTable[0]",
        ),
        (
            data("    <Data name=\"a\" type=\"pointRx\" size=\"1\"><Value key=\"0\" fatherId=\"fRow$0\" /></Data>"),
            "fRow[1]",
        ),
        (
            data("    <Data name=\"a\" type=\"pointRx\" size=\"1\"><Value key=\"0\" fatherId=\"sSlot$0\" /></Data>"),
            "sSlot[0].fPick[0]",
        ),
        (data("    <Data name=\"a\" type=\"tool\" size=\"1\"><Value key=\"0\" fatherId=\"$0\" /></Data>"), "tGrip[0]"),
        (data("    <Data name=\"a\" type=\"dio\" size=\"1\"><Value key=\"0\" link=\"$0\" /></Data>"), "BasicIO-1\\%I0"),
        (
            data("    <Data name=\"a\" type=\"tool\" size=\"1\"><Value key=\"0\" ioLink=\"$0\" /></Data>"),
            "BasicIO-1\\%Q1",
        ),
        (data("    <Data name=\"a\" type=\"mdesc\" size=\"1\"><Value key=\"0\" blend=\"$0\" /></Data>"), "joint"),
        (data("    <Data name=\"a\" type=\"mdesc\" size=\"1\"><Value key=\"0\" accel=\"$0\" /></Data>"), "100"),
        (data("    <Data name=\"a\" type=\"Slot\" size=\"1\"><Value key=\"0\"><$0</Value></Data>"), "Field fPick"),
        (
            data("    <Data name=\"a\" type=\"Slot\" size=\"1\"><Value key=\"0\"><Field name=\"$0\" /></Value></Data>"),
            "nHeight",
        ),
        (
            data(
                "    <Data name=\"a\" type=\"Slot\" size=\"1\"><Value key=\"0\"><Field name=\"pDrop\" type=\"$0\" /></Value></Data>",
            ),
            "pointRx",
        ),
        (
            data(
                "    <Data name=\"a\" type=\"Slot\" size=\"1\"><Value key=\"0\"><Field name=\"nHeight\" type=\"num\" size=\"$0\" /></Value></Data>",
            ),
            "2",
        ),
        // Programs of s7 and s8.
        (program("    <$0"), "Parameters"),
        (program("    <Parameters>\n      <$0\n    </Parameters>"), "Parameter"),
        (program("    <Parameters>\n      <Parameter name=\"$0\" />\n    </Parameters>"), "x_nOut"),
        (program("    <Parameters>\n      <Parameter name=\"x_nOut\" type=\"num\" $0 />\n    </Parameters>"), "use"),
        (
            program("    <Parameters>\n      <Parameter name=\"x_nOut\" type=\"num\" use=\"$0\n    </Parameters>"),
            "reference",
        ),
        (
            program("    <Parameters>\n      <Parameter name=\"x_nOut\" xsi:type=\"$0\" />\n    </Parameters>"),
            "element",
        ),
        (program("    <Locals>\n      $0\n    </Locals>"), "Local"),
        (program("    <Locals>\n      <Local name=\"l_n\" type=\"$0\" />\n    </Locals>"), "num"),
        (program("    <Locals>\n      <Local name=\"l_n\" type=\"num\" size=\"$0\" />\n    </Locals>"), "1"),
        (program("").replace("<Program name=\"other\">", "<Program name=\"$0\">"), "other"),
        (program("").replace("<Program name=\"other\">", "<Program name=\"other\" $0>"), "access"),
        // Files of s5 and s6.
        (old("  <$0", ""), "aliasSection"),
        (old("  <aliasSection>\n    <$0\n  </aliasSection>", ""), "alias"),
        (old("  <aliasSection>\n    <alias name=\"part\" interface=\"$0\" />\n  </aliasSection>", ""), "part"),
        (old("  <aliasSection>\n    <alias name=\"part\" $0 />\n  </aliasSection>", ""), "interface"),
        (old("", "  <numS$0"), "numSection"),
        (old("", "  <numSection>\n    <$0\n  </numSection>"), "num"),
        (old("", "  <numSection>\n    <num name=\"nA\" public=\"$0\" />\n  </numSection>"), "false"),
        (
            old("", "  <numSection>\n    <num name=\"nA\" public=\"false\">\n      <$0\n    </num>\n  </numSection>"),
            "valueNum",
        ),
        (
            old(
                "",
                "  <pointSection>\n    <point name=\"pA\" public=\"false\">\n      <valuePoint index=\"0\">\n        <$0\n      </valuePoint>\n    </point>\n  </pointSection>",
            ),
            "tpValue",
        ),
        (
            old(
                "",
                "  <frameSection><frame name=\"fA\" public=\"true\" /></frameSection>\n  <pointSection>\n    <point name=\"pA\" public=\"false\">\n      <pFather alias=\"\" name=\"$0\" fatherIndex=\"0\" />\n    </point>\n  </pointSection>",
            ),
            "fA",
        ),
        (
            old(
                "",
                "  <pointSection>\n    <point name=\"pA\" public=\"false\">\n      <valuePoint index=\"0\">\n        <cpValue shoulder=\"$0\" />\n      </valuePoint>\n    </point>\n  </pointSection>",
            ),
            "lefty",
        ),
        (old_program("    <paramSection>\n      <$0\n    </paramSection>"), "param"),
        (old_program("    <localSection>\n      <local name=\"$0\" />\n    </localSection>"), "l_n"),
        (
            old_program("    <paramSection>\n      <param name=\"x_nOut\" type=\"num\" $0 />\n    </paramSection>"),
            "byVal",
        ),
    ]
}

#[test]
fn the_right_answer_is_among_the_first_three() {
    let mut wrong = String::new();
    let places = places();
    assert!(places.len() >= 60, "{}", places.len());
    for (listing, expected) in &places {
        let labels: Vec<String> = found(listing).into_iter().take(3).map(|item| item.label).collect();
        if !labels.iter().any(|label| label == expected) {
            let line = listing.lines().find(|line| line.contains("$0")).unwrap_or("");
            wrong += &format!("{} wants {expected}, has {labels:?}\n", line.trim());
        }
    }
    assert!(wrong.is_empty(), "{wrong}");
}

#[test]
fn new_elements_are_complete() {
    check_insert(
        &program("    <Locals>\n      <$0\n    </Locals>"),
        "Local",
        expect![[r#"
        Local name="${1:l_n}" type="${2:num}" xsi:type="${3|array,element,collection|}" size="${4:1}" />
        Local name="l_n" type="num" xsi:type="array" size="1" />
    "#]],
    );
    check_insert(
        &program("    $0"),
        "Locals",
        expect![[r#"
            <Locals>
              $0
            </Locals>
            <Locals>
            </Locals>
        "#]],
    );
    check_insert(
        &manifest("<Library alias", "<$0<Library alias"),
        "Library",
        expect![[r#"
        Library alias="${1:tray}" path="${2:Disk://tray/tray.pjx}" />
        Library alias="tray" path="Disk://tray/tray.pjx" />
    "#]],
    );
    check_insert(
        &data("    <$0"),
        "Data",
        expect![[r#"
        Data name="${1:dLamp}" access="${2|private,public|}" xsi:type="${3|array,collection|}" type="${4:num}" size="${5:1}" />
        Data name="dLamp" access="private" xsi:type="array" type="num" size="1" />
    "#]],
    );
    check_insert(
        &data("    <Data name=\"a\" type=\"pointRx\" size=\"2\"><Value key=\"0\" />$0</Data>"),
        "Value",
        expect![[r#"
            <Value key="${1:1}" x="${2:0}" y="${3:0}" z="${4:0}" rx="${5:0}" ry="${6:0}" rz="${7:0}" shoulder="${8:ssame}" elbow="${9:esame}" wrist="${10:wsame}" fatherId="${11:world[0]}" />
            <Value key="1" x="0" y="0" z="0" rx="0" ry="0" rz="0" shoulder="ssame" elbow="esame" wrist="wsame" fatherId="world[0]" />
        "#]],
    );
    check_insert(
        &data("    <Data name=\"a\" type=\"Slot\" size=\"1\">\n$0</Data>"),
        "Value",
        expect![[r#"
        <Value key="${1:0}">
          <Field name="fPick" xsi:type="array" type="frame" size="1" />
          <Field name="nHeight" xsi:type="array" type="num" size="2" />
          <Field name="pDrop" xsi:type="array" type="pointRx" size="1" />
        </Value>
        <Value key="0">
          <Field name="fPick" xsi:type="array" type="frame" size="1" />
          <Field name="nHeight" xsi:type="array" type="num" size="2" />
          <Field name="pDrop" xsi:type="array" type="pointRx" size="1" />
        </Value>
    "#]],
    );
    check_insert(
        &data("    <Data name=\"a\" type=\"Slot\" size=\"1\"><Value key=\"0\"><$0</Value></Data>"),
        "Field nHeight",
        expect![[r#"
            Field name="nHeight" xsi:type="array" type="num" size="2" />
            Field name="nHeight" xsi:type="array" type="num" size="2" />
        "#]],
    );
    check_insert(
        &with("main/start.pgx", "<$0"),
        "Programs",
        expect![[r#"
            Programs xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance" xmlns="http://www.staubli.com/robotics/VAL3/Program/2">
              <Program name="${1:start}">
                <Code><![CDATA[begin
              $0
            end]]></Code>
              </Program>
            </Programs>
            Programs xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance" xmlns="http://www.staubli.com/robotics/VAL3/Program/2">
              <Program name="start">
                <Code><![CDATA[begin
            end]]></Code>
              </Program>
            </Programs>
        "#]],
    );
    check_insert(
        &old("", "  <pointSection>\n    <$0\n  </pointSection>"),
        "point",
        expect![[r#"
        point name="${1:name}" public="${2:false}" >
          <pFather alias="${3:}" name="${4:world}" fatherIndex="${5:0}" />
          <valuePoint index="${6:0}" >
            <tpValue x="${7:0}" y="${8:0}" z="${9:0}" rx="${10:0}" ry="${11:0}" rz="${12:0}" />
            <cpValue shoulder="${13:ssame}" elbow="${14:esame}" wrist="${15:wsame}" />
          </valuePoint>
        </point>
        point name="name" public="false" >
          <pFather alias="" name="world" fatherIndex="0" />
          <valuePoint index="0" >
            <tpValue x="0" y="0" z="0" rx="0" ry="0" rz="0" />
            <cpValue shoulder="ssame" elbow="esame" wrist="wsame" />
          </valuePoint>
        </point>
    "#]],
    );
    check_insert(
        &old_program("    <paramSection>\n      <$0\n    </paramSection>"),
        "param",
        expect![[r#"
        param name="${1:l_n}" type="${2:num}" byVal="${3|true,false|}" />
        param name="l_n" type="num" byVal="true" />
    "#]],
    );
}

#[test]
fn the_name_of_an_existing_tag_is_replaced() {
    check_insert(
        &program("    <Locals>\n      <Lo$0>\n    </Locals>"),
        "Local",
        expect![[r#"
        Local
        Local
    "#]],
    );
    check_insert(
        &program("    <Locals>\n      <Lo$0 name=\"l_n\" />\n    </Locals>"),
        "Local",
        expect![[r#"
        Local
        Local
    "#]],
    );
    check_insert(
        &program("    <Locals>\n    </L$0>"),
        "Locals",
        expect![[r#"
        Locals
        Locals
    "#]],
    );
    check_insert(
        &program("    <Locals>\n    </$0"),
        "Locals",
        expect![[r#"
        Locals>
        Locals>
    "#]],
    );
}

#[test]
fn attributes_are_proposed_with_their_values() {
    check(
        &program("    <Locals>\n      <Local $0 />\n    </Locals>"),
        expect![[r#"
        name Attribute required
        type Attribute required
        xsi:type Attribute optional, `array` by default
        size Attribute optional, `1` by default
    "#]],
    );
    check_insert(
        &data("    <Data name=\"a\" $0 />"),
        "access",
        expect![[r#"
        access="${1|private,public|}"
        access="private"
    "#]],
    );
    check_insert(
        &data("    <Data name=\"a\" access=$0 />"),
        "public",
        expect![[r#"
        "public"
        "public"
    "#]],
    );
    check_insert(
        &data("    <Data name=\"a\" acc$0=\"public\" />"),
        "access",
        expect![[r#"
        access
        access
    "#]],
    );
    check(
        &data("    <Data name=\"a\" type=\"num\" size=\"1\"><Value key=\"0\" $0 /></Data>"),
        expect![[r#"
        value Attribute `0` by default
    "#]],
    );
}

#[test]
fn nothing_is_proposed_in_other_parts_of_a_file() {
    check_nothing(&program("    <!-- $0 -->"));
    check_nothing(&program("    <Nothing><$0</Nothing>"));
    check_nothing(&data("    <Data name=\"a\" type=\"num\" size=\"1\" nothing=\"$0\" />"));
    check_nothing(&program("    <Description><![CDATA[$0]]></Description>"));
}
