use std::os::fd::OwnedFd;

use rustix::pty::{OpenptFlags, grantpt, openpt, ptsname, unlockpt};

use super::*;
use crate::sio::{Attempt, Channel, Sending, SettingValue};

/// A line, and the other end of it.
fn pty() -> (Channel, OwnedFd) {
    let other = openpt(OpenptFlags::RDWR | OpenptFlags::NOCTTY).unwrap();
    grantpt(&other).unwrap();
    unlockpt(&other).unwrap();
    let name = ptsname(&other, Vec::new()).unwrap().into_string().unwrap();
    (Channel::new(Box::new(SerialLine::open(Utf8Path::new(&name)).unwrap())), other)
}

#[test]
fn bytes_are_not_changed() {
    let (mut channel, other) = pty();
    let bytes: Vec<u8> = (0..=255).collect();
    assert_eq!(channel.send(&mut Sending::bytes(bytes.clone()), 0.0), Attempt::Done(Ok(256)));
    let mut heard = [0; 512];
    let count = rustix::io::read(&other, &mut heard).unwrap();
    assert_eq!(&heard[..count], bytes);
    rustix::io::write(&other, b"12\x03\n5\r\n").unwrap();
    assert_eq!(channel.read_text(0.0), Attempt::Done(Ok("12\x03\n5".to_owned())));
    assert_eq!(channel.read_bytes(4, 0.0), Attempt::Done(Some(vec![b'\n'])));
    assert_eq!(channel.read_bytes(4, 0.0), Attempt::Done(Some(vec![])));
}

#[test]
fn the_example_of_the_manual() {
    let (mut channel, other) = pty();
    assert_eq!(channel.control("baudRate", SettingValue::Num(115_200.0)), 0);
    assert_eq!(channel.control("bits", SettingValue::Num(8.0)), 0);
    assert_eq!(channel.control("parity", SettingValue::Text("none")), 0);
    assert_eq!(channel.control("stopBits", SettingValue::Num(2.0)), 0);
    assert_eq!(channel.control("timeout", SettingValue::Num(0.0)), 0);
    assert_eq!(channel.control("endOfString", SettingValue::Num(13.0)), 0);
    let modes = tcgetattr(&other).unwrap();
    assert_eq!(modes.output_speed(), 115_200);
    assert!(modes.control_modes.contains(ControlModes::CS8 | ControlModes::CSTOPB));
    assert_eq!(channel.control("mode", SettingValue::Text("rs232")), 0);
    assert_eq!(channel.control("mode", SettingValue::Text("rs422")), -3);
    assert_eq!(channel.control("baudRate", SettingValue::Num(0.0)), -3);
    assert_eq!(channel.control("port", SettingValue::Num(80.0)), -5);
}

#[test]
fn a_read_waits_for_a_missing_peer() {
    let (mut channel, other) = pty();
    drop(other);
    assert_eq!(channel.read_text(0.0), Attempt::Wait);
    assert_eq!(channel.clear(), Some(0));
    assert!(SerialLine::open(Utf8Path::new("/dev/null")).is_err());
}
