//! Effects of scripts.

use expect_test::{Expect, expect};
use val3_machine::script::Script;
use val3_tests::running::Running;

#[track_caller]
fn check(script: &str, listing: &str, expected: Expect) {
    let mut running = Running::start(listing);
    running.controller.follow(Script::parse(script).unwrap());
    let running = running.to_the_end();
    expected.assert_eq(&format!("{}{}", running.printed(), running.record()));
}

#[test]
fn variables_are_set_at_their_time() {
    check(
        r#"
            [[at]]
            t = 2.5
            set = { nCount = 4, "sNames[1]" = "bolt", 'bDone["x"]' = true }

            [[at]]
            t = 1
            set = { nCount = 3 }
        "#,
        r#"
        num nCount
        string sNames[2]
        bool bDone["x"]
          wait(nCount==3)
          ? clock()
          wait(nCount==4)
          ? clock()
          ? sNames[1]
          ? bDone["x"]
        "#,
        expect![[r#"
            1
            2.5
            bolt
            true
            {"t":1.0,"kind":"act","keys":{"set":{"nCount":3.0}}}
            {"t":2.5,"kind":"act","keys":{"set":{"bDone[\"x\"]":true,"nCount":4.0,"sNames[1]":"bolt"}}}
        "#]],
    );
}

#[test]
fn impossible_entries_are_logged() {
    check(
        r#"
            [[at]]
            t = 0
            set = { nNothing = 1, nCount = "four", "nCount[7]" = 1 }
            lock = "Board\\%I7"
            jog = [0, 0, 190]
        "#,
        "num nCount\n  delay(1)\n  ? nCount",
        expect![[r#"
            0
            {"t":0.0,"kind":"act","keys":{"jog":[0.0,0.0,190.0,0.0,0.0,0.0],"lock":"Board\\%I7","set":{"nCount":"four","nCount[7]":1.0,"nNothing":1.0}}}
            {"t":0.0,"kind":"log","level":"error","text":"script, t = 0: no input or output is called `Board\\%I7`"}
            {"t":0.0,"kind":"log","level":"error","text":"script, t = 0: `nCount` is of type num and does not take this value"}
            {"t":0.0,"kind":"log","level":"error","text":"script, t = 0: there is no variable `nCount[7]`"}
            {"t":0.0,"kind":"log","level":"error","text":"script, t = 0: there is no variable `nNothing`"}
            {"t":0.0,"kind":"log","level":"error","text":"script, t = 0: jog: axis 3 would be at 190.000, outside its range from -145 to 145 degrees"}
        "#]],
    );
}

#[test]
fn keys_power_and_modes_come_from_outside() {
    check(
        r#"
            [[at]]
            t = 0.5
            keys = "12{Return}"
            power = true
            monitor_speed = 40
            [[at]]
            t = 1
            key = "F1"
            estop = true
            [[at]]
            t = 2
            estop = false
            mode = "manual"
        "#,
        r#"
        num nValue
          ? get(nValue)
          ? nValue
          ? getMonitorSpeed()
          ? get()
          ? esStatus()
          delay(2)
          ? workingMode()
          ? esStatus()
        "#,
        expect![[r#"
            270
            12
            40
            271
            2
            1
            1
            {"t":2e-6,"task":"main~","kind":"put","screen":"","x":0,"y":0,"text":"0"}
            {"t":0.5,"kind":"act","keys":{"keys":"12{Return}","monitor_speed":40.0,"power":true}}
            {"t":0.5,"kind":"put","screen":"","x":0,"y":0,"text":"1"}
            {"t":0.5,"kind":"power","on":true}
            {"t":0.504,"kind":"put","screen":"","x":0,"y":0,"text":"12"}
            {"t":0.508,"kind":"put","screen":"","x":0,"y":0,"text":"12"}
            {"t":1.0,"kind":"act","keys":{"estop":true,"key":271}}
            {"t":1.0,"kind":"power","on":false}
            {"t":2.0,"kind":"act","keys":{"estop":false,"mode":"manual"}}
            {"t":2.0,"kind":"mode","mode":1}
        "#]],
    );
}

#[test]
fn a_script_stops_the_application() {
    check(
        "[[at]]\nt = 3\nstop = true",
        r#"
        num n
        program start()
        begin
          while true
            delay(1)
            n=n+1
          endWhile
        end
        program stop()
        begin
          ? n
          ? clock()
        end
        "#,
        expect![[r#"
            2
            3
            {"t":3.0,"kind":"act","keys":{"stop":true}}
        "#]],
    );
}

#[test]
fn inputs_outputs_and_faults_are_scripted() {
    check(
        r#"
            [[at]]
            t = 1
            io = { "Board\\%I0" = true, "Board\\%IW2" = 3.6 }
            [[at]]
            t = 2
            lock = { "Board\\%I0" = false }
            [[at]]
            t = 3
            unlock = "Board\\%I0"
            [[at]]
            t = 4
            fault = { link = "Board\\%I0", code = -3 }
            [[at]]
            t = 5
            fault = { link = "Board\\%I0", code = 0 }
            [[at]]
            t = 6
            fault = { link = "Board", code = 17 }
        "#,
        r#"
        num n
        string sFaults[1]
          for n=1 to 6
            delay(1)
            ? toString("",n)+" "+toString("",ioStatus(diIn))
            ioBusStatus(sFaults)
            ? sFaults[0]
          endFor
        === main/main.dtx
        <?xml version="1.0" encoding="utf-8"?>
        <Database xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance" xmlns="http://www.staubli.com/robotics/VAL3/Data/2">
          <Datas>
            <Data name="diIn" access="private" xsi:type="array" type="dio" size="1"><Value key="0" link="Board\%I0" /></Data>
            <Data name="aiIn" access="private" xsi:type="array" type="aio" size="1"><Value key="0" link="Board\%IW2" /></Data>
            <Data name="n" access="private" xsi:type="array" type="num" size="1" />
            <Data name="sFaults" access="private" xsi:type="array" type="string" size="1" />
          </Datas>
        </Database>
        "#,
        expect![[r#"
            1 0

            2 1

            3 0

            4 -3
            -3:Board
            5 0
            -3:Board
            6 -3
            17:Board
            {"t":1.0,"kind":"act","keys":{"io":{"Board\\%I0":true,"Board\\%IW2":3.6}}}
            {"t":1.0,"kind":"io","link":"Board\\%I0","value":1.0}
            {"t":1.0,"kind":"io","link":"Board\\%IW2","value":4.0}
            {"t":2.0,"kind":"act","keys":{"lock":{"Board\\%I0":false}}}
            {"t":2.0,"kind":"io","link":"Board\\%I0","value":0.0}
            {"t":3.0,"kind":"act","keys":{"unlock":"Board\\%I0"}}
            {"t":3.0,"kind":"io","link":"Board\\%I0","value":1.0}
            {"t":4.0,"kind":"act","keys":{"fault":{"code":-3,"link":"Board\\%I0"}}}
            {"t":5.0,"kind":"act","keys":{"fault":{"code":0,"link":"Board\\%I0"}}}
            {"t":6.0,"kind":"act","keys":{"fault":{"code":17,"link":"Board"}}}
        "#]],
    );
}

#[test]
fn the_safety_circuit_calibration_and_simulation_come_from_outside() {
    check(
        r#"
            [[at]]
            t = 1
            safety_fault = "DOOR"
            calibrated = false
            simulate = { "Board\\%Q0" = true, "Board\\none" = true }
            [[at]]
            t = 2
            safety_fault = false
            calibrated = true
            simulate = { "Board\\%Q0" = false }
        "#,
        r#"
        num n
          for n=0 to 2
            ? safetyFault(sSignal)
            ? sSignal
            ? esStatus()
            ? isCalibrated()
            ? ioStatus(doOut)
            doOut=(n==1)
            delay(1)
          endFor
        === main/main.dtx
        <?xml version="1.0" encoding="utf-8"?>
        <Database xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance" xmlns="http://www.staubli.com/robotics/VAL3/Data/2">
          <Datas>
            <Data name="doOut" access="private" xsi:type="array" type="dio" size="1"><Value key="0" link="Board\%Q0" /></Data>
            <Data name="n" access="private" xsi:type="array" type="num" size="1" />
            <Data name="sSignal" access="private" xsi:type="array" type="string" size="1" />
          </Datas>
        </Database>
        "#,
        expect![[r#"
            false

            0
            true
            0
            true
            DOOR
            2
            false
            2
            false
            DOOR
            0
            true
            0
            {"t":1.0,"kind":"act","keys":{"calibrated":false,"safety_fault":"DOOR","simulate":{"Board\\%Q0":true,"Board\\none":true}}}
            {"t":1.0,"kind":"log","level":"error","text":"script, t = 1: no input or output is called `Board\\none`"}
            {"t":2.0,"kind":"act","keys":{"calibrated":true,"safety_fault":false,"simulate":{"Board\\%Q0":false}}}
        "#]],
    );
}
