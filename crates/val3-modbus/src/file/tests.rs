use std::fmt::Write as _;

use expect_test::{Expect, expect};

use super::*;

const FILE: &str = r#"<?xml version="1.0" encoding="ISO-8859-1" standalone="yes"?>
<TOPICSLIST>
<TOPIC Name="Modbus" Card="0" Channel="0" Equipment="0" RefreshPeriod="200" Actif="1">
<MODULE Tag_name_root="" IDModule="BOOLEAN" InputSize="" OutputSize="10">
<ITEM Name="bStart" Syntaxe="%Q0" Offset="0"/>
<ITEM Name="bIn" Syntaxe="%Q1:8" Offset="1"/>
<ITEM Name="bReady" Syntaxe="%I9" Offset="9"/></MODULE>
<MODULE Tag_name_root="Word" IDModule="WORD" InputSize="" OutputSize="64">
<ITEM Name="nRecipe" Syntaxe="%QW0:2" Offset="0"/>
<ITEM Name="nCount" Syntaxe="%IW2:2" Offset="2"/></MODULE>
</TOPIC>
<GENERAL_PARAMETERS TopicName="Modbus" TCP_Port="502" ConnectionNumber="2"/>
</TOPICSLIST>
"#;

#[test]
fn topics_and_items_are_read() {
    let file = ModbusFile::read(FILE);
    assert_eq!(file.faults, []);
    let [topic] = &file.topics[..] else { panic!("one topic") };
    assert_eq!((topic.is_active, topic.clients, topic.port), (true, Some(2), Some(502)));
    let mut shown = String::new();
    for item in &topic.items {
        writeln!(shown, "{:?} {} {:?} {} {:?}", item.table, item.name, item.writer, item.first, item.count).unwrap();
    }
    expect![[r#"
        Bits bStart Client 0 None
        Bits bIn Client 1 Some(8)
        Bits bReady Robot 9 None
        Words nRecipe Client 0 Some(2)
        Words nCount Robot 2 Some(2)
    "#]]
    .assert_eq(&shown);
}

/// Checks the faults after the replacement of a text, each with its line.
fn check(from: &str, to: &str, expected: Expect) {
    assert!(FILE.contains(from), "{from}");
    let text = FILE.replacen(from, to, 1);
    let mut shown = String::new();
    for fault in ModbusFile::read(&text).faults {
        let line = text[..fault.offset].matches('\n').count() + 1;
        let effect = match () {
            () if fault.kind.hides_items() => " (hides items)",
            () if fault.kind.is_harmless() => " (harmless)",
            () => "",
        };
        writeln!(shown, "{line}: {}{effect}", fault.kind).unwrap();
    }
    expected.assert_eq(&shown);
}

#[test]
fn unknown_items_are_faults() {
    check(
        "</TOPIC>",
        "",
        expect![[r#"
        3: the XML is not well-formed here (hides items)
    "#]],
    );
    check(
        FILE,
        "<LIST/>",
        expect![[r#"
        1: the file has no root element `TOPICSLIST` (hides items)
    "#]],
    );
    check(
        "Name=\"bIn\" ",
        "",
        expect![[r#"
        6: `ITEM` has no `Name` (hides items)
        7: no item has the addresses 1 to 8 (harmless)
    "#]],
    );
    check(
        "Card=\"0\"",
        "Card=\"1\"",
        expect![[r#"
        3: `Card` is not 0, and it is unknown which links belong to such a topic (hides items)
    "#]],
    );
    check(
        "\"WORD\"",
        "\"REAL\"",
        expect![[r#"
        8: `IDModule` is `BOOLEAN` or `WORD`, not `REAL` (hides items)
    "#]],
    );
    check(
        "%I9",
        "%X9",
        expect![[r#"
        4: `OutputSize` is 10, but the items of the module have 9 bits (harmless)
        7: `Syntaxe` is `%Q` or `%I`, in words `%QW` or `%IW`, with an address up to 65535, such as `%Q1:8`, not `%X9` (hides items)
    "#]],
    );
}

#[test]
fn addresses_are_compared() {
    check(
        "Offset=\"9\"",
        "Offset=\"8\"",
        expect![[r#"
        7: `Offset` of `bReady` is 8, but its `Syntaxe` has the address 9
    "#]],
    );
    check(
        "%Q1:8",
        "%Q1:9",
        expect![[r#"
        7: `bReady` and `bIn` have the same address 9
    "#]],
    );
    check(
        "%Q1:8",
        "%Q1:7",
        expect![[r#"
        7: no item has the address 8 (harmless)
    "#]],
    );
    check(
        "OutputSize=\"64\"",
        "OutputSize=\"4\"",
        expect![[r#"
        8: `OutputSize` is 4, but the items of the module have 64 bits (harmless)
    "#]],
    );
    check(
        "\"bReady\"",
        "\"bIn\"",
        expect![[r#"
        7: another item of this table is called `bIn`
    "#]],
    );
    check(
        "ConnectionNumber=\"2\"",
        "ConnectionNumber=\"0\"",
        expect![[r#"
        12: `ConnectionNumber` is a number from 1 to 65535, not `0`
    "#]],
    );
}

#[test]
fn damaged_files_are_read_without_panic() {
    for end in 0..FILE.len() {
        let file = ModbusFile::read(&FILE[..end]);
        assert!(end >= FILE.trim_end().len() || !file.has_all_items(), "{end}");
    }
}
