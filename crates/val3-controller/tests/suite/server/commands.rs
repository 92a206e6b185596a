//! Commands of the server.

use std::io::{Read as _, Write as _};
use std::net::{Ipv4Addr, SocketAddr, TcpListener, TcpStream};
use std::sync::Mutex;

use super::{Behaviour, Death, ListForm, ServerState, Tree};

/// Connection state.
#[derive(Default)]
pub(super) struct Session {
    folder: String,
    passive: Option<TcpListener>,
    /// Address of the client in active mode.
    active: Option<SocketAddr>,
    renamed: String,
    is_logged_in: bool,
    /// Whether the server closes the connection without a reply.
    pub(super) is_closed: bool,
}

type Reply<'a> = dyn FnMut(&str) -> bool + 'a;

impl Session {
    /// Executes a command. Returns the final reply; `None` if the connection ends without a reply.
    pub(super) fn execute(&mut self, line: &str, state: &Mutex<ServerState>, reply: &mut Reply<'_>) -> Option<String> {
        let (verb, argument) = line.split_once(' ').unwrap_or((line, ""));
        if !self.is_logged_in {
            return Some(self.log_in(verb, argument, &state.lock().unwrap().behaviour));
        }
        let mut state = state.lock().unwrap();
        if state.is_dead {
            return None;
        }
        let number = state.log.len();
        state.log.push(line.to_owned());
        if let Some((start, path, content)) = state.behaviour.change
            && line.starts_with(start)
        {
            state.tree.files.insert(path.to_owned(), content.to_vec());
            state.behaviour.change = None;
        }
        if let Some((_, has_reply)) = state.behaviour.closes.take_if(|(start, _)| line.starts_with(*start)) {
            self.is_closed = !has_reply;
            return has_reply.then(|| "421 idle".to_owned());
        }
        if state.behaviour.silence.is_some_and(|start| line.starts_with(start)) {
            return None;
        }
        if let Some((_, text)) = state.behaviour.rejections.iter().find(|(start, _)| line.starts_with(start)) {
            return Some((*text).to_owned());
        }
        let death = state.behaviour.death.filter(|(at, _)| *at == number).map(|(_, death)| death);
        if death == Some(Death::Before) {
            state.is_dead = true;
            return None;
        }
        let text = self.perform(verb, argument, line, &mut state, death, reply);
        if death.is_some() {
            state.is_dead = true;
            return None;
        }
        Some(text)
    }

    fn log_in(&mut self, verb: &str, argument: &str, behaviour: &Behaviour) -> String {
        match verb {
            "AUTH" => behaviour.auth_reply.to_owned(),
            "USER" => "331 password".to_owned(),
            "PASS" if argument == behaviour.password => {
                self.is_logged_in = true;
                "230 welcome".to_owned()
            }
            _ => "530 Login incorrect".to_owned(),
        }
    }

    fn perform(
        &mut self,
        verb: &str,
        argument: &str,
        line: &str,
        state: &mut ServerState,
        death: Option<Death>,
        reply: &mut Reply<'_>,
    ) -> String {
        let form = state.behaviour.form;
        match verb {
            "TYPE" | "NOOP" => "200 ok".to_owned(),
            "FEAT" if form == ListForm::Mlsd => "211-Features:\r\n MLST type*;size*;\r\n UTF8\r\n211 End".to_owned(),
            "FEAT" if form == ListForm::Dos => "211 no features".to_owned(),
            "CWD" if state.tree.folders.contains(&folder_path(argument)) => {
                self.folder = folder_path(argument);
                "250 ok".to_owned()
            }
            "CWD" => "550 no such folder".to_owned(),
            "PASV" => self.listen(),
            "PORT" => self.aim(argument),
            "MLSD" if form == ListForm::Mlsd => self.send(listing(&self.folder, state), line, state, reply),
            "LIST" if matches!(form, ListForm::Unix | ListForm::Dos) => {
                self.send(listing(&self.folder, state), line, state, reply)
            }
            "NLST" if matches!(form, ListForm::Names | ListForm::Paths) => {
                self.send(listing(&self.folder, state), line, state, reply)
            }
            "RETR" => match state.tree.files.get(&resolved(state, argument)).cloned() {
                Some(bytes) => self.send(bytes, line, state, reply),
                None => "550 no such file".to_owned(),
            },
            "STOR" => self.store(argument, line, state, death, reply),
            "RNFR" => {
                self.renamed = argument.to_owned();
                if state.tree.files.contains_key(argument) { "350 go on" } else { "550 no such file" }.to_owned()
            }
            "RNTO" if state.behaviour.keeps_targets && state.tree.files.contains_key(argument) => {
                "553 it exists".to_owned()
            }
            "RNTO" => {
                let bytes = state.tree.files.remove(&self.renamed).unwrap();
                let target = resolved(state, argument);
                state.tree.files.insert(target, bytes);
                "250 renamed".to_owned()
            }
            "DELE" if state.tree.files.remove(argument).is_some() => "250 deleted".to_owned(),
            "MKD" if state.tree.folders.insert(argument.to_owned()) => "257 created".to_owned(),
            "RMD" if state.tree.files.keys().any(|path| path.starts_with(&format!("{argument}/"))) => {
                "550 not empty".to_owned()
            }
            "RMD" if state.tree.folders.remove(argument) => "250 removed".to_owned(),
            "DELE" | "MKD" | "RMD" => "550 rejected".to_owned(),
            "QUIT" => "221 bye".to_owned(),
            _ => "500 unknown command".to_owned(),
        }
    }

    fn listen(&mut self) -> String {
        let listener = TcpListener::bind("127.0.0.1:0").unwrap();
        let port = listener.local_addr().unwrap().port();
        self.passive = Some(listener);
        // A server whose address a router translates replies with an unreachable address.
        format!("227 Entering Passive Mode (10,0,0,1,{},{})", port / 256, port % 256)
    }

    fn aim(&mut self, argument: &str) -> String {
        let bytes: Vec<u8> = argument.split(',').map(|byte| byte.parse().unwrap()).collect();
        let [a, b, c, d, high, low] = bytes[..] else { return "501 six numbers".to_owned() };
        self.active = Some((Ipv4Addr::new(a, b, c, d), u16::from(high) * 256 + u16::from(low)).into());
        "200 ok".to_owned()
    }

    fn data(&mut self, reply: &mut Reply<'_>) -> TcpStream {
        let socket = match self.active.take() {
            Some(client) => TcpStream::connect(client).unwrap(),
            None => self.passive.take().unwrap().accept().unwrap().0,
        };
        reply("150 opening");
        socket
    }

    fn send(&mut self, bytes: Vec<u8>, line: &str, state: &ServerState, reply: &mut Reply<'_>) -> String {
        let mut socket = self.data(reply);
        if state.behaviour.breaks.is_some_and(|start| line.starts_with(start)) {
            let _ = socket.write_all(&bytes[..bytes.len() / 2]);
            return "426 data connection lost".to_owned();
        }
        let _ = socket.write_all(&bytes);
        if state.behaviour.second_reply.is_some_and(|start| line.starts_with(start)) {
            reply("426 transfer interrupted");
        }
        "226 sent".to_owned()
    }

    fn store(
        &mut self,
        path: &str,
        line: &str,
        state: &mut ServerState,
        death: Option<Death>,
        reply: &mut Reply<'_>,
    ) -> String {
        let mut bytes = Vec::new();
        let _ = self.data(reply).read_to_end(&mut bytes);
        let path = resolved(state, path);
        let is_broken = state.behaviour.breaks.is_some_and(|start| line.starts_with(start));
        if is_broken || death == Some(Death::Half) {
            bytes.truncate(bytes.len() / 2);
            state.tree.files.insert(path, bytes);
            return "426 data connection lost".to_owned();
        }
        match &mut state.behaviour.space {
            Some(space) if *space < bytes.len() => {
                bytes.truncate(*space);
                state.tree.files.insert(path, bytes);
                "452 Insufficient storage space".to_owned()
            }
            space => {
                space.iter_mut().for_each(|space| *space -= bytes.len());
                state.tree.files.insert(path, bytes);
                "226 stored".to_owned()
            }
        }
    }
}

fn folder_path(argument: &str) -> String {
    argument.trim_end_matches('/').to_owned()
}

/// Path of an existing file with the same name; letter case is ignored if the server does so.
fn resolved(state: &ServerState, path: &str) -> String {
    let is_same = |other: &&String| other.eq_ignore_ascii_case(path);
    let found = state.tree.files.keys().find(is_same).filter(|_| state.behaviour.ignores_case);
    found.map_or(path, String::as_str).to_owned()
}

/// Bytes of a listing.
fn listing(folder: &str, state: &ServerState) -> Vec<u8> {
    let Tree { files, folders } = &state.tree;
    let own = |path: &&String| path.rsplit_once('/').is_some_and(|(parent, _)| parent == folder) && !path.is_empty();
    let form = state.behaviour.form;
    let mut lines: Vec<String> = match form {
        ListForm::Mlsd => vec![format!("type=cdir; {folder}"), "type=pdir; ..".to_owned()],
        ListForm::Unix => vec!["total 3".to_owned()],
        _ => Vec::new(),
    };
    let entries = files.keys().filter(own).map(|path| (path, false));
    for (path, is_folder) in entries.chain(folders.iter().filter(own).map(|path| (path, true))) {
        let name = path.rsplit('/').next().unwrap();
        lines.push(match (form, is_folder) {
            (ListForm::Mlsd, true) => format!("type=dir;modify=20260101000000; {name}"),
            (ListForm::Mlsd, false) => format!("type=file;size=0; {name}"),
            (ListForm::Unix, true) => format!("drwxr-xr-x   2 0  0   512 Jan  1  1980 {name}"),
            (ListForm::Unix, false) => format!("-rw-r--r--   1 0  0   512 Jan  1  1980 {name}"),
            (ListForm::Dos, true) => format!("01-01-80  12:00AM       <DIR>          {name}"),
            (ListForm::Dos, false) => format!("01-01-80  12:00AM                  512 {name}"),
            (ListForm::Names, _) => name.to_owned(),
            (ListForm::Paths, _) => path.clone(),
        });
    }
    lines.extend(state.behaviour.extra_lines.iter().map(|line| (*line).to_owned()));
    lines.iter().flat_map(|line| format!("{line}\r\n").into_bytes()).collect()
}
