//! Files of runs and tests.

use val3_kinematics::Arm;
use val3_machine::files::unpack;
use val3_machine::script::Script;
use val3_machine::shapes::ShapeFormat;
use val3_machine::sio::replay;
use val3_suite::{Scenario, TestFileRole};
use val3_trace::Trace;

/// Largest unpacked size, in bytes.
const MOST_UNPACKED: usize = 64 << 20;

/// Reads a script of `val3 run --script`.
pub fn script(bytes: &[u8]) {
    if let Ok(text) = str::from_utf8(bytes)
        && let Err(error) = Script::parse(text)
    {
        assert!(!error.to_string().is_empty());
    }
}

/// Reads a scenario of `val3 test`.
pub fn scenario(bytes: &[u8]) {
    let Ok(text) = str::from_utf8(bytes) else { return };
    match Scenario::parse("tests/scenario.toml", text) {
        Ok(scenario) => assert!(scenario.application().is_ok() || Scenario::role(text) != TestFileRole::Scenario),
        Err(error) => assert!(!error.to_string().is_empty()),
    }
}

/// Reads the data that channels have received from the events of a run.
pub fn events(bytes: &[u8]) {
    if let Ok(text) = str::from_utf8(bytes) {
        // Most inputs cause an error.
        _ = replay(text);
    }
}

/// Reads recorded motion, in which time must not decrease.
pub fn trace(bytes: &[u8]) {
    let Ok(text) = str::from_utf8(bytes) else { return };
    match Trace::parse(text) {
        Ok(trace) => assert!(trace.rows.is_sorted_by_key(|row| row.time), "time goes back"),
        Err(error) => assert!(!error.to_string().is_empty()),
    }
}

/// Reads an arm file, and computes the pose of the flange.
pub fn arm(bytes: &[u8]) {
    let Ok(text) = str::from_utf8(bytes) else { return };
    match Arm::from_toml(text) {
        Ok(arm) => {
            _ = arm.flange(&Default::default());
        }
        Err(error) => assert!(!error.to_string().is_empty()),
    }
}

/// Recognises the format of a shape, which has a header of at least four bytes.
pub fn shape(bytes: &[u8]) {
    let has_form = [ShapeFormat::Glb, ShapeFormat::Stl].into_iter().any(|format| format.matches(bytes));
    assert!(!has_form || bytes.len() >= 4, "a form without a head");
}

/// Unpacks an encrypted library. The size is limited, and no name refers to a path outside its folder.
pub fn archive(bytes: &[u8]) {
    let Ok(files) = unpack(bytes, "password") else { return };
    assert!(files.iter().map(|file| file.bytes.len()).sum::<usize>() <= MOST_UNPACKED);
    for file in files {
        assert!(!file.path.is_absolute() && file.path.components().all(|part| part.as_str() != ".."), "{}", file.path);
    }
}
