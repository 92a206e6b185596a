//! Files that `libSave` writes and `libLoad` reads again (6.7).

use expect_test::expect;

use crate::cell::{Cell, run, shown};

/// A library with data of all types and containers, and a program for each of the two runs.
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
      if isDefined(nKeys["a <b>"])
        ? nKeys["a <b>"]
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
      fRow[0]=fRow[1]
      pA=pB
      pA.trsf.x=0.1
      pA.config.shoulder=righty
      tA.trsf.z=-1.5
      tA.otime=0.25
      jA={1,2,3,4,5,6.5}
      cA.wrist=wnegative
      mA={50,60,70,250,90,Cartesian,10,20}
      trA.rz=1e-7
      bA=true
      sA="<a> & 'b'"
      nGrid[1,2]=12
      resize(nGrid,1,4)
      nCube[1,0,1]=101
      insert(nKeys["a <b>"])
      nKeys["a <b>"]=8
      append(tSlot)
      tSlot[0].pPick=pB
      tSlot[0].pPick.trsf.y=3
      tSlot[1].sName="one"
      resize(tSlot[1].nValues,1,4)
      tSlot[2].nValues[0]=9
      insert(tKeyed["k"])
      tKeyed["k"].sName="keyed"
    end
    --- slot
    === all/all.dtx
    <?xml version="1.0" encoding="utf-8"?>
    <Database xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance" xmlns="http://www.staubli.com/robotics/VAL3/Data/2">
      <Datas>
        <Data name="aA" access="public" xsi:type="array" type="aio" size="1" />
        <Data name="bA" access="public" xsi:type="array" type="bool" size="1" />
        <Data name="cA" access="public" xsi:type="array" type="configRx" size="1" />
        <Data name="dA" access="public" xsi:type="array" type="dio" size="1">
          <Value key="0" link="BasicIO-1\%Q0" />
        </Data>
        <Data name="dRow" access="public" xsi:type="collection" type="dio">
          <Value key="door" link="BasicIO-1\%I0" />
          <Value key="none" />
        </Data>
        <Data name="fA" access="public" xsi:type="array" type="frame" size="1">
          <Value key="0" fatherId="world[0]" />
        </Data>
        <Data name="fRow" access="public" xsi:type="array" type="frame" size="3">
          <Value key="0" fatherId="world[0]" />
          <Value key="1" x="5" fatherId="fA[0]" />
        </Data>
        <Data name="jA" access="public" xsi:type="array" type="jointRx" size="1" />
        <Data name="mA" access="public" xsi:type="array" type="mdesc" size="1" />
        <Data name="nCube" access="public" xsi:type="array" type="num" size="2 2 2" />
        <Data name="nGrid" access="public" xsi:type="array" type="num" size="2 3">
          <Value key="0,1" value="1" />
        </Data>
        <Data name="nKeys" access="public" xsi:type="collection" type="num" />
        <Data name="pA" access="public" xsi:type="array" type="pointRx" size="1">
          <Value key="0" fatherId="world[0]" />
        </Data>
        <Data name="pB" access="public" xsi:type="array" type="pointRx" size="1">
          <Value key="0" y="2" fatherId="tSlot[1].fIn[0]" />
        </Data>
        <Data name="sA" access="public" xsi:type="array" type="string" size="1" />
        <Data name="siA" access="public" xsi:type="array" type="sio" size="1">
          <Value key="0" link="Socket\host" />
        </Data>
        <Data name="siB" access="public" xsi:type="array" type="sio" size="1" />
        <Data name="tA" access="public" xsi:type="array" type="tool" size="1">
          <Value key="0" fatherId="flange[0]" ioLink="valve1" />
        </Data>
        <Data name="tKeyed" access="public" xsi:type="collection" type="Slot" />
        <Data name="tSlot" access="public" xsi:type="array" type="Slot" size="2">
          <Value key="1">
            <Field name="sName" xsi:type="array" type="string" size="1">
              <Value key="0" value="first" />
            </Field>
          </Value>
        </Data>
        <Data name="trA" access="public" xsi:type="array" type="trsf" size="1" />
      </Datas>
    </Database>
    === slot/slot.dtx
    <?xml version="1.0" encoding="utf-8"?>
    <Database xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance" xmlns="http://www.staubli.com/robotics/VAL3/Data/2">
      <Datas>
        <Data name="fIn" access="public" xsi:type="array" type="frame" size="1">
          <Value key="0" fatherId="world[0]" />
        </Data>
        <Data name="nValues" access="public" xsi:type="array" type="num" size="2" />
        <Data name="pPick" access="public" xsi:type="array" type="pointRx" size="1">
          <Value key="0" fatherId="fIn[0]" />
        </Data>
        <Data name="sName" access="public" xsi:type="array" type="string" size="1">
          <Value key="0" value="none" />
        </Data>
      </Datas>
    </Database>
    "#;

#[test]
fn everything_is_read_as_it_was_saved() {
    let cell = Cell::new(EVERYTHING);
    expect![[r#"
        {{0,0,0,0,0,0}}
        {{0,0,0,0,0,0},{ssame,esame,wsame}}
        {{0,0,0,0,0,0},,0,0}
        {0,0,0,0,0,0}
        {ssame,esame,wsame}
        {100,100,100,99999,99999,joint,50,50}
        {0,0,0,0,0,0}
        false

        0
        0
        0
        0
        2
        {{0,0,0,0,0,0},{ssame,esame,wsame}}
        first
        2
        0
        0
        0
        0
        {{1,2,3,4,5,6}}
        {{0.1,2,0,0,0,0},{righty,esame,wsame}}
        {{0,0,-1.5,0,0,0},,0.25,0}
        {1,2,3,4,5,6.5}
        {ssame,esame,wnegative}
        {50,60,70,250,90,Cartesian,10,20}
        {0,0,0,0,0,1e-7}
        true
        <a> & 'b'
        12
        0
        101
        1
        8
        3
        {{0,3,0,0,0,0},{ssame,esame,wsame}}
        one
        4
        9
        1
        keyed
    "#]]
    .assert_eq(&cell.run());
    expect![[r#"
        <?xml version="1.0" encoding="utf-8"?>
        <Database xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance" xmlns="http://www.staubli.com/robotics/VAL3/Data/2">
          <Datas>
            <Data name="aA" access="public" xsi:type="array" type="aio" size="1" />
            <Data name="bA" access="public" xsi:type="array" type="bool" size="1">
              <Value key="0" value="true" />
            </Data>
            <Data name="cA" access="public" xsi:type="array" type="configRx" size="1">
              <Value key="0" wrist="wnegative" />
            </Data>
            <Data name="dA" access="public" xsi:type="array" type="dio" size="1">
              <Value key="0" link="BasicIO-1\%Q0" />
            </Data>
            <Data name="dRow" access="public" xsi:type="collection" type="dio">
              <Value key="door" link="BasicIO-1\%I0" />
              <Value key="none" />
            </Data>
            <Data name="fA" access="public" xsi:type="array" type="frame" size="1">
              <Value key="0" x="1" y="2" z="3" rx="4" ry="5" rz="6" fatherId="world[0]" />
            </Data>
            <Data name="fRow" access="public" xsi:type="array" type="frame" size="3">
              <Value key="0" x="5" fatherId="fA[0]" />
              <Value key="1" x="5" fatherId="fA[0]" />
            </Data>
            <Data name="jA" access="public" xsi:type="array" type="jointRx" size="1">
              <Value key="0" j1="1" j2="2" j3="3" j4="4" j5="5" j6="6.5" />
            </Data>
            <Data name="mA" access="public" xsi:type="array" type="mdesc" size="1">
              <Value key="0" accel="50" vel="60" decel="70" tmax="250" rmax="90" blend="cartesian" leave="10" reach="20" />
            </Data>
            <Data name="nCube" access="public" xsi:type="array" type="num" size="2 2 2">
              <Value key="1,0,1" value="101" />
            </Data>
            <Data name="nGrid" access="public" xsi:type="array" type="num" size="4 3">
              <Value key="0,1" value="1" />
              <Value key="1,2" value="12" />
            </Data>
            <Data name="nKeys" access="public" xsi:type="collection" type="num">
              <Value key="a &lt;b&gt;" value="8" />
            </Data>
            <Data name="pA" access="public" xsi:type="array" type="pointRx" size="1">
              <Value key="0" x="0.1" y="2" shoulder="righty" fatherId="tSlot[1].fIn[0]" />
            </Data>
            <Data name="pB" access="public" xsi:type="array" type="pointRx" size="1">
              <Value key="0" y="2" fatherId="tSlot[1].fIn[0]" />
            </Data>
            <Data name="sA" access="public" xsi:type="array" type="string" size="1">
              <Value key="0" value="&lt;a&gt; &amp; 'b'" />
            </Data>
            <Data name="siA" access="public" xsi:type="array" type="sio" size="1">
              <Value key="0" link="Socket\host" />
            </Data>
            <Data name="siB" access="public" xsi:type="array" type="sio" size="1" />
            <Data name="tA" access="public" xsi:type="array" type="tool" size="1">
              <Value key="0" z="-1.5" fatherId="flange[0]" ioLink="valve1" ioOpen="0.25" />
            </Data>
            <Data name="tKeyed" access="public" xsi:type="collection" type="Slot">
              <Value key="k">
                <Field name="fIn" xsi:type="array" type="frame" size="1" />
                <Field name="nValues" xsi:type="array" type="num" size="2" />
                <Field name="pPick" xsi:type="array" type="pointRx" size="1" />
                <Field name="sName" xsi:type="array" type="string" size="1">
                  <Value key="0" value="keyed" />
                </Field>
              </Value>
            </Data>
            <Data name="tSlot" access="public" xsi:type="array" type="Slot" size="3">
              <Value key="0">
                <Field name="fIn" xsi:type="array" type="frame" size="1" />
                <Field name="nValues" xsi:type="array" type="num" size="2" />
                <Field name="pPick" xsi:type="array" type="pointRx" size="1">
                  <Value key="0" y="3" fatherId="tSlot[1].fIn[0]" />
                </Field>
                <Field name="sName" xsi:type="array" type="string" size="1">
                  <Value key="0" value="none" />
                </Field>
              </Value>
              <Value key="1">
                <Field name="sName" xsi:type="array" type="string" size="1">
                  <Value key="0" value="one" />
                </Field>
                <Field name="nValues" xsi:type="array" type="num" size="4" />
              </Value>
              <Value key="2">
                <Field name="fIn" xsi:type="array" type="frame" size="1" />
                <Field name="nValues" xsi:type="array" type="num" size="2">
                  <Value key="0" value="9" />
                </Field>
                <Field name="pPick" xsi:type="array" type="pointRx" size="1" />
                <Field name="sName" xsi:type="array" type="string" size="1">
                  <Value key="0" value="none" />
                </Field>
              </Value>
            </Data>
            <Data name="trA" access="public" xsi:type="array" type="trsf" size="1">
              <Value key="0" rz="1e-7" />
            </Data>
          </Datas>
        </Database>"#]].assert_eq(&cell.read("usrapp/changed/all.dtx"));
}

#[test]
fn unchanged_data_keep_every_byte() {
    let cell = Cell::new(&EVERYTHING.replace("call all:change()", "? libSave()"));
    let before = cell.read("usrapp/all/all.dtx");
    cell.run();
    assert_eq!(cell.read("usrapp/all/all.dtx"), before);
    assert_eq!(cell.read("usrapp/changed/all.dtx"), before);
}

#[test]
fn the_second_save_of_the_same_values_changes_nothing() {
    let cell = Cell::new(
        &EVERYTHING.replace("? all:libSave(\"changed\")", "? all:libSave(\"changed\")\n      ? all:libSave()"),
    );
    cell.run();
    assert_eq!(cell.read("usrapp/all/all.dtx"), cell.read("usrapp/changed/all.dtx"));
}

#[test]
fn too_much_data_for_a_medium_are_not_saved() {
    for (bytes, code) in [(100_000, "0\n"), (500, "38\n")] {
        let cell = Cell::new("num nA[100]\nprogram start()\nbegin\n? libSave()\nend\n");
        let mut controller = cell.controller();
        controller.devices.limits.saved = bytes;
        assert_eq!(shown(&run(&mut controller, |_| {})), code, "{bytes}");
    }
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
