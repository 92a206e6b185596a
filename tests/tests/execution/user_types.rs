//! Values of user types (7.3).

use expect_test::expect;

use crate::execution::check;

#[test]
fn new_values_are_as_the_type_says_and_have_no_references() {
    check(
        r#"
        type Slot "Disk://Slot/Slot.pjx"
        Slot sRow[2]
        Slot sSlots[""]
        program frame(frame& x_fTray)
        begin
          ? position(x_fTray,world)
        end
        program point(point& x_pPart)
        begin
          ? position(x_pPart,world)
        end
        program start()
        begin
          link(sRow[1].fTray,world)
          link(sRow[1].pParts[1],world)
          call frame(sRow[1].fTray)
          call point(sRow[1].pParts[1])
          append(sRow)
          insert(sSlots["a"])
          resize(sRow[0].pParts,1,3)
          ? size(sRow[2].pParts)
          ? sRow[2].fTray.trsf
          ? sSlots["a"].pParts[1].trsf
          ? sRow[0].pParts[2].trsf
          taskCreate "frame",10,frame(sRow[2].fTray)
          taskCreate "point",10,point(sSlots["a"].pParts[1])
          taskCreate "resized",10,point(sRow[0].pParts[2])
          delay(0.1)
          link(sRow[2].fTray,world)
          taskResume("frame",0)
          sRow[2]=sRow[1]
          call point(sRow[2].pParts[1])
          taskKill("point")
          taskKill("resized")
        end
        --- Slot
        public num nNothing
        === Slot/Slot.dtx
        <?xml version="1.0" encoding="utf-8"?>
        <Database xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance" xmlns="http://www.staubli.com/robotics/VAL3/Data/2">
          <Datas>
            <Data name="fTray" access="public" xsi:type="array" type="frame" size="1"><Value key="0" x="100" fatherId="world[0]" /></Data>
            <Data name="pParts" access="public" xsi:type="array" type="pointRx" size="2"><Value key="1" x="5" fatherId="world[0]" /></Data>
          </Datas>
        </Database>
        "#,
        expect![[r#"
            {100,0,0,0,0,0}
            {5,0,0,0,0,0}
            2
            {100,0,0,0,0,0}
            {5,0,0,0,0,0}
            {0,0,0,0,0,0}
            error 163
            error 162
            error 162
            {100,0,0,0,0,0}
            {5,0,0,0,0,0}
        "#]],
    );
}

#[test]
fn a_copy_has_all_its_containers_and_a_value_taken_out_none() {
    check(
        r#"
        type Tray "Disk://Tray/Tray.pjx"
        Tray tRow[2]
        Tray tOther
        Tray tTrays[""]
        program pass(Tray x_tTray)
        begin
        end
        program grow(Tray& x_tTray)
        begin
          append(x_tTray.tSlots)
          insert(x_tTray.tNamed["first"])
        end
        program row(num& x_nRow[])
        begin
          delete(tRow[1])
          ? size(x_nRow)
        end
        program start()
        begin
          call pass(tRow[1])
          call grow(tRow[1])
          tOther=tRow[1]
          insert(tTrays["a"])
          tTrays["a"]=tOther
          call grow(tTrays["a"])
          ? size(tTrays["a"].tSlots)
          ? tTrays["a"].tSlots[2].nValues[1]
          call row(tRow[1].tSlots[1].nValues)
        end
        --- Slot
        public num nValues[2]
        --- Tray
        type Slot "Disk://Slot/Slot.pjx"
        public Slot tSlots[2]
        public Slot tNamed[""]
        "#,
        expect![[r#"
            4
            0
            error 20
        "#]],
    );
}
