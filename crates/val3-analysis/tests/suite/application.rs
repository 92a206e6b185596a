//! Combined effects of all programs in an application.

use expect_test::{Expect, expect};
use smol_str::SmolStr;
use val3_analysis::application::{Application, application, is_library_item, locks};
use val3_analysis::body::body;
use val3_analysis::items::fathers::{fathers, without_father};
use val3_analysis::items::project::data_files;

use crate::show::{program, project, workspace};

fn main_of(listing: &str) -> Application {
    let workspace = workspace(listing);
    application(&workspace.db, project(&workspace, "main")).clone()
}

const TASKS: &str = r#"
string sName
num nA
trsf trA
program start()
begin
  taskCreate "robot",10,cycle()
  taskCreateSync "io"+sName,0.02,bOver,watch1()
  for nA=0 to 3
    taskCreate "axis"+sName,10,axis()
  endFor
end
program cycle()
begin
  call shared()
end
program watch1()
begin
  call shared()
end
program axis()
begin
end
program shared()
begin
  trA.x=1
  trA.y=nA
end
bool bOver
"#;

#[test]
fn tasks_and_their_programs_are_listed() {
    let application = main_of(TASKS);
    assert!(application.sound && application.closed);
    let known = |name: &str| application.may_have_task(name);
    assert!(known("robot") && known("io1") && known("axis7") && !known("Robot") && !known("x"));
    let at_once = |program: &str| application.tasks_at_once([&SmolStr::from(program)]);
    assert_eq!((at_once("cycle"), at_once("shared"), at_once("axis")), (1, 2, 2));
    let beside = |one: &str, other: &str| application.run_side_by_side(&one.into(), &other.into());
    assert!(beside("cycle", "axis") && beside("cycle", "shared") && !beside("cycle", "cycle"));
    assert!(!beside("start", "cycle"));
}

#[test]
fn uses_of_all_programs_are_summarised() {
    let application = main_of(TASKS);
    let (number, position) = (application.uses_of("nA"), application.uses_of("trA"));
    assert!(number.read && number.written && !number.referenced);
    assert!(position.written_in_parts && !position.read && !position.read_whole);
    assert!(application.uses_of("bOver").referenced);
    assert!(!application.uses_of("nothing").may_read());
}

#[test]
fn an_application_with_faults_is_not_sound() {
    assert!(!main_of("num nA\nnA=nB").sound);
    assert!(main_of("$recClean(\"c\")").sound, "what an add-on has is no fault of the names");
    let pages = main_of("cls()\n=== main/interface/main.html\n<html/>");
    assert!(pages.sound && !pages.closed);
    let shown = |code: &str| main_of(&format!("version s8.12\nstring sPage\n{code}")).closed;
    assert!(!shown("userPage(\"first\")") && !shown("userPage(sPage)"), "the page may lie on the controller alone");
    assert!(shown("userPage()\nuserPage(true)"));
}

#[test]
fn names_in_strings_and_items_of_libraries_are_listed() {
    let listing = "library part \"Disk://part/part.pjx\"\nnum nA\nstring sA\ngetData(\"nB\"+sA,nA)\nnA=part:nW\n--- part\npublic num nW";
    let application = main_of(listing);
    assert!(
        application.is_named_in_text("nB2") && application.is_named_in_text("n") && !application.is_named_in_text("nA")
    );
    assert!(application.libraries.contains("part"));
    let workspace = workspace(listing);
    assert!(is_library_item(&workspace.db, "nW") && !is_library_item(&workspace.db, "nA"));
}

fn check_locks(code: &str, expected: Expect) {
    let workspace = workspace(&format!("bool bA\nbool bB\n{code}"));
    let db = &workspace.db;
    let file = program(db, project(&workspace, "main"), "start");
    let text = |range| &file.text(db)[range];
    let found = locks(body(db, file)).into_iter();
    let shown = found.map(|lock| format!("{}: {} / {}\n", lock.flag, text(lock.test), text(lock.set)));
    expected.assert_eq(&shown.collect::<String>());
}

#[test]
fn flags_tested_and_then_set_are_found() {
    check_locks(
        "wait(bA==false)\nbA=true\nif bB and !bA\nbA=true\nelseIf bB!=true\nbB=true\nendIf\nwhile bA\nendWhile\nbA=true",
        expect![[r#"
            bA: bA==false / bA=true
            bA: bB and !bA / bA=true
            bB: bB!=true / bB=true
            bA: bA / bA=true
        "#]],
    );
}

#[test]
fn other_tests_and_values_are_no_locks() {
    check_locks(
        "wait(bA)\nbA=true\nwait(!bA or bB)\nbA=true\nwait(!bA)\nbA=false\nwhile !bA\nendWhile\nbA=true\nif !bA\ncls()\nbA=true\nendIf",
        expect![[""]],
    );
}

#[test]
fn fathers_of_data_are_listed() {
    let data = "<Data name=\"fA\" xsi:type=\"array\" type=\"frame\" size=\"1\"/>\
                <Data name=\"pA\" xsi:type=\"array\" type=\"pointRx\" size=\"2\"><Value key=\"0\" fatherId=\"fB[1]\"/><Value key=\"1\"/></Data>";
    let project_file =
        "<Project xmlns=\"x\"><Parameters version=\"s7.11\"/><Database><Data file=\"main.dtx\"/></Database></Project>";
    let files = format!(
        "=== main/main.pjx\n{project_file}\n=== main/main.dtx\n<Database xmlns:xsi=\"y\"><Datas>{data}</Datas></Database>"
    );
    let workspace = workspace(&files);
    let (db, main) = (&workspace.db, project(&workspace, "main"));
    let named: Vec<&str> = fathers(db, main).iter().map(SmolStr::as_str).collect();
    assert_eq!(named, ["fB"]);
    let unlinked = without_father(db, data_files(db, main)[0]);
    let shown: Vec<String> = unlinked.iter().map(|(name, key, _)| format!("{name}[{key}]")).collect();
    assert_eq!(shown, ["fA[0]", "pA[1]"]);
    let beside: Vec<&str> = main.beside(db).iter().map(SmolStr::as_str).collect();
    assert_eq!(beside, ["main.dtx", "main.pjx"]);
}
