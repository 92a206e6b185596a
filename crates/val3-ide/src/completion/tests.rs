use expect_test::{Expect, expect};

use super::*;
use crate::testing::Marked;

/// The first completions.
fn check(listing: &str, expected: Expect) {
    let marked = Marked::new(listing);
    let found = completions(marked.db(), marked.at());
    let shown: String = found.iter().take(6).map(|item| format!("{} {:?} {}\n", item.label, item.kind, item.detail)).collect();
    expected.assert_eq(&shown);
}

const LIBRARY: &str = "\n--- part\npublic num nWeight\nnum nInner\npublic program pick(num x_n)\nbegin\nend";

#[test]
fn statements() {
    check("num nCount\nif nCount==1\n  nCount=2\nen$0", expect![[r#""#]]);
    check("num nCount\nnC$0", expect![[r#""#]]);
    check("wai$0", expect![[r#""#]]);
}

#[test]
fn values_of_the_expected_type() {
    check("mdesc mFast\npoint pA\ntool tGrip\nmovej(pA,tGrip,$0)", expect![[r#""#]]);
    check("trsf trA\nnum nA\ntrA=$0", expect![[r#""#]]);
    check("string sA\nnum nA\nif sA==$0", expect![[r#""#]]);
    check("mdesc mA\nmA.blend=$0", expect![[r#""#]]);
}

#[test]
fn members() {
    check("point pA\npA.$0", expect![[r#""#]]);
    check("point pA\npA.trsf.r$0=1", expect![[r#""#]]);
    check("type Slot \"Disk://Slot/Slot.pjx\"\nSlot sA\nsA.$0\n--- Slot\npublic num nHeight", expect![[r#""#]]);
}

#[test]
fn libraries() {
    let with = |line: &str| format!("library part \"Disk://part/part.pjx\"\nnum nA\n{line}{LIBRARY}");
    check(&with("nA=part:$0"), expect![[r#""#]]);
    check(&with("call part:$0"), expect![[r#""#]]);
    check(&with("call $0"), expect![[r#""#]]);
    check(&with("nA=part:libLoad(\"$0\")"), expect![[r#""#]]);
    check(&with("taskCreate \"a\",10,p$0"), expect![[r#""#]]);
}

#[test]
fn nothing_where_nothing_fits() {
    check("// no$0", expect![[r#""#]]);
    check("num nA\nnA=12$0", expect![[r#""#]]);
}
