//! Hover for the XML of files in both dialects.

use expect_test::expect;

use super::check;
use crate::hover;
use crate::testing::MarkedListing;

const MANIFEST: &str = r#"<Project xmlns="http://www.staubli.com/robotics/VAL3/Project/3">
  <Parameters version="s7.11.3" stackSize="5000" millimeterUnit="true" />
  <Programs>
    <Program file="start.pgx" />
  </Programs>
  <Database>
    <Data file="main.dtx" />
  </Database>
  <Libraries>
    <Library alias="part" path="Disk://part/part.pjx" autoload="false" password="" />
  </Libraries>
  <Types>
    <Type name="Slot" path="Disk://Slot/Slot.pjx" />
  </Types>
</Project>"#;

const DATA: &str = r#"<Database xmlns:xsi="i" xmlns="http://www.staubli.com/robotics/VAL3/Data/2">
  <Datas>
    <Data name="pA" access="private" xsi:type="array" type="pointRx" size="1">
      <Value key="0" x="1" shoulder="lefty" fatherId="world[0]" />
    </Data>
    <Data name="nA" access="private" xsi:type="array" type="num" size="1">
      <Value key="0" value="3" />
    </Data>
    <Data name="dA" access="public" xsi:type="collection" type="dio">
      <Value key="door" link="BasicIO-1\%I0" />
    </Data>
    <Data name="sA" access="public" xsi:type="array" type="Slot" size="1">
      <Value key="0">
        <Field name="nHeight" xsi:type="array" type="num" size="1" />
      </Value>
    </Data>
  </Datas>
</Database>"#;

const PROGRAM: &str = r#"<Programs xmlns:xsi="i" xmlns="http://www.staubli.com/robotics/VAL3/Program/2">
  <Program name="start" access="public">
    <Description><![CDATA[]]></Description>
    <Parameters xmlns="http://www.staubli.com/robotics/VAL3/Param/1">
      <Parameter name="x_n" type="num" xsi:type="array" use="reference" dimensions="2" />
    </Parameters>
    <Locals>
      <Local name="l_n" type="num" xsi:type="array" size="1" />
    </Locals>
    <Code><![CDATA[begin
end]]></Code>
  </Program>
</Programs>"#;

const LIBRARIES: &str = "\n--- part\npublic num nWeight[2]\npublic program pick(num x_n)\nbegin\nend\nnum nInner\n--- Slot\npublic num nHeight\n\
    === /configs/bio.cfx\n<bio><bioDin index=\"0\" /></bio>\n";

/// The cell with the cursor before `part` in one of its files.
fn at(part: &str) -> String {
    let files = [("main/main.pjx", MANIFEST), ("main/main.dtx", DATA), ("main/start.pgx", PROGRAM)];
    let (mut listing, mut is_marked) = (format!("cls(){LIBRARIES}"), false);
    for (path, text) in files {
        let here = text.contains(part) && !is_marked;
        is_marked |= here;
        let text = if here { text.replacen(part, &format!("$0{part}"), 1) } else { text.to_owned() };
        listing += &format!("=== {path}\n{text}\n");
    }
    assert!(is_marked, "{part}");
    listing
}

/// Every element, attribute and value of these files has a hover.
#[test]
fn every_element_and_attribute_has_a_hover() {
    let mut silent = String::new();
    for part in [
        "Project xmlns",
        "xmlns=",
        "Parameters version",
        "version=",
        "s7.11.3",
        "stackSize",
        "5000",
        "millimeterUnit",
        "Programs>",
        "Program file",
        "file=\"start",
        "start.pgx",
        "Database>",
        "Data file",
        "main.dtx",
        "Libraries>",
        "Library alias",
        "alias=",
        "part\" path",
        "path=\"Disk://part",
        "Disk://part/part",
        "autoload",
        "false\" pass",
        "password",
        "Types>",
        "Type name",
        "Slot\" path",
        "Disk://Slot",
        "Types>\n</Pro",
        "Datas>",
        "Data name",
        "name=\"pA",
        "pA\"",
        "access=\"private",
        "private",
        "xsi:type",
        "array\" type",
        "type=\"pointRx",
        "pointRx",
        "size=\"1",
        "Value key",
        "key=\"0\" x",
        "x=\"1",
        "shoulder",
        "lefty",
        "fatherId",
        "world",
        "value=\"3",
        "3\" />",
        "link=",
        "BasicIO",
        "collection",
        "door",
        "Field name",
        "nHeight",
        "Program name",
        "Description>",
        "Parameter name",
        "use=",
        "reference",
        "dimensions",
        "2\" />",
        "Locals>",
        "Local name",
        "l_n",
        "Code>",
    ] {
        let marked = MarkedListing::new(&at(part));
        if hover(marked.db(), marked.at()).is_none() {
            silent += &format!("{part}\n");
        }
    }
    assert!(silent.is_empty(), "nothing about:\n{silent}");
}

#[test]
fn elements_and_attributes_show_their_pages() {
    check(
        &at("Local name"),
        expect![[r#"
        ```xml
        <Local>
        ```

        A local variable. It has the defaults of its type when the program begins.

        - `name`, required. Name of the variable. Up to s7 it has at most 15 characters.
        - `type`, required. Type of each value: a built-in type, or a user type of the application.
        - `xsi:type`, optional, `array` by default. How the values are stored. Local variables are arrays; a single value has size 1.
        - `size`, optional, `1` by default. Number of values; with two or three dimensions one number for each, separated by a blank.
    "#]],
    );
    check(
        &at("dimensions"),
        expect![[r#"
        ```xml
        <Parameter dimensions>
        ```

        Number of dimensions of an array.

        optional, `1` by default: `1`, `2`, `3`
    "#]],
    );
    check(
        &at("use="),
        expect![[r#"
        ```xml
        <Parameter use>
        ```

        Passed by `value`, so that the caller keeps its own, or by `reference`. Arrays and collections are always passed by reference.

        optional, `value` by default: `value`, `reference`
    "#]],
    );
    check(
        &at("link="),
        expect![[r#"
        ```val3
        dio link
        ```

        The physical input, output or serial line that it is linked to: device, `\`, name.
    "#]],
    );
}

#[test]
fn paths_show_their_target() {
    check(
        &at("Disk://part/part"),
        expect![[r#"
        `Disk://part/part.pjx`

        `/cell/usr/usrapp/part/part.pjx`

        interface
        ```val3
        num nWeight[2]
        public program pick(num x_n)
        ```

    "#]],
    );
    check(
        &at("Disk://part/part").replace("Disk://part/part", "Disk://patr/part"),
        expect![[r#"
            No project exists at the path `Disk://patr/part.pjx`.
        "#]],
    );
    check(
        &at("main.dtx"),
        expect![[r#"
        `/cell/usr/usrapp/main/main.dtx`

        4 variables
    "#]],
    );
    check(
        &format!("library part \"Disk://part/part.pjx\"\nnum nA\nnA=part:libLoad(\"Disk:$0//part\"){LIBRARIES}"),
        expect![[r#"
            `Disk://part/part.pjx`

            `/cell/usr/usrapp/part/part.pjx`

            interface
            ```val3
            num nWeight[2]
            public program pick(num x_n)
            ```

        "#]],
    );
    check(
        &at("BasicIO"),
        expect![[r#"
        `%I0` of the device `BasicIO-1`, a `dio`
    "#]],
    );
}

#[test]
fn versions_show_their_page() {
    check(
        &at("s7.11.3"),
        expect![[r#"
            ```val3
            VAL 3 s7.11.3
            ```

            for CS8 controllers

            - Names have at most 15 characters.
            - It does not support programs in folders below the application (from s8.20).
            - Unsupported instructions: `userPageSet`, `userPageAlert`, `userPageConfirm`, `userPagePrompt`, `opcuaExport`, `setSafetyRestart`, `getJntRef`, `getSafeRefStatus`, `wakeUpRobot`, `hasCpuExtPowerSupply`, `setPayload`, `speedScale`.
        "#]],
    );
    check(
        &at("s7.11.3").replace("s7.11.3", "s8.20"),
        expect![[r#"
            ```val3
            VAL 3 s8.20
            ```

            for CS9 controllers

            - Unsupported instructions: `speedScale`.
        "#]],
    );
    check(
        &at("s7.11.3").replace("s7.11.3", "seven"),
        expect![[r#"
            `seven` is not a version. Examples of versions: `s7.11`, `s8.10.2Cs9_BS1991`.
        "#]],
    );
}

#[test]
fn files_of_s6_have_hovers() {
    let mut silent = String::new();
    for part in [
        "project xmlns",
        "parameters",
        "programSection>",
        "dataSection>",
        "aliasSection>",
        "alias name",
        "interface",
        "part\" />",
        "toolSection>",
        "tool name",
        "public=",
        "privilege",
        "tFather",
        "fatherIndex",
        "valueTool",
        "index=",
        "ttValue",
        "x=\"1",
        "io alias",
        "open=",
        "flange",
    ] {
        let marked = MarkedListing::new(&cell_of_s6(part));
        if hover(marked.db(), marked.at()).is_none() {
            silent += &format!("{part}\n");
        }
    }
    assert!(silent.is_empty(), "nothing about:\n{silent}");
    check(
        &cell_of_s6("open="),
        expect![[r#"
            ```val3
            tool.otime
            ```

            Time the tool takes to open. (seconds)

            on the flange: x=1 y=0 z=0 mm, rx=0 ry=0 rz=0 degrees

        "#]],
    );
    check(
        &cell_of_s6("part\" />"),
        expect![[r#"
        `Disk://part/part.pjx`

        `/cell/usr/usrapp/part/part.pjx`

        interface
        ```val3
        num nWeight[2]
        public program pick(num x_n)
        ```

    "#]],
    );
}

/// A cell in the old dialect with the cursor before the first `part` of the project file or data file.
fn cell_of_s6(part: &str) -> String {
    let data = "<dataList xmlns=\"DataNameSpace\"><toolSection><tool name=\"tA\" public=\"true\" privilege=\"0\"><tFather alias=\"\" name=\"flange\" fatherIndex=\"0\" /><valueTool index=\"0\"><ttValue x=\"1\" /><io alias=\"\" name=\"\" ioIndex=\"0\" open=\"2\" close=\"0\" /></valueTool></tool></toolSection></dataList>";
    let manifest = "<project xmlns=\"ProjectNameSpace\"><parameters version=\"s6.8\" /><programSection><program file=\"start.pgx\" /></programSection><dataSection><data file=\"main.dtx\" /></dataSection><aliasSection><alias name=\"part\" interface=\"part\" /></aliasSection></project>";
    let mark = |text: &str| text.replacen(part, &format!("$0{part}"), 1);
    format!(
        "cls(){LIBRARIES}=== main/main.pjx\n{}\n=== main/main.dtx\n{}\n",
        mark(manifest),
        if manifest.contains(part) { data.to_owned() } else { mark(data) }
    )
}
