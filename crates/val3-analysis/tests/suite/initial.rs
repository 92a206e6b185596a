//! Initial values: fathers and enumerated fields of positions and motion descriptors, in both dialects.

use expect_test::expect;
use val3_analysis::items::initial::initial;
use val3_analysis::items::project::data_files;

use crate::show::{project, workspace};

/// Shows the values in `main`: whether a value has a father, and its enumerated fields.
fn shown(data: &str) -> String {
    let workspace = workspace(&format!("return\n\n=== main/main.dtx\n<?xml version=\"1.0\"?>\n{data}\n"));
    let db = &workspace.db;
    let file = data_files(db, project(&workspace, "main"))[0];
    let mut lines: Vec<String> = Vec::new();
    for (name, values) in initial(db, file) {
        lines.push(format!("{name}: {}\n", values.len()));
        for (key, value) in values {
            let choices: String = value.choices.iter().map(|(field, is)| format!(" {field}={}", is.name)).collect();
            let father = if value.has_father { "father" } else { "no father" };
            let corner = if value.needs_corner { " (corner)" } else { "" };
            lines.push(format!("{name}[{key}]: {father}{choices}{corner}\n"));
        }
    }
    lines.sort();
    lines.concat()
}

#[test]
fn the_new_dialect() {
    let data = r#"<Database xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance" xmlns="http://www.staubli.com/robotics/VAL3/Data/2">
  <Datas>
    <Data name="nA" access="private" xsi:type="array" type="num" size="1" />
    <Data name="mA" access="private" xsi:type="array" type="mdesc" size="5">
      <Value key="0" blend="cartesian" />
      <Value key="1" vel="3" />
      <Value key="2" leave="120" />
      <Value key="3" blend="joint" leave="50" reach="50.0" />
      <Value key="4" reach="5" />
    </Data>
    <Data name="pA" access="private" xsi:type="collection" type="pointRx">
      <Value key="home" elbow="enegative" fatherId="world[0]" />
      <Value key="away" fatherId="" />
    </Data>
    <Data name="tA" access="private" xsi:type="array" type="tool" size="1" />
  </Datas>
</Database>"#;
    expect![[r#"
        mA: 5
        mA[0]: no father blend=Cartesian (corner)
        mA[1]: no father blend=joint
        mA[2]: no father blend=joint (corner)
        mA[3]: no father blend=joint
        mA[4]: no father blend=joint (corner)
        pA: 2
        pA[away]: no father config.shoulder=ssame config.elbow=esame config.wrist=wsame
        pA[home]: father config.shoulder=ssame config.elbow=enegative config.wrist=wsame
        tA: 0
    "#]]
    .assert_eq(&shown(data));
}

#[test]
fn the_old_dialect() {
    let data = r#"<dataList xmlns="DataNameSpace">
  <mdescSection>
    <mdesc name="mA" public="false">
      <valueMdesc index="0"><mdescValue accel="100" vel="100" blend="off" leave="1" reach="1" /></valueMdesc>
    </mdesc>
  </mdescSection>
  <pointSection>
    <point name="pA" public="false">
      <pFather alias="" name="world" fatherIndex="0" />
      <valuePoint index="0"><tpValue x="0" /><cpValue shoulder="lefty" elbow="esame" wrist="wsame" /></valuePoint>
    </point>
    <point name="pB" public="false">
      <pFather alias="" name="" fatherIndex="0" />
      <valuePoint index="0"><tpValue x="0" /></valuePoint>
    </point>
  </pointSection>
</dataList>"#;
    expect![[r#"
        mA: 1
        mA[0]: no father blend=off (corner)
        pA: 1
        pA[0]: father config.shoulder=lefty config.elbow=esame config.wrist=wsame
        pB: 1
        pB[0]: no father config.shoulder=ssame config.elbow=esame config.wrist=wsame
    "#]]
    .assert_eq(&shown(data));
}
