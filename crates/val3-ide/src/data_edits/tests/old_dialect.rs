//! Files of s5 and s6.

use expect_test::expect;

use super::*;

const CELL: &str = r#"
version s6.8
cls()
=== main/main.dtx
<?xml version="1.0" encoding="iso-8859-1" ?>
<dataList xmlns="DataNameSpace" >
  <boolSection />
  <dioSection>$0
    <dio name="dIn" public="true" privilege="0" size="2" />
  </dioSection>
  <frameSection>
    <frame name="fA" public="false" privilege="0" >
      <fFather alias="" name="world" fatherIndex="0" />
      <valueFrame index="0" >
        <tfValue x="0" y="0" z="0" rx="0" ry="0" rz="0" />
      </valueFrame>
    </frame>
  </frameSection>
  <numSection>
    <num name="nA" public="false" privilege="0" >
      <valueNum index="0" value="3" />
      <valueNum index="1" value="0" />
    </num>
  </numSection>
  <pointSection>
    <point name="pA" public="false" privilege="0" >
      <pFather alias="" name="world" fatherIndex="0" />
      <valuePoint index="0" >
        <tpValue x="1" y="2" z="3" rx="0" ry="0" rz="0" />
        <cpValue shoulder="ssame" elbow="esame" wrist="wsame" />
      </valuePoint>
    </point>
  </pointSection>
  <stringSection />
  <toolSection>
    <tool name="tA" public="false" privilege="0" >
      <tFather alias="" name="flange" fatherIndex="0" />
      <valueTool index="0" >
        <ttValue x="0" y="0" z="95" rx="0" ry="0" rz="0" />
        <io alias="io" name="valve1" ioIndex="0" open="0" close="0" />
      </valueTool>
    </tool>
  </toolSection>
</dataList>
"#;

#[test]
fn a_cell_changes_its_bytes_alone() {
    check(
        CELL,
        &[set("nA[1]", "value", Some("4"))],
        expect![[r#"
        usrapp/main/main.dtx
        -      <valueNum index="1" value="0" />
        +      <valueNum index="1" value="4" />
    "#]],
    );
    check(
        CELL,
        &[set("nA[0]", "value", None)],
        expect![[r#"
        usrapp/main/main.dtx
        -      <valueNum index="0" value="3" />
        +      <valueNum index="0" value="0" />
    "#]],
    );
    check(
        CELL,
        &[set("pA[0]", "elbow", Some("epositive")), set("pA[0]", "rz", Some("90"))],
        expect![[r#"
        usrapp/main/main.dtx
        -        <tpValue x="1" y="2" z="3" rx="0" ry="0" rz="0" />
        -        <cpValue shoulder="ssame" elbow="esame" wrist="wsame" />
        +        <tpValue x="1" y="2" z="3" rx="0" ry="0" rz="90" />
        +        <cpValue shoulder="ssame" elbow="epositive" wrist="wsame" />
    "#]],
    );
    check(
        CELL,
        &[set("pA[0]", "fatherId", Some("fA[0]"))],
        expect![[r#"
        usrapp/main/main.dtx
        -      <pFather alias="" name="world" fatherIndex="0" />
        +      <pFather alias="" name="fA" fatherIndex="0" />
    "#]],
    );
    check(
        CELL,
        &[set("tA[0]", "ioLink", Some("io:valve2[1]")), set("tA[0]", "ioOpen", Some("0.2"))],
        expect![[r#"
        usrapp/main/main.dtx
        -        <io alias="io" name="valve1" ioIndex="0" open="0" close="0" />
        +        <io alias="io" name="valve2" ioIndex="1" open="0.2" close="0" />
    "#]],
    );
    check(
        CELL,
        &[set("tA[0]", "fatherId", None)],
        expect![[r#"
        usrapp/main/main.dtx
        -      <tFather alias="" name="flange" fatherIndex="0" />
        +      <tFather alias="" name="" fatherIndex="0" />
    "#]],
    );
}

#[test]
fn data_are_added_copied_and_deleted() {
    check(
        CELL,
        &[add("sNew", "string", &[2], None)],
        expect![[r#"
        usrapp/main/main.dtx
        -  <stringSection />
        +  <stringSection>
        +    <string name="sNew" public="false" privilege="0" >
        +      <valueString index="0" value="" />
        +      <valueString index="1" value="" />
        +    </string>
        +  </stringSection>
    "#]],
    );
    check(
        CELL,
        &[add("fNew", "frame", &[1], Some("fA"))],
        expect![[r#"
        usrapp/main/main.dtx
        +    <frame name="fNew" public="false" privilege="0" >
        +      <fFather alias="" name="world" fatherIndex="0" />
        +      <valueFrame index="0" >
        +        <tfValue x="0" y="0" z="0" rx="0" ry="0" rz="0" />
        +      </valueFrame>
        +    </frame>
    "#]],
    );
    check(
        CELL,
        &[add("dNew", "dio", &[3], Some("nA"))],
        expect![[r#"
        usrapp/main/main.dtx
        +    <dio name="dNew" public="false" privilege="0" size="3" />
    "#]],
    );
    check(
        CELL,
        &[DataEdit::Duplicate { name: "tA".into(), new_name: "tB".into() }],
        expect![[r#"
        usrapp/main/main.dtx
        +    <tool name="tB" public="false" privilege="0" >
        +      <tFather alias="" name="flange" fatherIndex="0" />
        +      <valueTool index="0" >
        +        <ttValue x="0" y="0" z="95" rx="0" ry="0" rz="0" />
        +        <io alias="io" name="valve1" ioIndex="0" open="0" close="0" />
        +      </valueTool>
        +    </tool>
    "#]],
    );
    check(
        CELL,
        &[DataEdit::Delete(strings(&["pA"]))],
        expect![[r#"
        usrapp/main/main.dtx
        -  <pointSection>
        -    <point name="pA" public="false" privilege="0" >
        -      <pFather alias="" name="world" fatherIndex="0" />
        -      <valuePoint index="0" >
        -        <tpValue x="1" y="2" z="3" rx="0" ry="0" rz="0" />
        -        <cpValue shoulder="ssame" elbow="esame" wrist="wsame" />
        -      </valuePoint>
        -    </point>
        -  </pointSection>
        +  <pointSection />
    "#]],
    );
    check(
        CELL,
        &[DataEdit::Access { names: strings(&["nA", "dIn"]), public: true }],
        expect![[r#"
        usrapp/main/main.dtx
        -    <num name="nA" public="false" privilege="0" >
        +    <num name="nA" public="true" privilege="0" >
    "#]],
    );
}

#[test]
fn arrays_get_other_sizes() {
    check(
        CELL,
        &[resize("nA", &[3])],
        expect![[r#"
        usrapp/main/main.dtx
        +      <valueNum index="2" value="0" />
    "#]],
    );
    check(
        CELL,
        &[resize("nA", &[1])],
        expect![[r#"
        usrapp/main/main.dtx
        -      <valueNum index="1" value="0" />
    "#]],
    );
    check(
        CELL,
        &[resize("pA", &[2])],
        expect![[r#"
        usrapp/main/main.dtx
        +      <valuePoint index="1" >
        +        <tpValue x="0" y="0" z="0" rx="0" ry="0" rz="0" />
        +        <cpValue shoulder="ssame" elbow="esame" wrist="wsame" />
        +      </valuePoint>
    "#]],
    );
    check(
        CELL,
        &[resize("dIn", &[4])],
        expect![[r#"
        usrapp/main/main.dtx
        -    <dio name="dIn" public="true" privilege="0" size="2" />
        +    <dio name="dIn" public="true" privilege="0" size="4" />
    "#]],
    );
}

#[test]
fn characters_that_the_encoding_lacks_are_references() {
    let text = "\u{e9} \u{2192}";
    let added = done(CELL, &[add("sNew", "string", &[1], None), set("sNew[0]", "value", Some(text))]).unwrap();
    // The listing is stored as UTF-8, but the file declares ISO-8859-1.
    assert!(added.contains("value=\"\u{e9} &#8594;\""), "{added}");
}
