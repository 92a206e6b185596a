//! Names in the files of user pages.

use expect_test::expect;

use super::check;
use crate::references::references;
use crate::testing::{MarkedListing, shown_all};

/// An application with a page; `cursor` is a part of a file, with `|` for the cursor.
fn cell(cursor: &str) -> String {
    let marked = cursor.replace('|', "$0");
    let listing = r#"version s8.10
library part "Disk://part/part.pjx"
type Slot "Disk://Slot/Slot.pjx"
num nCount
Slot tSlot[2]
string sText["front","é"]
program start()
  string l_s
begin
  userPage("main")
  userPageSet("MAIN","lblCount","innerHTML","")
  nCount=tSlot[1].nHeight
  l_s=sText["front"]+sText["é"]
  call clkReset()
end
program clkReset()
begin
  nCount=0
end

=== main/interface/Main.html
<html><body><label id="lblOther" for="btnReset"/><label id='lblCount'/>
<button class="x" id="btnReset"/><!-- <p id="btnReset"> --></body></html>
=== main/interface/main.Bindings.JSON
{"bindings":[
{"id":"lblCount","attribute":"innerHTML","data":"nCount[0]","direction":"r"},
{"id":"lblCount","attribute":"value","data":"n\u0043ount[0]","direction":"rw"},
{"id":"lblOther","attribute":"innerHTML","data":"tSlot[1].nHeight[0]"},
{"id":"lblOther","attribute":"innerHTML","data":"sText[\"front\"]"},
{"id":"lblOther","attribute":"innerHTML","data":"sText[\"\u00e9\"]"},
{"id":"lblOther","attribute":"innerHTML","data":"part:nWeight[0]"}],
"callbacks":[{"id":"btnReset","event":"click","data":"clkReset"}]}
--- part
public num nWeight
--- Slot
public num nHeight
"#;
    let whole = cursor.replace('|', "");
    assert!(listing.contains(&whole), "{whole}");
    listing.replacen(&whole, &marked, 1)
}

#[test]
fn data_and_fields_are_renamed_in_bindings() {
    check(
        &cell("n|Count=tSlot"),
        "nTotal",
        expect![[r#"
            main/clkReset.pgx:5 nCount -> nTotal
            main/interface/main.Bindings.JSON:2 nCount -> nTotal
            main/interface/main.Bindings.JSON:3 n\u0043ount -> nTotal
            main/main.dtx:4 nCount -> nTotal
            main/start.pgx:10 nCount -> nTotal
        "#]],
    );
    check(
        &cell("tSlot[1].n|Height[0]"),
        "nSize",
        expect![[r#"
        Slot/Slot.dtx:4 nHeight -> nSize
        main/interface/main.Bindings.JSON:4 nHeight -> nSize
        main/start.pgx:10 nHeight -> nSize
    "#]],
    );
    check(
        &cell("part:n|Weight[0]"),
        "nMass",
        expect![[r#"
        main/interface/main.Bindings.JSON:7 nWeight -> nMass
        part/part.dtx:4 nWeight -> nMass
    "#]],
    );
    check(
        &cell("\"pa|rt:nWeight"),
        "piece",
        expect![[r#"
        main/interface/main.Bindings.JSON:7 part -> piece
        main/main.pjx:12 part -> piece
    "#]],
    );
}

#[test]
fn programs_are_renamed_in_bindings() {
    check(
        &cell("call clk|Reset"),
        "clkZero",
        expect![[r#"
        main/clkReset.pgx:3 clkReset -> clkZero
        main/interface/main.Bindings.JSON:8 clkReset -> clkZero
        main/main.pjx:5 clkReset -> clkZero
        main/start.pgx:12 clkReset -> clkZero
        clkReset.pgx moves to clkZero.pgx
    "#]],
    );
    check(
        &cell("\"data\":\"clk|Reset"),
        "clkZero",
        expect![[r#"
        main/clkReset.pgx:3 clkReset -> clkZero
        main/interface/main.Bindings.JSON:8 clkReset -> clkZero
        main/main.pjx:5 clkReset -> clkZero
        main/start.pgx:12 clkReset -> clkZero
        clkReset.pgx moves to clkZero.pgx
    "#]],
    );
}

#[test]
fn keys_are_renamed_in_bindings() {
    check(
        &cell("l_s=sText[\"fro|nt\"]"),
        "back",
        expect![[r#"
        main/interface/main.Bindings.JSON:5 front -> back
        main/main.dtx:7 front -> back
        main/start.pgx:11 front -> back
    "#]],
    );
    check(
        &cell("\\\"fro|nt\\\""),
        "a\\b",
        expect![[r#"
        main/interface/main.Bindings.JSON:5 front -> a\\b
        main/main.dtx:7 front -> a\b
        main/start.pgx:11 front -> a\b
    "#]],
    );
    check(
        &cell("+sText[\"|é\"]"),
        "è",
        expect![[r#"
        main/interface/main.Bindings.JSON:6 \u00e9 -> è
        main/main.dtx:8 é -> è
        main/start.pgx:11 é -> è
    "#]],
    );
}

#[test]
fn elements_are_renamed_in_page_bindings_and_programs() {
    check(
        &cell("userPageSet(\"MAIN\",\"lbl|Count"),
        "lblTotal",
        expect![[r#"
        main/interface/Main.html:1 lblCount -> lblTotal
        main/interface/main.Bindings.JSON:2 lblCount -> lblTotal
        main/interface/main.Bindings.JSON:3 lblCount -> lblTotal
        main/start.pgx:9 lblCount -> lblTotal
    "#]],
    );
    check(
        &cell("id=\"btn|Reset\"/>"),
        "btnZero",
        expect![[r#"
        main/interface/Main.html:1 btnReset -> btnZero
        main/interface/Main.html:2 btnReset -> btnZero
        main/interface/main.Bindings.JSON:8 btnReset -> btnZero
    "#]],
    );
    check(
        &cell("{\"id\":\"btn|Reset"),
        "lblCount",
        expect![[r#"
        refused: `Main.html` has an element with the id `lblCount` already
    "#]],
    );
    check(
        &cell("{\"id\":\"btn|Reset"),
        "a b",
        expect![[r#"
        refused: `a b` is no id: some text without blanks, quotes, `&`, `<`, `>` and `\`
    "#]],
    );
}

#[test]
fn elements_keep_an_id_that_others_may_name() {
    let scripted = cell("id=\"btn|Reset\"/>").replace("</body>", "<style>#btnReset { color: red }</style></body>");
    check(
        &scripted,
        "btnZero",
        expect![[r#"
        refused: a script or a style of `Main.html` may name `btnReset`. Rename it in the text
    "#]],
    );
    let computed = cell("id=\"btn|Reset\"/>").replace("\"lblCount\",\"inner", "l_s,\"inner");
    check(
        &computed,
        "btnZero",
        expect![[r#"
        refused: the program `start` computes the id of an element, which may be `btnReset`
    "#]],
    );
    let of_another_page = computed.replace("userPageSet(\"MAIN\"", "userPageSet(\"other\"");
    check(
        &of_another_page,
        "btnZero",
        expect![[r#"
        main/interface/Main.html:1 btnReset -> btnZero
        main/interface/Main.html:2 btnReset -> btnZero
        main/interface/main.Bindings.JSON:8 btnReset -> btnZero
    "#]],
    );
}

#[test]
fn references_reach_bindings() {
    expect![[r#"
        main/clkReset.pgx:5 nCount
        main/interface/main.Bindings.JSON:2 nCount
        main/interface/main.Bindings.JSON:3 n\u0043ount
        main/start.pgx:10 nCount
    "#]]
    .assert_eq(&references_at("n|Count=tSlot"));
    expect![[r#"
        main/interface/main.Bindings.JSON:8 clkReset
        main/start.pgx:12 clkReset
    "#]]
    .assert_eq(&references_at("call clk|Reset"));
    expect![[r#"
        main/interface/main.Bindings.JSON:2 lblCount
        main/interface/main.Bindings.JSON:3 lblCount
        main/start.pgx:9 lblCount
    "#]]
    .assert_eq(&references_at("id='lbl|Count'"));
}

fn references_at(cursor: &str) -> String {
    let marked = MarkedListing::new(&cell(cursor));
    shown_all(marked.db(), references(marked.db(), marked.at(), false))
}
