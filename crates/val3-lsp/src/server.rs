//! The server process: threads, pipes and termination.

use std::io::{self, BufRead, BufReader, Write};
use std::thread;

use camino::Utf8PathBuf;
use futures::channel::mpsc::UnboundedSender;
use tokio::sync::mpsc::{UnboundedReceiver, unbounded_channel};
use tower_lsp::{LspService, Server};

use crate::inbox::Inbox;
use crate::lifecycle::Lifecycle;
use crate::log::ServerLog;
use crate::outbox::Outbox;
use crate::pool::Pool;
use crate::requests::routes;
use crate::router::Router;
use crate::routes::Routes;
use crate::server_state::ServerState;
use crate::transport::{Intake, Pump, PumpWriter, read};

/// Stack size of the main loop in bytes; the main loop also parses.
const STACK_SIZE: usize = 16 << 20;

/// Start options of the server.
#[derive(Debug, Clone)]
pub struct ServerOptions {
    /// Path of the log file.
    pub log: Option<Utf8PathBuf>,
    /// The executable `val3`, with which clients execute tests.
    pub executable: String,
    /// Version that clients show.
    pub version: String,
}

impl Default for ServerOptions {
    /// No log, the `val3` in the PATH, and the version of the library.
    fn default() -> Self {
        Self { log: None, executable: "val3".to_owned(), version: env!("CARGO_PKG_VERSION").to_owned() }
    }
}

/// Serves one client until the session ends, and returns the exit code: 0 after `shutdown` and `exit`, otherwise 1.
/// Threads that still run when it returns end with the process.
///
/// # Errors
/// If the log cannot be opened or a thread cannot be started.
pub fn run(
    input: impl io::Read + Send + 'static,
    output: impl Write + Send + 'static,
    options: &ServerOptions,
) -> io::Result<u8> {
    serve(input, output, options, routes())
}

/// Like [`run`], with other handlers, for tests.
pub(crate) fn serve(
    input: impl io::Read + Send + 'static,
    output: impl Write + Send + 'static,
    options: &ServerOptions,
    routes: Routes,
) -> io::Result<u8> {
    let (exit, exited) = unbounded_channel();
    let closed = exit.clone();
    // Sending fails if the server is already ending for another reason.
    let pump = Pump::start(output, move || _ = closed.send(false))?;
    let (inbox, messages) = Inbox::new();
    let outbox = Outbox::new(pump.clone());
    let log = ServerLog::open(options.log.as_deref())?;
    let server = ServerState::new(inbox.clone(), outbox, Pool::start()?, log.clone(), &options.executable);
    let main_loop = thread::Builder::new().name("main loop".to_owned()).stack_size(STACK_SIZE);
    main_loop.spawn(move || server.run(&messages))?;
    let (requests, intake) = Intake::new();
    start_reading(BufReader::new(input), requests, inbox.clone(), pump.clone())?;
    let version = options.version.clone();
    let (lifecycle, socket) = LspService::new(|_| Lifecycle { inbox: inbox.clone(), log: log.clone(), version });
    let router = Router::new(lifecycle, routes, inbox, pump.clone(), exit);
    // No limit here, because the thread pool limits the work.
    let server = Server::new(intake, PumpWriter(pump.clone()), socket).concurrency_level(usize::MAX);
    let runtime = tokio::runtime::Builder::new_current_thread().build()?;
    let code = runtime.block_on(end_of(server.serve(router), exited));
    runtime.shutdown_background();
    pump.finish();
    Ok(code)
}

/// Waits for the end of the session, and returns the exit code. The session ends with `exit`, the end of the input, or
/// a closed output.
async fn end_of(serving: impl Future<Output = ()>, mut exited: UnboundedReceiver<bool>) -> u8 {
    let was_shut_down = tokio::select! {
        was_shut_down = exited.recv() => was_shut_down,
        // `exit` may have been read together with the end of the input.
        () = serving => exited.try_recv().ok(),
    };
    u8::from(was_shut_down != Some(true))
}

fn start_reading(
    input: impl BufRead + Send + 'static,
    requests: UnboundedSender<Vec<u8>>,
    inbox: Inbox,
    pump: Pump,
) -> io::Result<()> {
    let reading = thread::Builder::new().name("input".to_owned());
    let answered = move |id, answer| inbox.post(move |server| server.answered(id, answer));
    reading.spawn(move || read(input, &requests, answered, &pump))?;
    Ok(())
}
