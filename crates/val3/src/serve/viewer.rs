//! Connection to a viewer.

use std::future::ready;
use std::sync::Arc;
use std::sync::mpsc::TrySendError;
use std::time::Instant;

use axum::body::Bytes;
use axum::extract::ws::{CloseFrame, Message as Frame, Utf8Bytes, WebSocket, close_code};
use tokio::sync::mpsc;
use tokio::time::{interval, timeout};

use super::access::ViewerRole;
use super::command::{Parsed, PendingCommand, answer};
use super::log::{LogCursor, OlderPart, StoredMessage};
use super::quota::{Admission, Quota};
use super::shared::Shared;

/// Maximum number of messages read from the log in one call.
const BATCH: usize = 64;

/// Role in the scene. The text is unique, because data names contain no quotation marks.
const OPERATOR: &str = r#""role":"operator""#;

/// Role of a guest in the scene.
const GUEST: &str = r#""role":"guest""#;

/// Maximum number of a viewer's commands without a response.
const OPEN_COMMANDS: usize = 64;

/// End of a connection, with the reason for the viewer; `None` if the viewer cannot be reached.
type Departure = Option<(u16, &'static str)>;

/// Viewer of a run.
pub(super) struct Viewer {
    shared: Arc<Shared>,
    role: ViewerRole,
    socket: WebSocket,
    /// Cursor in the log; `None` before the first message.
    cursor: Option<LogCursor>,
    quota: Quota,
    /// Time of the last received frame.
    heard: Instant,
    answers: mpsc::Sender<Utf8Bytes>,
}

/// Serves a viewer until it disconnects, stops reading, or violates the protocol.
pub(super) async fn attend(socket: WebSocket, role: ViewerRole, shared: Arc<Shared>) {
    let (answers, inbox) = mpsc::channel(OPEN_COMMANDS);
    let now = Instant::now();
    let quota = Quota::new(shared.limits.commands, now);
    let mut viewer = Viewer { shared, role, socket, cursor: None, quota, heard: now, answers };
    if let Err(Some((code, reason))) = viewer.run(inbox).await {
        viewer.close(Frame::Close(Some(CloseFrame { code, reason: reason.into() }))).await;
    }
}

impl Viewer {
    async fn run(&mut self, mut inbox: mpsc::Receiver<Utf8Bytes>) -> Result<(), Departure> {
        let mut news = self.shared.log.subscribe();
        let mut is_over = self.shared.is_over.clone();
        let mut pings = interval(self.shared.limits.ping_time);
        loop {
            news.mark_unchanged();
            // Older parts are sent while no new message waits.
            let has_more = self.send_batch(&mut inbox).await? || self.send_older().await?;
            if !has_more && *is_over.borrow_and_update() {
                return Err(Some((close_code::AWAY, "the run has ended")));
            }
            tokio::select! {
                received = self.socket.recv() => self.receive(received.and_then(Result::ok)).await?,
                Some(answer) = inbox.recv() => self.send(Frame::Text(answer)).await?,
                _ = news.changed() => {}
                _ = is_over.changed() => {}
                _ = pings.tick() => self.ping().await?,
                () = ready(()), if has_more => {}
            }
        }
    }

    /// Sends the next messages from the log. Each answer is sent before the messages that were published after it.
    /// Returns whether more messages follow.
    async fn send_batch(&mut self, inbox: &mut mpsc::Receiver<Utf8Bytes>) -> Result<bool, Departure> {
        let messages = self.shared.log.lock().messages_since(&mut self.cursor, BATCH);
        let has_more = messages.len() >= BATCH;
        while let Ok(answer) = inbox.try_recv() {
            self.send(Frame::Text(answer)).await?;
        }
        for message in messages {
            self.send_stored(message).await?;
        }
        Ok(has_more)
    }

    /// Sends the next older part of the run. Returns whether the viewer has not received all parts.
    async fn send_older(&mut self) -> Result<bool, Departure> {
        let older = self.shared.log.lock().older(&mut self.cursor);
        match older {
            Some(OlderPart::Block(block)) => self.send_stored(block.encoded()).await?,
            Some(OlderPart::End(message)) => self.send_stored(message).await?,
            None => return Ok(false),
        }
        Ok(true)
    }

    async fn send_stored(&mut self, message: StoredMessage) -> Result<(), Departure> {
        let frame = match message {
            StoredMessage::Text(text) => Frame::Text(text),
            StoredMessage::Lasting(text) => Frame::Text(self.for_role(text)),
            StoredMessage::Binary(bytes) => Frame::Binary(bytes),
        };
        self.send(frame).await
    }

    /// Replaces the role in the scene by the role of the viewer.
    fn for_role(&self, text: Utf8Bytes) -> Utf8Bytes {
        match self.role {
            ViewerRole::Operator => text,
            ViewerRole::Guest => text.replacen(OPERATOR, GUEST, 1).into(),
        }
    }

    /// Sends a frame. A viewer that does not read in time is disconnected.
    async fn send(&mut self, frame: Frame) -> Result<(), Departure> {
        match timeout(self.shared.limits.send_time, self.socket.send(frame)).await {
            Ok(Ok(())) => Ok(()),
            Ok(Err(_)) | Err(_) => Err(None),
        }
    }

    /// Sends the close frame, and waits until the viewer has read all frames. Closing a socket with unread frames from
    /// the viewer, for example a pong, would reset the connection and discard frames that the viewer has not read.
    async fn close(mut self, goodbye: Frame) {
        let all_read = async {
            if self.socket.send(goodbye).await.is_ok() {
                while let Some(Ok(_)) = self.socket.recv().await {}
            }
        };
        // The connection ends also after a timeout.
        let _ = timeout(self.shared.limits.send_time, all_read).await;
    }

    async fn ping(&mut self) -> Result<(), Departure> {
        if self.heard.elapsed() > self.shared.limits.silence {
            return Err(None);
        }
        self.send(Frame::Ping(Bytes::new())).await
    }

    /// Handles a frame from the viewer; `None` if the connection has ended or is broken.
    async fn receive(&mut self, frame: Option<Frame>) -> Result<(), Departure> {
        self.heard = Instant::now();
        match frame {
            Some(Frame::Text(text)) => self.handle(&text).await,
            Some(Frame::Binary(_)) => Err(Some((close_code::UNSUPPORTED, "commands are texts"))),
            Some(Frame::Ping(_) | Frame::Pong(_)) => self.limit_frames(),
            Some(Frame::Close(_)) | None => Err(None),
        }
    }

    /// Counts a control frame as a command, because processing takes time and some control frames have a response.
    fn limit_frames(&mut self) -> Result<(), Departure> {
        match self.quota.admit(Instant::now()) {
            Admission::Granted | Admission::Refused => Ok(()),
            Admission::Expelled => Err(Some(FLOOD)),
        }
    }

    async fn handle(&mut self, text: &str) -> Result<(), Departure> {
        let admission = self.quota.admit(Instant::now());
        if admission == Admission::Expelled {
            return Err(Some(FLOOD));
        }
        let Parsed { id, command } = Parsed::of(text);
        let passed = match command {
            _ if admission == Admission::Refused => Err("too many commands in a short time"),
            Err(reason) => Err(reason),
            Ok(_) if self.role == ViewerRole::Guest => Err("guests cannot operate the cell"),
            Ok((name, message)) => match self.answers.clone().try_reserve_owned() {
                Ok(permit) => self.pass(PendingCommand::new(id.clone(), name, message, permit)),
                Err(_) => Err("too many commands are not answered yet"),
            },
        };
        match passed {
            Ok(()) => Ok(()),
            Err(reason) => self.send(Frame::Text(answer(&id, Err(reason.to_owned())))).await,
        }
    }

    /// Passes a command to the run loop.
    fn pass(&self, command: PendingCommand) -> Result<(), &'static str> {
        self.shared.commands.try_send(command).map_err(|error| match error {
            TrySendError::Full(_) => "the run is busy",
            TrySendError::Disconnected(_) => "the run has ended",
        })
    }
}

/// Close reason for viewers that exceed the quota.
const FLOOD: (u16, &str) = (close_code::POLICY, "too many commands");
