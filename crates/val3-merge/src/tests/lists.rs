//! Project files and configuration files.

use expect_test::{Expect, expect};

use super::merged;
use crate::{MergedKind, merge};

const PROJECT: &str = "\u{feff}<?xml version=\"1.0\" encoding=\"utf-8\"?>\r\n<Project>\r\n  <Parameters version=\"s7.8.3\" stackSize=\"5000\" />\r\n  \
    <Programs>\r\n    <Program file=\"start.pgx\" />\r\n    <Program file=\"stop.pgx\" />\r\n  </Programs>\r\n  <Libraries />\r\n</Project>";

#[track_caller]
fn check(kind: MergedKind, base: &str, ours: &str, theirs: &str, expected: &Expect) {
    expected.assert_eq(&merged(kind, base, ours, theirs));
}

#[test]
fn both_add_a_program_and_theirs_a_library() {
    let stop = "    <Program file=\"stop.pgx\" />\r\n";
    let ours = PROJECT.replace(stop, &format!("{stop}    <Program file=\"turn.pgx\" />\r\n"));
    let theirs = PROJECT
        .replace(stop, &format!("{stop}    <Program file=\"wait.pgx\" />\r\n"))
        .replace("<Libraries />", "<Libraries>\r\n    <Library alias=\"io\" path=\"Disk://io\" />\r\n    <Library alias=\"x\" path=\"Disk://x\" />\r\n  </Libraries>")
        .replace("\r\n", "\n");
    let found = merge(MergedKind::Project, PROJECT, &ours, &theirs);
    assert!(found.text.starts_with('\u{feff}') && !found.text.replace("\r\n", "").contains('\n'));
    check(
        MergedKind::Project,
        PROJECT,
        &ours,
        &theirs,
        &expect![[r#"
        <?xml version="1.0" encoding="utf-8"?>
        <Project>
          <Parameters version="s7.8.3" stackSize="5000" />
          <Programs>
            <Program file="start.pgx" />
            <Program file="stop.pgx" />
            <Program file="turn.pgx" />
            <Program file="wait.pgx" />
          </Programs>
          <Libraries>
            <Library alias="io" path="Disk://io" />
            <Library alias="x" path="Disk://x" />
          </Libraries>
        </Project>"#]],
    );
}

#[test]
fn removed_programs_go_and_parameters_may_contradict() {
    let ours = PROJECT.replace("    <Program file=\"stop.pgx\" />\r\n", "").replace("s7.8.3", "s7.9");
    let theirs = PROJECT
        .replace("    <Program file=\"start.pgx\" />\r\n", "")
        .replace("s7.8.3", "s7.10")
        .replace("5000", "6000");
    check(
        MergedKind::Project,
        PROJECT,
        &ours,
        &theirs,
        &expect![[r#"
        <?xml version="1.0" encoding="utf-8"?>
        <Project>
          <!-- <<<<<<< conflict in `Parameters`: version is "s7.9" in ours and "s7.10" in theirs
        ||||||| base
        <Parameters version="s7.8.3" stackSize="5000" />
        ======= theirs
        <Parameters version="s7.10" stackSize="6000" />
        >>>>>>> ours follows this comment: choose a version, and remove the comment -->
          <Parameters version="s7.9" stackSize="6000" />
          <Programs>
          </Programs>
          <Libraries />
        </Project>
        ! conflict in `Parameters`: version is "s7.9" in ours and "s7.10" in theirs
    "#]],
    );
}

const SETTINGS: &str = r#"<cell>
  <String name="ip" value="1" />
  <Float name="v">1.0</Float>
  <sock><port value="1" /></sock>
  <sock><port value="2" /></sock>
</cell>"#;

#[test]
fn settings_are_merged_by_key() {
    let ours = SETTINGS.replace("name=\"ip\" value=\"1\"", "name=\"ip\" value=\"2\"");
    let theirs = SETTINGS.replace("1.0<", "2.0<").replace(
        "<sock><port value=\"2\" /></sock>",
        "<sock><port value=\"2\" /></sock>\n  <sock><port value=\"3\" /></sock>",
    );
    check(
        MergedKind::Settings,
        SETTINGS,
        &ours,
        &theirs,
        &expect![[r#"
        <cell>
          <String name="ip" value="2" />
          <Float name="v">2.0</Float>
          <sock><port value="1" /></sock>
          <sock><port value="2" /></sock>
          <sock><port value="3" /></sock>
        </cell>"#]],
    );
    check(
        MergedKind::Settings,
        SETTINGS,
        &theirs,
        &SETTINGS.replace("1.0<", "3.0<").replace("\"2\"", "\"9\""),
        &expect![[r#"
        <cell>
          <String name="ip" value="1" />
          <!-- <<<<<<< conflict in `cell Float[v]`: ours and theirs have another text
        ||||||| base
        <Float name="v">1.0</Float>
        ======= theirs
        <Float name="v">3.0</Float>
        >>>>>>> ours follows this comment: choose a version, and remove the comment -->
          <Float name="v">2.0</Float>
          <!-- <<<<<<< conflict in `cell sock`: ours and theirs differ in several elements of this name
        ||||||| base
        <sock><port value="1" /></sock>
        <sock><port value="2" /></sock>
        ======= theirs
        <sock><port value="1" /></sock>
        <sock><port value="9" /></sock>
        >>>>>>> ours follows this comment: choose a version, and remove the comment -->
          <sock><port value="1" /></sock>
          <sock><port value="2" /></sock>
          <sock><port value="3" /></sock>
        </cell>
        ! conflict in `cell Float[v]`: ours and theirs have another text

        ! conflict in `cell sock`: ours and theirs differ in several elements of this name
    "#]],
    );
}
