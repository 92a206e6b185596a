use super::*;
use crate::io::{Signal, SignalId};

struct Cell {
    io: IoTable,
}

/// A cell with four digital inputs and outputs, a protected output, and three analog outputs.
fn cell() -> Cell {
    let mut io = IoTable::default();
    for number in 0..4 {
        io.declare(Signal::from_path(&format!("BasicIO-1\\%I{number}"), true));
        io.declare(Signal::from_path(&format!("BasicIO-1\\%Q{number}"), true));
    }
    io.declare(Signal { protected: true, ..Signal::from_path("CpuIO\\fan", true) });
    let temperature = "motor temperature".to_owned();
    io.declare(Signal { description: temperature, ..Signal::from_path("Board\\%IF0", false) });
    io.declare(Signal::from_path("Board\\%QF8", false));
    io.declare(Signal::from_path("Board\\%QB40", false));
    Cell { io }
}

impl Cell {
    fn links(&mut self, sign: &str, count: u8) -> Vec<LinkId> {
        (0..count).map(|number| self.io.link(&format!("BasicIO-1\\%{sign}{number}"))).collect()
    }

    fn id(&self, path: &str) -> SignalId {
        self.io.find(path).unwrap()
    }

    /// The hardware sets an input, and a cycle begins.
    fn set(&mut self, path: &str, value: f64) {
        let id = self.id(path);
        self.io.set(id, value);
        self.io.refresh_inputs();
    }
}

#[test]
fn bits_are_read_the_lowest_first() {
    let mut cell = cell();
    let inputs = cell.links("I", 4);
    for path in ["BasicIO-1\\%I1", "BasicIO-1\\%I3"] {
        cell.set(path, 1.0);
    }
    assert_eq!(cell.io.read_bits(&inputs), Ok(10.0));
    assert_eq!(cell.io.read_bits(&[]), Ok(0.0));
}

#[test]
fn bits_beyond_the_array_are_dropped() {
    let mut cell = cell();
    let outputs = cell.links("Q", 4);
    assert_eq!(cell.io.write_bits(&outputs, 10.0), Ok(10.0));
    assert_eq!(cell.io.write_bits(&outputs, 26.0), Ok(10.0));
    assert_eq!(
        outputs.iter().map(|link| cell.io.read_digital(*link).unwrap()).collect::<Vec<_>>(),
        [false, true, false, true]
    );
}

#[test]
fn the_whole_part_is_written_in_twos_complement() {
    let mut cell = cell();
    let outputs = cell.links("Q", 4);
    assert_eq!(cell.io.write_bits(&outputs, 5.9), Ok(5.0));
    assert_eq!(cell.io.write_bits(&outputs, -1.0), Ok(15.0));
    assert_eq!(cell.io.write_bits(&outputs, -2.7), Ok(14.0));
    assert_eq!(cell.io.write_bits(&outputs, 2_f64.powi(60) + 256.0), Ok(0.0));
}

#[test]
fn an_analog_output_gives_its_real_value() {
    let mut cell = cell();
    let (float, byte) = (cell.io.link("Board\\%QF8"), cell.io.link("Board\\%QB40"));
    assert_eq!(cell.io.write_analog(float, -12.3), Ok(-12.3));
    assert_eq!(cell.io.write_analog(byte, 12.3), Ok(12.0));
    assert_eq!(cell.io.write_analog(byte, 1000.0), Ok(255.0));
    assert_eq!(cell.io.read_analog(byte), Ok(255.0));
}

#[test]
fn an_analog_input_gives_the_value_of_the_sensor() {
    let mut cell = cell();
    let sensor = cell.io.link("Board\\%IF0");
    cell.set("Board\\%IF0", 36.6);
    assert_eq!(cell.io.read_analog(sensor), Ok(36.6));
}

#[test]
fn each_misuse_has_its_error() {
    let mut cell = cell();
    let input = cell.links("I", 1);
    let output = cell.links("Q", 1);
    let unknown = cell.io.link("BasicIO-1\\%Q99");
    let protected = cell.io.link("CpuIO\\fan");
    let analog = cell.io.link("Board\\%QF8");
    assert_eq!(cell.io.write_bits(&input, 1.0).map_err(IoError::number), Err(122));
    assert_eq!(cell.io.write_digital(input[0], true), Err(IoError::WriteToInput));
    for link in [LinkId::NONE, unknown, analog] {
        assert_eq!(cell.io.read_digital(link), Err(IoError::Unlinked));
        assert_eq!(cell.io.write_digital(link, true), Err(IoError::Unlinked));
    }
    assert_eq!(cell.io.read_analog(output[0]).map_err(IoError::number), Err(123));
    assert_eq!(cell.io.write_digital(protected, true).map_err(IoError::number), Err(124));
    assert_eq!(cell.io.read_digital(protected), Ok(false));
    let id = cell.id("BasicIO-1\\%Q0");
    cell.io.set_fault(id, Some(SignalFault::Failed));
    assert_eq!(cell.io.write_bits(&output, 1.0).map_err(IoError::number), Err(125));
    assert_eq!(cell.io.read_digital(output[0]), Err(IoError::NoAnswer));
    cell.io.set_fault(id, Some(SignalFault::Absent));
    assert_eq!(cell.io.read_digital(output[0]), Err(IoError::Unlinked));
    cell.io.set_fault(id, None);
    assert_eq!(cell.io.read_digital(output[0]), Ok(false));
}

#[test]
fn outputs_are_written_together_or_not_at_all() {
    let mut cell = cell();
    let mut outputs = cell.links("Q", 2);
    outputs.push(LinkId::NONE);
    assert_eq!(cell.io.write_bits(&outputs, 7.0), Err(IoError::Unlinked));
    assert_eq!(cell.io.read_bits(&outputs[..2]), Ok(0.0));
}

#[test]
fn each_state_has_its_status() {
    let mut cell = cell();
    let link = cell.io.link("BasicIO-1\\%I0");
    let unknown = cell.io.link("BasicIO-1\\%I99");
    let id = cell.id("BasicIO-1\\%I0");
    let status = |cell: &Cell, link| cell.io.digital_status(link).number();
    assert_eq!([status(&cell, link), status(&cell, LinkId::NONE), status(&cell, unknown)], [0, -1, -2]);
    assert_eq!(cell.io.analog_status(link).number(), -2);
    cell.io.simulate(id, true);
    assert_eq!(status(&cell, link), 2);
    cell.io.lock(id, None);
    assert_eq!(status(&cell, link), 1);
    cell.io.set_fault(id, Some(SignalFault::Failed));
    assert_eq!(status(&cell, link), -3);
    cell.io.set_fault(id, Some(SignalFault::Absent));
    assert_eq!(status(&cell, link), -2);
}

#[test]
fn a_status_comes_with_description_and_path() {
    let mut cell = cell();
    let sensor = cell.io.link("Board\\%IF0");
    let unknown = cell.io.link("Board\\%IF99");
    assert_eq!((cell.io.description(sensor), cell.io.text(sensor)), ("motor temperature", "Board\\%IF0"));
    assert_eq!((cell.io.description(unknown), cell.io.text(unknown)), ("", "Board\\%IF99"));
    assert_eq!((cell.io.description(LinkId::NONE), cell.io.text(LinkId::NONE)), ("", ""));
}

#[test]
fn inputs_change_when_a_cycle_begins_and_outputs_when_it_ends() {
    let mut cell = cell();
    let (input, output) = (cell.links("I", 1)[0], cell.links("Q", 1)[0]);
    let (in_id, out_id) = (cell.id("BasicIO-1\\%I0"), cell.id("BasicIO-1\\%Q0"));
    cell.io.set(in_id, 1.0);
    cell.io.write_digital(output, true).unwrap();
    assert_eq!((cell.io.read_digital(input), cell.io.read_digital(output)), (Ok(false), Ok(true)));
    assert_eq!(cell.io.hardware(out_id), Some(0.0));
    assert_eq!(changed(cell.io.refresh_inputs()), [(in_id, 1.0)]);
    assert_eq!((cell.io.read_digital(input), cell.io.hardware(out_id)), (Ok(true), Some(0.0)));
    assert_eq!(changed(cell.io.refresh_outputs()), [(out_id, 1.0)]);
    assert_eq!(cell.io.hardware(out_id), Some(1.0));
    assert!(cell.io.refresh_inputs().is_empty() && cell.io.refresh_outputs().is_empty());
}

fn changed(changes: Vec<crate::io::IoChange>) -> Vec<(SignalId, f64)> {
    changes.into_iter().map(|change| (change.signal, change.value)).collect()
}

#[test]
fn an_output_can_be_set_from_outside() {
    let mut cell = cell();
    let id = cell.id("BasicIO-1\\%Q0");
    cell.io.set(id, 1.0);
    let [change] = cell.io.refresh_outputs()[..] else { panic!("no change") };
    assert_eq!((change.signal, change.value), (id, 1.0));
    cell.io.lock(id, Some(0.0));
    assert_eq!(cell.io.refresh_outputs().len(), 1);
    cell.io.set(id, 1.0);
    assert!(cell.io.refresh_outputs().is_empty(), "the operator holds it");
}

#[test]
fn a_locked_input_has_a_value_that_differs_from_the_hardware() {
    let mut cell = cell();
    let input = cell.links("I", 1)[0];
    let id = cell.id("BasicIO-1\\%I0");
    cell.io.lock(id, Some(1.0));
    cell.set("BasicIO-1\\%I0", 0.0);
    assert_eq!((cell.io.read_digital(input), cell.io.hardware(id)), (Ok(true), Some(0.0)));
    cell.io.unlock(id);
    cell.io.refresh_inputs();
    assert_eq!(cell.io.read_digital(input), Ok(false));
}

#[test]
fn writing_a_locked_output_has_no_effect() {
    let mut cell = cell();
    let outputs = cell.links("Q", 2);
    let id = cell.id("BasicIO-1\\%Q0");
    cell.io.lock(id, Some(1.0));
    assert_eq!(cell.io.write_bits(&outputs, 2.0), Ok(3.0));
    cell.io.refresh_outputs();
    assert_eq!(cell.io.hardware(id), Some(1.0));
    cell.io.unlock(id);
    assert_eq!(cell.io.read_bits(&outputs), Ok(3.0));
    assert_eq!(cell.io.write_bits(&outputs, 2.0), Ok(2.0));
}

#[test]
fn a_simulated_output_does_not_reach_the_hardware() {
    let mut cell = cell();
    let output = cell.links("Q", 1)[0];
    let id = cell.id("BasicIO-1\\%Q0");
    cell.io.simulate(id, true);
    cell.io.write_digital(output, true).unwrap();
    assert!(cell.io.refresh_outputs().is_empty());
    assert_eq!((cell.io.read_digital(output), cell.io.hardware(id)), (Ok(true), Some(0.0)));
    cell.io.simulate(id, false);
    cell.io.refresh_outputs();
    assert_eq!(cell.io.hardware(id), Some(1.0));
}

#[test]
fn the_other_side_of_a_bus_can_set_an_output() {
    let mut cell = cell();
    let output = cell.links("Q", 1)[0];
    let id = cell.id("BasicIO-1\\%Q0");
    cell.io.set(id, 1.0);
    assert_eq!((cell.io.read_digital(output), cell.io.image(id)), (Ok(true), Some(1.0)));
}

#[test]
fn a_link_is_identified_by_its_text() {
    let mut cell = cell();
    let first = cell.io.link("BasicIO-1\\%I0");
    assert_eq!(cell.io.link("BasicIO-1\\%I0"), first);
    assert_ne!(cell.io.link("BasicIO-1\\%I1"), first);
    assert_eq!(cell.io.link(""), LinkId::NONE);
    let later = cell.io.link("New\\%Q0");
    assert_eq!(cell.io.digital_status(later).number(), -2);
    cell.io.declare(Signal::from_path("New\\%Q0", true));
    assert_eq!(cell.io.digital_status(later).number(), 0);
}

#[test]
fn an_application_declares_what_no_configuration_knows() {
    let mut cell = cell();
    let word = cell.io.adopt("ModbusSrv-0\\Modbus-Word\\Weight", false);
    let valve = cell.io.adopt("valve1", true);
    let other = cell.io.adopt("ModbusSrv-0\\Modbus-Word\\Height", false);
    let missing = cell.io.adopt("BasicIO-1\\%I99", true);
    assert_eq!((cell.io.analog_status(word).number(), cell.io.digital_status(valve).number()), (0, 0));
    assert_eq!(cell.io.digital_status(missing).number(), -2);
    assert_eq!(cell.io.analog_status(other).number(), 0);
}

#[test]
fn a_path_without_a_device_finds_its_address() {
    let mut cell = cell();
    let id = cell.io.declare(Signal::from_path("ValveIO\\valve1", true));
    assert_eq!((cell.io.find("valve1"), cell.io.find("valve2"), cell.io.find("Other\\valve1")), (Some(id), None, None));
    assert_eq!(cell.io.signal(id).unwrap().path, "ValveIO\\valve1");
}

#[test]
fn the_first_device_that_is_installed_is_used() {
    let mut cell = cell();
    let devices = [cell.io.link("Missing\\%I0"), cell.io.link("BasicIO-1\\%I0")];
    let signal = devices.into_iter().find(|link| cell.io.digital_status(*link).number() >= 0).unwrap();
    assert_eq!(cell.io.text(signal), "BasicIO-1\\%I0");
}

#[test]
fn a_failed_device_takes_its_signals_with_it() {
    let mut cell = cell();
    let (input, sensor) = (cell.links("I", 1)[0], cell.io.link("Board\\%IF0"));
    assert!(cell.io.bus_faults().is_empty());
    cell.io.set_device_fault("BasicIO-1", Some(71));
    assert_eq!(cell.io.bus_faults(), ["71:BasicIO-1"]);
    assert_eq!((cell.io.digital_status(input).number(), cell.io.analog_status(sensor).number()), (-3, 0));
    assert_eq!(cell.io.read_digital(input), Err(IoError::NoAnswer));
    cell.io.set_device_fault("BasicIO-1", None);
    assert_eq!(cell.io.read_digital(input), Ok(false));
}

#[test]
fn a_failed_signal_names_its_module() {
    let mut cell = cell();
    let id = cell.io.declare(Signal::from_path("J207\\Box1\\%Q0", true));
    cell.io.set_fault(id, Some(SignalFault::Failed));
    let id = cell.id("BasicIO-1\\%I0");
    cell.io.set_fault(id, Some(SignalFault::Failed));
    assert_eq!(cell.io.bus_faults(), ["-3:BasicIO-1", "-3:J207\\Box1"]);
}

#[test]
fn the_operator_holds_an_output_against_the_other_side_as_well() {
    let mut cell = cell();
    let output = cell.links("Q", 1)[0];
    let id = cell.id("BasicIO-1\\%Q0");
    cell.io.lock(id, Some(1.0));
    cell.io.set(id, 0.0);
    assert_eq!(cell.io.read_digital(output), Ok(true));
}

#[test]
fn a_device_is_known_by_its_whole_name() {
    let mut cell = cell();
    cell.io.declare(Signal::from_path("BasicIO-10\\%I0", true));
    let other = cell.io.link("BasicIO-10\\%I0");
    cell.io.set_device_fault("BasicIO-1", Some(71));
    assert_eq!(cell.io.digital_status(other).number(), 0);
}
