//! Impossible edits.

use super::*;

const CELL: &str = r#"
type Slot "Disk://Slot/Slot.pjx"
program other()
begin
end
cls()
=== main/main.dtx
<Database>
  <Datas>$0
    <Data name="nA" access="private" xsi:type="array" type="num" size="2" />
    <Data name="nTwice" access="private" xsi:type="array" type="num" size="1" />
    <Data name="nTwice" access="private" xsi:type="array" type="num" size="1" />
    <Data name="sKeys" access="private" xsi:type="collection" type="string">
      <Value key="a" />
    </Data>
  </Datas>
</Database>
"#;

const OLD: &str = "version s6.8\ncls()\n=== main/main.dtx\n<dataList>\n  <dioSection>$0\n    <dio name=\"dA\" public=\"false\" \
                   size=\"1\" />\n  </dioSection>\n  <numSection>\n    <num name=\"nA\" public=\"false\" >\n      \
                   <valueNum index=\"0\" value=\"1\" />\n    </num>\n  </numSection>\n</dataList>\n";

#[test]
fn names() {
    let reason = |name: &str| refused(CELL, add(name, "num", &[1], None));
    assert_eq!(reason("nA"), "there is already data called `nA`");
    assert_eq!(reason("other"), "there is already a program called `other`");
    assert_eq!(reason("1a"), "`1a` is no name: letters, digits and `_`, no digit first");
    assert_eq!(reason("endIf"), "`endIf` is a word of the language");
    assert_eq!(reason("nAbcdefghijklmno"), "names have at most 15 characters in this version");
    let copy = DataEdit::Duplicate { name: "nA".into(), new_name: "sKeys".into() };
    assert_eq!(refused(CELL, copy), "there is already data called `sKeys`");
}

#[test]
fn types_and_sizes() {
    let reason = |type_name: &str, sizes: &[u32]| refused(CELL, add("x", type_name, sizes, None));
    assert_eq!(reason("Slut", &[1]), "there is no type `Slut` in this project");
    assert_eq!(reason("point", &[1]), "there is no type `point` in this project");
    assert_eq!(reason("num", &[0]), "an array has one value at least");
    assert_eq!(reason("num", &[100, 100]), "an array has 9999 values at most in this version");
    assert_eq!(reason("num", &[1, 1, 1, 1]), "an array has one to three dimensions in this version");
    assert_eq!(refused(CELL, resize("sKeys", &[2])), "`sKeys` is a collection: it has keys and no size");
}

#[test]
fn values() {
    let reason = |path: &str, column: &str, text: &str| refused(CELL, set(path, column, Some(text)));
    assert_eq!(reason("nA[2]", "value", "1"), "`nA` has no value `2`: its size is 2");
    assert_eq!(reason("nA[0]", "x", "1"), "a value of `num` has no column `x`");
    assert_eq!(reason("nA", "value", "1"), "a cell has the key of its value");
    assert_eq!(reason("nA[0]", "value", "\u{1}"), "the character U+0001 cannot be written in the file");
    assert_eq!(reason("sKeys[b]", "value", "1"), "the collection `sKeys` has no key `b`");
    assert_eq!(reason("nB[0]", "value", "1"), "the file declares no data called `nB`");
    assert_eq!(reason("nA[0].x[0]", "value", "1"), "there is no field `x`: the type is no user type of the project");
}

#[test]
fn keys() {
    let add_key = |name: &str, key: &str| DataEdit::AddKey { place: place(name), key: key.into() };
    assert_eq!(refused(CELL, add_key("sKeys", "a")), "`sKeys` has the key `a` already");
    assert_eq!(refused(CELL, add_key("sKeys", "")), "a key is a text that is not empty");
    assert_eq!(refused(CELL, add_key("nA", "a")), "`nA` is an array: it has a size and no keys");
    let remove = DataEdit::RemoveKeys { place: place("sKeys"), keys: strings(&["b"]) };
    assert_eq!(refused(CELL, remove), "`sKeys` has no key `b`");
}

#[test]
fn what_the_old_dialect_cannot_write() {
    assert_eq!(refused(OLD, add("sNew", "string", &[], None)), "there are no collections before s7");
    assert_eq!(refused(OLD, add("nNew", "num", &[2, 2], None)), "an array has one dimension in this version");
    assert_eq!(
        refused(OLD, add("mNew", "configVrb", &[1], None)),
        "data of the type `configVrb` cannot be written in this file"
    );
    let link = set("dA[0]", "link", Some("x"));
    assert_eq!(refused(OLD, link), "the file writes no value `0` of `dA`");
    assert_eq!(refused(OLD, set("nA[1]", "value", Some("1"))), "the file writes no value `1` of `nA`");
}

#[test]
fn a_name_that_is_declared_twice_has_a_place() {
    let problem = done(CELL, &[set("nTwice[0]", "value", Some("1"))]).unwrap_err();
    assert_eq!(problem.reason, "the file declares `nTwice` twice; rename one of them in the text first");
    assert!(problem.range.is_some());
}

#[test]
fn broken_files_have_the_place_of_the_error() {
    let problem = done(&CELL.replace("  </Datas>\n", ""), &[set("nA[0]", "value", Some("1"))]).unwrap_err();
    assert_eq!(problem.reason, "the file has a syntax error; correct it in the text first");
    assert!(problem.range.is_some());
}
