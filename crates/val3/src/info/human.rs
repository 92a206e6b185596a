//! The description for people.

use std::io;

use codespan_reporting::term::termcolor::WriteColor;
use val3_backup::info::{ApplicationInfo, ControllerInfo, User};

use super::DescribedController;
use super::devices::{DeviceInfo, SignalDirection};
use crate::markdown::{heading_style, styled};
use crate::printable::one_line;

/// Width of the labels in front of values.
const LABEL: usize = 16;

/// Writes all descriptions.
pub(super) fn write(described: &[DescribedController], out: &mut dyn WriteColor) -> io::Result<()> {
    for (index, controller) in described.iter().enumerate() {
        if index > 0 {
            writeln!(out)?;
        }
        write_controller(controller, out)?;
    }
    Ok(())
}

fn write_controller(described: &DescribedController, out: &mut dyn WriteColor) -> io::Result<()> {
    let DescribedController { path, info, devices, logs, missing, unread } = described;
    styled(&heading_style(), &one_line(if path.is_empty() { "." } else { path }), out)?;
    writeln!(out)?;
    identity(info).into_iter().try_for_each(|(label, value)| writeln!(out, "  {label:<LABEL$}{}", one_line(&value)))?;
    section("Applications", applications(&info.applications), out)?;
    section("Boards and signals", boards(info, devices), out)?;
    section("Users", info.users.iter().map(user).collect(), out)?;
    section("Logs (val3 log)", logs.clone(), out)?;
    section("Not read", unread.iter().map(|(path, reason)| format!("{path}: {reason}")).collect(), out)?;
    let missing = if missing.is_empty() { vec!["nothing".to_owned()] } else { missing.clone() };
    section("Missing for val3 run", missing, out)
}

/// Writes a section if it has lines.
fn section(title: &str, lines: Vec<String>, out: &mut dyn WriteColor) -> io::Result<()> {
    if lines.is_empty() {
        return Ok(());
    }
    writeln!(out)?;
    styled(&heading_style(), title, out)?;
    writeln!(out)?;
    lines.iter().try_for_each(|line| writeln!(out, "  {}", one_line(line)))
}

/// Labels and values of the controller itself.
fn identity(info: &ControllerInfo) -> Vec<(&'static str, String)> {
    let known = |value: &Option<String>| value.clone().unwrap_or_else(|| "unknown".to_owned());
    let options = info.options.iter().map(|option| format!("{} ({})", option.name, option.state.word()));
    let mut lines =
        vec![("serial number", known(&info.serial)), ("software", known(&info.version)), ("arm", arm(info))];
    let hours = info.power_hours.map(|hours| format!("{hours:.1} h"));
    let more = [
        ("simulation", info.simulation.clone()),
        ("power on", hours),
        ("language", info.language.clone()),
        ("starts with", info.auto_start.clone()),
        ("options", joined(options.collect())),
        ("add-ons", joined(info.add_ons.clone())),
    ];
    lines.extend(more.into_iter().filter_map(|(label, value)| Some((label, value?))));
    lines
}

/// Joins names; `None` if there are none.
fn joined(names: Vec<String>) -> Option<String> {
    (!names.is_empty()).then(|| names.join(", "))
}

fn arm(info: &ControllerInfo) -> String {
    let Some(name) = &info.arm else { return "unknown".to_owned() };
    let serial = info.arm_serial.as_ref().map(|serial| format!("serial number {serial}"));
    let drawing = info.arm_of_drawing.then(|| "name of its drawing".to_owned());
    let parts = [Some(name.clone()), drawing, info.length_axis3.clone(), info.mount.clone(), serial];
    parts.into_iter().flatten().collect::<Vec<_>>().join(", ")
}

fn applications(applications: &[ApplicationInfo]) -> Vec<String> {
    let width = applications.iter().map(|application| application.name.chars().count()).max().unwrap_or(0);
    applications.iter().map(|application| application_line(application, width)).collect()
}

/// Line of an application, with its name in a column of this width.
fn application_line(application: &ApplicationInfo, width: usize) -> String {
    let ApplicationInfo { name, programs, files, size, modified, .. } = application;
    let programs = counted(*programs, "program");
    let files = counted(*files, "file");
    let date = modified.map_or_else(String::new, |time| format!("  {time}"));
    format!("{name:<width$}  {programs:>12}  {files:>9}  {:>9}{date}", shown_size(*size))
}

fn boards(info: &ControllerInfo, devices: &[DeviceInfo]) -> Vec<String> {
    let absent = info.boards.iter().filter(|board| !board.exists);
    let absent = absent.map(|board| format!("{}: not in the controller", board.name));
    devices.iter().map(device).chain(absent).collect()
}

fn device(device: &DeviceInfo) -> String {
    let count = |direction| device.signals.iter().filter(|signal| signal.direction == direction).count();
    let counts = [SignalDirection::Input, SignalDirection::Output, SignalDirection::Unknown]
        .map(|direction| (count(direction), direction.word()));
    let counts = counts.iter().filter(|(count, _)| *count > 0).map(|(count, word)| counted(*count, word));
    let counts: Vec<String> = counts.collect();
    // Sockets have few and telling names.
    let names = device.signals.iter().filter(|signal| signal.direction == SignalDirection::Unknown);
    let names: Vec<&str> = names.filter_map(|signal| signal.link.split_once('\\')).map(|(_, name)| name).collect();
    let names = if names.is_empty() || names.len() > 8 { String::new() } else { format!(": {}", names.join(", ")) };
    let counts = if counts.is_empty() { "no signals".to_owned() } else { counts.join(", ") };
    format!("{}: {counts}{names}", device.name)
}

fn user(user: &User) -> String {
    let default = if user.is_default { " (after the start)" } else { "" };
    let denied = if user.denied.is_empty() { String::new() } else { format!("; not {}", user.denied.join(", ")) };
    let rights = if user.rights.is_empty() { "no rights".to_owned() } else { user.rights.join(", ") };
    format!("{}{default}: {rights}{denied}", user.name)
}

fn counted(count: usize, word: &str) -> String {
    if count == 1 { format!("1 {word}") } else { format!("{count} {word}s") }
}

/// Size in kB or MB (1,000 bytes, as most file managers count).
#[allow(clippy::cast_precision_loss, reason = "the size is shown with one decimal")]
fn shown_size(bytes: u64) -> String {
    match bytes {
        0..1_000 => format!("{bytes} B"),
        1_000..1_000_000 => format!("{:.1} kB", bytes as f64 / 1e3),
        _ => format!("{:.1} MB", bytes as f64 / 1e6),
    }
}
