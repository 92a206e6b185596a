use super::super::power::POWER_OFF_TIME;
use super::*;

fn powered() -> Robot {
    let mut robot = Robot::default();
    robot.set_power(true);
    robot.take_events();
    robot
}

fn in_mode(number: u8) -> Robot {
    let mut robot = Robot::default();
    robot.set_mode(WorkingMode::from_number(number).unwrap(), 0);
    robot.take_events();
    robot
}

#[test]
fn the_example_of_enabling_power() {
    let mut robot = Robot::default();
    assert_eq!(robot.enable_power(0), PowerRequest::Started);
    robot.advance(POWER_ON_TIME - 1, true);
    assert!(!robot.is_powered());
    robot.advance(robot.next_due().unwrap(), true);
    assert!(robot.is_powered());
    const { assert!(POWER_ON_TIME < 5_000_000_000, "the example watches for 5 s") };
    assert_eq!(robot.take_events(), [RobotEvent::Power(true)]);
}

#[test]
fn power_comes_on_in_remote_mode_alone() {
    for mode in [0, 1, 2, 3] {
        let mut robot = in_mode(mode);
        assert_eq!(robot.enable_power(0), PowerRequest::NotRemote);
        robot.advance(u64::MAX, true);
        assert!(!robot.is_powered());
    }
    assert!(PowerRequest::NotRemote.refusal().is_some() && PowerRequest::Started.refusal().is_none());
}

#[test]
fn enabling_has_no_effect_while_power_is_being_cut() {
    let mut robot = powered();
    robot.disable_power(0);
    assert_eq!(robot.enable_power(1), PowerRequest::BeingCut);
    robot.advance(POWER_OFF_TIME, true);
    assert!(robot.is_power_off());
    assert_eq!(robot.enable_power(POWER_OFF_TIME), PowerRequest::Started);
    assert_eq!(robot.enable_power(POWER_OFF_TIME), PowerRequest::AlreadyOn);
}

#[test]
fn disabling_waits_for_the_arm_to_stop() {
    let mut robot = powered();
    robot.disable_power(0);
    assert!(robot.is_powered() && robot.is_power_being_cut());
    robot.advance(10 * POWER_OFF_TIME, false);
    assert!(robot.is_powered());
    robot.advance(10 * POWER_OFF_TIME, true);
    assert!(robot.is_power_off());
    assert_eq!(robot.take_events(), [RobotEvent::Power(false)]);
}

#[test]
fn an_emergency_stop_is_open_then_released_then_acknowledged() {
    let mut robot = powered();
    robot.press_emergency_stop();
    assert_eq!((robot.es_status() as u8, robot.is_powered()), (2, false));
    assert_eq!(robot.enable_power(0), PowerRequest::Stopped);
    robot.acknowledge_emergency_stop();
    assert_eq!(robot.es_status() as u8, 2);
    robot.release_emergency_stop();
    assert_eq!(robot.es_status() as u8, 1);
    robot.acknowledge_emergency_stop();
    assert_eq!(robot.es_status() as u8, 0);
    robot.release_emergency_stop();
    assert_eq!(robot.es_status() as u8, 0);
}

#[test]
fn enabling_power_acknowledges_a_released_stop() {
    let mut robot = Robot::default();
    robot.press_emergency_stop();
    robot.release_emergency_stop();
    assert_eq!(robot.enable_power(0), PowerRequest::Started);
    assert_eq!(robot.es_status() as u8, 0);
}

#[test]
fn a_safety_fault_names_its_signal_and_opens_the_circuit() {
    let mut robot = powered();
    assert_eq!(robot.safety_fault(), None);
    robot.set_safety_fault(Some("DOOR".to_owned()));
    assert_eq!((robot.safety_fault(), robot.es_status() as u8, robot.is_powered()), (Some("DOOR"), 2, false));
    robot.set_power(true);
    assert!(!robot.is_powered());
    robot.set_safety_fault(None);
    assert_eq!(robot.es_status() as u8, 0);
}

#[test]
fn a_change_of_the_mode_cuts_the_power() {
    let mut robot = powered();
    robot.set_mode(WorkingMode::Manual, 0);
    assert_eq!((robot.working_mode().number(), robot.mode_state()), (1, 6));
    robot.advance(POWER_OFF_TIME, true);
    assert_eq!(robot.take_events(), [RobotEvent::Mode(WorkingMode::Manual), RobotEvent::Power(false)]);
    robot.set_activity(Activity::ToolJog);
    assert_eq!(robot.mode_state(), 4);
}

#[test]
fn the_mode_state_depends_on_the_working_mode() {
    let robot = Robot::default();
    assert_eq!((robot.working_mode().number(), robot.mode_state()), (4, 0));
    assert_eq!(in_mode(3).mode_state(), 2);
}

#[test]
fn the_speed_can_always_be_lowered() {
    for mode in [0, 1, 2, 3, 4] {
        let mut robot = in_mode(mode);
        assert_eq!(robot.set_monitor_speed(30.0, true) as i8, 0);
        assert_eq!(robot.set_monitor_speed(30.0, true) as i8, 0);
        assert!((robot.monitor_speed() - 30.0).abs() < f64::EPSILON);
    }
}

#[test]
fn the_speed_is_raised_in_remote_mode_without_the_operator() {
    for (mode, operator, expected) in [
        (4, false, (0, 50.0)),
        (4, true, (-2, 10.0)),
        (0, true, (-1, 10.0)),
        (1, true, (-1, 10.0)),
        (2, true, (-1, 10.0)),
        (3, true, (-1, 10.0)),
    ] {
        let mut robot = in_mode(mode);
        robot.turn_speed(10.0);
        assert_eq!((robot.set_monitor_speed(50.0, operator) as i8, robot.monitor_speed()), expected, "{mode}");
    }
}

#[test]
fn the_speed_is_a_percentage() {
    let mut robot = in_mode(3);
    for speed in [-0.1, 100.1, f64::NAN] {
        assert_eq!(robot.set_monitor_speed(speed, true) as i8, -3);
    }
    assert_eq!(robot.set_monitor_speed(100.0, true) as i8, 0);
    assert_eq!(robot.set_monitor_speed(0.0, true) as i8, 0);
    robot.turn_speed(250.0);
    assert!((robot.monitor_speed() - 100.0).abs() < f64::EPSILON);
    assert_eq!(robot.take_events(), [RobotEvent::MonitorSpeed(0.0), RobotEvent::MonitorSpeed(100.0)]);
}

#[test]
fn calibration_is_returned() {
    let mut robot = Robot::default();
    assert!(robot.is_calibrated());
    robot.set_calibrated(false);
    assert!(!robot.is_calibrated());
}

#[test]
fn the_tool_is_slow_in_manual_mode_and_in_test_mode_below_full_speed() {
    for (mode, speed) in [(1, Some(MillimetresPerSecond(250.0))), (2, None), (3, None), (4, None)] {
        for allowed in [true, false] {
            let mut robot = in_mode(mode);
            robot.let_move(allowed);
            assert_eq!(robot.drive().tool_speed, speed, "{mode} {allowed}");
        }
    }
    let mut robot = in_mode(2);
    robot.set_activity(Activity::Programmed);
    robot.set_manual_speed(MillimetresPerSecond(100.0));
    assert_eq!(robot.drive().tool_speed, Some(MillimetresPerSecond(100.0)));
}
