//! Fathers of points, frames and tools (9.4 to 9.6).

use expect_test::expect;

use crate::data::datas;
use crate::show::faults;

#[test]
fn fathers() {
    let frames = r#"<Data name="fA" access="private" xsi:type="array" type="frame" size="2" />
<Data name="fG" access="private" xsi:type="array" type="frame" size="2 2" />
<Data name="fC" access="private" xsi:type="collection" type="frame" />
<Data name="tA" access="private" xsi:type="array" type="tool" size="1" />
<Data name="slA" access="private" xsi:type="array" type="Slot" size="2" />
<Data name="pA" access="private" xsi:type="array" type="pointRx" size="1">"#;
    let father = |father: &str| datas(&format!("{frames}<Value key=\"0\" fatherId=\"{father}\" /></Data>"));
    for fine in ["world[0]", "fA[1]", "fA", "fG[1,1]", "fC[&quot;a&quot;]", "slA[1].fSlot[1]", "slA.fSlot", ""] {
        assert_eq!(father(fine), "", "{fine}");
    }
    let faulty = [
        "fB[0]",
        "fA[2]",
        "fG[1,2]",
        "tA[0]",
        "flange[0]",
        "pA[0]",
        "slA[0]",
        "slA[0].fSolt",
        "slA[2].fSlot",
        "slA[0].nCount",
        "slA[0].nPrivate",
        "part:fA[0]",
        "fA[0",
        "fA[0].trsf",
    ];
    expect![[r#"
        main/main.dtx:7 `fB[0]` FatherMissing { father: "fB[0]", near: Some("fA") }
        main/main.dtx:7 `fA[2]` FatherIndex { father: "fA[2]", size: "2" }
        main/main.dtx:7 `fG[1,2]` FatherIndex { father: "fG[1,2]", size: "2 x 2" }
        main/main.dtx:7 `tA[0]` FatherKind { father: "tA[0]", expected: "frame", found: "tool" }
        main/main.dtx:7 `flange[0]` FatherKind { father: "flange[0]", expected: "frame", found: "tool" }
        main/main.dtx:7 `pA[0]` FatherKind { father: "pA[0]", expected: "frame", found: "pointRx" }
        main/main.dtx:7 `slA[0]` FatherKind { father: "slA[0]", expected: "frame", found: "Slot" }
        main/main.dtx:7 `slA[0].fSolt` FatherMissing { father: "slA[0].fSolt", near: Some("fSlot") }
        main/main.dtx:7 `slA[2].fSlot` FatherIndex { father: "slA[2].fSlot", size: "2" }
        main/main.dtx:7 `slA[0].nCount` FatherKind { father: "slA[0].nCount", expected: "frame", found: "num" }
        main/main.dtx:7 `slA[0].nPrivate` FatherMissing { father: "slA[0].nPrivate", near: None }
        main/main.dtx:7 `part:fA[0]` FatherInLibrary { father: "part:fA[0]" }
        main/main.dtx:7 `fA[0` FatherMissing { father: "fA[0", near: None }
        main/main.dtx:7 `fA[0].trsf` FatherMissing { father: "fA[0].trsf", near: None }
    "#]]
    .assert_eq(&faulty.map(father).concat());
}

fn frame(name: &str, size: &str, values: &str) -> String {
    format!(r#"<Data name="{name}" access="private" xsi:type="array" type="frame" size="{size}">{values}</Data>"#)
}

#[test]
fn circles_of_fathers() {
    let value = |key: &str, father: &str| format!(r#"<Value key="{key}" fatherId="{father}" />"#);
    let chain = frame("fA", "2", &(value("0", "world[0]") + &value("1", "fA[0]")));
    assert_eq!(datas(&chain), "");
    let faulty = [
        frame("fA", "1", &value("0", "fA[0]")),
        frame("fA", "1", &value("0", "fB[0]")) + &frame("fB", "1", &value("0", "fA")),
        frame("fA", "3", &(value("0", "fA[1]") + &value("1", "fA[2]") + &value("2", "fA[1]"))),
    ];
    expect![[r#"
        main/main.dtx:2 `fA[0]` FatherCircle { chain: ["fA", "fA"] }
        main/main.dtx:2 `fB[0]` FatherCircle { chain: ["fA", "fB", "fA"] }
        main/main.dtx:2 `fA[2]` FatherCircle { chain: ["fA[1]", "fA[2]", "fA[1]"] }
    "#]]
    .assert_eq(&faulty.map(|faulty| datas(&faulty)).concat());
}

fn frame_in_world(name: &str) -> String {
    format!(
        "<Data name=\"{name}\" access=\"private\" xsi:type=\"array\" type=\"frame\" size=\"1\"><Value key=\"0\" \
         fatherId=\"world[0]\" /></Data>\n"
    )
}

fn faults_with_world(world: &str, code: &str) -> String {
    faults(&format!(
        "{code}\n\n=== main/main.dtx\n<Database xmlns:xsi=\"x\"><Datas>\n<Data name=\"world\" access=\"private\" \
         xsi:type=\"array\" type=\"{world}\" size=\"1\" />\n{}{}</Datas></Database>\n",
        frame_in_world("fA"),
        frame_in_world("fB")
    ))
}

#[test]
fn data_called_world() {
    expect![[r#"
        main/main.dtx:2 `world` FatherHidden { name: "world", expected: "frame", found: "num", uses: 2 }
            Use main/main.dtx:3 `world[0]`
            Use main/main.dtx:4 `world[0]`
    "#]]
    .assert_eq(&faults_with_world("num", "link(fA,world)\nfB=world"));
    assert_eq!(faults_with_world("frame", "link(fA,world)"), "");
}

#[test]
fn data_called_flange_in_the_old_dialect() {
    let data = r#"=== main/main.dtx
<dataList xmlns="DataNameSpace">
  <numSection><num name="flange" public="false"><valueNum index="0" value="3" /></num></numSection>
  <toolSection>
    <tool name="tA" public="false"><tFather alias="" name="flange" fatherIndex="0" /></tool>
    <tool name="tB" public="false"><tFather alias="" name="flange" fatherIndex="0" /></tool>
  </toolSection>
</dataList>
"#;
    expect![[r#"
        main/main.dtx:2 `flange` FatherHidden { name: "flange", expected: "tool", found: "num", uses: 2 }
            Use main/main.dtx:4 `flange`
            Use main/main.dtx:5 `flange`
    "#]]
    .assert_eq(&faults(&format!("link(tA,flange)\n\n{data}")));
}
