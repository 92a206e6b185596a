use camino::Utf8PathBuf;
use expect_test::{Expect, expect};
use val3_analysis::db::FileEdit;
use val3_analysis::load::load;
use val3_analysis::system::Memory;
use val3_test::Fixture;

use crate::settings::{RuleSelection, WorkspaceSettings};
use crate::testing::{check_files, check_selected};
use crate::{check_unit, finish, units};

/// Checks the findings in a listing: code and message.
#[track_caller]
fn check(listing: &str, expected: Expect) {
    let files = Fixture::parse(listing).with_stops().files.into_iter().map(|(path, text)| (path, text.into_bytes()));
    let found = check_files(&files.collect::<Vec<_>>());
    let shown = found.iter().map(|found| format!("{} {}\n", found.code, found.message));
    expected.assert_eq(&shown.collect::<String>());
}

#[test]
fn only_the_next_line_is_silenced() {
    check(
        "num nA\n//val3: allow(V0101) made later\n// a word on it\n\nnB=1\nnC=2\n",
        expect![[r#"
        V0101 `nC` is not declared: no local variable, parameter or data has this name
    "#]],
    );
}

#[test]
fn only_the_named_findings_are_silenced() {
    check(
        "num nA\n//val3: allow(unknown-name, V0203)\nIF nB==1\nendIf\n",
        expect![[r#"
        V0702 `V0203` is not found in the line below
        V0701 the keyword `IF` is usually written `if`
    "#]],
    );
}

#[test]
fn the_whole_program_is_silenced() {
    check(
        "num nA\n//val3: allow-program(V0101)\nnB=1\nnC=2\nnA=\"\"\n",
        expect![[r#"
        V0202 a `string` cannot be assigned to a `num`
    "#]],
    );
}

#[test]
fn a_comment_may_silence_nothing_in_part_or_whole() {
    check(
        "num nA\n//val3: allow-program(V0701)\n//val3: allow(V0101, V0203)\nnB=1\n",
        expect![[r#"
        V0702 `V0701` is not found in this program
        V0702 `V0203` is not found in the line below
    "#]],
    );
}

#[test]
fn findings_of_the_project_in_a_program_are_silenced() {
    let part = "--- part\npublic program init()\nbegin\nputln(\"part\")\nend\n";
    let main = "library part \"Disk://part/part.pjx\"\nnum nCode\n//val3: allow(lib-load-path)\nnCode=part:libLoad(\"Disk://patr\")\nput(nCode)\n";
    check(&format!("{main}call part:init()\n{part}"), expect![[r#""#]]);
}

#[test]
fn the_syntax_is_never_silenced() {
    check(
        "num nA\n//val3: allow(V0010)\nnA=1+\n",
        expect![[r#"
        V0703 `V0010` cannot be silenced by a comment
        V0010 a value is expected here, but the line ends
    "#]],
    );
}

#[test]
fn comments_without_effect_are_reported() {
    check(
        "public num nA\n//val3: ignore(V0101)\nnA=1\n//val3: allow-program(V0101)\nnA=2\n",
        expect![[r#"
            V0703 a comment with `val3:` needs `allow(…)`, `allow-program(…)` or `no-coverage`
            V0703 `allow-program` is after the first line of code
        "#]],
    );
}

#[test]
fn a_comment_for_a_disabled_rule_is_not_reported() {
    let listing = "public num nA\n//val3: allow(V0101)\nnA=1\n";
    let files: Vec<_> =
        Fixture::parse(listing).with_stops().files.into_iter().map(|(path, text)| (path, text.into_bytes())).collect();
    let never = RuleSelection { never: ["V0101"].into(), ..RuleSelection::default() };
    assert_eq!(check_selected(&files, &never), []);
    let only = RuleSelection { only: Some(["V0702"].into()), ..RuleSelection::default() };
    assert_eq!(check_selected(&files, &only), []);
}

#[test]
fn findings_in_other_files_are_not_silenced() {
    check(
        "num nA\n//val3: allow-program(V0104)\nnA=1\n=== main/main.dtx\n<Database><Datas><Data/></Datas></Database>\n",
        expect![[r#"
        V0505 the element `Data` needs the attribute `name`
        V0505 the element `Data` needs the attribute `type`
        V0702 `V0104` is not found in this program
    "#]],
    );
}

/// Checks the code of the program `start` with each single fix, comment lines only.
#[track_caller]
fn fixed(listing: &str, expected: Expect) {
    let files = Fixture::parse(listing).with_stops().files.into_iter();
    let system = Memory::new(files.map(|(path, text)| (Utf8PathBuf::from("/").join(path), text)));
    let workspace = load(&system, &["/".into()]).unwrap();
    let (db, settings) = (&workspace.db, WorkspaceSettings::default());
    let units = units(db, &workspace.projects);
    let checked = units.iter().map(|unit| check_unit(db, *unit, &settings)).sum();
    let findings = finish(db, &units, &settings, checked).findings;
    let edits = findings.iter().filter_map(|finding| finding.fix.as_ref()).flat_map(|fix| &fix.edits);
    let fixed = edits.map(|edit| {
        let text = FileEdit::apply_all(edit.file.text(db), [edit]);
        let lines = text.lines().filter(|line| line.contains("//") && !line.contains('<'));
        lines.map(|line| format!("{}\n", line.trim())).chain(["-\n".to_owned()]).collect::<String>()
    });
    expected.assert_eq(&fixed.collect::<String>());
}

#[test]
fn unused_comments_are_removed_by_a_fix() {
    fixed(
        "num nA\n//a\n//val3: allow(V0101) why\nnA=1\n",
        expect![[r#"
        //a
        -
    "#]],
    );
    fixed(
        "num nA\n//val3: allow(V0203, V0101)\nnB=1\n",
        expect![[r#"
        //val3: allow(V0101)
        -
    "#]],
    );
    fixed(
        "num nA\n//val3: allow(V0101, V0203, V0202) why\nnB=1\n",
        expect![[r#"
        //val3: allow(V0101, V0202) why
        -
        //val3: allow(V0101, V0203) why
        -
    "#]],
    );
}
