//! Listings of folders: `MLSD` if the server names it, otherwise `LIST` in Unix or DOS form, otherwise `NLST`.

use suppaftp::list::{File, ListParser};
use suppaftp::{FtpError, Status};

use super::connection::{Connection, FtpClient, fault};
use super::transfer::read_lines;
use crate::access::{AccessFault, ListedEntry};
use crate::path::ControllerPath;

/// Command that lists folders.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum ListingCommand {
    /// Names with types.
    Mlsd,
    /// Lines for people.
    List,
    /// Only names, with or without their folder.
    Nlst,
}

impl ListingCommand {
    /// Returns the command according to `FEAT`.
    ///
    /// `FtpStream::feat` waits for a second line if a server has no features. With an expected status that no reply has,
    /// the complete reply is part of the error.
    pub(super) fn of_server(client: &mut FtpClient) -> Result<Self, AccessFault> {
        match client.custom_command("FEAT", &[Status::RestartMarker]) {
            Err(FtpError::UnexpectedResponse(reply)) => {
                let text = String::from_utf8_lossy(&reply.body).to_ascii_uppercase();
                let has_mlsd = text.lines().any(|line| matches!(line.split_whitespace().next(), Some("MLST" | "MLSD")));
                Ok(if has_mlsd { Self::Mlsd } else { Self::List })
            }
            Err(error) => Err(fault(error)),
            Ok(_) => Ok(Self::List),
        }
    }
}

/// Returns the sorted entries of a folder. A command that the server does not implement is replaced by the next one.
pub(super) fn list(
    connection: &mut Connection,
    folder: &ControllerPath,
    remote: &str,
    command: &mut ListingCommand,
) -> Result<Vec<ListedEntry>, AccessFault> {
    // The commands have no argument, because some servers interpret blanks, brackets and hyphens in it.
    connection.client.cwd(remote).map_err(fault)?;
    loop {
        let listed = match command {
            ListingCommand::Mlsd => read_lines(connection, "MLSD").and_then(|lines| entries(folder, &lines, mlsd)),
            ListingCommand::List => {
                read_lines(connection, "LIST").and_then(|lines| entries(folder, &lines, unix_or_dos))
            }
            ListingCommand::Nlst => names(connection).and_then(|names| with_types(connection, folder, remote, &names)),
        };
        match (&listed, *command) {
            (Err(AccessFault::Rejected { code: 500 | 502, .. }), ListingCommand::Mlsd) => {
                *command = ListingCommand::List;
            }
            (Err(AccessFault::Rejected { code: 500 | 502, .. }), ListingCommand::List) => {
                *command = ListingCommand::Nlst;
            }
            _ => return listed,
        }
    }
}

/// Name and type of a line; `None` for a line without an entry.
type ParsedLine = Result<Option<(String, bool)>, AccessFault>;

fn entries(
    folder: &ControllerPath,
    lines: &[String],
    parse: fn(&str) -> ParsedLine,
) -> Result<Vec<ListedEntry>, AccessFault> {
    let mut entries = Vec::new();
    for line in lines {
        let Some((name, is_folder)) = parse(line)? else { continue };
        // The folder and its parent are entries on some servers.
        if name == "." || name == ".." && is_folder {
            continue;
        }
        let path = folder.child(&name).map_err(AccessFault::Name)?;
        entries.push(ListedEntry { path, is_folder });
    }
    entries.sort();
    Ok(entries)
}

fn mlsd(line: &str) -> ParsedLine {
    let facts = line.split("; ").next().unwrap_or_default().to_ascii_lowercase();
    // The folder itself and its parent, whose names may be paths.
    if facts.split(';').any(|fact| fact == "type=cdir" || fact == "type=pdir") {
        return Ok(None);
    }
    // An unknown type, such as `OS.unix=slink:`, is an error of the parser.
    let parsed = ListParser::parse_mlsd(line).map_err(|_| AccessFault::Listing(line.to_owned()))?;
    entry(parsed)
}

fn unix_or_dos(line: &str) -> ParsedLine {
    let is_total = line.strip_prefix("total ").is_some_and(|rest| rest.trim().parse::<u64>().is_ok());
    if is_total {
        return Ok(None);
    }
    let parsed = ListParser::parse_posix(line).or_else(|_| ListParser::parse_dos(line));
    entry(parsed.map_err(|_| AccessFault::Listing(line.to_owned()))?)
}

fn entry(file: File) -> ParsedLine {
    if file.is_symlink() {
        return Err(AccessFault::Special(file.name().to_owned()));
    }
    Ok(Some((file.name().to_owned(), file.is_directory())))
}

/// Names of the current folder. Some servers return paths, others only names.
fn names(connection: &mut Connection) -> Result<Vec<String>, AccessFault> {
    let lines = match read_lines(connection, "NLST") {
        // No files (RFC 959, 5.4).
        Err(AccessFault::Rejected { code: 450, .. }) => Vec::new(),
        lines => lines?,
    };
    let last = |line: &String| line.rsplit('/').next().unwrap_or_default().to_owned();
    Ok(lines.iter().map(last).filter(|name| name != "." && name != "..").collect())
}

/// Determines types by entering: a name that can be entered is a folder.
fn with_types(
    connection: &mut Connection,
    folder: &ControllerPath,
    remote: &str,
    names: &[String],
) -> Result<Vec<ListedEntry>, AccessFault> {
    let mut entries = Vec::new();
    for name in names {
        let path = folder.child(name).map_err(AccessFault::Name)?;
        let is_folder = match connection.client.cwd(format!("{remote}/{name}")).map_err(fault) {
            Ok(()) => true,
            Err(AccessFault::Rejected { code: 501 | 550, .. }) => false,
            Err(other) => return Err(other),
        };
        entries.push(ListedEntry { path, is_folder });
    }
    entries.sort();
    Ok(entries)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn listed(parse: fn(&str) -> ParsedLine, lines: &[&str]) -> Result<Vec<(String, bool)>, AccessFault> {
        let lines: Vec<String> = lines.iter().map(|line| (*line).to_owned()).collect();
        let entries = entries(&ControllerPath::applications(), &lines, parse)?;
        Ok(entries.into_iter().map(|entry| (entry.path.name().to_owned(), entry.is_folder)).collect())
    }

    fn names(list: &[(&str, bool)]) -> Result<Vec<(String, bool)>, AccessFault> {
        Ok(list.iter().map(|(name, is_folder)| ((*name).to_owned(), *is_folder)).collect())
    }

    #[test]
    fn each_form_of_a_listing_is_read() {
        let unix =
            ["total 8", "drwxr-xr-x 2 root root 4096 Jan  1  1980 demo", "-rw-r--r-- 1 0 0 12 Mar  3 12:00 a b.pgx"];
        assert_eq!(listed(unix_or_dos, &unix), names(&[("a b.pgx", false), ("demo", true)]));
        let dos = ["01-05-21  08:00AM       <DIR>          demo", "01-05-21  08:00PM                 1234 A.PGX"];
        assert_eq!(listed(unix_or_dos, &dos), names(&[("A.PGX", false), ("demo", true)]));
        let mlsd_lines = [
            "type=cdir;modify=20210105080000; /usr/usrapp",
            "type=dir; demo",
            "type=file;size=3;modify=19800101000000; a; b.pgx",
        ];
        assert_eq!(listed(mlsd, &mlsd_lines), names(&[("a; b.pgx", false), ("demo", true)]));
    }

    #[test]
    fn untrusted_entries_stop_the_listing() {
        let link = "lrwxrwxrwx 1 root root 4 Jan  1  1980 out -> /etc";
        assert_eq!(listed(unix_or_dos, &[link]), Err(AccessFault::Special("out".to_owned())));
        assert!(matches!(listed(mlsd, &["type=file; ../x"]), Err(AccessFault::Name(_))));
        assert!(matches!(listed(mlsd, &["type=file; /etc/x"]), Err(AccessFault::Name(_))));
        assert!(matches!(listed(mlsd, &["type=file; .."]), Err(AccessFault::Name(_))));
        assert!(matches!(listed(mlsd, &["type=OS.unix=slink:/etc; x"]), Err(AccessFault::Listing(_))));
        assert_eq!(listed(unix_or_dos, &["hello"]), Err(AccessFault::Listing("hello".to_owned())));
    }
}
