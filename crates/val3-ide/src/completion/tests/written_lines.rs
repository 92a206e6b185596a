//! Completions of entire lines: postfix statements and documentation comments.

use expect_test::expect;

use super::{check_insert, found};

#[test]
fn a_statement_follows_the_dot_after_its_value() {
    let labels = |listing: &str| -> Vec<String> { found(listing).into_iter().map(|item| item.label).collect() };
    assert_eq!(labels("bool bRun\nbRun.$0"), ["if", "var", "while"]);
    assert_eq!(labels("num nCount[2]\nnCount[nCount[0]+1].$0"), ["switch", "var"]);
    assert_eq!(labels("bool bRun\nbRun.if$0"), ["if"]);
    check_insert(
        "bool bRun\n  bRun.if$0",
        "if",
        expect![[r#"
        if bRun
          $0
        endIf
        if bRun
        start.pgx:
    "#]],
    );
    check_insert(
        "point pA\npA.trsf.x.var$0",
        "var",
        expect![[r#"
        l_nValue=pA.trsf.x
        l_nValue=pA.trsf.x
        start.pgx: <Locals>
              <Local name="l_nValue" type="num" xsi:type="array" size="1" />
            </Locals>
        start.pgx:
    "#]],
    );
    check_insert(
        "num nA\ntoString(\"\",nA).sw$0",
        "switch",
        expect![[r#"
        switch toString("",nA)
          case ${1:value}
            $0
          break
        endSwitch
        switch toString("",nA)
        start.pgx:
    "#]],
    );
    assert!(labels("point pA\npA.$0").contains(&"trsf".to_owned()));
    for other in [
        "num nA\nnA=nA.$0",
        "num nA\nnA.$0+1",
        "dio dA\ndA.$0",
        "num nA[3]\nnA.$0",
        "if bA.$0",
        "num nA\nput(abs(nA).$0",
    ] {
        assert!(!labels(other).iter().any(|label| ["if", "var", "switch"].contains(&label.as_str())), "{other}");
    }
}

#[test]
fn comments_about_the_program_are_proposed() {
    let pick = |code| format!("program pick(num x_nA, num x_nB)\nbegin\n{code}\nend");
    let listing = |code| format!("program start()\nbegin\n  call pick(1,2)\nend\n{}", pick(code));
    let labels = |code| -> Vec<String> { found(&listing(code)).into_iter().map(|item| item.label).collect() };
    assert_eq!(labels("  //$0"), ["\\brief", "\\param x_nA", "\\param x_nB"]);
    assert_eq!(labels("  //\\brief pick: takes it\n\n  // \\pa$0\n  //\\param x_nB num"), ["\\param x_nA"]);
    check_insert(
        &listing("//\\$0"),
        "\\param x_nB",
        expect![[r#"
        \param x_nB num, in
        \param x_nB num, in
    "#]],
    );
    check_insert(
        &listing("//\\br$0"),
        "\\brief",
        expect![[r#"
        \brief pick: purpose
        \brief pick: purpose
    "#]],
    );
    for other in ["  // a$0", "  cls()\n  //$0", "  // \\param x$0"] {
        assert!(labels(other).is_empty(), "{other}");
    }
}
