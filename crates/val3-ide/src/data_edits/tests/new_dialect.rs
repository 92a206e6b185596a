//! Files of s7 and s8.

use expect_test::expect;

use super::*;

/// Format of the vendor's editor.
const CELL: &str = r#"
type Slot "Disk://Slot/Slot.pjx"
cls()
=== main/main.dtx
<?xml version="1.0" encoding="utf-8"?>
<Database xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance" xmlns="http://www.staubli.com/robotics/VAL3/Data/2">
  <Datas>$0
    <Data name="nCount" access="private" xsi:type="array" type="num" size="1" />
    <Data name="nList" access="public" xsi:type="array" type="num" size="4">
      <Value key="0" value="1.50" />
      <Value key="2" value="3" />
    </Data>
    <Data name="nGrid" access="private" xsi:type="array" type="num" size="3 4">
      <Value key="2,1" value="5" />
    </Data>
    <Data name="pA" access="public" xsi:type="array" type="pointRx" size="2">
      <Value key="0" x="10" shoulder="lefty" fatherId="world[0]" />
    </Data>
    <Data name="dIn" access="public" xsi:type="collection" type="dio">
      <Value key="door" link="BasicIO-1\%I0" />
      <Value key="lamp" />
    </Data>
    <Data name="tSlot" access="public" xsi:type="array" type="Slot" size="2">
      <Value key="0">
        <Field name="pPick" xsi:type="array" type="pointRx" size="1">
          <Value key="0" x="10" fatherId="world[0]" />
        </Field>
        <Field name="sID" xsi:type="array" type="string" size="1" />
      </Value>
    </Data>
  </Datas>
</Database>
=== Slot/Slot.pjx
<?xml version="1.0" encoding="utf-8"?>
<Project xmlns="http://www.staubli.com/robotics/VAL3/Project/3">
  <Parameters version="s7.11" stackSize="5000" millimeterUnit="true" />
  <Programs />
  <Database>
    <Data file="Slot.dtx" />
  </Database>
  <Libraries />
  <Types />
</Project>
=== Slot/Slot.dtx
<?xml version="1.0" encoding="utf-8"?>
<Database xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance" xmlns="http://www.staubli.com/robotics/VAL3/Data/2">
  <Datas>
    <Data name="pPick" access="public" xsi:type="array" type="pointRx" size="1">
      <Value key="0" z="7" fatherId="world[0]" />
    </Data>
    <Data name="sID" access="public" xsi:type="array" type="string" size="1" />
    <Data name="nHidden" access="private" xsi:type="array" type="num" size="1" />
  </Datas>
</Database>
"#;

/// Format of the controller, with another order of the attributes.
const CONTROLLER: &str = r#"
cls()
=== main/main.dtx
<?xml version="1.0" encoding="utf-8" ?>
<Database xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance" xmlns="http://www.staubli.com/robotics/VAL3/Data/2" >
  <Datas>$0
    <Data access="private" name="bReady" type="bool" xsi:type="array" size="1" >
    </Data>
    <Data access='private' name='sText' type='string' xsi:type='array' size='1' >
      <Value key='0' value='it&apos;s' />
    </Data>
  </Datas>
</Database>
"#;

#[test]
fn a_cell_changes_its_bytes_alone() {
    check(
        CELL,
        &[set("nList[2]", "value", Some("-4"))],
        expect![[r#"
        usrapp/main/main.dtx
        -      <Value key="2" value="3" />
        +      <Value key="2" value="-4" />
    "#]],
    );
    check(
        CELL,
        &[set("pA[0]", "rz", Some("90"))],
        expect![[r#"
        usrapp/main/main.dtx
        -      <Value key="0" x="10" shoulder="lefty" fatherId="world[0]" />
        +      <Value key="0" x="10" rz="90" shoulder="lefty" fatherId="world[0]" />
    "#]],
    );
    check(
        CELL,
        &[set("pA[0]", "fatherId", Some("fB[1]"))],
        expect![[r#"
        usrapp/main/main.dtx
        -      <Value key="0" x="10" shoulder="lefty" fatherId="world[0]" />
        +      <Value key="0" x="10" shoulder="lefty" fatherId="fB[1]" />
    "#]],
    );
    check(
        CELL,
        &[set("dIn[lamp]", "link", Some("a & b"))],
        expect![[r#"
        usrapp/main/main.dtx
        -      <Value key="lamp" />
        +      <Value key="lamp" link="a &amp; b" />
    "#]],
    );
    check(
        CONTROLLER,
        &[set("sText[0]", "value", Some("isn't"))],
        expect![[r#"
        usrapp/main/main.dtx
        -      <Value key='0' value='it&apos;s' />
        +      <Value key='0' value='isn&apos;t' />
    "#]],
    );
}

#[test]
fn the_same_number_changes_nothing() {
    check(CELL, &[set("nList[0]", "value", Some("1.5"))], expect![[""]]);
    check(CELL, &[set("nList[1]", "value", None)], expect![[""]]);
}

#[test]
fn a_value_that_becomes_the_default_leaves_an_array() {
    check(
        CELL,
        &[set("nList[0]", "value", Some("0"))],
        expect![[r#"
        usrapp/main/main.dtx
        -      <Value key="0" value="1.50" />
    "#]],
    );
    check(
        CELL,
        &[set("pA[0]", "x", None)],
        expect![[r#"
        usrapp/main/main.dtx
        -      <Value key="0" x="10" shoulder="lefty" fatherId="world[0]" />
        +      <Value key="0" shoulder="lefty" fatherId="world[0]" />
    "#]],
    );
    check(
        CELL,
        &[set("dIn[door]", "link", None)],
        expect![[r#"
        usrapp/main/main.dtx
        -      <Value key="door" link="BasicIO-1\%I0" />
        +      <Value key="door" />
    "#]],
    );
    check(
        CONTROLLER,
        &[set("sText[0]", "value", Some(""))],
        expect![[r#"
        usrapp/main/main.dtx
        -      <Value key='0' value='it&apos;s' />
    "#]],
    );
}

#[test]
fn a_value_that_the_file_leaves_out_is_written_in_its_place() {
    check(
        CELL,
        &[set("nList[1]", "value", Some("2"))],
        expect![[r#"
        usrapp/main/main.dtx
        +      <Value key="1" value="2" />
    "#]],
    );
    check(
        CELL,
        &[set("nCount[0]", "value", Some("7"))],
        expect![[r#"
        usrapp/main/main.dtx
        -    <Data name="nCount" access="private" xsi:type="array" type="num" size="1" />
        +    <Data name="nCount" access="private" xsi:type="array" type="num" size="1">
        +      <Value key="0" value="7" />
        +    </Data>
    "#]],
    );
    check(
        CONTROLLER,
        &[set("bReady[0]", "value", Some("true"))],
        expect![[r#"
        usrapp/main/main.dtx
        +      <Value key="0" value="true" />
    "#]],
    );
}

#[test]
fn a_file_that_spells_defaults_still_spells_them() {
    let listing = r#"
cls()
=== main/main.dtx
<Database>
  <Datas>$0
    <Data name="pA" access="public" xsi:type="array" type="trsf" size="1">
      <Value key="0" x="10" y="0" z="0" rx="0" ry="0" rz="0" />
    </Data>
  </Datas>
</Database>
"#;
    check(
        listing,
        &[set("pA[0]", "x", Some("0"))],
        expect![[r#"
        usrapp/main/main.dtx
        -      <Value key="0" x="10" y="0" z="0" rx="0" ry="0" rz="0" />
        +      <Value key="0" x="0" y="0" z="0" rx="0" ry="0" rz="0" />
    "#]],
    );
}

#[test]
fn fields_of_user_types() {
    check(
        CELL,
        &[set("tSlot[0].pPick[0]", "x", Some("11"))],
        expect![[r#"
        usrapp/main/main.dtx
        -          <Value key="0" x="10" fatherId="world[0]" />
        +          <Value key="0" x="11" fatherId="world[0]" />
    "#]],
    );
    check(
        CELL,
        &[set("tSlot[0].sID[0]", "value", Some("a"))],
        expect![[r#"
        usrapp/main/main.dtx
        -        <Field name="sID" xsi:type="array" type="string" size="1" />
        +        <Field name="sID" xsi:type="array" type="string" size="1">
        +          <Value key="0" value="a" />
        +        </Field>
    "#]],
    );
    check(
        CELL,
        &[set("tSlot[1].pPick[0]", "x", Some("11"))],
        expect![[r#"
        usrapp/main/main.dtx
        +      <Value key="1">
        +        <Field name="pPick" xsi:type="array" type="pointRx" size="1">
        +          <Value key="0" x="11" z="7" fatherId="world[0]" />
        +        </Field>
        +        <Field name="sID" xsi:type="array" type="string" size="1" />
        +      </Value>
    "#]],
    );
    check(CELL, &[set("tSlot[1].pPick[0]", "z", Some("7"))], expect![[""]]);
    let there_and_back = [set("tSlot[1].sID[0]", "value", Some("a")), set("tSlot[1].sID[0]", "value", None)];
    check(CELL, &there_and_back, expect![[""]]);
    check(
        CELL,
        &[resize("tSlot[0].sID", &[2])],
        expect![[r#"
        usrapp/main/main.dtx
        -        <Field name="sID" xsi:type="array" type="string" size="1" />
        +        <Field name="sID" xsi:type="array" type="string" size="2" />
    "#]],
    );
}

#[test]
fn data_are_added_copied_and_deleted() {
    check(
        CELL,
        &[add("nNew", "num", &[1], None)],
        expect![[r#"
        usrapp/main/main.dtx
        +    <Data name="nNew" access="private" xsi:type="array" type="num" size="1" />
    "#]],
    );
    check(
        CELL,
        &[add("pNew", "pointRx", &[2], Some("pA"))],
        expect![[r#"
        usrapp/main/main.dtx
        +    <Data name="pNew" access="private" xsi:type="array" type="pointRx" size="2">
        +      <Value key="0" fatherId="world[0]" />
        +      <Value key="1" fatherId="world[0]" />
        +    </Data>
    "#]],
    );
    check(
        CELL,
        &[add("sNew", "string", &[], Some("nCount"))],
        expect![[r#"
        usrapp/main/main.dtx
        +    <Data name="sNew" access="private" xsi:type="collection" type="string" />
    "#]],
    );
    check(
        CONTROLLER,
        &[add("nNew", "num", &[3], None)],
        expect![[r#"
        usrapp/main/main.dtx
        +    <Data access="private" name="nNew" type="num" xsi:type="array" size="3" >
        +    </Data>
    "#]],
    );
    check(
        CELL,
        &[DataEdit::Duplicate { name: "nList".into(), new_name: "nCopy".into() }],
        expect![[r#"
        usrapp/main/main.dtx
        +    <Data name="nCopy" access="public" xsi:type="array" type="num" size="4">
        +      <Value key="0" value="1.50" />
        +      <Value key="2" value="3" />
        +    </Data>
    "#]],
    );
    check(
        CELL,
        &[DataEdit::Delete(strings(&["nList", "nGrid"]))],
        expect![[r#"
        usrapp/main/main.dtx
        -    <Data name="nList" access="public" xsi:type="array" type="num" size="4">
        -      <Value key="0" value="1.50" />
        -      <Value key="2" value="3" />
        -    </Data>
        -    <Data name="nGrid" access="private" xsi:type="array" type="num" size="3 4">
        -      <Value key="2,1" value="5" />
        -    </Data>
    "#]],
    );
    let access = DataEdit::Access { names: strings(&["nList", "nCount", "pA"]), public: true };
    check(
        CELL,
        &[access],
        expect![[r#"
        usrapp/main/main.dtx
        -    <Data name="nCount" access="private" xsi:type="array" type="num" size="1" />
        +    <Data name="nCount" access="public" xsi:type="array" type="num" size="1" />
    "#]],
    );
}

#[test]
fn arrays_get_other_sizes() {
    check(
        CELL,
        &[resize("nList", &[6])],
        expect![[r#"
        usrapp/main/main.dtx
        -    <Data name="nList" access="public" xsi:type="array" type="num" size="4">
        +    <Data name="nList" access="public" xsi:type="array" type="num" size="6">
    "#]],
    );
    check(
        CELL,
        &[resize("nList", &[1])],
        expect![[r#"
        usrapp/main/main.dtx
        -    <Data name="nList" access="public" xsi:type="array" type="num" size="4">
        -      <Value key="0" value="1.50" />
        -      <Value key="2" value="3" />
        +    <Data name="nList" access="public" xsi:type="array" type="num" size="1">
        +      <Value key="0" value="1.50" />
    "#]],
    );
    check(
        CELL,
        &[resize("pA", &[3])],
        expect![[r#"
        usrapp/main/main.dtx
        -    <Data name="pA" access="public" xsi:type="array" type="pointRx" size="2">
        -      <Value key="0" x="10" shoulder="lefty" fatherId="world[0]" />
        +    <Data name="pA" access="public" xsi:type="array" type="pointRx" size="3">
        +      <Value key="0" x="10" shoulder="lefty" fatherId="world[0]" />
        +      <Value key="2" fatherId="world[0]" />
    "#]],
    );
    check(
        CELL,
        &[resize("nGrid", &[2, 8])],
        expect![[r#"
        usrapp/main/main.dtx
        -    <Data name="nGrid" access="private" xsi:type="array" type="num" size="3 4">
        -      <Value key="2,1" value="5" />
        -    </Data>
        +    <Data name="nGrid" access="private" xsi:type="array" type="num" size="2 8" />
    "#]],
    );
    check(
        CELL,
        &[resize("nList", &[4, 2])],
        expect![[r#"
        usrapp/main/main.dtx
        -    <Data name="nList" access="public" xsi:type="array" type="num" size="4">
        -      <Value key="0" value="1.50" />
        -      <Value key="2" value="3" />
        +    <Data name="nList" access="public" xsi:type="array" type="num" size="4 2">
        +      <Value key="0,0" value="1.50" />
        +      <Value key="2,0" value="3" />
    "#]],
    );
}

#[test]
fn collections_have_keys() {
    let (add, remove) = (
        DataEdit::AddKey { place: place("dIn"), key: "a<b".into() },
        DataEdit::RemoveKeys { place: place("dIn"), keys: strings(&["door"]) },
    );
    check(
        CELL,
        &[add],
        expect![[r#"
        usrapp/main/main.dtx
        +      <Value key="a&lt;b" />
    "#]],
    );
    check(
        CELL,
        &[remove],
        expect![[r#"
        usrapp/main/main.dtx
        -      <Value key="door" link="BasicIO-1\%I0" />
    "#]],
    );
    let rename = DataEdit::RenameKey { place: place("dIn"), key: "lamp".into(), new_key: "light".into() };
    check(
        CELL,
        &[rename],
        expect![[r#"
        usrapp/main/main.dtx
        -      <Value key="lamp" />
        +      <Value key="light" />
    "#]],
    );
}

#[test]
fn each_change_is_made_in_the_result_of_those_before_it() {
    let edits = [
        add("nNew", "num", &[2], Some("nCount")),
        set("nNew[1]", "value", Some("5")),
        DataEdit::Delete(strings(&["nCount"])),
        DataEdit::Duplicate { name: "nNew".into(), new_name: "nCount".into() },
    ];
    check(
        CELL,
        &edits,
        expect![[r#"
        usrapp/main/main.dtx
        -    <Data name="nCount" access="private" xsi:type="array" type="num" size="1" />
        +    <Data name="nNew" access="private" xsi:type="array" type="num" size="2">
        +      <Value key="1" value="5" />
        +    </Data>
        +    <Data name="nCount" access="private" xsi:type="array" type="num" size="2">
        +      <Value key="1" value="5" />
        +    </Data>
    "#]],
    );
}

#[test]
fn an_empty_file_gets_data_and_is_empty_again() {
    let listing = "cls()\n=== main/main.dtx\n<Database>\n  <Datas$0 />\n</Database>\n";
    check(
        listing,
        &[add("nNew", "num", &[1], None)],
        expect![[r#"
        usrapp/main/main.dtx
        -  <Datas />
        +  <Datas>
        +    <Data name="nNew" access="private" xsi:type="array" type="num" size="1" />
        +  </Datas>
    "#]],
    );
    check(listing, &[add("nNew", "num", &[1], None), DataEdit::Delete(strings(&["nNew"]))], expect![""]);
}

/// The active variable may be removed, for example by an undo, before the edit arrives.
#[test]
fn new_data_after_a_variable_that_is_gone_comes_last() {
    let added = |after| done(CELL, &[add("nNew", "num", &[1], after)]).unwrap();
    assert_eq!(added(Some("nGone")), added(None));
}
