//! `val3 test --new`: skeletons of tests.

use expect_test::expect;

use crate::support::Folder;

const CELL: &str = r#"
num nUnused
--- pal
type Slot "Disk://Slot/Slot.pjx"
public program total(num x_nParts, string x_sUnit, num& x_nSum, string& x_sText)
begin
  x_nSum=x_nParts*2
  x_sText=x_sUnit
end
program clear()
begin
end
program fill(Slot& x_tOne, Slot& x_tOther)
begin
  x_tOne.nPart=x_tOther.nPart
end
program poses(num& x_nIn[], joint& x_jOut, point& x_pOut, trsf& x_trOut, bool& x_bOk)
begin
end
--- Slot
public num nPart
"#;

fn cell() -> Folder {
    let folder = Folder::with(CELL);
    let run = folder.val3(&["test", "--init", "usrapp/pal"]);
    assert_eq!(run.code, 0, "{run:?}");
    folder
}

#[test]
fn a_test_has_an_assertion_for_each_output() {
    let folder = cell();
    let run = folder.val3(&["test", "--new", "testTotal", "--for", "total", "usrapp/pal"]);
    assert_eq!(run.code, 0, "{run:?}");
    expect![[r#"
        <?xml version="1.0" encoding="utf-8"?>
        <Programs xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance" xmlns="http://www.staubli.com/robotics/VAL3/Program/2">
          <Program name="testTotal" access="public">
            <Locals>
              <Local name="l_nParts" type="num" xsi:type="array" size="1" />
              <Local name="l_sUnit" type="string" xsi:type="array" size="1" />
              <Local name="l_nSum" type="num" xsi:type="array" size="1" />
              <Local name="l_sText" type="string" xsi:type="array" size="1" />
            </Locals>
            <Code><![CDATA[begin
          l_nParts=0
          l_sUnit=""
          call pal:total(l_nParts,l_sUnit,l_nSum,l_sText)
          // Fill in the expected values
          call assert:equalNum(l_nSum,0,0.001)
          call assert:equalString(l_sText,"")
        end]]></Code>
          </Program>
        </Programs>
    "#]]
    .assert_eq(&folder.read("usrapp/palTest/testTotal.pgx"));
    expect![[r#"
        <?xml version="1.0" encoding="utf-8"?>
        <Programs xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance" xmlns="http://www.staubli.com/robotics/VAL3/Program/2">
          <Program name="start" access="public">
            <Code><![CDATA[begin
          // On a real controller: the tests one after the other
          call testFirst()
          call testTotal()
        end
        ]]></Code>
          </Program>
        </Programs>
    "#]]
    .assert_eq(&folder.read("usrapp/palTest/start.pgx"));
    let checked = folder.val3(&["check", "usrapp/palTest"]);
    assert_eq!(checked.code, 0, "{checked:?}");
    // The skeleton fails until it is completed.
    let text = folder.read("usrapp/palTest/testTotal.pgx").replace("l_nParts=0", "l_nParts=3");
    folder.write("usrapp/palTest/testTotal.pgx", &text);
    let run = folder.val3(&["test", "usrapp/palTest/testTotal.pgx"]);
    assert!(run.code == 1 && run.stdout.contains("6 instead of 0"), "{run:?}");
}

#[test]
fn outputs_of_all_kinds_have_assertions() {
    let folder = cell();
    let run = folder.val3(&["test", "--new", "testPoses", "--for", "poses", "usrapp/pal"]);
    assert_eq!(run.code, 0, "{run:?}");
    let text = folder.read("usrapp/palTest/testPoses.pgx");
    expect![[r#"
        [begin
          call pal:poses(l_nIn,l_jOut,l_pOut,l_trOut,l_bOk)
          // Fill in the expected values
          call assert:equalNums(l_nIn,l_nInExpected,0.001)
          call assert:equalJoint(l_jOut,{0,0,0,0,0,0},0.01)
          call assert:equalPose(l_pOut,l_pOutExpected,0.01,0.01)
          call assert:equalTrsf(l_trOut,{0,0,0,0,0,0},0.01,0.01)
          call assert:equalBool(l_bOk,true)
        end]]></Code>
          </Program>
        </Programs>
    "#]]
    .assert_eq(text.split_once("CDATA").unwrap().1);
    let run = folder.val3(&["test", "usrapp/palTest/testPoses.pgx"]);
    assert_eq!(run.code, 1, "{run:?}");
}

#[test]
fn user_types_are_declared() {
    let folder = cell();
    let run = folder.val3(&["test", "--new", "testFill", "--for", "fill", "usrapp/pal"]);
    assert_eq!(run.code, 0, "{run:?}");
    let project = folder.read("usrapp/palTest/palTest.pjx");
    assert_eq!(project.matches("<Type name=\"Slot\" path=\"../Slot/Slot.pjx\" />").count(), 1, "{project}");
    let checked = folder.val3(&["check", "usrapp/palTest"]);
    assert_eq!(checked.code, 0, "{checked:?}");
    let run = folder.val3(&["test", "usrapp/palTest/testFill.pgx"]);
    assert!(run.code == 1 && run.stdout.contains("state what `l_tOne` has to be"), "{run:?}");
}

#[test]
fn a_test_without_outputs_fails_until_it_is_written() {
    let folder = cell();
    let run = folder.val3(&["test", "--new", "testClear", "--for", "pal:clear", "usrapp/palTest"]);
    assert_eq!(run.code, 0, "{run:?}");
    let run = folder.val3(&["test", "usrapp/palTest/testClear.pgx"]);
    assert!(run.code == 1 && run.stdout.contains("this test is not written yet"), "{run:?}");
}

#[test]
fn what_cannot_be_written_is_explained() {
    let folder = cell();
    for (args, message) in [
        (&["--new", "total", "usrapp/pal"][..], "it begins with `test`"),
        (&["--new", "testFirst", "usrapp/pal"], "it has a program `testFirst`"),
        (&["--new", "testA", "--for", "totl", "usrapp/pal"], "none of its libraries has a program `totl`"),
        (&["--new", "testA", "usrapp/main"], "it is no test application"),
        (&["--new", "testA", "usrapp/none"], "usrapp/none"),
        (&["--for", "total", "usrapp/pal"], "--new"),
    ] {
        let run = folder.val3(&[&["test"], args].concat());
        assert!(run.code == 2 && run.stderr.contains(message), "{args:?}: {run:?}");
    }
    folder.write("usrapp/palTest/testB.pgx", "kept");
    let run = folder.val3(&["test", "--new", "testB", "usrapp/pal"]);
    assert!(run.code == 2 && run.stderr.contains("the file exists"), "{run:?}");
    assert_eq!(folder.read("usrapp/palTest/testB.pgx"), "kept");
}
