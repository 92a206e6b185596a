//! The description as a JSON document.

use serde_json::{Value, json};
use val3_backup::DateTime;
use val3_backup::info::{ApplicationInfo, ControllerInfo, ControllerOption, User};

use super::DescribedController;
use super::devices::{DeviceInfo, SignalInfo};

/// Version of the document.
const VERSION: u32 = 1;

/// Converts the descriptions to a document.
pub(super) fn document(described: &[DescribedController]) -> Value {
    let controllers: Vec<Value> = described.iter().map(controller).collect();
    json!({ "version": VERSION, "controllers": controllers })
}

fn controller(described: &DescribedController) -> Value {
    let DescribedController { path, info, devices, logs, missing, unread } = described;
    let ControllerInfo { serial, version, arm, arm_of_drawing, arm_serial, mount, length_axis3, .. } = info;
    json!({
        "path": path,
        "serial": serial,
        "software": version,
        "arm": { "name": arm, "of_drawing": arm_of_drawing, "serial": arm_serial, "mount": mount, "length_axis3": length_axis3 },
        "simulation": info.simulation,
        "power_hours": info.power_hours,
        "language": info.language,
        "auto_start": info.auto_start,
        "options": info.options.iter().map(option).collect::<Vec<_>>(),
        "add_ons": info.add_ons,
        "applications": info.applications.iter().map(application).collect::<Vec<_>>(),
        "boards": info.boards.iter().map(|board| json!({ "name": board.name, "exists": board.exists })).collect::<Vec<_>>(),
        "devices": devices.iter().map(device).collect::<Vec<_>>(),
        "users": info.users.iter().map(user).collect::<Vec<_>>(),
        "logs": logs,
        "missing": missing,
        "unread": unread.iter().map(|(path, reason)| json!({ "path": path, "reason": reason })).collect::<Vec<_>>(),
    })
}

fn option(option: &ControllerOption) -> Value {
    json!({ "name": option.name, "state": option.state.word() })
}

fn application(application: &ApplicationInfo) -> Value {
    let ApplicationInfo { name, path, programs, files, size, modified } = application;
    let modified = modified.as_ref().map(DateTime::to_string);
    json!({ "name": name, "path": path, "programs": programs, "files": files, "size": size, "modified": modified })
}

fn device(device: &DeviceInfo) -> Value {
    json!({ "name": device.name, "signals": device.signals.iter().map(signal).collect::<Vec<_>>() })
}

fn signal(signal: &SignalInfo) -> Value {
    json!({ "link": signal.link, "type": signal.ty, "name": signal.name, "direction": signal.direction.word() })
}

fn user(user: &User) -> Value {
    json!({ "name": user.name, "is_default": user.is_default, "rights": user.rights, "denied": user.denied })
}
