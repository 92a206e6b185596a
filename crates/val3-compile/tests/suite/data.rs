//! Data with their initial values and links.

use std::fmt::Write;

use expect_test::{Expect, expect};
use val3_bytecode::Image;
use val3_lang::memory::{ContainerShape, DetachedValue, LinkPlace, PartInit};

use crate::show::image;

fn check(listing: &str, expected: Expect) {
    expected.assert_eq(&shown(&image(listing)));
}

/// Formats all data with their values, then the links.
fn shown(image: &Image) -> String {
    let mut text = String::new();
    for data in &image.data {
        let access = if data.public { "public " } else { "" };
        writeln!(text, "{}", format!("{access}{} {}", data.name, part(&data.init)).trim_end()).unwrap();
    }
    for link in &image.links {
        writeln!(text, "{} {:?}[{}].{} -> {:?}", link.data, link.path, link.value, link.link, link.target).unwrap();
    }
    text
}

fn part(part: &PartInit) -> String {
    let shape = match &part.shape {
        ContainerShape::Array { dims, sizes } => format!("{:?}", &sizes[..usize::from(*dims)]),
        ContainerShape::Collection(keys) => format!("{keys:?}"),
    };
    let values: Vec<String> = part.values.iter().map(|value| value.as_ref().map_or("-".to_owned(), element)).collect();
    format!("{shape} {}", values.join(" "))
}

fn element(value: &DetachedValue) -> String {
    let nums: Vec<String> = value.nums.iter().map(ToString::to_string).collect();
    let texts = value.texts.iter().map(|text| format!("{text:?}"));
    let links = value.links.iter().map(|link| match link {
        LinkPlace::None => "none".to_owned(),
        LinkPlace::Data(_) => "built in".to_owned(),
        LinkPlace::Port(port) => format!("port {port}"),
    });
    let parts = value.parts.iter().map(part);
    let all: Vec<String> = nums.into_iter().chain(texts).chain(links).chain(parts).collect();
    format!("({})", all.join(","))
}

fn with_data(data: &str) -> String {
    format!("return\n\n=== main/main.dtx\n<?xml version=\"1.0\"?>\n<Database><Datas>{data}</Datas></Database>\n")
}

#[test]
fn simple_values() {
    check(
        "num nA = 3\npublic string sB[2,3] = \"x\"\nbool bC[\"k\",\"j\"] = true\nreturn",
        expect![[r#"
        nA [1] (3)
        public sB [2, 3] ("x")
        bC {"j": 1, "k": 0} (1) (0)
    "#]],
    );
    check(
        &with_data(
            r#"<Data name="nG" access="private" xsi:type="array" type="num" size="2 3"><Value key="1,2" value="1e3" /></Data>"#,
        ),
        expect![[r#"
            nG [2, 3] - - - - - (1000)
        "#]],
    );
}

#[test]
fn omitted_fields_of_motion_descriptors_have_defaults() {
    check(
        &with_data(
            r#"<Data name="mA" access="private" xsi:type="array" type="mdesc" size="2"><Value key="1" accel="20" blend="cartesian" /></Data>"#,
        ),
        expect![[r#"
            mA [2] (100,100,100,99999,99999,0,50,50) (20,100,100,99999,99999,2,50,50)
        "#]],
    );
}

#[test]
fn positions_and_their_fathers() {
    check(
        &with_data(
            r#"<Data name="fA" access="private" xsi:type="array" type="frame" size="2"><Value key="0" x="1" fatherId="world[0]" /><Value key="1" rz="2" fatherId="fA[0]" /></Data>
<Data name="pA" access="private" xsi:type="array" type="pointRx" size="1"><Value key="0" z="3" shoulder="lefty" wrist="wfree" fatherId="fA[1]" /></Data>
<Data name="tA" access="private" xsi:type="array" type="tool" size="1"><Value key="0" z="5" fatherId="flange[0]" ioLink="valve1" ioOpen="0.1" ioClose="0.2" /></Data>
<Data name="dA" access="private" xsi:type="array" type="dio" size="2"><Value key="1" link="BasicIO-1\%I0" /></Data>"#,
        ),
        expect![[r#"
            fA [2] (1,0,0,0,0,0,built in) (0,0,0,0,0,2,none)
            pA [1] (0,0,3,0,0,0,2,0,1,none)
            tA [1] (0,0,5,0,0,0,0.1,0.2,built in,none)
            dA [2] - (none)
            0 [][1].0 -> Father(FatherLink { library: None, name: "fA", at: "0", fields: [] })
            1 [][0].0 -> Father(FatherLink { library: None, name: "fA", at: "1", fields: [] })
            2 [][0].1 -> Port(Dio, "valve1")
            3 [][1].0 -> Port(Dio, "BasicIO-1\\%I0")
        "#]],
    );
}

#[test]
fn user_types() {
    let listing = r#"
        type Slot "Disk://Slot/Slot.pjx"
        return

        === main/main.dtx
        <?xml version="1.0"?>
        <Database><Datas><Data name="tSlot" access="public" xsi:type="array" type="Slot" size="2">
        <Value key="1"><Field name="nX" xsi:type="array" type="num" size="3"><Value key="2" value="9" /></Field>
        <Field name="fF" xsi:type="array" type="frame" size="1"><Value key="0" x="4" fatherId="tSlot[0].fF[0]" /></Field></Value>
        </Data></Datas></Database>
        === Slot/Slot.dtx
        <?xml version="1.0"?>
        <Database><Datas><Data name="nX" access="public" xsi:type="array" type="num" size="2"><Value key="0" value="5" /></Data>
        <Data name="dI" access="public" xsi:type="array" type="dio" size="1"><Value key="0" link="a\b" /></Data>
        <Data name="nHidden" access="private" xsi:type="array" type="num" size="1" />
        <Data name="fF" access="public" xsi:type="array" type="frame" size="1"><Value key="0" fatherId="world[0]" /></Data></Datas></Database>
        === Slot/Slot.pjx
        <?xml version="1.0"?>
        <Project><Parameters version="s7.11" stackSize="5000" millimeterUnit="true" /><Programs /><Database><Data file="Slot.dtx" /></Database></Project>
    "#;
    check(
        listing,
        expect![[r#"
            public tSlot [2] - ([3] - - (9),[1] (none),[1] (4,0,0,0,0,0,none))
            0 [(1, 1)][0].0 -> Port(Dio, "a\\b")
            0 [(1, 2)][0].0 -> Father(FatherLink { library: None, name: "tSlot", at: "0", fields: [("fF", "0")] })
            0 [(0, 1)][0].0 -> Port(Dio, "a\\b")
        "#]],
    );
}

#[test]
fn the_old_dialect() {
    let listing = r#"
        version s6.8
        return

        === main/main.dtx
        <?xml version="1.0"?>
        <dataList xmlns="DataNameSpace"><numSection><num name="nA" public="false"><valueNum index="0" value="3" /><valueNum index="1" value="4" /></num></numSection>
        <dioSection><dio name="dI" public="true" size="2" /></dioSection>
        <frameSection><frame name="world" public="false"><fFather alias="" name="" fatherIndex="0" /><valueFrame index="0"><tfValue x="0" y="0" z="0" rx="0" ry="0" rz="0" /></valueFrame></frame>
        <frame name="fA" public="false"><fFather alias="" name="world" fatherIndex="0" /><valueFrame index="0"><tfValue x="1" y="2" z="0" rx="0" ry="0" rz="0" /></valueFrame></frame></frameSection>
        <pointSection><point name="pA" public="false"><pFather alias="part" name="fB" fatherIndex="2" /><valuePoint index="0"><tpValue x="7" y="0" z="0" rx="0" ry="0" rz="0" /><cpValue shoulder="righty" elbow="esame" wrist="wsame" /></valuePoint></point></pointSection>
        <toolSection><tool name="tA" public="false"><tFather alias="" name="flange" fatherIndex="0" /><valueTool index="0"><ttValue x="0" y="0" z="9" rx="0" ry="0" rz="0" /><io alias="" name="" ioIndex="0" open="0.5" close="0.6" /></valueTool></tool></toolSection>
        <mdescSection><mdesc name="mA" public="false"><valueMdesc index="0"><mdescValue accel="10" vel="20" decel="30" tmax="40" rmax="50" blend="off" leave="1" reach="2" /></valueMdesc></mdesc></mdescSection></dataList>
    "#;
    check(
        listing,
        expect![[r#"
        nA [2] (3) (4)
        public dI [2]
        fA [1] (1,2,0,0,0,0,built in)
        pA [1] (7,0,0,0,0,0,3,0,0,none)
        tA [1] (0,0,9,0,0,0,0.5,0.6,built in,none)
        mA [1] (10,20,30,40,50,1,1,2)
        3 [][0].0 -> Father(FatherLink { library: Some("part"), name: "fB", at: "2", fields: [] })
    "#]],
    );
}
