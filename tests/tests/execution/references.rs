//! Frames, tools and points that refer to each other (9.4 to 9.6), through elements, fields of user types and
//! parameters.

use expect_test::expect;

use crate::execution::check;

/// If a frame moves, all data relative to it move too, independent of the expression that names them.
#[test]
fn references_lead_through_elements_and_fields() {
    check(
        r#"
        type Station "Disk://Station/Station.pjx"
        frame fCell
        frame fRow[2]
        frame fByName["left"]
        private Station tPlace
        point pPart
        program start()
        begin
          fCell.trsf={100,0,0,0,0,90}
          link(fRow[1],fCell)
          fRow[1].trsf={10,0,0,0,0,0}
          link(fByName["left"],fRow[1])
          link(tPlace.fTable,fByName["left"])
          link(tPlace.pRow[1],tPlace.fTable)
          link(pPart,tPlace.fTable)
          ? position(tPlace.pRow[1],world)
          fCell.trsf.x=200
          ? position(tPlace.pRow[1],world)
          tPlace.fTable.trsf.z=5
          ? position(pPart,fCell)
          ? distance(pPart,tPlace.pRow[1])
        end
        --- Station
        public frame fTable
        public point pRow[2]
        "#,
        expect![[r#"
            {100,10,0,0,0,90}
            {200,10,0,0,0,90}
            {10,0,5,0,0,0}
            0
        "#]],
    );
}

/// A copy has the father of the original; `world` and `flange` are their own fathers.
#[test]
fn a_copy_keeps_the_reference() {
    check(
        r#"
        frame fTable
        tool tHand
        program start()
          frame l_fCopy
          frame l_fBase
          tool l_tCopy
          tool l_tTip
        begin
          fTable.trsf={1,2,3,0,0,0}
          l_fCopy=fTable
          ? l_fCopy==fTable
          l_fCopy.trsf.z=30
          ? position(l_fCopy,fTable)
          l_fBase=world
          ? l_fBase==world
          l_fBase.trsf.x=7
          ? position(l_fBase,world)
          l_tTip=flange
          l_tTip.trsf.z=20
          ? position(l_tTip,flange)
          tHand.trsf.z=50
          link(l_tTip,tHand)
          l_tCopy=l_tTip
          ? position(l_tCopy,flange)
          ? l_tCopy==l_tTip and l_tCopy!=tHand
        end
        "#,
        expect![[r#"
            true
            {0,0,27,0,0,0}
            true
            {7,0,0,0,0,0}
            {0,0,20,0,0,0}
            {0,0,70,0,0,0}
            true
        "#]],
    );
}

/// A type's project declares the values of fields, not their fathers (7.3).
#[test]
fn fields_have_no_reference_at_first() {
    let listing = r#"
        type Station "Disk://Station/Station.pjx"
        private Station tPlace[1]
        program show(frame& x_fPart)
        begin
          ? x_fPart
          ? position(x_fPart,world)
        end
        program start()
          Station l_tPlace
        begin
          taskCreate "local",100,local()
          wait(taskStatus("local")!=1)
          taskCreate "global",100,show(tPlace[0].fTable)
          wait(taskStatus("global")!=1)
          append(tPlace)
          link(tPlace[1].fTable,world)
          call show(tPlace[1].fTable)
        end
        program local()
          Station l_tPlace
        begin
          call show(l_tPlace.fTable)
        end
        --- Station
        === Station/Station.dtx
        <?xml version="1.0"?>
        <Database><Datas><Data name="fTable" access="public" xsi:type="array" type="frame" size="1">
        <Value key="0" x="7" fatherId="world[0]" /></Data></Datas></Database>
    "#;
    check(
        listing,
        expect![[r#"
            {{7,0,0,0,0,0}}
            error 163
            {{7,0,0,0,0,0}}
            error 163
            {{7,0,0,0,0,0}}
            {7,0,0,0,0,0}
        "#]],
    );
}

/// A called program can link a parameter to its own data, but the link exists only as long as both.
#[test]
fn a_reference_that_ends_with_a_program_is_none() {
    check(
        r#"
        program hang(frame& x_fPart)
          frame l_fOwn
        begin
          link(l_fOwn,world)
          l_fOwn.trsf.x=10
          link(x_fPart,l_fOwn)
          ? position(x_fPart,world)
        end
        program other()
          frame l_fOther
        begin
          link(l_fOther,world)
          l_fOther.trsf.x=77
        end
        program start()
          frame l_fPart
        begin
          call hang(l_fPart)
          call other()
          ? position(l_fPart,world)
        end
        "#,
        expect![[r#"
            {10,0,0,0,0,0}
            error 163
        "#]],
    );
}
