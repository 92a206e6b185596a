//! Data links to Modbus server tables and field bus signals, in `val3 check`.

use crate::support::Folder;

const MODBUS: &str = r#"<?xml version="1.0" encoding="ISO-8859-1" standalone="yes"?>
<TOPICSLIST>
  <TOPIC Name="Modbus" Card="0" Channel="0" Equipment="0" RefreshPeriod="200" Actif="1">
    <MODULE Tag_name_root="Bit" IDModule="BOOLEAN" InputSize="" OutputSize="9">
      <ITEM Name="bStart" Syntaxe="%Q0" Offset="0"/>
      <ITEM Name="bIn" Syntaxe="%Q1:8" Offset="1"/>
    </MODULE>
    <MODULE Tag_name_root="Word" IDModule="WORD" InputSize="" OutputSize="32">
      <ITEM Name="nRecipe" Syntaxe="%QW0:2" Offset="0"/>
    </MODULE>
  </TOPIC>
  <GENERAL_PARAMETERS TopicName="Modbus" TCP_Port="502" ConnectionNumber="2"/>
</TOPICSLIST>
"#;

const FIELD_BUS: &str = r#"<ProcessData><Adapter displayName="PROFINET"><Module displayName="In">
<Signal systemTag="CE061C2D-63EF-4C60-9F0E-0D5C5E2B1A77" dataType="bit"/>
<Signal systemTag="CE061C2D-63EF-4C60-9F0E-0D5C5E2B1A78" dataType="word"/>
</Module></Adapter></ProcessData>
"#;

/// Findings about links in an application with these data types and links. `files` are added to the cell.
fn findings(data: &[(&str, &str)], files: &[(&str, &str)]) -> String {
    let folder = Folder::with(
        "version s8.10\ncls()\n=== main/main.dtx\n\n=== /configs/arm.cfx\n<arm><String name=\"arm\" value=\"tx2_60-S1\"/></arm>\n",
    );
    let data: String = data.iter().zip(0..).map(|((ty, link), number)| variable(number, ty, link)).collect();
    let text = format!(
        "<Database xmlns:xsi=\"http://www.w3.org/2001/XMLSchema-instance\" xmlns=\"http://www.staubli.com/robotics/VAL3/Data/2\"><Datas>\n{data}</Datas></Database>"
    );
    folder.write("usrapp/main/main.dtx", &text);
    files.iter().for_each(|(path, text)| folder.write(path, text));
    let run = folder.val3(&["check", "--format", "concise"]);
    let rules = ["V0525", "V0526", "V0561"];
    let lines = run.stdout.lines().filter(|line| rules.iter().any(|rule| line.contains(rule)));
    lines.map(|line| format!("{line}\n")).collect()
}

fn variable(number: usize, ty: &str, link: &str) -> String {
    format!(
        "<Data name=\"io{number}\" access=\"public\" xsi:type=\"array\" type=\"{ty}\" size=\"1\"><Value key=\"0\" link=\"{link}\"/></Data>\n"
    )
}

const TABLE: (&str, &str) = ("applicom/Modbus/modbus.xml", MODBUS);
const BUS: (&str, &str) = ("configs/hilscher/J207J208.xml", FIELD_BUS);

#[test]
fn links_to_the_modbus_server_are_compared_with_its_table() {
    let links = [
        ("dio", r"ModbusSrv-0\Modbus-Bit\bStart"),
        ("dio", r"ModbusSrv-0\Modbus-Bit\bIn[7]"),
        ("dio", r"ModbusSrv-0\Modbus-Bit\bIn:8[0]"),
        ("aio", r"ModbusSrv-0\Modbus-Word\nRecipe[1]"),
        ("dio", r"ModbusSrv-0\Modbus-Bit\bIn[8]"),
        ("dio", r"ModbusSrv-0\Modbus-Bit\bStrat"),
        ("dio", r"ModbusSrv-0\Modbus-Word\nRecipe[0]"),
    ];
    expect_test::expect![[r#"
        usrapp/main/main.dtx:6:92: warning[V0525] the cell has no input or output `ModbusSrv-0\Modbus-Bit\bIn[8]`
        usrapp/main/main.dtx:7:92: warning[V0525] the cell has no input or output `ModbusSrv-0\Modbus-Bit\bStrat`
        usrapp/main/main.dtx:8:92: error[V0526] the data is `dio`, but its link `ModbusSrv-0\Modbus-Word\nRecipe[0]` names `aio`
    "#]].assert_eq(&findings(&links, &[TABLE]));
    assert_eq!(findings(&links, &[]), "");
    // The signal names of another card are unknown.
    let other = MODBUS.replace("Card=\"0\"", "Card=\"1\"");
    expect_test::expect![[r#"
        usrapp/main/main.pjx:2:2: warning[V0561] line 3 of `usr/applicom/Modbus/modbus.xml`: `Card` is not 0, and it is unknown which links belong to such a topic
    "#]].assert_eq(&findings(&links, &[(TABLE.0, &other)]));
}

#[test]
fn links_by_guid_are_compared_with_the_field_bus() {
    let links = [
        ("dio", "CE061C2D-63EF-4C60-9F0E-0D5C5E2B1A77"),
        ("aio", "ce061c2d-63ef-4c60-9f0e-0d5c5e2b1a78"),
        ("dio", "CE061C2D-63EF-4C60-9F0E-0D5C5E2B1A78"),
        ("dio", "CE061C2D-63EF-4C60-9F0E-0D5C5E2B1A79"),
        ("dio", "usrIn0"),
    ];
    expect_test::expect![[r#"
        usrapp/main/main.dtx:4:92: error[V0526] the data is `dio`, but its link `CE061C2D-63EF-4C60-9F0E-0D5C5E2B1A78` names `aio`
        usrapp/main/main.dtx:5:92: warning[V0525] the cell has no input or output `CE061C2D-63EF-4C60-9F0E-0D5C5E2B1A79`
    "#]].assert_eq(&findings(&links, &[BUS]));
    assert_eq!(findings(&links, &[]), "");
    // An EtherCAT master has other signals.
    assert_eq!(findings(&links, &[BUS, ("configs/J206_EtherCAT/eni.xml", "<EtherCATConfig/>")]), "");
    let named = FIELD_BUS.replace("CE061C2D-63EF-4C60-9F0E-0D5C5E2B1A77", "In.1");
    assert_eq!(findings(&links, &[(BUS.0, &named)]), "");
}
