//! `--add-suppressions`, `--extend-select` and `--quiet`.

use crate::support::{CLEAN, FAULTY, Folder};

const PROGRAM: &str = "usrapp/main/start.pgx";

#[test]
fn comments_for_all_findings_are_written() {
    let folder = Folder::with("num nLeft\n\nprogram start(num x_nA)\n  num l_nB\nbegin\n  nFirst=1\n  nOther=2\nend\n");
    let run = folder.val3(&["check", "--add-suppressions"]);
    let program = folder.read(PROGRAM);
    assert!(
        program.contains("\n  //val3: allow(V0101)\n  nFirst=1\n  //val3: allow(V0101)\n  nOther=2\n"),
        "{program}"
    );
    assert!(!run.stdout.contains("V0101") && run.stderr.contains("silenced by new comments"), "{run:?}");
    let again = folder.val3(&["check", "--add-suppressions"]);
    assert!(again.stderr.contains("0 findings silenced by new comments"), "{again:?}");
    assert_eq!((folder.read(PROGRAM), again.stdout), (program, run.stdout));
}

#[test]
fn only_selected_findings_are_silenced() {
    let folder = Folder::with(FAULTY);
    let before = folder.read(PROGRAM);
    folder.val3(&["check", "--add-suppressions", "--ignore", "V0101"]);
    assert_eq!(folder.read(PROGRAM), before);
    assert_eq!(folder.val3(&["check", "--add-suppressions", "--select", "V0101"]).code, 0);
    for other in ["--fix", "--diff", "--watch", "--write-baseline"] {
        assert_eq!(folder.val3(&["check", "--add-suppressions", other]).code, 2, "{other}");
    }
}

#[test]
fn findings_that_no_comment_can_silence_are_reported() {
    let folder = Folder::with("num nCount\n\nif nCount=1\nendIf\n");
    let before = folder.read(PROGRAM);
    let run = folder.val3(&["check", "--add-suppressions"]);
    assert!(run.code == 1 && run.stdout.contains("V0023"), "{run:?}");
    assert_eq!(folder.read(PROGRAM), before);
}

#[test]
fn findings_that_are_off_can_be_added() {
    let folder = Folder::with(concat!("num nCount\n// TO", "DO\nnCount=nCount+1\n"));
    let found = |options: &[&str]| folder.val3(&[&["check"], options].concat()).stdout;
    assert_eq!(found(&[]), "");
    for word in ["unfinished-mark", "V0714", "V071"] {
        assert!(found(&["--extend-select", word]).contains("V0714"), "{word}");
    }
    assert!(found(&["--select", "V0101", "--extend-select", "V0714"]).contains("V0714"));
    assert_eq!(found(&["--extend-select", "V0714", "--ignore", "V0714"]), "");
    assert_eq!(folder.val3(&["check", "--extend-select", "sql"]).code, 2);
}

#[test]
fn quiet_prints_only_findings() {
    let run = Folder::with(FAULTY).val3(&["check", "--quiet"]);
    assert!(run.code == 1 && run.stdout.contains("V0101") && run.stderr.is_empty(), "{run:?}");
    let run = Folder::with(CLEAN).val3(&["check", "-q"]);
    assert_eq!((run.code, run.stdout.as_str(), run.stderr.as_str()), (0, "", ""), "{run:?}");
    let run = Folder::with("num nCount\nIF nCount==1\nendIf\n").val3(&["check", "--quiet", "--fix"]);
    assert_eq!((run.code, run.stderr.as_str()), (0, ""), "{run:?}");
}

/// An s5 program, whose code is escaped text.
const ESCAPED: &str = r#"<?xml version="1.0" encoding="iso-8859-1"?>
<programList xmlns="ProgramNameSpace">
  <program name="start" public="true">
    <description></description>
    <paramSection />
    <localSection><local name="l_nUnused" type="num" size="1" /></localSection>
    <source><code>begin
  if nCount&lt;3 and nCount!=1
    nCount=nCount/0
  endIf
end
    </code></source>
  </program>
</programList>
"#;

#[test]
fn comments_in_escaped_code_are_written() {
    let folder = Folder::with("version s5.2\nnum nCount\n\nprogram start()\nbegin\nend\n");
    folder.write(PROGRAM, ESCAPED);
    assert_eq!(folder.val3(&["check"]).code, 1);
    let run = folder.val3(&["check", "--add-suppressions"]);
    assert_eq!(run.code, 0, "{run:?}");
    let expected = ESCAPED
        .replace("begin\n", "begin\n  //val3: allow-program(V0115)\n")
        .replace("    nCount=nCount/0", "    //val3: allow(V0230)\n    nCount=nCount/0");
    assert_eq!(folder.read(PROGRAM), expected);
    assert_eq!(folder.val3(&["check", PROGRAM, "--fail-level", "info"]).code, 0);
}
