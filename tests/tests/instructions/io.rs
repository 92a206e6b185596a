//! Inputs and outputs (3.5, 3.6, 8.1).

use expect_test::{Expect, expect};
use val3_lang::types::BaseType;
use val3_machine::devices::Devices;
use val3_machine::io::{Direction, Signal, SignalFault, SignalKind, SignalRange};
use val3_tests::running::Running;

/// Data with links: `diSignals` to outputs 0 to 3 of `Io`, other data to the signals that their names describe.
const DATA: &str = r#"
=== main/main.dtx
<?xml version="1.0" encoding="utf-8"?>
<Database xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance" xmlns="http://www.staubli.com/robotics/VAL3/Data/2">
  <Datas>
    <Data name="doBits" access="private" xsi:type="array" type="dio" size="4">
      <Value key="0" link="Io\%Q0" /><Value key="1" link="Io\%Q1" /><Value key="2" link="Io\%Q2" /><Value key="3" link="Io\%Q3" />
    </Data>
    <Data name="diInput" access="private" xsi:type="array" type="dio" size="1"><Value key="0" link="Io\%I0" /></Data>
    <Data name="doSystem" access="private" xsi:type="array" type="dio" size="1"><Value key="0" link="Io\system" /></Data>
    <Data name="diMissing" access="private" xsi:type="array" type="dio" size="1"><Value key="0" link="Io\%I99" /></Data>
    <Data name="diNone" access="private" xsi:type="array" type="dio" size="1" />
    <Data name="aiFloat" access="private" xsi:type="array" type="aio" size="1"><Value key="0" link="Io\float" /></Data>
    <Data name="aiByte" access="private" xsi:type="array" type="aio" size="1"><Value key="0" link="Io\byte" /></Data>
    <Data name="aiNone" access="private" xsi:type="array" type="aio" size="1" />
    <Data name="sText" access="private" xsi:type="array" type="string" size="1" />
    <Data name="sPath" access="private" xsi:type="array" type="string" size="1" />
    <Data name="sFaults" access="private" xsi:type="array" type="string" size="1" />
  </Datas>
</Database>
"#;

fn signal(path: &str, kind: SignalKind, direction: Direction, protected: bool) -> Signal {
    Signal { path: path.to_owned(), description: format!("the {path}"), kind, direction, protected }
}

fn devices() -> Devices {
    let mut devices = Running::devices();
    devices.state.io.declare_device("Io", ["%Q0", "%Q1", "%Q2", "%Q3", "%I0"].map(|name| (name, BaseType::Dio)));
    devices.state.io.declare(signal("Io\\system", SignalKind::Digital, Direction::Output, true));
    devices.state.io.declare(signal("Io\\float", SignalKind::Analog(SignalRange::Float), Direction::Output, false));
    let byte = SignalRange::Whole { lowest: 0.0, highest: 255.0 };
    devices.state.io.declare(signal("Io\\byte", SignalKind::Analog(byte), Direction::Output, false));
    devices
}

/// Runs after `prepare` has changed the devices.
#[track_caller]
fn run(prepare: impl FnOnce(&mut Devices), body: &str) -> Running {
    let mut running = Running::on(devices(), &format!("{body}\n{DATA}"));
    prepare(&mut running.controller.devices);
    running.for_seconds(10)
}

#[track_caller]
fn check(body: &str, expected: Expect) {
    expected.assert_eq(&run(|_| {}, body).printed());
}

#[test]
fn signals_are_read_and_written_as_binary_numbers() {
    check(
        "  doBits[0]=false\n  doBits[1]=true\n  doBits[2]=false\n  doBits[3]=true\n  ? dioGet(doBits)\n  ? dioGet(doBits[1])",
        expect![[r#"
            10
            5
        "#]],
    );
    check(
        "  ? dioSet(doBits,10)\n  ? dioSet(doBits,26)\n  ? dioSet(doBits,3.9)\n  ? dioSet(doBits[2],3)\n  ? dioGet(doBits)",
        expect![[r#"
        10
        10
        3
        3
        15
    "#]],
    );
}

#[test]
fn outputs_are_recorded_at_the_end_of_the_cycle() {
    expect![[r#"
        {"t":0.004,"kind":"io","link":"Io\\%Q1","value":1.0}
        {"t":0.004,"kind":"io","link":"Io\\%Q3","value":1.0}
        {"t":0.004,"kind":"io","link":"Io\\float","value":-12.3}
    "#]]
    .assert_eq(&run(|_| {}, "  dioSet(doBits,10)\n  aioSet(aiFloat,-12.3)").record());
}

#[test]
fn an_analog_output_returns_its_value() {
    check(
        "  ? aioSet(aiFloat,-12.3)\n  ? aioGet(aiFloat)\n  ? aioSet(aiByte,12.3)\n  ? aioSet(aiByte,300)\n  ? aioGet(aiByte)",
        expect![[r#"
        -12.3
        -12.3
        12
        255
        255
    "#]],
    );
}

#[test]
fn each_misuse_has_its_error() {
    let error = |line: &str| run(|_| {}, line).printed();
    assert_eq!(error("  diInput=true"), "error 122\n");
    assert_eq!(error("  ? diNone==true"), "error 123\n");
    assert_eq!(error("  ? dioGet(diNone)"), "error 123\n");
    assert_eq!(error("  ? dioGet(diMissing)"), "error 123\n");
    assert_eq!(error("  ? dioSet(diInput,1)"), "error 122\n");
    assert_eq!(error("  ? dioSet(doSystem,1)"), "error 124\n");
    assert_eq!(error("  ? aioGet(aiNone)"), "error 123\n");
    assert_eq!(error("  ? aioSet(aiNone,1)"), "error 123\n");
    let failed = |line: &str| run(|devices| devices.state.io.set_device_fault("Io", Some(5)), line).printed();
    assert_eq!(failed("  ? aioGet(aiFloat)"), "error 125\n");
    assert_eq!(failed("  ? dioSet(doBits,1)"), "error 125\n");
}

#[test]
fn a_variable_takes_the_link_of_another() {
    check(
        "  dioLink(diNone,doBits[2])\n  diNone=true\n  ? dioGet(doBits)\n  aioLink(aiNone,aiByte)\n  ? aioSet(aiNone,1.6)",
        expect![[r#"
        4
        2
    "#]],
    );
    check(
        r#"
          if (ioStatus(diMissing)>=0)
            dioLink(diNone,diMissing)
          elseIf (ioStatus(diInput)>=0)
            dioLink(diNone,diInput)
          else
            ? "no io device installed"
          endIf
          ioStatus(diNone,sText,sPath)
          ? sPath
        "#,
        expect![[r#"
            Io\%I0
        "#]],
    );
}

#[test]
fn the_status_shows_whether_a_signal_works() {
    check(
        "  ? ioStatus(diInput)\n  ? ioStatus(diNone)\n  ? ioStatus(diMissing)\n  ? ioStatus(aiNone)\n  ? ioStatus(aiFloat)",
        expect![[r#"
        0
        -1
        -2
        -1
        0
    "#]],
    );
    let id = |devices: &Devices| devices.state.io.find("Io\\float").unwrap();
    let status = |prepare: &dyn Fn(&mut Devices)| run(prepare, "  ? ioStatus(aiFloat)").printed();
    assert_eq!(status(&|devices| devices.state.io.lock(id(devices), None)), "1\n");
    assert_eq!(status(&|devices| devices.state.io.simulate(id(devices), true)), "2\n");
    assert_eq!(status(&|devices| devices.state.io.set_fault(id(devices), Some(SignalFault::Absent))), "-2\n");
    assert_eq!(status(&|devices| devices.state.io.set_fault(id(devices), Some(SignalFault::Failed))), "-3\n");
}

#[test]
fn the_status_comes_with_description_and_path() {
    check(
        "  ? ioStatus(aiFloat,sText,sPath)\n  ? sText\n  ? sPath\n  ? ioStatus(diMissing,sText,sPath)\n  ? sText\n  ? sPath",
        expect![[r#"
            0
            the Io\float
            Io\float
            -2

            Io\%I99
        "#]],
    );
}

#[test]
fn a_locked_output_keeps_its_value_and_a_locked_input_hides_the_hardware() {
    let lock = |devices: &mut Devices| {
        let [output, input] = ["Io\\float", "Io\\%I0"].map(|path| devices.state.io.find(path).unwrap());
        devices.state.io.lock(output, Some(7.0));
        devices.state.io.lock(input, Some(1.0));
        devices.state.io.set(input, 0.0);
    };
    assert_eq!(run(lock, "  ? aioSet(aiFloat,3)\n  ? diInput==true").printed(), "7\ntrue\n");
}

#[test]
fn failed_devices_are_counted_and_described() {
    assert_eq!(run(|_| {}, "  ? ioBusStatus(sFaults)").printed(), "0\n");
    let fail = |devices: &mut Devices| {
        devices.state.io.set_device_fault("J207\\Box1", Some(12));
        devices.state.io.set_device_fault("Io", Some(5));
    };
    let body = "  ? ioBusStatus(sFaults)\n  ? size(sFaults)\n  ? sFaults[0]\n  ? sFaults[1]";
    expect![[r#"
        2
        2
        5:Io
        12:J207\Box1
    "#]]
    .assert_eq(&run(fail, body).printed());
    let local = "program start()\n  string l_sFaults[1]\nbegin\n  ? ioBusStatus(l_sFaults)\n  ? size(l_sFaults)\n  ? l_sFaults[0]\nend";
    expect![[r#"
        2
        1
        5:Io
    "#]]
    .assert_eq(&run(fail, local).printed());
}
