//! Files of programs: the file instructions of add-ons.

use expect_test::expect;

use val3_machine::controller::RunStatus;
use val3_machine::event::EventKind;

use crate::cell::Cell;

#[test]
fn lines_are_written_and_read() {
    let cell = Cell::new(
        r#"
        num nFile
        string sLines[3]
        program start()
        begin
          nFile=$fileOpen("./log.txt","w")
          ? nFile
          sLines[0]="one"
          sLines[1]="two"
          ? $fileSet(nFile,sLines,2)
          ? $fileClose(nFile)
          ? $fileClose(nFile)
          nFile=$fileOpen("Disk://main/LOG.txt","r")
          ? $fileGet(nFile,sLines,9)
          ? sLines[1]
          ? $fileGet(nFile,sLines,1)
          $fileClose(nFile)
          nFile=$fileOpen("./log.txt","a")
          sLines[0]="three"
          $fileSet(nFile,sLines,1)
          $fileClose(nFile)
          ? $fileOpen("none.txt","r")
          ? $fileOpen("Nowhere://x","w")
          ? $fileOpen("x","x")
        end
        "#,
    );
    expect![[r#"
        0
        2
        0
        -1
        2
        two
        0
        -1
        -1
        -1
    "#]]
    .assert_eq(&cell.run());
    assert_eq!(cell.read("usrapp/main/log.txt"), "one\ntwo\nthree\n");
}

#[test]
fn bytes_are_written_and_read() {
    let cell = Cell::new(
        r#"
        num nFile
        num nBytes[4]
        program start()
        begin
          nBytes[0]=65
          nBytes[1]=256+66
          nBytes[2]=66.6
          nFile=$fileOpen("USB0://raw.bin","w")
          ? $fileSet(nFile,nBytes,3)
          $fileClose(nFile)
          nFile=$fileOpen("USB0://raw.bin","r")
          ? $fileGet(nFile,nBytes[2],1)
          ? nBytes[2]
          ? $fileGet(nFile,nBytes,4)
          ? nBytes[1]
          $fileClose(nFile)
          ? $fileGet(nFile,nBytes,4)
          ? $fileSet(-1,nBytes,4)
        end
        "#,
    );
    assert_eq!(cell.run(), "3\n1\n65\n2\n67\n0\n0\n");
    assert_eq!(cell.read("usb/raw.bin"), "ABC");
}

#[test]
fn files_are_copied_moved_and_deleted() {
    let cell = Cell::new(
        r#"
        program start()
        begin
          ? $fileExists("data/a.txt")
          ? $copy("data/a.txt","USB0://a.txt")
          ? $rename("data/a.txt","data/b.txt")
          ? $fileExists("data/a.txt")
          ? $delete("data/b.txt")
          ? $delete("data/b.txt")
          ? $copy("data/a.txt","data/c.txt")
          ? $fileExists("Nowhere://a")
          ? $delete("data")
          ? $delete("Disk://")
        end
        "#,
    );
    cell.write("usrapp/data/a.txt", "a");
    assert_eq!(cell.run(), "true\ntrue\ntrue\nfalse\ntrue\nfalse\nfalse\nfalse\ntrue\nfalse\n");
    assert_eq!(cell.read("usb/a.txt"), "a");
    assert!(!cell.path("usrapp/data").exists());
}

/// The cell's table may declare `void` and a single variable where the catalogue has a number and an array.
#[test]
fn the_table_of_a_cell_may_have_other_forms() {
    let cell = Cell::new(
        r#"
        num nFile
        string sLine[2]
        program start()
        begin
          nFile=$fileOpen("./log.txt","w")
          sLine[1]="second"
          ? $fileSet(nFile,sLine[1],1)
          $fileClose(nFile)
        end
        === /app/val3.Expansion.anthro.cfx
        <?xml version="1.0" encoding="utf-8"?>
        <Language xmlns="http://www.staubli.com/robotics/VAL3/1">
          <Version>s7.8</Version>
          <Functions>
            <Func><Name>$fileOpen</Name><Return>num</Return>
              <Param index="0" type="string" dataRef="false" array="false" arrayDim="0" />
              <Param index="1" type="string" dataRef="false" array="false" arrayDim="0" />
              <Lib>false</Lib><Class>Function</Class></Func>
            <Func><Name>$fileSet</Name><Return>num</Return>
              <Param index="0" type="num" dataRef="false" array="false" arrayDim="0" />
              <Param index="1" type="string" dataRef="true" array="false" arrayDim="0" />
              <Param index="2" type="num" dataRef="false" array="false" arrayDim="0" />
              <Lib>false</Lib><Class>Modifier</Class></Func>
            <Func><Name>$fileClose</Name><Return>void</Return>
              <Param index="0" type="num" dataRef="false" array="false" arrayDim="0" />
              <Lib>false</Lib><Class>Modifier</Class></Func>
          </Functions>
        </Language>
        "#,
    );
    assert_eq!(cell.run(), "1\n");
    assert_eq!(cell.read("usrapp/main/log.txt"), "second\n");
}

#[test]
fn the_old_forms_of_insert_and_delete() {
    let cell = Cell::new(
        r#"
        num nRow[2]
        program start()
        begin
          nRow[0]=1
          nRow[1]=2
          $dins(nRow,1)
          ? size(nRow)
          ? nRow[2]
          $ddel(nRow,0)
          ? nRow[1]
          $ddel(nRow,9)
        end
        "#,
    );
    assert_eq!(cell.run(), "3\n2\n2\nerror 20 in start\n");
}

/// Access to a medium uses controller time, so a loop of accesses reaches the time limit. Other tasks run meanwhile.
#[test]
fn access_takes_time() {
    let cell = Cell::new(
        r#"
        num nFile
        num nStart
        num nTicks
        string sLines[1]
        program tick()
        begin
          while true
            nTicks=nTicks+1
            delay(0.004)
          endWhile
        end
        program start()
        begin
          taskCreate "tick",10,tick()
          nStart=clock()
          nFile=$fileOpen("./log.txt","w")
          ? clock()-nStart
          nStart=clock()
          for nTicks=0 to 9
            $fileSet(nFile,sLines,1)
          endFor
          $fileClose(nFile)
          ? clock()-nStart
          nTicks=0
          nStart=clock()
          ? libSave("./copy")
          ? clock()-nStart>=0.008
          ? nTicks>=2
          taskKill("tick")
        end
        "#,
    );
    expect![[r#"
        0.004
        0.001
        0
        true
        true
    "#]]
    .assert_eq(&cell.run());
}

/// While the interrupt is set, control returns to the caller after each instruction.
#[test]
fn an_interrupt_ends_the_cycle_after_the_instruction() {
    let cell = Cell::new(
        r#"
        program start()
        begin
          while true
            ? "x"
          endWhile
        end
        "#,
    );
    let mut controller = cell.controller();
    controller.step();
    assert!(controller.devices.take_events().len() > 500);
    controller.devices.interrupt.store(true, std::sync::atomic::Ordering::Relaxed);
    for _ in 0..3 {
        let before = controller.now();
        controller.step();
        assert_eq!(controller.devices.take_events().len(), 1);
        assert!(controller.now() > before && controller.now() - before < 10_000);
    }
}

/// A loop that writes to an open file, 40 times in a cycle.
const WRITING: &str = r#"
    num nFile
    string sLines[1]
    bool bLate
    program write()
    begin
      nFile=$fileOpen("./log.txt","w")
      while true
        $fileSet(nFile,sLines,1)
        ? "written"
      endWhile
    end
    "#;

/// Checks that the limit ends a run after the access that reaches it, not at the end of the cycle.
#[track_caller]
fn stops_at_its_limit(start: &str) {
    const LIMIT: u64 = 9_000_000;
    let cell = Cell::new(&format!("{WRITING}program start()\nbegin\n{start}\nend\n"));
    let mut controller = cell.controller();
    controller.set_limit(Some(LIMIT));
    while controller.step() != RunStatus::Limit {}
    let written =
        controller.devices.take_events().iter().filter(|event| matches!(event.kind, EventKind::Print { .. })).count();
    assert!((LIMIT..LIMIT + 200_000).contains(&controller.now()), "{}", controller.now());
    assert!((9..50).contains(&written), "{written}");
    controller.set_limit(Some(2 * LIMIT));
    while controller.step() != RunStatus::Limit {}
    assert!(controller.now() >= 2 * LIMIT);
}

#[test]
fn the_limit_of_a_run_ends_a_loop_of_file_accesses() {
    stops_at_its_limit("call write()");
}

#[test]
fn the_limit_of_a_run_ends_a_synchronous_task() {
    stops_at_its_limit("taskCreateSync \"sync\",0.004,bLate,write()");
}

/// A synchronous task waits for a medium, so its period is too short.
#[test]
fn access_in_a_synchronous_task() {
    let cell = Cell::new(
        r#"
        num nFile
        num nRuns
        bool bLate
        program sync()
        begin
          while nRuns<3
            nRuns=nRuns+1
            ? $fileExists("./none.txt")
            ? bLate
            delay(0)
          endWhile
        end
        program start()
        begin
          taskCreateSync "sync",0.004,bLate,sync()
          wait(taskStatus("sync")==-1)
        end
        "#,
    );
    let printed = cell.run();
    assert_eq!(
        printed.lines().filter(|line| *line == "false").count()
            + printed.lines().filter(|line| *line == "true").count(),
        6,
        "{printed}"
    );
    assert!(printed.contains("true"), "{printed}");
}
