//! Every single change to attributes, text or code is reported, in files of both dialects.

use std::collections::BTreeMap;
use std::ops::Range;

use expect_test::expect;
use val3_diff::{FileTree, compare};
use val3_test::Fixture;

use crate::dialects::{OLD_DATA, OLD_PROGRAM};
use crate::support::human;

/// All kinds of items in an application, and a file of the controller.
const APPLICATION: &str = r#"
library tray "Disk://tray/tray.pjx" autoload=false
type Slot "Disk://Slot/Slot.pjx"
num nCount = 3
public string sName = "box"
bool bOn = true
num nGrid[3,4]
dio dIn[""]
public program start(num x_n, string& x_s, num& x_a[])
  num l_i
  string l_s[3]
begin
  // first
  l_i=x_n+1
  put("a")
end
--- Slot
public num nWeight
=== main/main.dtx
<?xml version="1.0" encoding="utf-8"?>
<Database xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance" xmlns="http://www.staubli.com/robotics/VAL3/Data/2">
  <Datas>
    <Data name="fTable" access="private" xsi:type="array" type="frame" size="1"><Value key="0" x="1" rz="2" fatherId="world[0]" /></Data>
    <Data name="pPick" access="public" xsi:type="array" type="pointRx" size="3">
      <Value key="0" x="1" y="2" z="3" rx="4" ry="5" rz="6" shoulder="lefty" elbow="epositive" wrist="wpositive" fatherId="fTable[0]" />
      <Value key="2" />
    </Data>
    <Data name="jHome" access="private" xsi:type="array" type="jointRx" size="1"><Value key="0" j1="1" j6="6" /></Data>
    <Data name="tGrip" access="private" xsi:type="array" type="tool" size="1"><Value key="0" z="9" ioLink="valve" ioOpen="0.1" ioClose="0.2" fatherId="flange[0]" /></Data>
    <Data name="mFast" access="private" xsi:type="array" type="mdesc" size="1"><Value key="0" accel="1" vel="2" decel="3" tmax="4" rmax="5" blend="Cartesian" leave="6" reach="7" /></Data>
    <Data name="nCount" access="private" xsi:type="array" type="num" size="2"><Value key="0" value="3" /><Value key="7" value="4" /></Data>
    <Data name="dIn" access="private" xsi:type="collection" type="dio"><Value key="a" link="BasicIO-1\%I0" /></Data>
    <Data name="tSlot" access="private" xsi:type="array" type="Slot" size="1">
      <Value key="0"><Field name="nWeight" xsi:type="array" type="num" size="2" /><Field name="pA" xsi:type="array" type="pointRx" size="1"><Value key="0" x="1" fatherId="world[0]" /></Field></Value>
    </Data>
  </Datas>
</Database>
=== /configs/arm.cfx
<arm xmlns="arm"><Type name="a" value="TX2-60">text</Type></arm>
"#;

/// Attributes that a file may omit with this value.
const DEFAULTS: [&str; 5] =
    [r#"access="private""#, r#"public="false""#, r#"autoload="true""#, r#"byVal="true""#, r#"use="value""#];

fn files() -> BTreeMap<String, String> {
    let mut files: BTreeMap<String, String> = Fixture::parse(APPLICATION).files.into_iter().collect();
    files.insert("usrapp/old/old.dtx".to_owned(), OLD_DATA.to_owned());
    files.insert("usrapp/old/p.pgx".to_owned(), OLD_PROGRAM.to_owned());
    files
}

/// Returns the ranges of the attributes in a file, in the form `name="value"`.
fn attributes(text: &str) -> Vec<Range<usize>> {
    let mut found = Vec::new();
    for (start, _) in text.match_indices("=\"") {
        let name = text[..start].rfind([' ', '\n', '<']).unwrap() + 1;
        let end = start + 2 + text[start + 2..].find('"').unwrap() + 1;
        let is_in_tag = text[..start].rfind('<') > text[..start].rfind('>');
        let is_declaration = text[..start].rfind("<?") > text[..start].rfind("?>");
        if is_in_tag && !is_declaration {
            found.push(name..end);
        }
    }
    found
}

#[track_caller]
fn assert_reported(path: &str, range: Range<usize>, replacement: &str) {
    let old = files();
    let mut new = old.clone();
    let before = old[path][range.clone()].to_owned();
    new.get_mut(path).unwrap().replace_range(range, replacement);
    let found = compare(&FileTree::new(old), &FileTree::new(new));
    assert!(!found.is_empty(), "no difference in {path}: {before} -> {replacement}");
}

#[test]
fn other_attributes_are_named_with_their_elements() {
    let old = files();
    let mut new = old.clone();
    let data = new.get_mut("usrapp/main/main.dtx").unwrap();
    *data = data
        .replace("type=\"num\" size=\"2\" /><Field", "type=\"numx\" /><Field")
        .replace("name=\"nCount\" access", "name=\"nCount\" acces");
    let project = new.get_mut("usrapp/main/main.pjx").unwrap();
    *project = project.replace("</Programs>", "<Program file=\"gone.pgx\" /></Programs>");
    expect![[r#"
        main  main/main.pjx
          Other attributes and texts of the files
            ~ main/main.dtx
                Datas Data[nCount] acces  (not written) → private
                Datas Data[tSlot] Value[0] Field[nWeight] type  num → numx
                Datas Data[tSlot] Value[0] Field[nWeight] size  2 → (not written)
            ~ main/main.pjx
                Programs Program[gone.pgx]  added

        Notes
            ! main/main.pjx  in the new version the project file lists `gone.pgx`, and there is no such file; restore it, or remove the entry

        1 application differs: 2 files with other XML
    "#]].assert_eq(&human(&compare(&FileTree::new(old), &FileTree::new(new))));
}

/// Returns another value of the same form.
fn other(value: &str) -> String {
    match value {
        "true" => "false".to_owned(),
        "false" => "true".to_owned(),
        value => value.parse::<u32>().map_or_else(|_| format!("{value}x"), |number| (number + 1).to_string()),
    }
}

#[test]
fn every_changed_attribute_is_reported() {
    let mut count = 0;
    for (path, text) in files() {
        for range in attributes(&text) {
            let (name, value) = text[range.clone()].split_once('=').unwrap();
            assert_reported(&path, range.clone(), &format!("{name}=\"{}\"", other(value.trim_matches('"'))));
            count += 1;
        }
    }
    assert!(count > 150, "{count}");
}

#[test]
fn every_removed_attribute_is_reported_unless_it_is_the_default() {
    for (path, text) in files() {
        for range in attributes(&text) {
            let attribute = &text[range.clone()];
            let is_default = DEFAULTS.contains(&attribute)
                || ["=\"0\"", "=\"\"", "same\""].iter().any(|end| attribute.ends_with(end));
            if !is_default {
                assert_reported(&path, range, "");
            }
        }
    }
}

#[test]
fn every_changed_character_of_code_and_texts_is_reported() {
    for (path, text) in files() {
        let start = if path.ends_with(".pgx") { text.to_lowercase().find("<code>").unwrap() + 6 } else { 0 };
        for (at, character) in text.char_indices().skip_while(|(at, _)| *at < start) {
            let is_in_tag = text[..at].rfind('<') > text[..at].rfind('>') && !text[..at].ends_with("CDATA[");
            let is_code = path.ends_with(".pgx") && text[at..].to_lowercase().contains("</code>");
            if character.is_ascii_alphanumeric() && (is_code || !is_in_tag) {
                assert_reported(&path, at..at + 1, if character == 'q' { "z" } else { "q" });
            }
        }
    }
}
