//! `val3 test`: tests that are executed once for each table row.

use expect_test::expect;
use serde_json::Value;

use crate::support::Folder;
use crate::test_command::cell;

/// A test application with `testSum` and its table: numbers and their squares; the last square is wrong.
pub(crate) fn squares(parameter: &str, code: &str) -> Folder {
    let folder = cell(&[]);
    let project = folder.read("usrapp/mainTest/mainTest.pjx");
    let with_test = project.replace("  </Programs>", "    <Program file=\"testSum.pgx\" />\n  </Programs>");
    folder.write("usrapp/mainTest/mainTest.pjx", &with_test);
    let numbers = data("nIn", "num", &["0", "2", "-3"]);
    let sums = data("nOut", "num", &["0", "4", "8"]);
    let names = data("sName", "string", &["one", "two"]);
    let database = folder.read("usrapp/mainTest/mainTest.dtx");
    let filled = format!("<Datas>{numbers}{sums}{names}</Datas>");
    folder.write("usrapp/mainTest/mainTest.dtx", &database.replace("<Datas />", &filled));
    let program = format!(
        "<?xml version=\"1.0\" encoding=\"utf-8\"?>\n<Programs xmlns:xsi=\"http://www.w3.org/2001/XMLSchema-instance\" \
         xmlns=\"http://www.staubli.com/robotics/VAL3/Program/2\">\n  <Program name=\"testSum\">\n    <Parameters \
         xmlns=\"http://www.staubli.com/robotics/VAL3/Param/1\">\n      {parameter}\n    </Parameters>\n    \
         <Code><![CDATA[begin\n{code}\nend]]></Code>\n  </Program>\n</Programs>\n"
    );
    folder.write("usrapp/mainTest/testSum.pgx", &program);
    folder
}

fn data(name: &str, ty: &str, values: &[&str]) -> String {
    let rows = values.iter().enumerate().map(|(key, value)| format!("<Value key=\"{key}\" value=\"{value}\" />"));
    let (size, rows) = (values.len(), rows.collect::<String>());
    format!("<Data name=\"{name}\" access=\"private\" xsi:type=\"array\" type=\"{ty}\" size=\"{size}\">{rows}</Data>")
}

pub(crate) const ROW: &str = r#"<Parameter name="x_nCase" type="num" xsi:type="element" />"#;

#[test]
fn a_test_with_a_table_is_executed_once_a_row() {
    let folder = squares(ROW, "call assert:equalNum(nIn[x_nCase]*nIn[x_nCase],nOut[(x_nCase)],0)");
    let run = folder.val3(&["test", "usrapp"]);
    assert_eq!(run.code, 1);
    expect![[r#"
        mainTest
          ok    testSum[0] (0.004 s)
          ok    testSum[1] (0.004 s)
          FAIL  testSum[2] (0.004 s)
                9 instead of 8 (1 away, tolerance 0)
                at mainTest:testSum (usrapp/mainTest/testSum.pgx:8)
                    8 │ call assert:equalNum(nIn[x_nCase]*nIn[x_nCase],nOut[(x_nCase)],0)
                row: nIn = -3, nOut = 8
        failures:
          usrapp/mainTest/testSum.pgx:8: mainTest:testSum[2]: 9 instead of 8 (1 away, tolerance 0)
        2 passed, 1 failed
    "#]]
    .assert_eq(&run.stdout);
    let listed = folder.val3(&["test", "usrapp", "--list", "--filter", "testSum[1]"]);
    assert_eq!(listed.stdout, "mainTest:testSum[1]\n");
    let json = folder.val3(&["test", "usrapp", "--format", "json"]);
    let report: Value = serde_json::from_str(&json.stdout).unwrap();
    assert_eq!((&report["tests"][2]["program"], &report["tests"][2]["row"]), (&"testSum".into(), &2.into()));
}
