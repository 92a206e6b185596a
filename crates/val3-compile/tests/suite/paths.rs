//! Paths with steps that do not exist, in `isDefined` (2.5.4).

use expect_test::expect;

use crate::cell::Cell;

/// Each step of a path may be missing (2.5.4). Indexes are computed once, and errors in an index remain errors.
#[test]
fn every_step_of_a_path_may_be_missing() {
    let listing = r#"
        library part "Disk://part/part.pjx" autoload=false
        type Line "Disk://Line/Line.pjx"
        Line tX[2]
        Line tKeyed[""]
        frame fRow[2]
        num nA[2]
        bool bX
        program start()
        begin
          ? isDefined(tX[1].tSlot[1].nValues[2])
          ? isDefined(tX[2].tSlot[1].nValues[2])
          ? isDefined(tX[1].tSlot[-1].nValues[2])
          ? isDefined(tX[1].tSlot[1].nValues[3])
          ? isDefined(tX[2].tSlot)
          ? isDefined(tKeyed["a"].tSlot[0].nValues)
          insert(tKeyed["a"])
          ? isDefined(tKeyed["a"].tSlot[0].nValues)
          ? isDefined(tKeyed["a"].nKeyed["b"])
          ? isDefined(fRow[2].trsf.x)
          ? isDefined(fRow[1].trsf.x)
          if isDefined(tX[2].tSlot[1].nValues[2])
            ? "wrong"
          elseIf isDefined(tX[0].tSlot[1].nValues[2])
            ? "right"
          endIf
          bX=isDefined(tX[sel(bX,9,1)].tSlot[sel(bX,9,1)].nValues[sel(bX,9,1)])
          ? bX
          ? isDefined(part:tSlot[0].nValues[0])
          ? isDefined(tX[nA[9]].tSlot[0].nValues[0])
        end
        --- Line
        type Slot "Disk://Slot/Slot.pjx"
        public Slot tSlot[2]
        public num nKeyed[""]
        --- Slot
        public frame fPlace
        public num nValues[3]
        --- part
        type Slot "Disk://Slot/Slot.pjx"
        public Slot tSlot
        "#;
    expect![[r#"
            true
            false
            false
            false
            false
            false
            true
            false
            false
            true
            right
            true
            false
            error 20 in start
        "#]]
    .assert_eq(&Cell::new(listing).run());
}
