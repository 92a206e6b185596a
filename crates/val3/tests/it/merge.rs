//! `val3 merge`: three files in, one out.

use expect_test::expect;

use crate::support::Folder;

const DATA: &str = "<Database>\n  <Datas>\n    <Data name=\"nA\" access=\"private\" xsi:type=\"array\" type=\"num\" size=\"1\">\n      \
    <Value key=\"0\" value=\"1\" />\n    </Data>\n  </Datas>\n</Database>\n";

/// A folder with three versions of a data file, in which `nA` has these values.
fn versions(base: &str, ours: &str, theirs: &str) -> Folder {
    let folder = Folder::empty();
    for (name, value) in [("base", base), ("ours", ours), ("theirs", theirs)] {
        folder.write(name, &DATA.replace("value=\"1\"", &format!("value=\"{value}\"")));
    }
    folder
}

#[test]
fn ours_becomes_the_result() {
    let folder = versions("1", "1", "7");
    folder.write("ours", &DATA.replace("nA", "nB").replace("private", "public"));
    let theirs = DATA.replace(
        "  </Datas>",
        "    <Data name=\"nC\" access=\"private\" xsi:type=\"array\" type=\"num\" size=\"1\" />\n  </Datas>",
    );
    folder.write("theirs", &theirs);
    let run = folder.val3(&["merge", "--path", "main/main.dtx", "base", "ours", "theirs"]);
    assert_eq!((run.code, run.stdout.as_str(), run.stderr.as_str()), (0, "", ""));
    let merged = folder.read("ours");
    assert!(merged.contains("nB") && merged.contains("nC") && !merged.contains("nA"), "{merged}");
}

#[test]
fn a_conflict_is_reported_and_stays_in_the_file() {
    let folder = versions("1", "5", "7");
    let run = folder.val3(&["merge", "--stdout", "base", "ours", "theirs"]);
    assert_eq!(run.code, 1);
    expect![[r#"
        ours: conflict in `nA[0]`: value is "5" in ours and "7" in theirs
        ours: 1 conflict; `val3 check` reports it until it is resolved
    "#]]
    .assert_eq(&run.stderr);
    expect![[r#"
        <Database>
          <Datas>
            <Data name="nA" access="private" xsi:type="array" type="num" size="1">
              <!-- <<<<<<< conflict in `nA[0]`: value is "5" in ours and "7" in theirs
        ||||||| base
        <Value key="0" value="1" />
        ======= theirs
        <Value key="0" value="7" />
        >>>>>>> ours follows this comment: choose a version, and remove the comment -->
              <Value key="0" value="5" />
            </Data>
          </Datas>
        </Database>
    "#]]
    .assert_eq(&run.stdout);
    assert!(folder.read("ours").contains("\"5\"") && !folder.read("ours").contains("\"7\""), "OURS is not changed");
}

#[test]
fn files_added_by_both_sides_have_no_base() {
    let folder = versions("1", "5", "5");
    folder.write("theirs", &folder.read("theirs").replace("<Datas>", "<Datas>\n    <Data name=\"nB\" type=\"num\" />"));
    let run = folder.val3(&["merge", "-p", "/dev/null", "ours", "theirs"]);
    assert_eq!((run.code, run.stdout.as_str()), (0, folder.read("theirs").as_str()));
}

#[test]
fn a_file_that_cannot_be_merged_says_so() {
    let folder = versions("1", "5", "7");
    folder.write("theirs", "<Database>");
    let run = folder.val3(&["merge", "--path", "a.dtx", "base", "ours", "theirs"]);
    assert_eq!(run.code, 1);
    assert!(
        run.stderr.contains(
            "a.dtx: merged by lines, so compare the result with both versions: THEIRS is not well-formed XML"
        ),
        "{}",
        run.stderr
    );
    let folder = versions("1", "5", "7");
    std::fs::write(folder.path().join("theirs"), b"\xff\xfea\0").unwrap();
    let run = folder.val3(&["merge", "base", "ours", "theirs"]);
    assert_eq!(
        (run.code, run.stderr.as_str()),
        (
            1,
            "ours: not merged, OURS is unchanged: THEIRS is no text of a controller: its text is UTF-16; save it as UTF-8\n"
        )
    );
    let run = folder.val3(&["merge", "base", "ours", "absent"]);
    assert_eq!(run.code, 129);
    assert!(run.stderr.starts_with("error: `absent`: there is no such file"), "{}", run.stderr);
    assert_eq!(folder.val3(&["merge", "base", "ours"]).code, 2);
    assert_eq!(folder.val3(&["merge"]).code, 2);
}

#[test]
fn both_sides_are_compared_with_the_base() {
    let folder = versions("1", "5", "7");
    for name in ["base", "ours", "theirs"] {
        std::fs::rename(folder.path().join(name), folder.path().join(format!("{name}.dtx"))).unwrap();
    }
    let run = folder.val3(&["diff", "--base", "base.dtx", "ours.dtx", "theirs.dtx"]);
    assert_eq!(run.code, 1, "{run:?}");
    let parts: Vec<&str> = run
        .stdout
        .lines()
        .filter(|line| line.starts_with("==") || line.contains('→') || line.contains("conflict in"))
        .collect();
    expect![[r#"
        == Changes of OURS
            ~ nA  1 → 5
        == Changes of THEIRS
            ~ nA  1 → 7
        == Conflicts of a merge
        ours.dtx: conflict in `nA[0]`: value is "5" in ours and "7" in theirs"#]]
    .assert_eq(&parts.join("\n"));
    let run = folder.val3(&["diff", "--base", "base.dtx", "base.dtx", "base.dtx"]);
    assert_eq!(run.code, 0);
    assert!(run.stdout.ends_with("== A merge has no conflict\n"), "{run:?}");
    for (arguments, message) in [
        (&["diff", "--base", "base.dtx", "ours.dtx"][..], "--base compares two versions, and 1 are given"),
        (&["diff", "--base", "base.dtx", "ours.dtx", "theirs.dtx", "--format", "json"], "--base prints only"),
    ] {
        let run = folder.val3(arguments);
        assert!(run.code == 2 && run.stderr.contains(message), "{run:?}");
    }
}
