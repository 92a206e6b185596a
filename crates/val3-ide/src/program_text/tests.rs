use expect_test::expect;
use val3_analysis::db::{Db, FileEdit};

use super::*;
use crate::owner::owner;
use crate::testing::MarkedListing;
use crate::write_program;

const LISTING: &str = "call pick(1,l_s,l_n)\n\npublic program pick(num x_n, string& x_s, num x_a[])\n  num l_i\n  point l_p[3]\n\
    begin\n  $0x_s=\"a\"\nend";

/// Files after the text was written as a program: created files, and changed files with their new text.
fn written(listing: &str, text: &str) -> Result<String, String> {
    let marked = MarkedListing::new(listing);
    let db = marked.db();
    let project = owner(db, marked.at().file).unwrap();
    let (change, _) = write_program(db, project, text)?;
    let created = change.creates.iter().map(|(path, text)| format!("{}\n{text}", path.file_name().unwrap()));
    let mut edited: Vec<File> = change.edits.iter().map(|edit| edit.file).collect();
    edited.dedup();
    let edited = edited.into_iter().map(|file| {
        let edits = change.edits.iter().filter(|edit| edit.file == file);
        format!("{}\n{}\n", file.path(db).file_name().unwrap(), FileEdit::apply_all(file.text(db), edits))
    });
    Ok(created.chain(edited).collect())
}

fn shown(db: &dyn Db, file: File) -> String {
    program_text(db, file).unwrap()
}

#[test]
fn a_program_is_shown_without_xml() {
    let marked = MarkedListing::new(LISTING);
    expect![[r#"
        public program pick(num x_n, string& x_s, num x_a[])
          num l_i
          point l_p[3]
        begin
          x_s="a"
        end
    "#]]
    .assert_eq(&shown(marked.db(), marked.at().file));
}

#[test]
fn the_shown_text_changes_nothing() {
    let marked = MarkedListing::new(LISTING);
    assert_eq!(written(LISTING, &shown(marked.db(), marked.at().file)).unwrap(), "");
}

#[test]
fn a_new_program_is_created_with_its_entry() {
    let text = "program place(point x_p, num& x_n[])\n  joint l_j\nbegin\n  // ]]>\n  if x_n[0]<1\n    x_n[0]=1\n  endIf\nend\n";
    let files = written(LISTING, text).unwrap();
    assert!(files.contains("<Parameter name=\"x_p\" type=\"point\" xsi:type=\"element\" />"), "{files}");
    assert!(files.contains("<Local name=\"l_j\" type=\"jointRx\" xsi:type=\"array\" size=\"1\" />"), "{files}");
    assert!(files.contains("x_n[0]&lt;1") && files.contains("<Program file=\"place.pgx\" />"), "{files}");
}

#[test]
fn only_the_changed_parts_of_a_program_are_edited() {
    let text = "program pick(num x_n)\n  num l_i\n  point l_p[3]\nbegin\n  l_i=x_n\nend";
    let files = written(LISTING, text).unwrap();
    assert!(files.contains("<Program name=\"pick\">") || files.contains("access=\"private\""), "{files}");
    assert!(files.contains("begin\n  l_i=x_n\nend") && !files.contains("x_s"), "{files}");
    let files = written(LISTING, "program pick()\nbegin\nend").unwrap();
    assert!(!files.contains("<Local") && !files.contains("<Param"), "{files}");
}

#[test]
fn wrong_texts_are_refused_with_the_right_form() {
    let refused = |text: &str| written(LISTING, text).unwrap_err();
    expect!["the line `begin` before the code is missing"].assert_eq(&refused("program a()"));
    expect!["the last line must be `end`"].assert_eq(&refused("program a()\nbegin\n"));
    expect![
        "`sub a()` is no head of a program: write [public] program pick(num x_nCount, string& x_sName, num x_nList[])"
    ]
    .assert_eq(&refused("sub a()\nbegin\nend"));
    expect!["`num` is no declaration: write num x_n, num& x_n, num x_n[], num x_n[,] or num x_n[\"\"]"]
        .assert_eq(&refused("program a(num)\nbegin\nend"));
    expect!["`num l_n[\"\"]` is no declaration: write num l_n or num l_n[3]"]
        .assert_eq(&refused("program a()\nnum l_n[\"\"]\nbegin\nend"));
    assert!(refused("program a(int x_n)\nbegin\nend").starts_with("there is no type `int` in this project"));
    assert!(refused("program Pick()\nbegin\nend").contains("letter case"));
    assert!(refused("program if()\nbegin\nend").contains("word of the language"));
}

#[test]
fn every_written_program_is_read_back() {
    for listing in [LISTING, &format!("version s6.4\n{LISTING}")] {
        let marked = MarkedListing::new(listing);
        let (db, file) = (marked.db(), marked.at().file);
        let text = shown(db, file);
        assert_eq!(written(listing, &text).unwrap(), "", "{text}");
    }
}
