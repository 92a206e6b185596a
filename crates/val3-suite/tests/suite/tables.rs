//! Tests that are executed once for each row of a table.

use expect_test::expect;

use crate::bench::Bench;

/// Opens a test application with numbers, their squares, and a shorter array. The last square is wrong.
fn bench(parameter: &str, code: &str) -> Bench {
    let listing = format!(
        "num nUnused\n--- mainTest\nlibrary assert \"Disk://val3assert/val3assert.pjx\"\nnum nIn[3]\nnum nOut[3]\n\
         string sName[2]\nprogram setup()\nbegin\nnIn[1]=2\nnIn[2]=-3\nnOut[1]=4\nnOut[2]=8\nend\n\
         program testSum({parameter})\nbegin\n{code}\nend"
    );
    Bench::open(&listing, "mainTest")
}

#[test]
fn a_test_with_a_table_is_executed_once_a_row() {
    let mut bench = bench("num x_nCase", "call assert:equalNum(nIn[x_nCase]*nIn[x_nCase],nOut[(x_nCase)],0)");
    assert_eq!(bench.cases()[2].name(), "mainTest:testSum[2]");
    assert_eq!(bench.cases()[2].columns, ["nIn", "nOut"]);
    expect![[r#"
        testSum[0]: ok, 0.008 s
        testSum[1]: ok, 0.008 s
        testSum[2]: failed, 0.008 s
        9 instead of 8 (1 away, tolerance 0)
          at mainTest:testSum (mainTest/testSum.pgx:8)
    "#]]
    .assert_eq(&bench.tests());
    let row = bench.test("testSum[2]", "").row;
    assert_eq!(row, [("nIn".to_owned(), "-3".to_owned()), ("nOut".to_owned(), "8".to_owned())]);
}

#[test]
fn rows_do_not_see_each_other() {
    let mut bench = bench("num x_nCase", "nOut[x_nCase]=nOut[x_nCase]+1\n? nOut[0]+10*nOut[1]+100*nOut[2]");
    let prints = ["testSum[0]", "testSum[1]", "testSum[2]"].map(|title| bench.test(title, "").prints.concat());
    assert_eq!(prints, ["841", "850", "940"]);
}

#[test]
fn a_test_that_cannot_be_executed_fails_with_the_reason() {
    let reasons = [
        ("num x_nCase", "? x_nCase"),
        ("num x_nCase", "? nIn[x_nCase]\n? sName[x_nCase]"),
        ("num x_nOther", "? nIn[x_nOther]"),
        ("string x_nCase", "? x_nCase"),
        ("num& x_nCase", "? nIn[x_nCase]"),
        ("num x_nCase[]", "? nIn[x_nCase[0]]"),
    ];
    let reasons = reasons.map(|(parameter, code)| bench(parameter, code).tests());
    expect![[r#"
        testSum: failed, 0 s
        `testSum` reads no global array by `x_nCase`, so that it has no rows
          at mainTest:testSum (mainTest/testSum.pgx:8)
        testSum: failed, 0 s
        the columns of its table have different numbers of rows: `nIn` 3, `sName` 2
          at mainTest:testSum (mainTest/testSum.pgx:8)
        testSum: failed, 0 s
        `testSum` has parameters: a test has none, or only `num x_nCase`, the number of a row
          at mainTest:testSum (mainTest/testSum.pgx:8)
        testSum: failed, 0 s
        `testSum` has parameters: a test has none, or only `num x_nCase`, the number of a row
          at mainTest:testSum (mainTest/testSum.pgx:8)
        testSum: failed, 0 s
        `testSum` has parameters: a test has none, or only `num x_nCase`, the number of a row
          at mainTest:testSum (mainTest/testSum.pgx:8)
        testSum: failed, 0 s
        `testSum` has parameters: a test has none, or only `num x_nCase`, the number of a row
          at mainTest:testSum (mainTest/testSum.pgx:8)
    "#]]
    .assert_eq(&reasons.concat());
}
