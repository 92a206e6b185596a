//! The addresses of the cell's Modbus server.

use val3_analysis::cell::CellText;
use val3_lines::LineIndex;
use val3_machine::io::IoTable;
use val3_modbus::{DEVICE, FileFault, ModbusFile, ModbusMap, NotServed};
use val3_session::Application;

use crate::output::to_stderr;
use crate::paths::{Paths, current_folder};
use crate::printable::one_line;
use crate::user_error::UserError;

/// Maximum number of listed links.
const MOST_LINKS: usize = 20;

/// Help for a file whose topics cannot be served.
const ONE_TOPIC: &str = "set `Actif` to 1 in the topic that shall be served, and to 0 in all others";

/// Reads the addresses from the cell's file, and shows faults that do not prevent a server.
///
/// # Errors
/// The file is missing, or does not determine all addresses.
pub(super) fn map(application: &Application, io_table: &IoTable) -> Result<ModbusMap, UserError> {
    let db = application.db();
    let io = application.project().cell(db).map(|cell| &cell.config(db).io);
    let file = io.and_then(|io| io.modbus.as_ref()).ok_or_else(|| missing(io_table))?;
    let path = Paths::new(&[], &current_folder()?).to_open(&file.path);
    let content = ModbusFile::read(&file.text);
    let map = ModbusMap::of(&content).map_err(|reason| unusable(&path, file, reason))?;
    if !content.faults.is_empty() {
        to_stderr(|out| writeln!(out, "{}", listed("warning: ", &path, file, &content.faults)));
    }
    Ok(map)
}

/// Error of a cell without the file. Links contain no addresses, but show which items the application needs.
fn missing(io: &IoTable) -> UserError {
    let paths = io.signals().filter_map(|signal| io.signal(signal)).map(|signal| signal.path.as_str());
    let linked: Vec<&str> = paths.filter(|path| path.split('\\').next() == Some(DEVICE)).collect();
    let mut lines: Vec<String> = linked.iter().take(MOST_LINKS).map(|link| format!("  {}", one_line(link))).collect();
    match linked.len().saturating_sub(MOST_LINKS) {
        0 => {}
        more => lines.push(format!("  and {more} more")),
    }
    if !lines.is_empty() {
        lines.insert(0, "  the application has links to these items:".to_owned());
    }
    UserError::new("the cell has no Modbus server: `usr/applicom/Modbus/modbus.xml` does not exist")
        .with_details(lines.join("\n"))
        .with_help(
            "copy the file from the controller to `applicom/Modbus` next to `usrapp`: links contain no addresses",
        )
}

fn unusable(path: &str, file: &CellText, reason: NotServed) -> UserError {
    let error = |problem: &str| UserError::new(format!("`{path}` cannot be served: {problem}"));
    match reason {
        NotServed::Faults(faults) => {
            error("it does not determine all addresses").with_details(listed("  ", path, file, &faults))
        }
        NotServed::NoTopic => error("no topic is active").with_help(ONE_TOPIC),
        NotServed::Topics(names) => {
            error(&format!("several topics are active: {}", names.join(", "))).with_help(ONE_TOPIC)
        }
        NotServed::NoClients { topic } => {
            error(&format!("it has no number of clients for `{topic}`")).with_help(format!(
                "write <GENERAL_PARAMETERS TopicName=\"{topic}\" TCP_Port=\"502\" ConnectionNumber=\"2\"/> at its end"
            ))
        }
    }
}

/// Formats faults, one in each line: `usr/applicom/Modbus/modbus.xml:5: …`.
fn listed(start: &str, path: &str, file: &CellText, faults: &[FileFault]) -> String {
    let lines = LineIndex::new(&file.text);
    let faults = faults.iter().map(|fault| format!("{path}:{}: {}", lines.line(fault.offset) + 1, fault.kind));
    faults.map(|fault| format!("{start}{}", one_line(&fault))).collect::<Vec<_>>().join("\n")
}
