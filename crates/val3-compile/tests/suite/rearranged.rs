//! References to elements after their container was resized, after keys were deleted, and after an assignment (2.5,
//! 2.6.2, 7.3, 9.4.1).

use expect_test::{Expect, expect};

use crate::cell::Cell;

#[track_caller]
fn check(listing: &str, expected: Expect) {
    expected.assert_eq(&Cell::new(listing).run());
}

/// Elements keep their indexes (2.5.5).
#[test]
fn references_into_a_grid_follow_their_elements() {
    check(
        r"
        frame fM[2,2]
        point pA
        num nM[2,2]
        program start()
        begin
          link(fM[1,1],world)
          fM[1,1].trsf.x=11
          link(fM[1,0],world)
          fM[1,0].trsf.x=10
          link(pA,fM[1,1])
          resize(fM,2,3)
          ? position(pA,world)
          nM[1,0]=10
          nM[1,1]=11
          call sub(nM[1,1])
          resize(fM,2,1)
          ? position(pA,world)
        end
        program sub(num& x_nValue)
        begin
          resize(nM,2,3)
          ? x_nValue
          x_nValue=99
          ? nM[1,0]
          ? nM[1,1]
          resize(nM,1,1)
          resize(nM,1,2)
          resize(nM,2,2)
          nM[1,1]=5
          ? x_nValue
        end
        ",
        expect![[r#"
            {11,0,0,0,0,0}
            11
            10
            99
            5
            error 162 in start
        "#]],
    );
}

/// A deleted key is not the key that is inserted next.
#[test]
fn references_end_with_their_keys() {
    check(
        r#"
        frame fC[""]
        point pPick
        num nC[""]
        program start()
        begin
          insert(fC["left"])
          link(fC["left"],world)
          link(pPick,fC["left"])
          delete(fC["left"])
          insert(fC["right"])
          link(fC["right"],world)
          insert(nC["x"])
          insert(nC["y"])
          taskCreate "t",10,sub(nC["x"])
          wait(taskStatus("t")!=1)
          ? nC["z"]
          ? position(pPick,world)
        end
        program sub(num& x_nValue)
        begin
          ? x_nValue
          delete(nC["x"])
          insert(nC["z"])
          x_nValue=7
        end
        "#,
        expect![[r#"
            0
            error 20 in sub
            0
            error 162 in start
        "#]],
    );
}

/// After `=`, the fields of a user type, and the fields of its fields, are the same data as before (7.3).
#[test]
fn references_into_fields_remain_after_an_assignment() {
    check(
        r#"
        type Line "Disk://Line/Line.pjx"
        Line tX[2]
        point pP
        program start()
        begin
          link(tX[0].tSlot[1].fPlace,world)
          link(tX[1].tSlot[0].fPlace,world)
          link(tX[1].tSlot[1].fPlace,world)
          tX[1].tSlot[1].fPlace.trsf.x=9
          tX[1].tSlot[1].nValues[2]=5
          append(tX[1].tSlot)
          insert(tX[0].nKeyed["a"])
          insert(tX[0].nKeyed["b"])
          insert(tX[1].nKeyed["b"])
          tX[1].nKeyed["b"]=4
          link(pP,tX[0].tSlot[1].fPlace)
          call sub(tX[0].tSlot[1].nValues[2],tX[0].nKeyed["b"])
          ? position(pP,world)
        end
        program sub(num& x_nValue,num& x_nKeyed)
        begin
          tX[0]=tX[1]
          ? x_nValue
          ? x_nKeyed
          x_nValue=6
          ? tX[0].tSlot[1].nValues[2]
          ? size(tX[0].tSlot)
          ? isDefined(tX[0].nKeyed["a"])
        end
        --- Line
        type Slot "Disk://Slot/Slot.pjx"
        public Slot tSlot[2]
        public num nKeyed[""]
        --- Slot
        public frame fPlace
        public num nValues[3]
        "#,
        expect![[r#"
            5
            4
            6
            3
            false
            {9,0,0,0,0,0}
        "#]],
    );
}
