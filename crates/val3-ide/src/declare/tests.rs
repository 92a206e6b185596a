use expect_test::{Expect, expect};
use val3_analysis::db::{Db, Project};
use val3_lang::types::Container;

use super::{FileEdit, NewVariable, data, library, public_data};
use crate::assists::shown;
use crate::edit::SourceChange;
use crate::testing::MarkedListing;

/// Checks the edits of a declaration in the project of the program `start`.
fn check(listing: &str, declare: impl Fn(&dyn Db, Project) -> Option<FileEdit>, expected: Expect) {
    let marked = MarkedListing::new(listing);
    let project = crate::owner(marked.db(), marked.at().file).unwrap();
    let edit = declare(marked.db(), project);
    let change = edit.map_or_else(String::new, |edit| shown(marked.db(), &SourceChange::of([edit])));
    expected.assert_eq(&change);
}

fn several(name: &str, type_name: &str, container: Container, sizes: &[u32]) -> NewVariable {
    NewVariable { name: name.to_owned(), type_name: type_name.to_owned(), container, sizes: sizes.to_vec() }
}

const NEW: &str = "c$0ls()\n=== main/main.dtx\n<Database>\n  <Datas>\n  </Datas>\n</Database>\n";

const OLD: &str = "c$0ls()\n=== main/main.dtx\n<dataList>\n  <numSection>\n    <num name=\"nA\" public=\"false\" >\n      <valueNum index=\"0\" value=\"1\" />\n    </num>\n  </numSection>\n  <stringSection/>\n</dataList>\n";

#[test]
fn data_are_declared_with_and_without_a_value() {
    let number = NewVariable::single("nB", "num");
    check(
        NEW,
        |db, project| data(db, project, &number, Some("1")),
        expect![[r#"
            usrapp/main/main.dtx
            +    <Data name="nB" access="private" xsi:type="array" type="num" size="1">
            +      <Value key="0" value="1" />
            +    </Data>
        "#]],
    );
    check(
        NEW,
        |db, project| data(db, project, &number, None),
        expect![[r#"
            usrapp/main/main.dtx
            +    <Data name="nB" access="private" xsi:type="array" type="num" size="1" />
        "#]],
    );
    check(
        "c$0ls()\n=== main/main.dtx\n<Database><Datas/></Database>\n",
        |db, project| data(db, project, &NewVariable::single("sA", "string"), Some("<a> & \"b\"")),
        expect![[r#"
            usrapp/main/main.dtx
            -<Database><Datas/></Database>
            +<Database><Datas><Data name="sA" access="private" xsi:type="array" type="string" size="1"><Value key="0" value="&lt;a&gt; &amp; &quot;b&quot;" /></Data></Datas></Database>
        "#]],
    );
}

#[test]
fn data_of_s6_are_declared() {
    check(
        OLD,
        |db, project| data(db, project, &NewVariable::single("nB", "num"), Some("1")),
        expect![[r#"
            usrapp/main/main.dtx
            +    <num name="nB" public="false" >
            +      <valueNum index="0" value="1" />
            +    </num>
        "#]],
    );
    check(
        OLD,
        |db, project| data(db, project, &several("sA", "string", Container::Array { dims: 1 }, &[2]), Some("<")),
        expect![[r#"
            usrapp/main/main.dtx
            -  <stringSection/>
            +  <stringSection>
            +    <string name="sA" public="false" >
            +      <valueString index="0" value="&lt;" />
            +      <valueString index="1" value="" />
            +    </string>
            +  </stringSection>
        "#]],
    );
    // A missing section is inserted at its position in the order.
    check(
        OLD,
        |db, project| data(db, project, &NewVariable::single("bA", "bool"), None),
        expect![[r#"
        usrapp/main/main.dtx
        +  <boolSection>
        +    <bool name="bA" public="false" >
        +      <valueBool index="0" value="false" />
        +    </bool>
        +  </boolSection>
    "#]],
    );
    check(
        OLD,
        |db, project| data(db, project, &several("nA", "num", Container::Array { dims: 2 }, &[2, 2]), None),
        expect![""],
    );
}

#[test]
fn structured_data_of_s6_are_declared() {
    let sections = super::old_data::SECTIONS.map(|section| format!("  <{section} />\n")).concat();
    let cell = format!("c$0ls()\n=== main/main.dtx\n<dataList>\n{sections}</dataList>\n");
    for (type_name, size, expected) in [
        (
            "trsf",
            2,
            expect![[r#"
            usrapp/main/main.dtx
            -  <trsfSection />
            +  <trsfSection>
            +    <trsf name="xA" public="false" >
            +      <valueTrsf index="0" >
            +        <trsfValue x="0" y="0" z="0" rx="0" ry="0" rz="0" />
            +      </valueTrsf>
            +      <valueTrsf index="1" >
            +        <trsfValue x="0" y="0" z="0" rx="0" ry="0" rz="0" />
            +      </valueTrsf>
            +    </trsf>
            +  </trsfSection>
        "#]],
        ),
        (
            "frame",
            1,
            expect![[r#"
            usrapp/main/main.dtx
            -  <frameSection />
            +  <frameSection>
            +    <frame name="xA" public="false" >
            +      <fFather alias="" name="world" fatherIndex="0" />
            +      <valueFrame index="0" >
            +        <tfValue x="0" y="0" z="0" rx="0" ry="0" rz="0" />
            +      </valueFrame>
            +    </frame>
            +  </frameSection>
        "#]],
        ),
        (
            "tool",
            1,
            expect![[r#"
            usrapp/main/main.dtx
            -  <toolSection />
            +  <toolSection>
            +    <tool name="xA" public="false" >
            +      <tFather alias="" name="flange" fatherIndex="0" />
            +      <valueTool index="0" >
            +        <ttValue x="0" y="0" z="0" rx="0" ry="0" rz="0" />
            +        <io alias="io" name="valve1" ioIndex="0" open="0" close="0" />
            +      </valueTool>
            +    </tool>
            +  </toolSection>
        "#]],
        ),
        (
            "jointRx",
            1,
            expect![[r#"
            usrapp/main/main.dtx
            -  <jointSection />
            +  <jointSection>
            +    <joint name="xA" public="false" >
            +      <valueJoint index="0" >
            +        <jointValue j1="0" j2="0" j3="0" j4="0" j5="0" j6="0" />
            +      </valueJoint>
            +    </joint>
            +  </jointSection>
        "#]],
        ),
        (
            "jointRs",
            1,
            expect![[r#"
            usrapp/main/main.dtx
            -  <jointRsSection />
            +  <jointRsSection>
            +    <jointRs name="xA" public="false" >
            +      <valueJointRs index="0" >
            +        <jointRsValue j1="0" j2="0" j3="0" j4="0" />
            +      </valueJointRs>
            +    </jointRs>
            +  </jointRsSection>
        "#]],
        ),
        (
            "pointRx",
            1,
            expect![[r#"
            usrapp/main/main.dtx
            -  <pointSection />
            +  <pointSection>
            +    <point name="xA" public="false" >
            +      <pFather alias="" name="world" fatherIndex="0" />
            +      <valuePoint index="0" >
            +        <tpValue x="0" y="0" z="0" rx="0" ry="0" rz="0" />
            +        <cpValue shoulder="ssame" elbow="esame" wrist="wsame" />
            +      </valuePoint>
            +    </point>
            +  </pointSection>
        "#]],
        ),
        (
            "point",
            1,
            expect![[r#"
            usrapp/main/main.dtx
            -  <pointSection />
            +  <pointSection>
            +    <point name="xA" public="false" >
            +      <pFather alias="" name="world" fatherIndex="0" />
            +      <valuePoint index="0" >
            +        <tpValue x="0" y="0" z="0" rx="0" ry="0" rz="0" />
            +        <cpValue shoulder="ssame" elbow="esame" wrist="wsame" />
            +      </valuePoint>
            +    </point>
            +  </pointSection>
        "#]],
        ),
        (
            "pointRs",
            1,
            expect![[r#"
            usrapp/main/main.dtx
            -  <pointRsSection />
            +  <pointRsSection>
            +    <pointRs name="xA" public="false" >
            +      <pRsFather alias="" name="world" fatherIndex="0" />
            +      <valuePointRs index="0" >
            +        <tpRsValue x="0" y="0" z="0" rx="0" ry="0" rz="0" />
            +        <cpRsValue shoulder="ssame" />
            +      </valuePointRs>
            +    </pointRs>
            +  </pointRsSection>
        "#]],
        ),
        (
            "mdesc",
            1,
            expect![[r#"
            usrapp/main/main.dtx
            -  <mdescSection />
            +  <mdescSection>
            +    <mdesc name="xA" public="false" >
            +      <valueMdesc index="0" >
            +        <mdescValue accel="100" vel="100" decel="100" tmax="99999" rmax="99999" blend="joint" leave="50" reach="50" />
            +      </valueMdesc>
            +    </mdesc>
            +  </mdescSection>
        "#]],
        ),
        ("configRx", 1, expect![""]),
        ("pointVrb", 1, expect![""]),
    ] {
        let variable = several("xA", type_name, Container::Array { dims: 1 }, &[size]);
        check(&cell, |db, project| data(db, project, &variable, None), expected);
    }
}

#[test]
fn public_data_of_an_interface_are_declared() {
    let variables = [
        NewVariable::single("pA", "pointRx"),
        several("nA", "num", Container::Array { dims: 2 }, &[2, 3]),
        several("dIn", "dio", Container::Collection, &[]),
    ];
    check(
        NEW,
        |db, project| public_data(db, project, &variables),
        expect![[r#"
            usrapp/main/main.dtx
            +    <Data name="pA" access="public" xsi:type="array" type="pointRx" size="1">
            +      <Value key="0" fatherId="world[0]" />
            +    </Data>
            +    <Data name="nA" access="public" xsi:type="array" type="num" size="2 3" />
            +    <Data name="dIn" access="public" xsi:type="collection" type="dio" />
        "#]],
    );
    check(OLD, |db, project| public_data(db, project, &variables), expect![""]);
}

#[test]
fn libraries_are_declared() {
    let part = |db: &dyn Db, project: Project| library(db, project, "part", "Disk://part/part.pjx");
    check(
        "c$0ls()\n=== main/main.pjx\n<Project>\n  <Programs>\n    <Program file=\"start.pgx\" />\n  </Programs>\n  <Libraries/>\n</Project>\n",
        part,
        expect![[r#"
            usrapp/main/main.pjx
            -  <Libraries/>
            +  <Libraries>
            +    <Library alias="part" path="Disk://part/part.pjx" />
            +  </Libraries>
        "#]],
    );
    check(
        "c$0ls()\n=== main/main.pjx\n<project>\n  <programSection>\n    <program file=\"start.pgx\" />\n  </programSection>\n  <aliasSection>\n    <alias name=\"io\" interface=\"Disk://io/io.pjx\" />\n  </aliasSection>\n</project>\n",
        part,
        expect![[r#"
            usrapp/main/main.pjx
            +    <alias name="part" interface="Disk://part/part.pjx" />
        "#]],
    );
}
