//! Files of a small cell that are renamed, come and go.

use expect_test::{Expect, expect};
use val3_test::ROOT;

use super::*;
use crate::assists::shown;
use crate::testing::Marked;

const CELL: &str = "library part \"Disk://part/part.pjx\"\nlibrary near \"./tray/tray.pjx\"\ntype Slot \"Disk://types/Slot\"\nSlot sA\ncall pick()\nputln(part:libLoad(\"Disk://part\"))\ncall part:weigh()\nprogram pick()\nbegin\n  call pick()\nend\n--- part\npublic program weigh()\nbegin\nend\n--- main/tray\nlibrary part \"../../part/part.pjx\"\npublic num nA\n--- types/Slot\npublic num nHeight\n";

fn path(name: &str) -> Utf8PathBuf {
    Utf8PathBuf::from(format!("{ROOT}/usrapp/{name}"))
}

#[track_caller]
fn renamed(from: &str, to: &str, expected: Expect) {
    let marked = Marked::new(CELL);
    let change = will_rename_files(marked.db(), &[(path(from), path(to))]);
    expected.assert_eq(&shown(marked.db(), &change));
}

#[test]
fn a_program() {
    renamed(
        "main/pick.pgx",
        "main/grip.pgx",
        expect![[r#"
        usrapp/main/main.pjx
        -    <Program file="pick.pgx" />
        +    <Program file="grip.pgx" />
        usrapp/main/pick.pgx
        -  <Program name="pick">
        -    <Code><![CDATA[begin
        -  call pick()
        +  <Program name="grip">
        +    <Code><![CDATA[begin
        +  call grip()
        usrapp/main/start.pgx
        -call pick()
        +call grip()
    "#]],
    );
    renamed(
        "main/pick.pgx",
        "main/not a name.pgx",
        expect![[r#"
        usrapp/main/main.pjx
        -    <Program file="pick.pgx" />
        +    <Program file="not a name.pgx" />
    "#]],
    );
    renamed(
        "part/weigh.pgx",
        "part/sub/weigh.pgx",
        expect![[r#"
        usrapp/part/part.pjx
        -    <Program file="weigh.pgx" />
        +    <Program file="sub/weigh.pgx" />
    "#]],
    );
    renamed(
        "part/weigh.pgx",
        "main/weigh.pgx",
        expect![[r#"
        usrapp/main/main.pjx
        +    <Program file="weigh.pgx" />
        usrapp/part/part.pjx
        -    <Program file="weigh.pgx" />
    "#]],
    );
}

#[test]
fn data_and_projects() {
    renamed(
        "part/part.dtx",
        "part/data.dtx",
        expect![[r#"
        usrapp/part/part.pjx
        -    <Data file="part.dtx" />
        +    <Data file="data.dtx" />
    "#]],
    );
    renamed(
        "part/part.pjx",
        "part/unit.pjx",
        expect![[r#"
        usrapp/main/main.pjx
        -    <Library alias="part" path="Disk://part/part.pjx" />
        +    <Library alias="part" path="Disk://part/unit.pjx" />
        usrapp/main/start.pgx
        -putln(part:libLoad("Disk://part"))
        +putln(part:libLoad("Disk://part/unit.pjx"))
        usrapp/main/tray/tray.pjx
        -    <Library alias="part" path="../../part/part.pjx" />
        +    <Library alias="part" path="../../part/unit.pjx" />
    "#]],
    );
}

#[test]
fn folders() {
    renamed(
        "part",
        "unit",
        expect![[r#"
        usrapp/main/main.pjx
        -    <Library alias="part" path="Disk://part/part.pjx" />
        +    <Library alias="part" path="Disk://unit/part.pjx" />
        usrapp/main/start.pgx
        -putln(part:libLoad("Disk://part"))
        +putln(part:libLoad("Disk://unit/part.pjx"))
        usrapp/main/tray/tray.pjx
        -    <Library alias="part" path="../../part/part.pjx" />
        +    <Library alias="part" path="../../unit/part.pjx" />
    "#]],
    );
    renamed(
        "main",
        "deep/app",
        expect![[r#"
        usrapp/main/tray/tray.pjx
        -    <Library alias="part" path="../../part/part.pjx" />
        +    <Library alias="part" path="../../../part/part.pjx" />
    "#]],
    );
    renamed(
        "types",
        "kinds",
        expect![[r#"
        usrapp/main/main.pjx
        -    <Type name="Slot" path="Disk://types/Slot" />
        +    <Type name="Slot" path="Disk://kinds/Slot" />
    "#]],
    );
}

#[test]
fn files_that_come_and_go() {
    let marked = Marked::new(CELL);
    let db = marked.db();
    let new = ["main/b.pgx", "main/a.pgx", "main/more.dtx", "main/notes.txt", "part/x.pgx"].map(path);
    expect![[r#"
        usrapp/main/main.pjx
        -  </Programs>
        -  <Database>
        -    <Data file="main.dtx" />
        +    <Program file="b.pgx" />
        +    <Program file="a.pgx" />
        +  </Programs>
        +  <Database>
        +    <Data file="main.dtx" />
        +    <Data file="more.dtx" />
        usrapp/part/part.pjx
        +    <Program file="x.pgx" />
    "#]]
    .assert_eq(&shown(db, &will_create_files(db, &new)));
    let gone = ["main/pick.pgx", "main/main.dtx", "main/none.pgx"].map(path);
    expect![[r#"
        usrapp/main/main.pjx
        -    <Program file="pick.pgx" />
        -    <Program file="start.pgx" />
        -  </Programs>
        -  <Database>
        -    <Data file="main.dtx" />
        +    <Program file="start.pgx" />
        +  </Programs>
        +  <Database>
    "#]]
    .assert_eq(&shown(db, &will_delete_files(db, &gone)));
    assert!(will_create_files(db, &[path("main/pick.pgx")]).is_empty());
}
