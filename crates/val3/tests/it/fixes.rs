//! `--fix`, `--unsafe-fixes` and `--diff`.

use std::fs;

use crate::support::{CLEAN, CommandOutput, FAULTY, Folder, UNUSUAL};

const PROGRAM: &str = "usrapp/main/start.pgx";
/// Two keywords in an unusual spelling, and a misspelled name.
const MIXED: &str = "num nCount\nIF nCount==1\nnCuont=2\nendif\n";

#[test]
fn safe_fixes_are_written_and_other_findings_reported() {
    let folder = Folder::with(MIXED);
    let before = folder.read(PROGRAM);
    let run = folder.val3(&["check", "--fix"]);
    assert_eq!(run.code, 1, "{run:?}");
    assert!(run.stdout.contains("error[V0101]") && !run.stdout.contains("V0701"), "{run:?}");
    assert!(run.stderr.contains("2 of 3 findings fixed"), "{run:?}");
    assert_eq!(folder.read(PROGRAM), before.replace("IF", "if").replace("endif", "endIf"));
}

#[test]
fn unsafe_fixes_are_applied_on_request() {
    let folder = Folder::with(MIXED);
    let run = folder.val3(&["check", "--fix", "--unsafe-fixes"]);
    assert_eq!((run.code, run.stdout.as_str()), (0, ""), "{run:?}");
    assert!(run.stderr.contains("3 of 3 findings fixed"), "{run:?}");
    assert!(folder.read(PROGRAM).contains("nCount=2"));
}

#[test]
fn only_selected_findings_are_fixed() {
    let folder = Folder::with(MIXED);
    let before = folder.read(PROGRAM);
    folder.val3(&["check", "--fix", "--unsafe-fixes", "--ignore", "V0701"]);
    assert_eq!(folder.read(PROGRAM), before.replace("nCuont", "nCount"));
}

#[test]
fn known_and_silenced_findings_are_not_fixed() {
    let folder = Folder::with(MIXED);
    folder.val3(&["check", "--write-baseline", "--baseline", "known.json"]);
    let before = folder.read(PROGRAM);
    let run = folder.val3(&["check", "--fix", "--unsafe-fixes", "--baseline", "known.json"]);
    assert!(run.stderr.contains("0 of 0 findings fixed"), "{run:?}");
    let run = folder.val3(&["check", "--fix", "--unsafe-fixes", "--ignore", "all"]);
    assert_eq!((run.code, folder.read(PROGRAM)), (0, before), "{run:?}");
}

#[test]
fn files_without_fixes_are_not_written() {
    let folder = Folder::with(FAULTY);
    let written = || fs::metadata(folder.path().join(PROGRAM)).unwrap().modified().unwrap();
    let before = written();
    let run = folder.val3(&["check", "--fix"]);
    assert!(run.stderr.contains("0 of 1 finding fixed"), "{run:?}");
    assert_eq!(written(), before);
}

#[test]
fn fixing_twice_is_fixing_once() {
    let folder = Folder::with(MIXED);
    folder.val3(&["check", "--fix", "--unsafe-fixes"]);
    let once = folder.read(PROGRAM);
    let run = folder.val3(&["check", "--fix", "--unsafe-fixes"]);
    assert!(run.stderr.contains("0 of 0 findings fixed"), "{run:?}");
    assert_eq!(folder.read(PROGRAM), once);
}

#[test]
fn a_diff_shows_and_writes_nothing() {
    let folder = Folder::with(UNUSUAL);
    let before = folder.read(PROGRAM);
    let run = folder.val3(&["check", "--diff"]);
    assert_eq!((run.code, run.stderr.as_str()), (1, ""), "{run:?}");
    assert!(run.stdout.starts_with("--- a/usrapp/main/start.pgx\n+++ b/usrapp/main/start.pgx\n@@ "), "{run:?}");
    assert!(run.stdout.contains("\n-IF nCount==1\n+if nCount==1\n"), "{run:?}");
    assert_eq!(folder.read(PROGRAM), before);
    assert_eq!(folder.val3(&["check", "--diff", "--exit-zero"]).code, 0);
}

#[test]
fn nothing_to_change_is_an_empty_diff() {
    for listing in [CLEAN, FAULTY] {
        let run = Folder::with(listing).val3(&["check", "--diff"]);
        assert_eq!((run.code, run.stdout.as_str()), (0, ""), "{run:?}");
    }
    let run = Folder::with(FAULTY).val3(&["check", "--diff", "--unsafe-fixes"]);
    assert_eq!(run.code, 1, "{run:?}");
}

/// A project with an additional, unlisted program in its folder. Only this program uses some data and a library.
fn with_stray_program(code: &str) -> Folder {
    let folder = Folder::with(
        "library part \"Disk://part/part.pjx\"\nnum nUsed\nnum nLeft\nprogram start()\nbegin\nend\n--- part\npublic num nA\n",
    );
    let code = format!("begin\n  {code}\nend]]>");
    let text = folder.read(PROGRAM).replace("name=\"start\"", "name=\"stray\"").replace("begin\nend]]>", &code);
    folder.write("usrapp/main/stray.pgx", &text);
    folder
}

const USES: &str = "nUsed=part:nA";

/// Findings in the JSON of a check, without the offered fixes.
fn findings(run: &CommandOutput) -> serde_json::Value {
    let mut json: serde_json::Value = serde_json::from_str(&run.stdout).unwrap();
    json["diagnostics"].take()
}

#[test]
fn the_report_after_fixes_equals_the_next_check() {
    let folders = [USES, "nUsed=nOther"].map(with_stray_program);
    for folder in folders.into_iter().chain([MIXED, FAULTY, UNUSUAL].map(Folder::with)) {
        let fixed = folder.val3(&["check", "--fix", "--unsafe-fixes", "--format", "json"]);
        assert_eq!(findings(&fixed), findings(&folder.val3(&["check", "--format", "json"])));
    }
}

#[test]
fn items_used_by_an_unlisted_program_are_kept() {
    let folder = with_stray_program(USES);
    let run = folder.val3(&["check", "--fix", "--unsafe-fixes"]);
    assert_eq!(run.code, 0, "{run:?}");
    let (project, data) = (folder.read("usrapp/main/main.pjx"), folder.read("usrapp/main/main.dtx"));
    assert!(project.contains("stray.pgx") && project.contains("alias=\"part\""), "{project}");
    assert!(data.contains("nUsed") && !data.contains("nLeft"), "{data}");
}

#[test]
fn no_fix_adds_an_error() {
    // Listing the program would add its fault to the application.
    let folder = with_stray_program("nUsed=nOther");
    for select in [&[][..], &["--select", "unlisted-file"]] {
        let run = folder.val3(&[&["check", "--fix", "--unsafe-fixes"], select].concat());
        assert_eq!(run.code, 0, "{run:?}");
        assert!(run.stderr.contains("1 fix omitted because it would add an error"), "{run:?}");
        assert!(!folder.read("usrapp/main/main.pjx").contains("stray.pgx"));
    }
}

#[test]
fn line_ends_are_kept() {
    let folder = with_stray_program(USES);
    for file in ["usrapp/main/main.pjx", "usrapp/main/main.dtx"] {
        folder.write(file, &folder.read(file).replace('\n', "\r\n"));
    }
    crate::support::run(folder.exact_command(&["check", "--fix", "--unsafe-fixes"]));
    let project = folder.read("usrapp/main/main.pjx");
    assert!(
        project.contains("    <Program file=\"start.pgx\" />\r\n    <Program file=\"stray.pgx\" />\r\n"),
        "{project}"
    );
    for file in ["usrapp/main/main.pjx", "usrapp/main/main.dtx"] {
        let text = folder.read(file);
        assert_eq!(text.matches('\n').count(), text.matches("\r\n").count(), "{text}");
    }
}

#[test]
fn an_empty_list_is_removed() {
    let folder = Folder::with(
        "num nA\nnum nB\nlibrary part \"Disk://part/part.pjx\"\nprogram start()\n  num l_nA\n  num l_nB\n  num l_nC\nbegin\nend\n\
         --- part\npublic num nA\n",
    );
    folder.val3(&["check", "--fix", "--unsafe-fixes"]);
    let program = folder.read(PROGRAM);
    assert!(program.contains("<Program name=\"start\">\n    <Code>"), "{program}");
    assert!(folder.read("usrapp/main/main.dtx").contains("<Datas />"));
    assert!(folder.read("usrapp/main/main.pjx").contains("<Libraries />"));
}

/// A program of s5: ISO-8859-1, escaped, with Windows line ends.
const OLD: &[u8] = b"<?xml version=\"1.0\" encoding=\"ISO-8859-1\"?>\r\n\
    <programList xmlns=\"ProgramNameSpace\">\r\n\
    <program name=\"start\" public=\"false\" >\r\n\
    <description>gr\xf6\xdfe</description>\r\n\
    <paramSection/>\r\n<localSection/>\r\n\
    <source>\r\n<code>begin\r\n  // pr\xeat\r\n  IF 1&lt;2 // d\xe9j&amp;\r\n  endIf\r\nend</code>\r\n</source>\r\n\
    </program>\r\n</programList>\r\n";

#[test]
fn bytes_of_latin1_files_are_kept() {
    let folder = Folder::with(CLEAN);
    let path = folder.path().join(PROGRAM);
    fs::write(&path, OLD).unwrap();
    let run = folder.val3(&["check", "--fix", "--select", "V0701,V0024"]);
    assert!(run.stderr.contains("2 of 2 findings fixed"), "{run:?}");
    let latin1 = |bytes: &[u8]| bytes.iter().map(|byte| char::from(*byte)).collect::<String>();
    let expected = latin1(OLD).replace("  IF 1&lt;2 // d\u{e9}j&amp;", "  // d\u{e9}j&amp;\r\n  if 1&lt;2");
    assert_eq!(latin1(&fs::read(&path).unwrap()), expected);
}

#[cfg(unix)]
#[test]
fn a_file_that_must_not_be_written_is_an_error() {
    use std::os::unix::fs::PermissionsExt;
    let folder = Folder::with(UNUSUAL);
    fs::set_permissions(folder.path().join(PROGRAM), fs::Permissions::from_mode(0o444)).unwrap();
    let run = folder.val3(&["check", "--fix"]);
    assert_eq!(run.code, 2, "{run:?}");
    assert!(run.stderr.contains("cannot write `usrapp/main/start.pgx`: it is read-only"), "{run:?}");
}

#[test]
fn contradicting_options_are_refused() {
    let folder = Folder::with(UNUSUAL);
    for options in
        [&["--fix", "--diff"][..], &["--fix", "--write-baseline"], &["--unsafe-fixes"], &["--diff", "--statistics"]]
    {
        let run = folder.val3(&[&["check"], options].concat());
        assert_eq!(run.code, 2, "{options:?} {run:?}");
    }
}

#[test]
fn the_summary_counts_fixable_findings() {
    let run = Folder::with(MIXED).val3(&["check"]);
    assert!(run.stderr.contains("2 can be fixed by --fix, 1 more may be fixed by --unsafe-fixes"), "{run:?}");
}
