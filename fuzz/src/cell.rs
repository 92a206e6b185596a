//! Applications and the files around them.

use camino::Utf8Path;
use val3_check::settings::RuleSelection;
use val3_check::testing::try_check;
use val3_config::ConfigFile;
use val3_machine::sio::channels;
use val3_syntax::encoding::decode;

/// Project file, data file and program file.
const APPLICATION: [&str; 3] =
    ["/cell/usr/usrapp/main/main.pjx", "/cell/usr/usrapp/main/main.dtx", "/cell/usr/usrapp/main/start.pgx"];

/// Controller files that have an effect on the check.
const CELL: [&str; 6] = [
    "/cell/usr/configs/arm.cfx",
    "/cell/usr/configs/cell.cfx",
    "/cell/usr/configs/sio.cfx",
    "/cell/usr/configs/bio.cfx",
    "/cell/usr/configs/bio2.cfx",
    "/cell/usr/app/val3.Motion.anthro.cfx",
];

const CONFIG: &str = "/cell/val3.toml";

/// Checks an application: `bytes` contain its project, data and program, separated by a zero byte.
pub fn check(bytes: &[u8]) {
    let parts = bytes.splitn(APPLICATION.len(), |byte| *byte == 0);
    check_all(&APPLICATION.iter().zip(parts).map(|(path, part)| file(path, part)).collect::<Vec<_>>());
}

/// Checks an application in a cell in which each controller file has these bytes.
pub fn cfx(bytes: &[u8]) {
    let cell = CELL.iter().map(|path| file(path, bytes));
    check_all(&application().chain(cell).collect::<Vec<_>>());
    let text = decode(bytes.to_vec()).text;
    for channel in channels(&text) {
        _ = (channel.port(), channel.target());
    }
}

/// Checks an application below a `val3.toml`. The line of a fault in it must be inside the text.
pub fn config(bytes: &[u8]) {
    if let Ok(text) = str::from_utf8(bytes)
        && let Err(error) = ConfigFile::parse(Utf8Path::new(CONFIG), text)
    {
        assert!((1..=text.lines().count().max(1) + 1).contains(&error.line()), "{error:?} lies outside its file");
    }
    check_all(&application().chain([file(CONFIG, bytes)]).collect::<Vec<_>>());
}

/// Returns the application in a seed of [`check`], without faults.
fn application() -> impl Iterator<Item = (String, Vec<u8>)> {
    let parts = include_bytes!("../corpus/check/whole").splitn(APPLICATION.len(), |byte| *byte == 0);
    APPLICATION.iter().zip(parts).map(|(path, part)| file(path, part))
}

fn file(path: &str, bytes: &[u8]) -> (String, Vec<u8>) {
    (path.to_owned(), bytes.to_vec())
}

/// Checks that each finding is inside its file. If a `val3.toml` has a fault, nothing is checked.
fn check_all(files: &[(String, Vec<u8>)]) {
    let Ok(findings) = try_check(files, &RuleSelection::default()) else { return };
    for finding in findings {
        let file = files.iter().find(|(path, _)| *path == finding.file);
        let lines = file.map_or(0, |(_, bytes)| bytes.split(|byte| *byte == b'\n').count());
        assert!(finding.line <= lines.max(1), "{finding:?} lies outside its file");
    }
}
