use expect_test::{Expect, expect};

use super::*;
use crate::{SavedContainer, SavedContent, SavedField, SavedValue};

/// New text of a file.
#[track_caller]
fn rewritten(text: &str, data: &[SavedData]) -> String {
    rewrite(text, data).unwrap()
}

fn values(values: &[(&str, &[(&str, &str)])]) -> Vec<SavedValue> {
    let values = values.iter().map(|(key, given)| {
        let attributes = given.iter().map(|(name, text)| ((*name).into(), (*text).to_owned()));
        SavedValue { key: (*key).to_owned(), content: SavedContent::Attributes(attributes.collect()) }
    });
    values.collect()
}

/// A value with the attribute `value`.
fn single(index: u32, text: String) -> SavedValue {
    SavedValue { key: index.to_string(), content: SavedContent::Attributes(vec![("value".into(), text)]) }
}

fn array(name: &str, ty: &str, sizes: &[u32], given: &[(&str, &[(&str, &str)])]) -> SavedData {
    let shape = SavedContainer::Sizes(sizes.to_vec());
    SavedData { name: name.into(), type_name: ty.into(), shape, values: values(given), is_part: false }
}

fn collection(name: &str, ty: &str, given: &[(&str, &[(&str, &str)])]) -> SavedData {
    SavedData { shape: SavedContainer::Keys, ..array(name, ty, &[], given) }
}

const NEW: &str = r#"<?xml version="1.0" encoding="utf-8"?>
<Database xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance" xmlns="http://www.staubli.com/robotics/VAL3/Data/2">
  <Datas>
    <Data name="nCount" access="private" xsi:type="array" type="num" size="1" />
    <Data name="nList" access="public" xsi:type="array" type="num" size="4">
      <Value key="0" value="1.50" />
      <Value  key='2'   value='3'/>
    </Data>
    <Data name="pA" access="public" xsi:type="array" type="pointRx" size="1">
      <Value key="0" x="10" shoulder="lefty" fatherId="world[0]" />
    </Data>
    <Data name="dIn" access="public" xsi:type="collection" type="dio">
      <Value key="door" link="BasicIO-1\%I0" />
    </Data>
  </Datas>
</Database>"#;

/// Checks the changed lines.
fn check(before: &str, data: &[SavedData], expected: Expect) {
    let after = rewritten(before, data);
    let (old, new): (Vec<_>, Vec<_>) = (before.lines().collect(), after.lines().collect());
    let gone = old.iter().filter(|line| !new.contains(line)).map(|line| format!("-{line}\n"));
    let come = new.iter().filter(|line| !old.contains(line)).map(|line| format!("+{line}\n"));
    expected.assert_eq(&gone.chain(come).collect::<String>());
    assert!(val3_syntax::parse(&after).errors().is_empty(), "{after}");
    assert_eq!(rewritten(&after, data), after, "a second time changes nothing");
}

#[test]
fn equal_values_keep_their_bytes() {
    let same = [
        array("nCount", "num", &[1], &[("0", &[("value", "0")])]),
        array("nList", "num", &[4], &[("0", &[("value", "1.5")]), ("1", &[]), ("2", &[("value", "3")])]),
        array(
            "pA",
            "pointRx",
            &[1],
            &[("0", &[("x", "10.0"), ("shoulder", "lefty"), ("fatherId", "world"), ("y", "0")])],
        ),
        collection("dIn", "dio", &[("door", &[("link", r"BasicIO-1\%I0")])]),
        array("nowhere", "num", &[1], &[("0", &[("value", "5")])]),
    ];
    assert_eq!(rewritten(NEW, &same), NEW);
    assert_eq!(rewritten(NEW, &[]), NEW);
}

#[test]
fn a_value_changes_in_its_place() {
    let data = [
        array("nList", "num", &[4], &[("0", &[("value", "1.5")]), ("2", &[("value", "-0.25")])]),
        array(
            "pA",
            "pointRx",
            &[1],
            &[("0", &[("x", "10"), ("rz", "90"), ("elbow", "epositive"), ("fatherId", "fA[1]")])],
        ),
    ];
    check(
        NEW,
        &data,
        expect![[r#"
            -      <Value  key='2'   value='3'/>
            -      <Value key="0" x="10" shoulder="lefty" fatherId="world[0]" />
            +      <Value  key='2'   value='-0.25'/>
            +      <Value key="0" x="10" rz="90" elbow="epositive" fatherId="fA[1]" />
        "#]],
    );
}

#[test]
fn values_are_added_and_removed() {
    let data = [
        array("nCount", "num", &[1], &[("0", &[("value", "7")])]),
        array("nList", "num", &[6], &[("1", &[("value", "2")]), ("2", &[("value", "3")]), ("5", &[("value", "6")])]),
        collection("dIn", "dio", &[("a<b\"", &[("link", "x")]), ("new\n", &[])]),
        array("pA", "pointRx", &[1], &[("0", &[])]),
    ];
    check(
        NEW,
        &data,
        expect![[r#"
        -    <Data name="nCount" access="private" xsi:type="array" type="num" size="1" />
        -    <Data name="nList" access="public" xsi:type="array" type="num" size="4">
        -      <Value key="0" value="1.50" />
        -    <Data name="pA" access="public" xsi:type="array" type="pointRx" size="1">
        -      <Value key="0" x="10" shoulder="lefty" fatherId="world[0]" />
        -      <Value key="door" link="BasicIO-1\%I0" />
        +    <Data name="nCount" access="private" xsi:type="array" type="num" size="1">
        +      <Value key="0" value="7" />
        +    <Data name="nList" access="public" xsi:type="array" type="num" size="6">
        +      <Value key="1" value="2" />
        +      <Value key="5" value="6" />
        +    <Data name="pA" access="public" xsi:type="array" type="pointRx" size="1" />
        +      <Value key="a&lt;b&quot;" link="x" />
        +      <Value key="new&#10;" />
    "#]],
    );
}

#[test]
fn a_smaller_array_loses_values() {
    let data = [array("nList", "num", &[2], &[("0", &[("value", "1.5")])])];
    check(
        NEW,
        &data,
        expect![[r#"
        -    <Data name="nList" access="public" xsi:type="array" type="num" size="4">
        -      <Value  key='2'   value='3'/>
        +    <Data name="nList" access="public" xsi:type="array" type="num" size="2">
    "#]],
    );
}

#[test]
fn tables_are_in_order() {
    let text = "<Database><Datas>\r\n<Data name=\"n\" access=\"public\" xsi:type=\"array\" type=\"num\" size=\"3 4\" >\r\n  <Value key=\"1,2\" value=\"5\"/>\r\n</Data>\r\n</Datas></Database>";
    let data = [array(
        "n",
        "num",
        &[3, 4],
        &[("0,3", &[("value", "1")]), ("1,2", &[("value", "5")]), ("2,0", &[("value", "9")])],
    )];
    let after = rewritten(text, &data);
    assert!(!after.replace("\r\n", "").contains('\n'));
    check(
        text,
        &data,
        expect![[r#"
        +  <Value key="0,3" value="1"/>
        +  <Value key="2,0" value="9"/>
    "#]],
    );
}

#[test]
fn a_file_on_one_line() {
    let text = r#"<Database><Datas><Data name="s" access="public" xsi:type="array" type="string" size="1"/></Datas></Database>"#;
    let data = [array("s", "string", &[1], &[("0", &[("value", "a & b")])])];
    let expected = r#"size="1"><Value key="0" value="a &amp; b"/></Data></Datas></Database>"#;
    assert!(rewritten(text, &data).ends_with(expected), "{}", rewritten(text, &data));
    assert_eq!(rewritten(&rewritten(text, &data), &[array("s", "string", &[1], &[])]), text);
}

const SLOTS: &str = r#"<Database>
  <Datas>
    <Data name="tSlot" access="public" xsi:type="array" type="Slot" size="3">
      <Value key="0">
        <Field name="pPick" xsi:type="array" type="pointRx" size="1">
          <Value key="0" x="10" fatherId="world[0]" />
        </Field>
        <Field name="sID" xsi:type="array" type="string" size="1" />
      </Value>
      <Value key="1">
        <Field name="old" xsi:type="array" type="num" size="1" />
        <Field name="sID" xsi:type="array" type="string" size="1" />
      </Value>
    </Data>
  </Datas>
</Database>
"#;

fn slot(key: &str, x: &str, id: &str) -> SavedValue {
    let pick = array("pPick", "pointRx", &[1], &[("0", &[("x", x), ("fatherId", "world[0]")])]);
    let id = array("sID", "string", &[1], &[("0", &[("value", id)])]);
    let fields = [pick, id].map(|data| SavedField { initial: x == "0", data });
    SavedValue { key: key.to_owned(), content: SavedContent::Fields(fields.into()) }
}

fn slots(values: Vec<SavedValue>) -> [SavedData; 1] {
    [SavedData { values, ..array("tSlot", "Slot", &[3], &[]) }]
}

#[test]
fn fields_of_user_types() {
    check(
        SLOTS,
        &slots(vec![slot("0", "10", ""), slot("1", "0", "x"), slot("2", "0", "")]),
        expect![[r#"
        -        <Field name="old" xsi:type="array" type="num" size="1" />
        +        <Field name="sID" xsi:type="array" type="string" size="1">
        +          <Value key="0" value="x" />
    "#]],
    );
    check(
        SLOTS,
        &slots(vec![slot("0", "11", "a"), slot("1", "12", ""), slot("2", "13", "c")]),
        expect![[r#"
        -          <Value key="0" x="10" fatherId="world[0]" />
        -        <Field name="old" xsi:type="array" type="num" size="1" />
        +          <Value key="0" x="11" fatherId="world[0]" />
        +        <Field name="sID" xsi:type="array" type="string" size="1">
        +          <Value key="0" value="a" />
        +          <Value key="0" x="12" fatherId="world[0]" />
        +      <Value key="2">
        +          <Value key="0" x="13" fatherId="world[0]" />
        +        <Field name="sID" xsi:type="array" type="string" size="1">
        +          <Value key="0" value="c" />
    "#]],
    );
}

#[test]
fn the_lists_of_s6() {
    let text = r#"<?xml version="1.0" encoding="iso-8859-1"?>
<dataList xmlns="DataNameSpace" >
  <numSection>
    <num name="nA" public="false" privilege="0" >
      <valueNum index="0" value="3" />
    </num>
  </numSection>
  <pointSection>
    <point name="pA" public="false">
      <pFather alias="" name="world" fatherIndex="0" />
      <valuePoint index="0">
        <tpValue x="0" y="0" z="0" rx="0" ry="0" rz="0" />
        <cpValue shoulder="ssame" elbow="esame" wrist="wsame" />
      </valuePoint>
    </point>
  </pointSection>
</dataList>
"#;
    let same = [array("nA", "num", &[1], &[("0", &[("value", "3.0")])]), array("pA", "point", &[1], &[])];
    assert_eq!(rewritten(text, &same), text);
    let data = [
        array("nA", "num", &[3], &[("0", &[("value", "3")]), ("1", &[("value", "4")])]),
        array("pA", "point", &[1], &[("0", &[("y", "5.5"), ("wrist", "wfree"), ("fatherId", "fB[2]")])]),
    ];
    check(
        text,
        &data,
        expect![[r#"
        -      <pFather alias="" name="world" fatherIndex="0" />
        -        <tpValue x="0" y="0" z="0" rx="0" ry="0" rz="0" />
        -        <cpValue shoulder="ssame" elbow="esame" wrist="wsame" />
        +      <valueNum index="1" value="4" />
        +      <valueNum index="2" value="0" />
        +      <pFather alias="" name="fB" fatherIndex="2" />
        +        <tpValue x="0" y="5.5" z="0" rx="0" ry="0" rz="0" />
        +        <cpValue shoulder="ssame" elbow="esame" wrist="wfree" />
    "#]],
    );
    let grown = rewritten(text, &data);
    let shrunk = rewritten(&grown, &same);
    assert_eq!(shrunk.matches("valueNum").count(), 1);
}

#[test]
fn a_part_of_the_values_leaves_the_others() {
    let one = |ty, key, given| [SavedData { is_part: true, ..array("pA", ty, &[2], &[(key, given)]) }];
    let database = r#"<?xml version="1.0" encoding="utf-8" ?>
<Database xmlns="http://www.staubli.com/robotics/VAL3/Data/2">
  <Datas>
    <Data name="pA" access="private" xsi:type="array" type="pointRx" size="3">
      <Value key="0" x="1" fatherId="world[0]" />
      <Value key="2" y="2" fatherId="world[0]" />
    </Data>
  </Datas>
</Database>
"#;
    check(
        database,
        &one("pointRx", "0", &[("x", "7"), ("fatherId", "world[0]")]),
        expect![[r#"
            -      <Value key="0" x="1" fatherId="world[0]" />
            +      <Value key="0" x="7" fatherId="world[0]" />
        "#]],
    );
    let lists = r#"<dataList xmlns="DataNameSpace">
  <pointSection>
    <point name="pA" public="false">
      <pFather alias="" name="fB" fatherIndex="0" />
      <valuePoint index="0">
        <tpValue x="1" y="2" />
      </valuePoint>
      <valuePoint index="1">
        <tpValue x="3" y="4" />
      </valuePoint>
      <valuePoint index="2">
        <tpValue x="5" y="6" />
      </valuePoint>
    </point>
  </pointSection>
</dataList>
"#;
    check(
        lists,
        &one("point", "1", &[("x", "7"), ("y", "4")]),
        expect![[r#"
            -        <tpValue x="3" y="4" />
            +        <tpValue x="7" y="4" />
        "#]],
    );
}

/// Size of a variable in a file, and its values that differ from the default.
fn size_and_values(text: &str, name: &str) -> (String, Vec<(String, String)>) {
    let parse = val3_syntax::parse(text);
    let root = xml::root(parse.view()).unwrap();
    let data = root.list("Datas", "Data").find(|data| data.value("name").as_deref() == Some(name)).unwrap();
    let text = |value: XmlElement<'_>, name| value.value(name).unwrap_or_default().into_owned();
    let values = data.elements().map(|value| (text(value, "key"), text(value, "value")));
    (text(data, "size"), values.collect())
}

proptest::proptest! {
    /// A file contains the last saved values, independent of earlier values, and all other contents are unchanged.
    #[test]
    fn a_file_contains_the_saved_values(saved in proptest::collection::vec(
        (1..6u32, proptest::collection::btree_map(0..6u32, "[a<&\"\n]{0,3}", 0..6)), 1..4,
    )) {
        let mut text = NEW.replace("type=\"num\" size=\"4\"", "type=\"string\" size=\"4\"");
        for (size, values) in saved {
            let given: Vec<_> = values.into_iter().filter(|(index, _)| *index < size).collect();
            let values = given.iter().map(|(index, text)| single(*index, text.clone())).collect();
            let data = SavedData { values, ..array("nList", "string", &[size], &[]) };
            text = rewritten(&text, &[data]);
            let spelt = given.into_iter().filter(|(_, text)| !text.is_empty());
            let expected = (size.to_string(), spelt.map(|(index, text)| (index.to_string(), text)).collect());
            proptest::prop_assert_eq!(size_and_values(&text, "nList"), expected);
            proptest::prop_assert!(text.ends_with(NEW.split_once("    <Data name=\"pA\"").unwrap().1), "{}", text);
        }
    }
}

/// Values are looked up in a map. With a linear search, a text of this size would take minutes.
#[test]
fn many_values() {
    let count = 20_000_u32;
    let element = |index: u32| format!("      <Value key=\"{index}\" value=\"{}\" />\n", index + 1);
    let list: String = (0..count).step_by(2).map(element).collect();
    let text = format!(
        "<?xml version=\"1.0\" encoding=\"utf-8\" ?>\n<Database xmlns=\"http://www.staubli.com/robotics/VAL3/Data/2\">\n  \
         <Datas>\n    <Data name=\"nList\" access=\"private\" xsi:type=\"array\" type=\"num\" size=\"{count}\">\n{list}    \
         </Data>\n  </Datas>\n</Database>\n"
    );
    let values = (0..count).map(|index| single(index, (index + 2).to_string())).collect();
    let data = SavedData { values, ..array("nList", "num", &[count], &[]) };
    let written = rewritten(&text, &[data]);
    let lines: Vec<&str> = written.lines().filter(|line| line.contains("<Value")).collect();
    assert_eq!(lines.len(), count as usize);
    let line = |index: u32| format!("      <Value key=\"{index}\" value=\"{}\" />", index + 2);
    assert!(lines.iter().zip(0..).all(|(found, index)| *found == line(index)));
}
