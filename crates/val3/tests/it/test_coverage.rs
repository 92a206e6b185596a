//! `val3 test --coverage`: complete cells, their reports, and what the reports omit.

use expect_test::expect;
use serde_json::{Value, json};

use crate::support::{CommandOutput, Folder};

/// A test application that loads the library `pal`. This library loads `tool`, and in one mode `spare`.
const CELL: &str = r#"
--- palTest
library pal "Disk://pal/pal.pjx"
library assert "Disk://val3assert/val3assert.pjx"
num nSum
program testOne()
begin
  call pal:work(1,nSum)
  call assert:equalNum(nSum,7,0)
end
program testTwo()
begin
  call pal:work(2,nSum)
  call assert:equalNum(nSum,4,0)
end
program testThree()
begin
  call pal:work(3,nSum)
  call assert:equalNum(nSum,0,0)
end
program testError()
begin
  call assert:expectError(10)
  call pal:divide(0,nSum)
end

--- pal
library tool "Disk://tool/tool.pjx"
library spare "Disk://tool/tool.pjx" autoload=false
num nCode
public program work(num x_nMode, num& x_nSum)
  num l_i
begin
  x_nSum=0
  for l_i=1 to x_nMode
    x_nSum=x_nSum+1
  endFor
  while x_nSum<4
    x_nSum=x_nSum+1
  endWhile
  do
    l_i=l_i-1
  until l_i<=0
  switch x_nMode
    case 1
      call tool:open(true,x_nSum)
    break
    case 2, 8
      if x_nSum==0 or x_nSum==9
        call tool:close()
      endIf
    break
    case 5
      x_nSum=5
    break
  endSwitch
  if x_nMode==3
    nCode=spare:libLoad("Disk://spare")
    call spare:close()
    x_nSum=0
  elseIf x_nMode==9
    x_nSum=9
  endIf
end
public program divide(num x_nBy, num& x_nSum)
begin
  x_nSum=1/x_nBy
  x_nSum=2
end
public program idle()
begin
  if nCode==0
    nCode=1
  endIf
end

--- tool
num nOpen
public program open(bool x_bWide, num& x_nSum)
begin
  if x_bWide
    x_nSum=x_nSum+3
  else
    //val3: no-coverage
    nOpen=1
  endIf
  //val3: no-coverage the simulation has no sensor
  if nOpen==1
    nOpen=2
  endIf
end
public program close()
begin
  //val3: no-coverage
  nOpen=0
end

--- spare
num nOpen
public program open(bool x_bWide, num& x_nSum)
begin
  nOpen=3
end
public program close()
begin
  nOpen=0
end
"#;

fn cell() -> Folder {
    let folder = Folder::with(CELL);
    let written = folder.val3(&["test", "--init", "usrapp/pal"]);
    assert_eq!(written.code, 0, "{written:?}");
    folder
}

fn tested(options: &[&str]) -> CommandOutput {
    cell().val3(&[&["test", "usrapp"], options].concat())
}

/// JSON report of a cell.
fn report(folder: &Folder, options: &[&str]) -> Value {
    let run = folder.val3(&[&["test", "usrapp", "--coverage-output", "json=report.json"], options].concat());
    assert_eq!(run.code, 0, "{run:?}");
    serde_json::from_str(&folder.read("report.json")).unwrap()
}

/// File of a program in a report.
fn file<'r>(report: &'r Value, path: &str) -> Option<&'r Value> {
    report["files"].as_array().unwrap().iter().find(|file| file["file"] == path)
}

#[test]
fn the_table_follows_the_results() {
    let run = tested(&["--coverage"]);
    assert_eq!(run.code, 0, "{run:?}");
    expect![[r#"
        palTest
          ok    testError (0.008 s)
          ok    testOne (0.004 s)
          ok    testThree (0.012 s)
          ok    testTwo (0.004 s)
        4 passed, 0 failed
        coverage             lines          branches  missing lines
        pal        72.7 %    16/22   72.2 %    13/18
          divide   50.0 %      1/2                 -  10
          idle      0.0 %      0/2    0.0 %      0/2  5-6
          work     83.3 %    15/18   81.2 %    13/16  28-32, 40
        spare      50.0 %      1/2                 -
          close   100.0 %      1/1                 -
          open      0.0 %      0/1                 -  9
        tool      100.0 %      2/2   50.0 %      1/2
          open    100.0 %      2/2   50.0 %      1/2
        total      73.0 %    19/26   70.0 %    14/20
    "#]]
    .assert_eq(&run.stdout);
}

#[test]
fn other_formats_have_the_table_beside_their_results() {
    let human = tested(&["--coverage"]);
    let table = human.stdout.split_once("passed, 0 failed\n").unwrap().1;
    for format in ["json", "junit", "tap", "github", "json-lines"] {
        let run = tested(&["--coverage", "--format", format]);
        assert_eq!((run.code, run.stderr.as_str()), (0, table), "{format}");
        assert!(!run.stdout.contains("missing lines"), "{run:?}");
    }
    let plain = tested(&[]);
    assert!(!plain.stdout.contains("missing lines") && plain.stderr.is_empty(), "{plain:?}");
}

/// Counts for both sides of every construct.
#[test]
fn each_side_of_each_construct_is_counted() {
    let folder = cell();
    let report = report(&folder, &[]);
    let work = file(&report, "usrapp/pal/work.pgx").unwrap();
    let text = folder.read("usrapp/pal/work.pgx");
    let code: Vec<&str> = text.lines().collect();
    let shown = work["branches"].as_array().unwrap().iter().map(|branch| {
        let sides = branch["sides"].as_array().unwrap().iter();
        let sides: Vec<_> = sides.map(|side| format!("{} {}", side["name"].as_str().unwrap(), side["hits"])).collect();
        let line = usize::try_from(branch["line"].as_u64().unwrap()).unwrap();
        format!("{}: {}\n", code[line - 1].trim(), sides.join("; "))
    });
    expect![[r#"
        for l_i=1 to x_nMode: round 6; end 3
        while x_nSum<4: true 6; false 3
        until l_i<=0: false 6; true 3
        switch x_nMode: case 1 1; case 2, 8 1; case 5 0; no case 1
        if x_nSum==0 or x_nSum==9: true 0; false 1
        if x_nMode==3: true 1; false 2
        elseIf x_nMode==9: true 0; false 2
    "#]]
    .assert_eq(&shown.collect::<String>());
    let count = |text: &str| hits(work, code.iter().position(|line| line.trim() == text).unwrap() + 1);
    assert_eq!(count("x_nSum=0"), Some(json!(3)));
    assert_eq!(count("x_nSum=5"), Some(json!(0)));
    assert_eq!(count("while x_nSum<4"), Some(json!(9)));
    assert_eq!(count("do"), None);
    assert_eq!(
        (&report["version"], &work["application"], &work["program"]),
        (&json!(1), &json!("pal"), &json!("work"))
    );
}

/// Hits of a line in a program's report; `None` if the line is not counted.
fn hits(program: &Value, line: usize) -> Option<Value> {
    let mut lines = program["lines"].as_array().unwrap().iter();
    Some(lines.find(|counted| counted["line"] == line)?["hits"].clone())
}

#[test]
fn lines_after_a_runtime_error_are_not_executed() {
    let report = report(&cell(), &[]);
    let divide = file(&report, "usrapp/pal/divide.pgx").unwrap();
    let hits: Vec<&Value> = divide["lines"].as_array().unwrap().iter().map(|line| &line["hits"]).collect();
    assert_eq!(hits, [&json!(1), &json!(0)]);
}

#[test]
fn comments_leave_out_lines_blocks_and_programs() {
    let report = report(&cell(), &[]);
    let open = file(&report, "usrapp/tool/open.pgx").unwrap();
    assert_eq!(open["lines"].as_array().unwrap().len(), 2, "{open}");
    assert_eq!(open["branches"].as_array().unwrap().len(), 1, "{open}");
    assert!(file(&report, "usrapp/tool/close.pgx").is_none(), "{report}");
}

#[test]
fn the_comment_is_known_and_a_misspelt_one_is_not() {
    let folder = cell();
    let check = folder.val3(&["check", "usrapp/tool", "--format", "concise", "--fail-level", "info"]);
    assert!(!check.stdout.contains("V0702") && !check.stdout.contains("V0703"), "{check:?}");
    let text = folder.read("usrapp/tool/close.pgx").replace("no-coverage", "no-coverag");
    folder.write("usrapp/tool/close.pgx", &text);
    let check = folder.val3(&["check", "usrapp/tool", "--format", "concise"]);
    assert!(check.stdout.contains("V0703"), "{check:?}");
}

/// Loaded programs without an execution are listed; tests, `val3assert` and unloaded programs are not.
#[test]
fn what_is_loaded_is_reported() {
    let report = report(&cell(), &["--filter", "testTwo"]);
    let files: Vec<&str> =
        report["files"].as_array().unwrap().iter().map(|file| file["file"].as_str().unwrap()).collect();
    let pal = ["divide", "idle", "work"].map(|program| format!("usrapp/pal/{program}.pgx"));
    assert_eq!(files, [&pal[0], &pal[1], &pal[2], "usrapp/tool/open.pgx"]);
    let report = self::report(&cell(), &[]);
    let spare = file(&report, "usrapp/spare/close.pgx").unwrap();
    assert_eq!(spare["lines"][0]["hits"], 1, "{spare}");
    let open = file(&report, "usrapp/spare/open.pgx").unwrap();
    assert_eq!(open["lines"][0]["hits"], 0, "{open}");
}

/// A stand-in belongs to the tests, and the library that it replaces is not loaded.
#[test]
fn stand_ins_are_left_out() {
    let folder = cell();
    folder.write("val3.toml", "[test]\nreplace = { tool = \"usrapp/spare\" }\n");
    let run = folder.val3(&["test", "usrapp", "--filter", "testThree", "--coverage-output", "json=report.json"]);
    assert_eq!(run.code, 0, "{run:?}");
    let report: Value = serde_json::from_str(&folder.read("report.json")).unwrap();
    let files = report["files"].as_array().unwrap();
    assert!(files.iter().all(|file| file["application"] == "pal") && files.len() == 3, "{report}");
}

#[test]
fn reports_are_the_same_with_any_number_of_jobs_and_in_any_order() {
    let folder = cell();
    let run = |options: &[&str]| output_and_reports(&folder, options);
    let first = run(&["--jobs", "1"]);
    assert!(first.0.contains("missing lines") && first.1.iter().all(|text| text.contains("work")), "{first:?}");
    for options in [["--jobs", "4"], ["--seed", "1"], ["--seed", "2"], ["--seed", "3"]] {
        assert_eq!(run(&options), first, "{options:?}");
    }
    assert_eq!(run(&["--jobs", "3", "--seed", "7"]), first);
}

/// Output of the tests, and all reports about the coverage.
fn output_and_reports(folder: &Folder, options: &[&str]) -> (String, [String; 5]) {
    let outputs = ["lcov=lcov.info", "cobertura=cobertura.xml", "json=report.json", "html=pages"];
    let outputs: Vec<&str> = outputs.into_iter().flat_map(|output| ["--coverage-output", output]).collect();
    let run = folder.val3(&[&["test", "usrapp"], outputs.as_slice(), options].concat());
    assert_eq!(run.code, 0, "{run:?}");
    let files = ["lcov.info", "cobertura.xml", "report.json", "pages/index.html", "pages/pal.work.html"];
    (run.stdout, files.map(|file| folder.read(file)))
}

#[test]
fn counts_are_those_of_all_repetitions() {
    let folder = cell();
    let hits = |report: &Value| file(report, "usrapp/pal/work.pgx").unwrap()["lines"][0]["hits"].clone();
    assert_eq!(hits(&report(&folder, &[])), 3);
    assert_eq!(hits(&report(&folder, &["--repeat", "5", "--jobs", "2"])), 15);
}

/// Counting changes neither results nor times.
#[test]
fn results_do_not_depend_on_counting() {
    let result = |run: CommandOutput| run.stdout.split_once("failed\n").unwrap().0.to_owned();
    assert_eq!(result(tested(&["--coverage"])), result(tested(&[])));
}

#[test]
fn too_few_executed_lines_fail() {
    let below = tested(&["--fail-under", "50"]);
    assert_eq!((below.code, below.stderr.as_str()), (0, ""), "{below:?}");
    let above = tested(&["--fail-under", "99.5"]);
    assert_eq!(above.code, 1, "{above:?}");
    expect![[r#"
        error: 73.0 % of the lines were executed (19 of 26), fewer than 99.5 %
    "#]]
    .assert_eq(&above.stderr);
    let folder = cell();
    let nothing =
        folder.val3(&["test", "usrapp/val3assert", "usrapp/palTest", "--fail-under", "0", "--shard", "50/50"]);
    assert_eq!(nothing.code, 1, "{nothing:?}");
    assert!(nothing.stderr.contains("no line was counted"), "{nothing:?}");
    for wrong in ["101", "-1", "much"] {
        assert_eq!(folder.val3(&["test", "usrapp", &format!("--fail-under={wrong}")]).code, 2, "{wrong}");
    }
}

#[test]
fn failing_tests_have_a_coverage_too() {
    let folder = cell();
    let text = folder.read("usrapp/palTest/testTwo.pgx").replace("nSum,4,0", "nSum,5,0");
    folder.write("usrapp/palTest/testTwo.pgx", &text);
    let run = folder.val3(&["test", "usrapp", "--coverage"]);
    assert_eq!(run.code, 1);
    assert!(run.stdout.contains("4 instead of 5") && run.stdout.contains("missing lines"), "{run:?}");
}

#[test]
fn reports_are_written_to_files() {
    let folder = cell();
    let run = folder.val3(&["test", "usrapp", "--coverage-output", "cobertura=c.xml", "--coverage-output", "html=a/b"]);
    assert_eq!(run.code, 0, "{run:?}");
    assert!(folder.read("c.xml").contains("filename=\"usrapp/pal/work.pgx\""));
    let page = folder.read("a/b/pal.work.html");
    assert!(page.contains("case 2, 8") && page.contains("never: case 5") && !page.contains("CDATA"), "{page}");
    for (option, reason) in [
        ("lcov=none/lcov.info", "cannot write `none/lcov.info`"),
        ("html=c.xml", "cannot create the folder `c.xml`"),
        ("text=c.txt", "`text` is not a format; supported formats:  lcov, cobertura, html, json"),
        ("lcov", "write FORMAT=FILE"),
    ] {
        let refused = folder.val3(&["test", "usrapp", "--coverage-output", option]);
        assert_eq!(refused.code, 2, "{refused:?}");
        assert!(refused.stderr.contains(reason), "{refused:?}");
    }
}

/// The coverage of a subset of the tests would differ from run to run.
#[test]
fn coverage_needs_all_tests() {
    for option in ["--coverage", "--coverage-output=json=c.json", "--fail-under=1"] {
        let run = tested(&[option, "--fail-fast"]);
        assert_eq!(run.code, 2, "{run:?}");
        assert!(run.stderr.contains("--fail-fast"), "{run:?}");
    }
}

/// An application that a scenario runs is reported with its libraries.
#[test]
fn applications_of_scenarios_are_counted() {
    let folder = Folder::with(
        "library tool \"Disk://tool/tool.pjx\"\ncall tool:run()\nif 1>2\n? 1\nendIf\n--- tool\npublic program run()\nbegin\n? 3\nend\n",
    );
    folder.write("tests/first.toml", "application = \"../usrapp/main\"\n[expect]\nprint = [\"3\"]\n");
    let run = folder.val3(&["test", ".", "--coverage"]);
    assert_eq!(run.code, 0, "{run:?}");
    expect![[r#"
        main
          ok    first (0.004 s)
        1 passed, 0 failed
        coverage             lines          branches  missing lines
        main      66.6 %      2/3                 -
          start   66.6 %      2/3                 -  7
        tool     100.0 %      1/1                 -
          run    100.0 %      1/1                 -
        total     75.0 %      3/4                 -
    "#]]
    .assert_eq(&run.stdout);
}

#[test]
fn programs_in_folders_belong_to_their_application() {
    let folder = cell();
    let project = folder.read("usrapp/pal/pal.pjx");
    folder.write("usrapp/pal/pal.pjx", &project.replace("\"divide.pgx\"", "\"math/divide.pgx\""));
    folder.write("usrapp/pal/math/divide.pgx", &folder.read("usrapp/pal/divide.pgx"));
    let run = folder.val3(&["test", "usrapp", "--coverage", "--coverage-output", "cobertura=c.xml"]);
    assert_eq!(run.code, 0, "{run:?}");
    let rows = run.stdout.lines().map(|line| line.split_whitespace().next().unwrap_or_default());
    assert_eq!(rows.filter(|name| *name == "pal").count(), 1, "{}", run.stdout);
    assert!(run.stdout.contains("\n  divide "), "{}", run.stdout);
    let report = folder.read("c.xml");
    assert_eq!(report.matches("<package name=\"pal\"").count(), 1, "{report}");
    assert!(report.contains("filename=\"usrapp/pal/math/divide.pgx\""), "{report}");
}

#[test]
fn tests_in_a_listed_application_are_no_tested_code() {
    let folder = cell();
    folder.write("val3.toml", "[test]\napplications = [\"usrapp/pal\"]\n");
    let project = folder.read("usrapp/pal/pal.pjx");
    folder.write("usrapp/pal/pal.pjx", &project.replace("</Programs>", "<Program file=\"testIdle.pgx\" /></Programs>"));
    folder.write("usrapp/pal/testIdle.pgx", &crate::test_command::program("testIdle", "call idle()"));
    let report = report(&folder, &[]);
    assert!(file(&report, "usrapp/pal/testIdle.pgx").is_none(), "{report}");
    let idle = file(&report, "usrapp/pal/idle.pgx").unwrap();
    assert!(idle["lines"].as_array().unwrap().iter().any(|line| line["hits"] != 0), "{idle}");
}
