//! Identity of a controller: serial numbers, arm, version.

use val3_syntax::arm_file::ArmFile;
use val3_syntax::version_file;
use val3_syntax::view::View;
use val3_syntax::xml::{self, XmlElement};

use super::applications::{ApplicationInfo, applications};
use super::cfx::{Settings, TextFiles, joined};
use super::options::{ControllerOption, options};
use super::roots::ControllerRoot;
use super::users::{User, users};
use crate::{BackupFiles, UnreadFile};

/// Description of a controller. A missing entry is missing in the backup.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct ControllerInfo {
    /// Serial number of the controller.
    pub serial: Option<String>,
    /// Version of the software, for example `s8.10.2Cs9_BS1991`.
    pub version: Option<String>,
    /// Name of the arm, for example `tx2_60-S1`.
    pub arm: Option<String>,
    /// Whether the name of the arm comes from its drawing in the emulator, because `arm.cfx` names none.
    pub arm_of_drawing: bool,
    /// Serial number of the arm.
    pub arm_serial: Option<String>,
    /// Mount of the arm: `floor`, `wall` or `ceiling`.
    pub mount: Option<String>,
    /// Length of axis 3 of a SCARA arm, for example `L400`.
    pub length_axis3: Option<String>,
    /// Kind of simulation, for example `emulation`; `None` on a real controller.
    pub simulation: Option<String>,
    /// Hours with arm power.
    pub power_hours: Option<f64>,
    /// Language of the messages.
    pub language: Option<String>,
    /// Name of the application that starts with the controller.
    pub auto_start: Option<String>,
    /// Options with a known name.
    pub options: Vec<ControllerOption>,
    /// Names of add-ons with a table in `usr/app`.
    pub add_ons: Vec<String>,
    /// Applications and libraries.
    pub applications: Vec<ApplicationInfo>,
    /// Boards of a CS8 that the controller states to have or not to have.
    pub boards: Vec<Board>,
    /// Users.
    pub users: Vec<User>,
    /// Files that cannot be read. Their entries are missing above.
    pub unread: Vec<UnreadFile>,
}

/// Board of a CS8 with inputs and outputs.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Board {
    /// Name of the board's file: `bio`, `bio2`, `mio` or `cio`.
    pub name: String,
    /// Whether the controller has the board.
    pub exists: bool,
}

/// Settings of `controller.cfx` that state whether a board exists, and the names of the boards.
const BOARDS: [(&str, &str); 4] =
    [("buildBio", "bio"), ("buildBio2", "bio2"), ("buildMio", "mio"), ("buildCio", "cio")];

/// Reads the files of the controller with this root.
pub(super) fn read(files: &dyn BackupFiles, root: &ControllerRoot) -> ControllerInfo {
    let mut texts = TextFiles::new(files);
    let configs = joined(&root.usr, "configs");
    let controller = texts.settings(&joined(&configs, "controller.cfx"));
    // s6 stores options and serial numbers here.
    let system = texts.settings(&joined(&root.path, "sys/configs/options.cfx"));
    let cell_text = texts.text(&joined(&configs, "cell.cfx")).unwrap_or_default();
    let cell = Settings::of(&cell_text);
    let arm_text = texts.text(&joined(&configs, "arm.cfx")).unwrap_or_default();
    let arm = Settings::of(&arm_text);
    let arm_file = ArmFile::read(&arm_text);
    let version = texts.text(&joined(&configs, "val3version.xml")).and_then(|text| version_file::language(&text));
    let emulator = emulator(&mut texts, &root.path);
    let [controller_version, drawing] =
        emulator.map(|text| [content(&text, "Version"), content(&text, "RobotSkin")]).unwrap_or_default();
    let first = |name: &str| controller.value(name).or_else(|| system.value(name)).map(str::to_owned);
    let named_arm = arm_file.model.or_else(|| system.value("arm").map(str::to_owned));
    let mut options_found = options(&controller);
    options_found.extend(options(&system));
    ControllerInfo {
        serial: first("serialNumber"),
        version: version.filter(|version| !version.is_empty()).or(controller_version),
        arm_of_drawing: named_arm.is_none() && drawing.is_some(),
        arm: named_arm.or(drawing),
        arm_serial: arm.value("orderNumber").or_else(|| system.value("orderNumber")).map(str::to_owned),
        mount: arm.value("mount").map(str::to_owned),
        length_axis3: arm_file.length_axis3,
        simulation: controller.value("simulMode").map(str::to_owned),
        power_hours: controller.value("powerHourCount").and_then(|hours| hours.parse().ok()),
        language: cell.value("language").map(str::to_owned),
        auto_start: auto_start(&cell_text),
        options: options_found,
        add_ons: add_ons(&texts, &joined(&root.usr, "app")),
        applications: applications(files.files(), &root.usr),
        boards: boards(&controller),
        users: users(&mut texts, &configs, cell.value("defaultUser")),
        unread: texts.unread,
    }
}

/// Returns the text of the emulator's `.controller` file.
fn emulator(texts: &mut TextFiles<'_>, folder: &str) -> Option<String> {
    let files = texts.in_folder(folder);
    let is_controller = |name: &str| name.to_ascii_lowercase().ends_with(".controller");
    let (path, _) = files.into_iter().find(|(_, name)| is_controller(name))?;
    texts.text(path)
}

/// Returns the text in the first element with this name.
fn content(text: &str, name: &str) -> Option<String> {
    let parse = val3_syntax::parse(text);
    let element = xml::root(parse.view()).and_then(|root| descendant(root, name))?;
    let element = text.get(std::ops::Range::<usize>::from(View::range(element.view())))?;
    let (_, content) = element.split_once('>')?;
    Some(content.split('<').next()?.trim().to_owned()).filter(|content| !content.is_empty())
}

fn descendant<'g>(element: XmlElement<'g>, name: &str) -> Option<XmlElement<'g>> {
    element.elements().find_map(|inner| if inner.name() == name { Some(inner) } else { descendant(inner, name) })
}

/// Returns the name in `<autoStart name="…" location="…" />`.
fn auto_start(text: &str) -> Option<String> {
    let parse = val3_syntax::parse(text);
    let element = xml::root(parse.view())?.child(&["autoStart"])?;
    element.value("name").map(|name| name.trim().to_owned()).filter(|name| !name.is_empty())
}

/// Returns the names of the add-ons with tables in a folder.
fn add_ons(texts: &TextFiles<'_>, folder: &str) -> Vec<String> {
    let tables = texts.in_folder(folder);
    let mut names: Vec<String> = tables.into_iter().filter_map(|(_, file)| add_on(file)).map(str::to_owned).collect();
    names.sort_unstable();
    names.dedup();
    names
}

/// Returns the name of the add-on in the name of a table, for example `Motion` in `val3.Motion.anthro.cfx`.
fn add_on(table: &str) -> Option<&str> {
    let parts: Vec<&str> = table.split('.').collect();
    let [first, name, _, last] = parts.as_slice() else { return None };
    (first.eq_ignore_ascii_case("val3") && last.eq_ignore_ascii_case("cfx")).then_some(*name)
}

fn boards(controller: &Settings) -> Vec<Board> {
    let stated = BOARDS.iter().filter_map(|(setting, name)| Some((name, controller.value(setting)?)));
    stated.map(|(name, value)| Board { name: (*name).to_owned(), exists: value == "true" }).collect()
}
