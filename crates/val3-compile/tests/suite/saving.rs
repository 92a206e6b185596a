//! What `libSave` writes and `libLoad` reads again (6.7).

use expect_test::{Expect, expect};

use crate::cell::{Cell, run, shown};

/// A library with data of every type and container, and a program for each of two runs.
const EVERYTHING: &str = r#"
    library all "Disk://all/all.pjx" autoload=false
    num nCode
    program start()
    begin
      nCode=all:libLoad("all")
      if nCode!=0
        ? nCode
      endIf
      call all:show()
      call all:change()
      ? all:libSave("changed")
      nCode=all:libLoad("changed")
      ? nCode
      call all:show()
    end
    --- all
    type Slot "slot/slot.pjx"
    public num nCode
    public frame fA
    public frame fRow[3]
    public tool tA
    public point pA
    public joint jA
    public config cA
    public mdesc mA
    public trsf trA
    public bool bA
    public string sA
    public num nGrid[2,3]
    public num nCube[2,2,2]
    public num nKeys[""]
    public dio dA
    public aio aA
    public sio siA
    public dio dRow[2]
    public Slot tSlot[2]
    public Slot tKeyed[""]
    public program show()
    begin
      ? fA
      ? pA
      ? tA
      ? jA
      ? cA
      ? mA
      ? trA
      ? bA
      ? sA
      ? nGrid[1,2]
      ? nGrid[0,0]
      ? nCube[1,0,1]
      ? size(nKeys)
      if isDefined(nKeys["a \"b\""])
        ? nKeys["a \"b\""]
      endIf
      ? size(tSlot)
      ? tSlot[0].pPick
      ? tSlot[1].sName
      ? size(tSlot[1].nValues)
      ? tSlot[size(tSlot)-1].nValues[0]
      ? size(tKeyed)
      if isDefined(tKeyed["k"])
        ? tKeyed["k"].sName
      endIf
    end
    public program change()
    begin
      fA.trsf={1,2,3,4,5,6}
      link(fA,fRow[1])
      link(pA,fA)
      pA.trsf.x=0.1
      pA.config.shoulder=righty
      tA.trsf.z=-1.5
      tA.otime=0.25
      jA={1,2,3,4,5,6.5}
      cA.wrist=wnegative
      mA={50,60,70,250,90,Cartesian,10,20}
      trA.rz=1e-7
      bA=true
      sA="<a> & \"b\""
      nGrid[1,2]=12
      resize(nGrid,1,4)
      nCube[1,0,1]=101
      insert(nKeys["a \"b\""])
      nKeys["a \"b\""]=8
      append(tSlot)
      link(tSlot[0].pPick,fRow[2])
      tSlot[0].pPick.trsf.y=3
      tSlot[1].sName="one"
      resize(tSlot[1].nValues,1,4)
      tSlot[2].nValues[0]=9
      insert(tKeyed["k"])
      tKeyed["k"].sName="keyed"
    end
    --- slot
    public point pPick
    public string sName="none"
    public num nValues[2]
    "#;

#[test]
fn everything_is_read_as_it_was_saved() {
    let text = Cell::new(EVERYTHING).run();
    expect![[""]].assert_eq(&text);
}

#[test]
fn what_has_not_changed_leaves_every_byte() {
    let cell = Cell::new(&EVERYTHING.replace("call all:change()", "nCode=all:libSave()"));
    let before = cell.read("usrapp/all/all.dtx");
    cell.run();
    assert_eq!(cell.read("usrapp/all/all.dtx"), before);
    assert_eq!(cell.read("usrapp/changed/all.dtx"), before);
}

#[test]
fn the_second_save_of_the_same_values_changes_nothing() {
    let cell = Cell::new(&EVERYTHING.replace("? all:libSave(\"changed\")", "? all:libSave(\"changed\")\n  ? all:libSave()"));
    cell.run();
    assert_eq!(cell.read("usrapp/all/all.dtx"), cell.read("usrapp/changed/all.dtx"));
}

#[test]
fn an_application_saves_itself() {
    let cell = Cell::new(
        r#"
        num nRuns
        program start()
        begin
          nRuns=nRuns+1
          ? nRuns
          ? libSave()
        end
        "#,
    );
    assert_eq!([cell.run(), cell.run(), cell.run()], ["1\n0\n", "2\n0\n", "3\n0\n"]);
}

#[test]
fn a_library_saves_the_library_it_is() {
    let cell = Cell::new(
        r#"
        library part "Disk://part/part.pjx"
        num nOwn=1
        program start()
        begin
          nOwn=2
          call part:store()
        end
        --- part
        public num nWeight=1
        public program store()
        begin
          nWeight=7
          ? libSave()
          ? libPath()
        end
        "#,
    );
    assert_eq!(cell.run(), "0\nDisk://part\n");
    assert!(cell.read("usrapp/part/part.dtx").contains(r#"value="7""#));
    assert!(!cell.read("usrapp/main/main.dtx").contains(r#"value="2""#));
}

#[test]
fn a_library_whose_files_were_deleted_can_be_saved() {
    let cell = Cell::new(
        r#"
        library part "Disk://part/part.pjx"
        program start()
        begin
          part:nWeight=7
          ? libDelete("part")
          ? part:libSave("part")
          ? libDelete("part")
          ? part:libSave()
          ? part:libSave("USB0://part")
        end
        --- part
        public num nWeight=1
        "#,
    );
    assert_eq!(cell.run(), "0\n0\n0\n0\n0\n");
    assert!(cell.read("usrapp/part/part.dtx").contains(r#"value="7""#));
    assert_eq!(cell.read("usb/part/part.dtx"), cell.read("usrapp/part/part.dtx"));
}
