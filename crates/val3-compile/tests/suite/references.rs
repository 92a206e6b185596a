//! References from frames, tools and points to another project (9.4 to 9.6, errors 80 and 82).

use expect_test::{Expect, expect};

use crate::cell::Cell;

/// Checks the program `start` with a library `part`, which uses the library `base`.
#[track_caller]
fn check(code: &str, expected: Expect) {
    let listing = format!(
        r#"
library part "Disk://part/part.pjx" autoload=false
frame fCell
point pPick
tool tHand
program start()
  frame l_fNear
begin
  part:libLoad("part")
{code}
end
--- part
library base "Disk://base/base.pjx"
public frame fTable
frame fHidden
public frame fTray
public point pIn[2]
public tool tTip
public program init()
begin
  fTable.trsf={{100,0,0,0,0,0}}
  fHidden.trsf={{50,0,0,0,0,0}}
  link(fTray,fHidden)
  link(pIn[0],fTable)
  link(pIn[1],fHidden)
  tTip.trsf={{0,0,9,0,0,0}}
end
public program hang()
begin
  link(fTable,base:fFloor)
end
--- base
public frame fFloor
"#
    );
    expected.assert_eq(&Cell::new(&listing).run());
}

#[test]
fn data_of_a_library_are_references_and_have_them() {
    check(
        "  call part:init()\n  link(fCell,part:fTable)\n  fCell.trsf={0,5,0,0,0,0}\n  ? position(fCell,world)\n  \
         ? position(part:pIn[1],world)\n  pPick=part:pIn[0]\n  part:fTable.trsf.x=200\n  ? position(pPick,world)\n  \
         link(tHand,part:tTip)\n  ? position(tHand,flange)",
        expect![[r#"
            {100,5,0,0,0,0}
            {50,0,0,0,0,0}
            {200,0,0,0,0,0}
            {0,0,9,0,0,0}
        "#]],
    );
}

/// A local variable may refer to them, because its reference cannot be named.
#[test]
fn private_data_of_a_library_cannot_be_referred_to_by_global_data() {
    check(
        "  call part:init()\n  l_fNear=part:fTray\n  ? position(l_fNear,world)\n  ? appro(part:pIn[1],{0,0,1,0,0,0})\n  \
         pPick=part:pIn[1]",
        expect![[r#"
            {50,0,0,0,0,0}
            {{0,0,1,0,0,0},{ssame,esame,wsame}}
            error 82 in start
        "#]],
    );
    check("  call part:init()\n  fCell=part:fTray", expect!["error 82 in start\n"]);
}

#[test]
fn data_of_an_undeclared_library_cannot_be_referred_to_by_global_data() {
    check("  call part:hang()\n  ? 1\n  fCell=part:fTable", expect!["1\nerror 82 in start\n"]);
}

/// A rejected assignment changes nothing.
#[test]
fn a_refused_assignment_leaves_the_variable() {
    check(
        "  taskCreate \"copy\",100,copy()\n  wait(taskStatus(\"copy\")!=1)\n  ? taskStatus(\"copy\")\n  ? fCell\nend\n\
         program copy()\nbegin\n  call part:init()\n  fCell.trsf.z=3\n  part:fTray.trsf.x=7\n  fCell=part:fTray",
        expect![[r#"
            error 82 in copy
            82
            {{0,0,3,0,0,0}}
        "#]],
    );
}

/// If a library is unloaded, its frames no longer exist.
#[test]
fn a_reference_leaves_with_its_library() {
    check(
        "  call part:init()\n  link(fCell,part:fTable)\n  ? position(fCell,world)\n  ? part:libLoad(\"base\")\n  \
         ? position(fCell,world)",
        expect![[r#"
            {100,0,0,0,0,0}
            11
            error 163 in start
        "#]],
    );
}
