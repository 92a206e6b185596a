//! State of the controller (8.1), and additions of CS9 controllers.

use expect_test::expect;
use val3_machine::controller_state::{Licence, WorkingMode};
use val3_machine::devices::Devices;
use val3_tests::running::Running;

#[track_caller]
fn run(prepare: impl FnOnce(&mut Devices), listing: &str) -> String {
    let mut running = Running::start(listing);
    prepare(&mut running.controller.devices);
    running.to_the_end().printed()
}

fn mode(number: u8) -> impl FnOnce(&mut Devices) {
    move |devices| devices.state.robot.set_mode(WorkingMode::from_number(number).unwrap(), 0)
}

#[test]
fn power_comes_on_and_is_waited_for() {
    let example = "  enablePower()\n  ? isPowered()\n  ? watch(isPowered(),5)\n  disablePower()\n  ? isPowered()\n  disablePower()";
    let running = Running::start(example).to_the_end();
    assert_eq!(running.printed(), "false\ntrue\nfalse\n");
    expect![[r#"
        {"t":1.004,"kind":"power","on":true}
        {"t":1.108,"kind":"power","on":false}
    "#]]
    .assert_eq(&running.record());
}

#[test]
fn power_stays_off_in_other_modes_and_the_log_says_why() {
    let mut running = Running::start("  enablePower()\n  ? watch(isPowered(),5)");
    mode(3)(&mut running.controller.devices);
    let running = running.to_the_end();
    assert_eq!(running.printed(), "false\n");
    expect![[r#"
        {"t":0.0,"kind":"mode","mode":3}
        {"t":2e-6,"task":"main~","kind":"log","level":"warning","text":"arm power not switched on: the robot is not in remote mode"}
    "#]].assert_eq(&running.record());
}

#[test]
fn the_mode_comes_with_its_state() {
    let body = "num nStatus\n  ? workingMode()\n  ? workingMode(nStatus)\n  ? nStatus";
    assert_eq!(run(|_| {}, body), "4\n4\n0\n");
    assert_eq!(run(mode(1), body), "1\n1\n6\n");
    assert_eq!(run(mode(0), body), "0\n0\n0\n");
}

#[test]
fn the_emergency_stop_has_three_states() {
    let body = "  ? esStatus()";
    assert_eq!(run(|_| {}, body), "0\n");
    assert_eq!(run(|devices| devices.state.robot.press_emergency_stop(), body), "2\n");
    let released = |devices: &mut Devices| {
        devices.state.robot.press_emergency_stop();
        devices.state.robot.release_emergency_stop();
    };
    assert_eq!(run(released, body), "1\n");
}

#[test]
fn a_safety_fault_names_its_signal() {
    let body = "string sSignal = \"none\"\n  ? safetyFault(sSignal)\n  ? sSignal\n  ? esStatus()\n  ? isCalibrated()";
    assert_eq!(run(|_| {}, body), "false\nnone\n0\ntrue\n");
    let faulty = |devices: &mut Devices| {
        devices.state.robot.set_safety_fault(Some("USEREN1".to_owned()));
        devices.state.robot.set_calibrated(false);
    };
    assert_eq!(run(faulty, body), "true\nUSEREN1\n2\nfalse\n");
}

#[test]
fn the_monitor_speed_has_every_result() {
    let body = "  ? setMonitorSpeed(20)\n  ? setMonitorSpeed(30)\n  ? setMonitorSpeed(101)\n  ? setMonitorSpeed(-1)\n  ? getMonitorSpeed()";
    assert_eq!(run(|_| {}, body), "0\n0\n-3\n-3\n30\n");
    assert_eq!(run(mode(3), body), "0\n-1\n-3\n-3\n20\n");
    let operator = |devices: &mut Devices| {
        devices.state.profiles.change("maintenance", "");
    };
    assert_eq!(run(operator, body), "0\n-2\n-3\n-3\n20\n");
}

#[test]
fn versions_and_licences_are_returned() {
    let body = r#"
          ? getVersion("VAL 3")
          ? getVersion("ArmType")
          ? getVersion("Tuning")
          ? getVersion("Mounting")
          ? getVersion("ControllerSN")
          ? getVersion("ArmSN")
          ? "["+getVersion("Starc")+"]"
          ? getVersion("compliance")
          ? "["+getVersion("nothing")+"]"
        "#;
    expect![[r#"
        s7.11.0 - Jan 01 2024 - 00:00:00
        tx2_90-S1
        R1
        floor
        F24_000001_C_01
        F24_000001_A_01
        []
        enabled
        []
    "#]]
    .assert_eq(&run(|_| {}, body));
    let licence = "  ? \"[\"+getVersion(\"alter\")+\"]\"\n  ? getLicence(\"vision\",\"secret\")\n  ? \"[\"+getLicence(\"vision\",\"x\")+\"]\"";
    let demo = |devices: &mut Devices| {
        devices.state.versions.set_licence("alter", Some(Licence::Demo));
        devices.state.versions.set_oem_licence("vision", "secret", Licence::Enabled);
    };
    assert_eq!(run(demo, licence), "[demo]\nenabled\n[]\n");
    let without = |devices: &mut Devices| {
        devices.state.versions.set_licence("alter", None);
        devices.state.versions.set_licence("oemLicence", None);
    };
    assert_eq!(run(without, licence), "[]\noemLicenceDisabled\n[oemLicenceDisabled]\n");
}

#[test]
fn additions_return_values_set_from_outside() {
    let body = r#"
        version s8.10
        joint jSafe
        num nDone
          ? getSafeRefStatus()
          ? hasCpuExtPowerSupply()
          ? setSafetyRestart()
          ? wakeUpRobot()
          jSafe=getJntRef("safeRef")
          ? jSafe.j2
          opcuaExport(nDone,false)
        "#;
    assert_eq!(run(|_| {}, body), "0\nfalse\nfalse\n0\n0\n");
    let set = |devices: &mut Devices| {
        devices.state.cs9.safe_reference = 3.0;
        devices.state.cs9.external_supply = true;
        devices.state.cs9.accepts_restart = true;
        devices.state.cs9.wake_up = -1.0;
        devices.state.cs9.references.insert("safeRef".to_owned(), vec![1.0, 2.5]);
    };
    assert_eq!(run(set, body), "3\ntrue\ntrue\n-1\n2.5\n");
    assert_eq!(run(|_| {}, "version s5.4\n  ? speedScale()"), "100\n");
}
