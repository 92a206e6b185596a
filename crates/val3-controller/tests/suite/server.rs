//! An FTP server in memory with configurable faults.

mod commands;

use std::collections::{BTreeMap, BTreeSet};
use std::io::{BufRead as _, BufReader, Write as _};
use std::net::{TcpListener, TcpStream};
use std::sync::{Arc, Mutex, MutexGuard};
use std::thread;

use val3_controller::{AccessError, ConnectionSettings, FtpAddress, FtpFiles, FtpTimeouts, Password, ServerAddress};

use commands::Session;

/// Files and folders by absolute path.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub(crate) struct Tree {
    pub(crate) files: BTreeMap<String, Vec<u8>>,
    pub(crate) folders: BTreeSet<String>,
}

/// Form of a listing.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub(crate) enum ListForm {
    /// `MLSD`, which `FEAT` names.
    #[default]
    Mlsd,
    /// `LIST` as Unix.
    Unix,
    /// `LIST` as DOS.
    Dos,
    /// Only `NLST`, with names.
    Names,
    /// Only `NLST`, with paths.
    Paths,
}

/// Moment at which the server dies, relative to the command.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Death {
    /// The command has no effect.
    Before,
    /// Half of the transferred bytes are stored.
    Half,
    /// The command is executed, but has no reply.
    After,
}

/// Deviations from a good server.
#[derive(Debug, Clone, Default)]
pub(crate) struct Behaviour {
    pub(crate) form: ListForm,
    /// `RNTO` over a file is rejected.
    pub(crate) keeps_targets: bool,
    /// Names are compared without regard to case.
    pub(crate) ignores_case: bool,
    /// Commands whose start is rejected with a reply.
    pub(crate) rejections: Vec<(&'static str, &'static str)>,
    /// Start of a command whose data connection ends in the middle.
    pub(crate) breaks: Option<&'static str>,
    /// Free space in bytes.
    pub(crate) space: Option<usize>,
    /// Start of a command before which a file gets another content, as by another client.
    pub(crate) change: Option<(&'static str, &'static str, &'static [u8])>,
    /// Start of a command that has no reply.
    pub(crate) silence: Option<&'static str>,
    /// Start of a command whose transfer has a reply about its interruption, and the usual reply later.
    pub(crate) second_reply: Option<&'static str>,
    /// Lines added to each listing.
    pub(crate) extra_lines: Vec<&'static str>,
    pub(crate) password: &'static str,
    /// Reply to `AUTH`.
    pub(crate) auth_reply: &'static str,
    /// Start of a command at which the connection is closed once, and whether the server replies with 421 before.
    pub(crate) closes: Option<(&'static str, bool)>,
    /// Number of the command at which the server dies, counted after the login from 0.
    pub(crate) death: Option<(usize, Death)>,
}

/// State that all connections share.
#[derive(Debug, Default)]
pub(crate) struct ServerState {
    pub(crate) tree: Tree,
    pub(crate) behaviour: Behaviour,
    /// Commands after the login.
    pub(crate) log: Vec<String>,
    /// Whether the server has died: it accepts no connection.
    pub(crate) is_dead: bool,
}

/// A running server. Its threads end with the process.
#[derive(Clone)]
pub(crate) struct Server {
    state: Arc<Mutex<ServerState>>,
    port: u16,
    /// Whether clients use the active mode.
    pub(crate) is_active: bool,
}

impl Server {
    pub(crate) fn start(tree: Tree, behaviour: Behaviour) -> Self {
        let listener = TcpListener::bind("127.0.0.1:0").unwrap();
        let port = listener.local_addr().unwrap().port();
        let state = Arc::new(Mutex::new(ServerState { tree, behaviour, ..ServerState::default() }));
        let shared = Arc::clone(&state);
        thread::spawn(move || {
            for socket in listener.incoming().map(Result::unwrap) {
                let shared = Arc::clone(&shared);
                thread::spawn(move || serve(socket, &shared));
            }
        });
        Self { state, port, is_active: false }
    }

    pub(crate) fn state(&self) -> MutexGuard<'_, ServerState> {
        self.state.lock().unwrap()
    }

    /// Replaces the behaviour, and revives the server.
    pub(crate) fn behave(&self, behaviour: Behaviour) {
        let mut state = self.state();
        (state.behaviour, state.is_dead) = (behaviour, false);
        state.log.clear();
    }

    pub(crate) fn address(&self) -> FtpAddress {
        FtpAddress {
            is_encrypted: false,
            server: ServerAddress { user: "default".into(), host: "127.0.0.1".into(), port: self.port },
            base: String::new(),
        }
    }

    pub(crate) fn try_connect(&self, password: &str) -> Result<FtpFiles, AccessError> {
        let limit = std::time::Duration::from_millis(400);
        let timeouts = FtpTimeouts { connect: limit, transfer: limit };
        let settings = ConnectionSettings { fingerprint: None, is_active: self.is_active };
        FtpFiles::connect(self.address(), Password::new(password.to_owned()), settings, timeouts)
    }

    pub(crate) fn connect(&self) -> FtpFiles {
        self.try_connect("").unwrap()
    }
}

/// Serves one connection.
fn serve(socket: TcpStream, state: &Mutex<ServerState>) {
    if state.lock().unwrap().is_dead {
        return;
    }
    // Two replies in succession would wait for an acknowledgement.
    socket.set_nodelay(true).unwrap();
    let mut lines = BufReader::new(socket.try_clone().unwrap()).lines();
    let mut session = Session::default();
    let mut reply = |text: &str| (&socket).write_all(format!("{text}\r\n").as_bytes()).is_ok();
    reply("220 ready");
    while let Some(Ok(line)) = lines.next() {
        match session.execute(&line, state, &mut reply) {
            Some(text) if !reply(&text) || text.starts_with("421 idle") => return,
            Some(_) => {}
            // The server is dead, has closed the connection, or is silent.
            None if session.is_closed || state.lock().unwrap().is_dead => return,
            None => {}
        }
    }
}
