//! Data files: each fault, and a correct value at its limit.

use expect_test::expect;

use crate::show::faults;

/// Returns the faults of a `main.dtx` with these elements, in a project with the user type `Slot`.
pub(crate) fn datas(elements: &str) -> String {
    let listing = format!(
        "=== main/main.pjx\n<Project><Database><Data file=\"main.dtx\" /></Database><Types><Type name=\"Slot\" \
         path=\"Disk://Slot/Slot.pjx\" /></Types></Project>\n=== main/main.dtx\n<Database>\n<Datas>{elements}</Datas>\
         </Database>\n--- Slot\npublic num nCount[2]\npublic num nByName[\"\"]\npublic frame fSlot[2]\npublic num nGrid[2,2]\nnum nPrivate\n"
    );
    faults(&listing)
}

/// Returns the faults in an array with these values.
fn array(ty: &str, size: &str, values: &str) -> String {
    datas(&format!(r#"<Data name="vA" access="private" xsi:type="array" type="{ty}" size="{size}">{values}</Data>"#))
}

#[test]
fn values_that_suit() {
    for (ty, value) in [
        ("bool", r#"value="true""#),
        ("num", r#"value="-1.5e3""#),
        ("string", r#"value="&lt;any text&gt;""#),
        ("dio", r#"link="BasicIO-1\%I0""#),
        ("aio", r#"link="any""#),
        ("sio", r#"link="""#),
        ("trsf", r#"x="1" y="2" z="3" rx="4" ry="5" rz="6""#),
        ("frame", r#"x="1" fatherId="world[0]""#),
        ("tool", r#"z="150" fatherId="flange[0]" ioLink="valve1" ioOpen="0.1" ioClose="0.2""#),
        ("pointRx", r#"x="1" shoulder="lefty" elbow="epositive" wrist="wfree" fatherId="world[0]""#),
        ("pointRs", r#"x="1" shoulder="righty""#),
        ("jointRx", r#"j1="1" j6="6""#),
        ("jointRs", r#"j4="4""#),
        ("configRx", r#"shoulder="ssame" elbow="esame" wrist="wsame""#),
        ("mdesc", r#"accel="10" vel="10" decel="10" tmax="1" rmax="1" blend="cartesian" leave="1" reach="1""#),
        ("screen", ""),
    ] {
        let found = array(ty, "1", &format!(r#"<Value key="0" {value} />"#));
        assert_eq!(found, "", "{ty} {value}");
    }
}

#[test]
fn values_that_do_not_suit() {
    let values = [
        ("bool", r#"value="True""#),
        ("bool", r#"value="1""#),
        ("num", r#"value="1,5""#),
        ("num", r#"value="""#),
        ("num", r#"value="nan""#),
        ("num", r#"valu="1""#),
        ("trsf", r#"x="one""#),
        ("trsf", r#"w="1""#),
        ("pointRx", r#"shoulder="left""#),
        ("pointRs", r#"elbow="epositive""#),
        ("jointRx", r#"j7="1""#),
        ("jointRs", r#"j5="1""#),
        ("mdesc", r#"blend="Joint""#),
        ("mdesc", r#"tvel="1""#),
    ];
    let found = values.map(|(ty, value)| array(ty, "1", &format!(r#"<Value key="0" {value} />"#)));
    expect![[r#"
        main/main.dtx:2 `True` InvalidValue { ty: "bool", attribute: "value", value: "True", expected: "`true` or `false`" }
        main/main.dtx:2 `1` InvalidValue { ty: "bool", attribute: "value", value: "1", expected: "`true` or `false`" }
        main/main.dtx:2 `1,5` InvalidValue { ty: "num", attribute: "value", value: "1,5", expected: "a number" }
        main/main.dtx:2 `` InvalidValue { ty: "num", attribute: "value", value: "", expected: "a number" }
        main/main.dtx:2 `nan` InvalidValue { ty: "num", attribute: "value", value: "nan", expected: "a number" }
        main/main.dtx:2 `valu` UnknownValueAttribute { ty: "num", attribute: "valu", near: Some("value") }
        main/main.dtx:2 `one` InvalidValue { ty: "trsf", attribute: "x", value: "one", expected: "a number" }
        main/main.dtx:2 `w` UnknownValueAttribute { ty: "trsf", attribute: "w", near: Some("x") }
        main/main.dtx:2 `left` InvalidValue { ty: "point", attribute: "shoulder", value: "left", expected: "`ssame`, `sfree`, `lefty` or `righty`" }
        main/main.dtx:2 `elbow` UnknownValueAttribute { ty: "point", attribute: "elbow", near: None }
        main/main.dtx:2 `j7` UnknownValueAttribute { ty: "joint", attribute: "j7", near: Some("j1") }
        main/main.dtx:2 `j5` UnknownValueAttribute { ty: "joint", attribute: "j5", near: Some("j1") }
        main/main.dtx:2 `tvel` UnknownValueAttribute { ty: "mdesc", attribute: "tvel", near: Some("tmax") }
    "#]].assert_eq(&found.concat());
}

fn array_with_keys(size: &str, keys: &[&str]) -> String {
    let values: String = keys.iter().map(|key| format!(r#"<Value key="{key}" />"#)).collect();
    array("num", size, &values)
}

#[test]
fn keys() {
    assert_eq!(array_with_keys("3", &["0", "1", "2"]), "");
    assert_eq!(array_with_keys("2 3", &["0,0", "1,2", "1, 1"]), "");
    assert_eq!(array_with_keys("2 2 2", &["1,1,1"]), "");
    let faulty = [
        array_with_keys("3", &["3"]),
        array_with_keys("3", &["-1"]),
        array_with_keys("3", &["a"]),
        array_with_keys("3", &["0,1"]),
        array_with_keys("3", &["1", "1"]),
        array_with_keys("2 3", &["2,0"]),
        array_with_keys("2 3", &["1,3"]),
        array_with_keys("2 3", &["1"]),
        array("num", "1", "<Value />"),
    ];
    expect![[r#"
        main/main.dtx:2 `3` KeyOutOfRange { key: "3", size: "3" }
        main/main.dtx:2 `-1` InvalidKey { key: "-1", dims: 1 }
        main/main.dtx:2 `a` InvalidKey { key: "a", dims: 1 }
        main/main.dtx:2 `0,1` InvalidKey { key: "0,1", dims: 1 }
        main/main.dtx:2 `1` DuplicateKey { key: "1" }
        main/main.dtx:2 `2,0` KeyOutOfRange { key: "2,0", size: "2 x 3" }
        main/main.dtx:2 `1,3` KeyOutOfRange { key: "1,3", size: "2 x 3" }
        main/main.dtx:2 `1` InvalidKey { key: "1", dims: 2 }
        main/main.dtx:2 `Value` MissingAttribute { element: "Value", attribute: "key", default: None, written: None }
    "#]]
    .assert_eq(&faulty.concat());
}

fn collection(values: &str) -> String {
    datas(&format!(r#"<Data name="vA" access="private" xsi:type="collection" type="num">{values}</Data>"#))
}

#[test]
fn keys_of_collections() {
    assert_eq!(collection(r#"<Value key="a" /><Value key="0" /><Value key="A" />"#), "");
    let faulty = [collection(r#"<Value key="a" /><Value key="a" />"#), collection(r#"<Value key="" />"#)];
    expect![[r#"
        main/main.dtx:2 `a` DuplicateKey { key: "a" }
        main/main.dtx:2 `` InvalidKey { key: "", dims: 0 }
    "#]]
    .assert_eq(&faulty.concat());
}

#[test]
fn declarations() {
    let fine = r#"<Data name="a_1" access="public" xsi:type="array" type="num" size="1" />
<Data name="exactly15chars_" access="private" xsi:type="array" type="num" size="1" />"#;
    assert_eq!(datas(fine), "");
    let faulty = r#"
<Data name="1a" access="public" xsi:type="array" type="num" size="1" />
<Data name="sixteen_letters_" access="public" xsi:type="array" type="num" size="1" />
<Data name="endIf" access="public" xsi:type="array" type="num" size="1" />
<Data name="nTwice" access="public" xsi:type="array" type="num" size="1" />
<Data name="nTwice" access="public" xsi:type="array" type="num" size="1" />
<Data name="nA" access="protected" xsi:type="array" type="num" size="1" />
<Data name="nB" access="public" xsi:type="element" type="num" size="1" />
<Data name="nC" access="public" xsi:type="array" type="nmu" size="1" />
<Data name="nD" access="public" xsi:type="array" type="Slto" size="1" />
<Data name="nE" access="public" xsi:type="array" type="num" size="0" />
<Data name="nF" access="public" xsi:type="array" size="1" />
<Data access="public" xsi:type="array" type="num" size="1" />
<Value key="0" />
<Data name="nG" access="public" xsi:type="array" type="num" size="1"><Valu key="0" /></Data>
"#;
    expect![[r#"
        main/main.dtx:15 `Value` UnexpectedElement { name: "Value", parent: "Datas" }
        main/main.dtx:13 `Data` MissingAttribute { element: "Data", attribute: "type", default: None, written: None }
        main/main.dtx:14 `Data` MissingAttribute { element: "Data", attribute: "name", default: None, written: None }
        main/main.dtx:3 `1a` InvalidName { name: "1a" }
        main/main.dtx:4 `sixteen_letters_` NameTooLong { name: "sixteen_letters_", limit: 15 }
        main/main.dtx:5 `endIf` ReservedName { name: "endIf" }
        main/main.dtx:7 `nTwice` DuplicateName { name: "nTwice", what: Data }
            First main/main.dtx:6 `nTwice`
        main/main.dtx:8 `protected` InvalidAttribute { element: "Data", attribute: "access", value: "protected", expected: "`public` or `private`" }
        main/main.dtx:9 `element` InvalidAttribute { element: "Data", attribute: "xsi:type", value: "element", expected: "`array` or `collection`" }
        main/main.dtx:10 `nmu` UnknownType { name: "nmu", near: Some("num") }
        main/main.dtx:11 `Slto` UnknownType { name: "Slto", near: Some("Slot") }
        main/main.dtx:12 `0` InvalidSize { size: "0" }
        main/main.dtx:16 `Valu` UnexpectedElement { name: "Valu", parent: "Data" }
    "#]].assert_eq(&datas(faulty));
}

#[test]
fn values_of_user_types() {
    let slot = |fields: &str| array("Slot", "1", &format!(r#"<Value key="0">{fields}</Value>"#));
    let count = |value: &str| format!(r#"<Field name="nCount" xsi:type="array" type="num" size="2">{value}</Field>"#);
    assert_eq!(slot(""), "");
    assert_eq!(slot(&count(r#"<Value key="1" value="3" />"#)), "");
    assert_eq!(
        slot(r#"<Field name="nByName" xsi:type="collection" type="num"><Value key="a" value="1" /></Field>"#),
        ""
    );
    let faulty = [
        slot(&count(r#"<Value key="2" value="3" />"#)),
        slot(&count(r#"<Value key="1" value="x" />"#)),
        slot(r#"<Field name="nCuont" xsi:type="array" type="num" size="2" />"#),
        slot(r#"<Field name="nPrivate" xsi:type="array" type="num" size="2" />"#),
        slot(r#"<Field name="nCount" xsi:type="array" type="string" size="2" />"#),
        slot(r#"<Field name="nCount" xsi:type="collection" type="num" />"#),
        slot(r#"<Field name="nByName" xsi:type="array" type="num" size="1" />"#),
        slot(r#"<Field name="nCount" xsi:type="array" type="num" size="0" />"#),
        slot(r#"<Field xsi:type="array" type="num" size="1" />"#),
        slot(r#"<Value key="0" />"#),
    ];
    expect![[r#"
        main/main.dtx:2 `2` KeyOutOfRange { key: "2", size: "2" }
        main/main.dtx:2 `x` InvalidValue { ty: "num", attribute: "value", value: "x", expected: "a number" }
        main/main.dtx:2 `nCuont` UnknownUserField { ty: "Slot", field: "nCuont", near: Some("nCount") }
        main/main.dtx:2 `nPrivate` UnknownUserField { ty: "Slot", field: "nPrivate", near: None }
        main/main.dtx:2 `nCount` UserFieldType { ty: "Slot", field: "nCount", expected: "num", found: "string" }
        main/main.dtx:2 `nCount` UserFieldType { ty: "Slot", field: "nCount", expected: "num", found: "num[\"\"]" }
        main/main.dtx:2 `nByName` UserFieldType { ty: "Slot", field: "nByName", expected: "num[\"\"]", found: "num" }
        main/main.dtx:2 `0` InvalidSize { size: "0" }
        main/main.dtx:2 `Field` MissingAttribute { element: "Field", attribute: "name", default: None, written: None }
        main/main.dtx:2 `Value` UnexpectedElement { name: "Value", parent: "Value" }
    "#]]
    .assert_eq(&faulty.concat());
}

fn link_faults(ty: &str, link: &str) -> String {
    let attribute = if ty == "tool" { "ioLink" } else { "link" };
    faults(&format!(
        "=== /configs/sio.cfx\n<sio><socketClt><String name=\"name\" value=\"host\" /></socketClt></sio>\n\
         === /configs/bio.cfx\n<bio><bioDin index=\"0\" /><bioDout index=\"1\" /></bio>\n\
         === main/main.pjx\n<Project><Database><Data file=\"main.dtx\" /></Database></Project>\n=== main/main.dtx\n\
         <Database><Datas><Data name=\"vA\" access=\"private\" xsi:type=\"array\" type=\"{ty}\" size=\"1\"><Value \
         key=\"0\" {attribute}=\"{link}\" /></Data></Datas></Database>"
    ))
}

#[test]
fn links_against_the_cell() {
    for (ty, fine) in [
        ("sio", r"Socket\host"),
        ("dio", r"BasicIO-1\%I0"),
        ("tool", r"BasicIO-1\%Q1"),
        ("dio", r"J206\anything"),
        ("sio", r"Serial\1"),
        ("dio", "valve1"),
        ("dio", ""),
    ] {
        assert_eq!(link_faults(ty, fine), "", "{fine}");
    }
    let faulty = [
        link_faults("sio", r"Socket\hots"),
        link_faults("dio", r"Socket\host"),
        link_faults("dio", r"BasicIO-1\%I1"),
        link_faults("aio", r"BasicIO-1\%I0"),
        link_faults("tool", r"Socket\host"),
    ];
    expect![[r#"
        main/main.dtx:1 `Socket\hots` IoLinkUnknown { link: "Socket\\hots", near: Some("Socket\\host") }
        main/main.dtx:1 `Socket\host` IoLinkKind { link: "Socket\\host", expected: "dio", found: "sio" }
        main/main.dtx:1 `BasicIO-1\%I1` IoLinkUnknown { link: "BasicIO-1\\%I1", near: Some("BasicIO-1\\%I0") }
        main/main.dtx:1 `BasicIO-1\%I0` IoLinkKind { link: "BasicIO-1\\%I0", expected: "aio", found: "dio" }
        main/main.dtx:1 `Socket\host` IoLinkKind { link: "Socket\\host", expected: "dio", found: "sio" }
    "#]]
    .assert_eq(&faulty.concat());
}

fn with_second_file(second: &str) -> String {
    format!(
        "nA=nB\n=== main/main.pjx\n<Project><Programs><Program file=\"start.pgx\" /></Programs><Database><Data \
         file=\"main.dtx\" /><Data file=\"more.dtx\" /></Database></Project>\n=== main/main.dtx\n{}\n\
         === main/more.dtx\n{}",
        data_file("nA"),
        data_file(second)
    )
}

fn data_file(name: &str) -> String {
    format!(
        r#"<Database><Datas><Data name="{name}" access="private" xsi:type="array" type="num" size="1" /></Datas></Database>"#
    )
}

#[test]
fn two_data_files() {
    expect![[r#""#]].assert_eq(&faults(&with_second_file("nB")));
    expect![[r#"
        main/more.dtx:1 `nA` DuplicateName { name: "nA", what: Data }
            First main/main.dtx:1 `nA`
        main/start.pgx:5 `nB` UnknownName { name: "nB", near: Some("nA") }
    "#]]
    .assert_eq(&faults(&with_second_file("nA")));
}

#[test]
fn an_unknown_root_element_is_reported() {
    let listing = "=== main/main.pjx\n<Project><Database><Data file=\"main.dtx\" /></Database></Project>\n\
                   === main/main.dtx\n<Datas />";
    expect![[r#"
        main/main.dtx:1 `Datas` WrongRoot { expected: Data, found: "Datas" }
    "#]]
    .assert_eq(&faults(listing));
}
