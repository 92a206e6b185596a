//! Coverage counts the programs that tests test.

use expect_test::expect;
use val3_coverage::Coverage;
use val3_suite::{counted, executed, project_name, tested_projects};

use crate::bench::Bench;

const CELL: &str = r#"
num nUnused
--- palTest
library pal "Disk://pal/pal.pjx"
library assert "Disk://val3assert/val3assert.pjx"
num nSum
program testOne()
begin
  call pal:work(nSum)
  call assert:equalNum(nSum,2,0)
end
--- pal
public program work(num& x_nSum)
begin
  x_nSum=2
  if x_nSum<1
    x_nSum=1
  endIf
end
public program idle()
begin
  ? 1
end
"#;

/// Returns the programs with their line counts: `pal:work 0:1 …`, lines from the first.
fn programs(coverage: &Coverage) -> String {
    let mut text = String::new();
    for project in coverage.projects() {
        for (_, program) in &project.programs {
            let first = program.lines.keys().next().copied().unwrap_or_default();
            let lines = program.lines.iter().map(|(line, count)| format!(" {}:{count}", line - first));
            let sides = program.branches.iter().flat_map(|branch| &branch.sides);
            let sides = sides.map(|side| format!(" {}:{}", side.name, side.hits));
            let counts: String = lines.chain(sides).collect();
            text += &format!("{}:{}{counts}\n", project.name, program.program);
        }
    }
    text
}

#[test]
fn tests_and_assertions_are_not_counted() {
    let mut bench = Bench::open(CELL, "palTest");
    assert!(bench.test("testOne", "").has_passed());
    expect![[r#"
        pal:idle 0:0
        pal:work 0:1 1:1 2:0 true:0 false:1
    "#]]
    .assert_eq(&programs(&counted(&bench.controller, &bench.application)));
    let all = programs(&executed(&bench.controller));
    for program in ["pal:work", "palTest:testOne", "val3assert:equalNum"] {
        assert!(all.contains(program), "{all}");
    }
    let db = bench.application.db();
    let projects = tested_projects(&bench.application);
    assert_eq!(projects.iter().map(|project| project_name(db, *project)).collect::<Vec<_>>(), ["pal"]);
}

#[test]
fn counts_of_a_second_test_begin_anew() {
    let mut bench = Bench::open(CELL, "palTest");
    bench.test("testOne", "");
    let first = programs(&counted(&bench.controller, &bench.application));
    bench.test("testOne", "");
    assert_eq!(programs(&counted(&bench.controller, &bench.application)), first);
}
