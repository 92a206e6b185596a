//! Serial lines and sockets of the controller, by link text (3.7).

use std::cell::{Cell, RefCell};
use std::collections::BTreeMap;
use std::rc::Rc;

use val3_lang::fault::{self, Fault};
use val3_lang::ports::{Reply, TaskNumber, nanoseconds};
use val3_lang::runtime_errors::UNLINKED;

use crate::event::EventKind;
use crate::inputs::Inputs;
use crate::sio::{
    Attempt, ByteStream, Channel, ChannelConfig, ChannelState, LineKind, LineRecorder, NetworkAccess, RecordedReply,
    RecorderState, Replay, ScriptedPeer, Sending, SettingRefusal, SocketGuard, UnfinishedString,
};

/// All lines that are configured or linked by variables.
#[derive(Default)]
pub struct ChannelTable {
    pub(super) lines: Vec<NamedLine>,
    /// The bytes that tasks are sending.
    sending: BTreeMap<TaskNumber, Sending>,
    /// Results of lines since the last `take_answers`, if they are recorded.
    answers: Option<Answers>,
    /// Whether a line had a peer at the last check.
    had_peer: bool,
    /// Output of the cycle over lines whose other end is a script, by link.
    pub(super) output: BTreeMap<String, Vec<u8>>,
    /// Recorded results by link, which lines return instead of external results.
    replay: Option<BTreeMap<String, Vec<RecordedReply>>>,
    pub(super) inputs: Inputs,
    /// Whether the current instruction has used a link that is not configured.
    is_missing: bool,
}

/// Results with the link of the line. Each recorder shares the list.
type Answers = Rc<RefCell<Vec<(String, RecordedReply)>>>;

/// Line with its link.
pub(super) struct NamedLine {
    pub(super) link: String,
    /// `None` for a link that is not configured.
    pub(super) channel: Option<RecordedChannel>,
    /// Whether a program has used the line and not closed it since.
    in_use: bool,
    /// Task that has used the line last, shown to users.
    user: Option<TaskNumber>,
    /// Whether its input arrives in wall-clock time.
    is_outside: bool,
    /// Whether a variable or the configuration names it, not only a script.
    is_known: bool,
    /// The script, if it is the other end.
    pub(super) script: Option<ScriptedPeer>,
}

impl NamedLine {
    /// Whether a program uses the line, and a peer is connected or called.
    fn has_peer(&self) -> bool {
        self.in_use && self.channel.as_ref().is_some_and(|recorded| recorded.channel.has_peer())
    }
}

pub(super) struct RecordedChannel {
    pub(super) channel: Channel,
    recorder: Rc<Cell<RecorderState>>,
}

/// State of all lines in a snapshot.
#[derive(Debug, Clone)]
pub struct LinesState {
    lines: Vec<(Option<(ChannelState, RecorderState)>, bool)>,
    sending: BTreeMap<TaskNumber, Sending>,
    answers: Option<Vec<(String, RecordedReply)>>,
    had_peer: bool,
    output: BTreeMap<String, Vec<u8>>,
}

impl ChannelTable {
    /// Creates an empty list of lines, whose calls will pass through this recorder.
    pub(super) fn new(inputs: Inputs) -> Self {
        Self { inputs, ..Self::default() }
    }

    /// Recorder of the calls to lines.
    pub(crate) fn inputs(&self) -> &Inputs {
        &self.inputs
    }

    /// Returns a copy of all lines' states.
    pub(crate) fn state(&self) -> LinesState {
        let channel = |line: &RecordedChannel| (line.channel.state(), line.recorder.get());
        LinesState {
            lines: self.lines.iter().map(|line| (line.channel.as_ref().map(channel), line.in_use)).collect(),
            sending: self.sending.clone(),
            answers: self.answers.as_ref().map(|answers| answers.borrow().clone()),
            had_peer: self.had_peer,
            output: self.output.clone(),
        }
    }

    /// Restores a state and removes newer links. Peers receive nothing.
    pub(crate) fn restore(&mut self, state: &LinesState) {
        self.lines.truncate(state.lines.len());
        for (line, (channel, in_use)) in self.lines.iter_mut().zip(&state.lines) {
            line.in_use = *in_use;
            if let (Some(line), Some((channel, recorder))) = (&mut line.channel, channel) {
                line.channel.restore(channel.clone());
                line.recorder.set(*recorder);
            }
        }
        self.sending = state.sending.clone();
        if let (Some(answers), Some(saved)) = (&self.answers, &state.answers) {
            answers.borrow_mut().clone_from(saved);
        }
        self.had_peer = state.had_peer;
        self.output.clone_from(&state.output);
    }

    /// Removes and returns the unsent bytes of a task.
    pub(super) fn take_sending(&mut self, task: TaskNumber) -> Option<Sending> {
        self.sending.remove(&task)
    }

    /// Stores the unsent bytes of a task until its next turn.
    pub(super) fn keep_sending(&mut self, task: TaskNumber, sending: Sending) {
        self.sending.insert(task, sending);
    }

    /// Discards the unsent bytes of a task that has ended.
    pub(super) fn forget_sending(&mut self, task: TaskNumber) {
        self.sending.remove(&task);
    }

    /// Opens the configured lines to the outside, within `reach`. A serial line has no device until one is
    /// [attached](Self::attach). `guard_of` returns the guard that has to permit the socket of a line.
    ///
    /// # Errors
    /// Link of the first line that does not support its configuration.
    pub fn configure(
        &mut self,
        configs: &[ChannelConfig],
        reach: NetworkAccess,
        guard_of: &dyn Fn(&ChannelConfig) -> Option<Rc<dyn SocketGuard>>,
    ) -> Result<(), String> {
        for config in configs {
            if let Some(line) = self.line(config, reach, guard_of(config)) {
                let channel = self.recorded(config, line).map_err(|_| config.link.clone())?;
                self.put(&config.link, channel, self.replay.is_none());
                self.known_number(&config.link);
            }
        }
        Ok(())
    }

    /// Connects a link to a line. `config` may contain parameters of the line.
    ///
    /// # Errors
    /// If the line does not support its configuration.
    pub fn attach(
        &mut self,
        config: &ChannelConfig,
        line: Box<dyn ByteStream>,
        is_outside: bool,
    ) -> Result<(), SettingRefusal> {
        let channel = self.recorded(config, line)?;
        self.put(&config.link, channel, is_outside);
        self.known_number(&config.link);
        Ok(())
    }

    /// Records the results of lines that are configured from now on.
    pub fn record(&mut self) {
        self.answers = Some(Rc::default());
    }

    /// Replays recorded results, by link, on lines that are configured from now on. A line without entries stays
    /// silent.
    pub fn replay(&mut self, entries: BTreeMap<String, Vec<RecordedReply>>) {
        self.replay = Some(entries);
    }

    /// Results of recorded lines since the last call.
    pub(super) fn take_answers(&mut self) -> Vec<(String, RecordedReply)> {
        self.answers.as_ref().map(|answers| std::mem::take(&mut *answers.borrow_mut())).unwrap_or_default()
    }

    fn line(
        &mut self,
        config: &ChannelConfig,
        reach: NetworkAccess,
        guard: Option<Rc<dyn SocketGuard>>,
    ) -> Option<Box<dyn ByteStream>> {
        match (&mut self.replay, guard) {
            (Some(entries), _) => {
                let entries = entries.remove(&config.link).unwrap_or_default();
                Some(Box::new(Replay::new(config.kind, entries)))
            }
            (None, Some(guard)) => config.guarded(reach, guard),
            (None, None) => config.socket(reach),
        }
    }

    /// Channel on a line whose calls pass through the recorder of external input.
    pub(super) fn recorded(
        &self,
        config: &ChannelConfig,
        line: Box<dyn ByteStream>,
    ) -> Result<RecordedChannel, SettingRefusal> {
        let (answers, link) = (self.answers.clone(), config.link.clone());
        let recorder = LineRecorder::new(line, self.inputs.clone(), move |entry| {
            if let Some(answers) = &answers {
                answers.borrow_mut().push((link.clone(), entry));
            }
        });
        let state = recorder.state();
        Ok(RecordedChannel { channel: config.channel(Box::new(recorder))?, recorder: state })
    }

    pub(super) fn put(&mut self, link: &str, channel: RecordedChannel, is_outside: bool) {
        let number = self.number(link) as usize;
        if let Some(known) = self.lines.get_mut(number) {
            (known.channel, known.is_outside, known.in_use) = (Some(channel), is_outside, false);
            known.script = None;
        }
    }

    /// Number of a link, which variables store.
    pub(super) fn number(&mut self, link: &str) -> u32 {
        let at = self.lines.iter().position(|known| known.link.eq_ignore_ascii_case(link)).unwrap_or_else(|| {
            let (link, script) = (link.to_owned(), None);
            let (in_use, user, is_outside, is_known) = (false, None, false, false);
            self.lines.push(NamedLine { link, channel: None, in_use, user, is_outside, is_known, script });
            self.lines.len() - 1
        });
        u32::try_from(at).unwrap_or(u32::MAX)
    }

    /// Like [`number`](Self::number), for a link of a variable or of the configuration.
    pub(super) fn known_number(&mut self, link: &str) -> u32 {
        let number = self.number(link);
        if let Some(known) = self.lines.get_mut(number as usize) {
            known.is_known = true;
        }
        number
    }

    /// Number of bytes that waiting tasks have to send.
    pub(super) fn pending(&self) -> usize {
        self.sending.values().map(Sending::total).sum()
    }

    /// The text of a link.
    pub(super) fn link(&self, number: u32) -> Option<&str> {
        self.lines.get(number as usize).map(|known| known.link.as_str())
    }

    /// The state of a line, for users.
    pub(super) fn state_of(&self, number: u32) -> &'static str {
        match self.lines.get(number as usize) {
            Some(NamedLine { in_use: true, .. }) => "in use",
            Some(NamedLine { channel: Some(_), .. }) => "not in use",
            _ => "not configured",
        }
    }

    /// Whether the line with this number is configured.
    pub(super) fn is_configured(&self, number: u32) -> bool {
        self.lines.get(number as usize).is_some_and(|line| line.channel.is_some())
    }

    /// Channel with this number.
    pub(super) fn channel(&mut self, number: Option<u32>) -> Option<&mut Channel> {
        let known = number.and_then(|number| self.lines.get_mut(number as usize));
        let recorded = known.and_then(|known| known.channel.as_mut());
        self.is_missing = recorded.is_none();
        recorded.map(|recorded| &mut recorded.channel)
    }

    /// Whether the instruction that stops its task has used a link that is not configured.
    pub(super) fn take_missing(&mut self) -> bool {
        std::mem::take(&mut self.is_missing)
    }

    /// Calls a channel for a task, which uses the channel from then on.
    pub(super) fn ask<T>(
        &mut self,
        number: Option<u32>,
        task: TaskNumber,
        question: impl FnOnce(&mut Channel) -> Attempt<T>,
    ) -> fault::Result<Reply<T>> {
        let channel = self.channel(number).ok_or(Fault(UNLINKED))?;
        let turn = question(channel);
        let timeout = channel.timeout();
        if let Some(known) = number.and_then(|number| self.lines.get_mut(number as usize)) {
            (known.in_use, known.user) = (true, Some(task));
        }
        Ok(match turn {
            Attempt::Done(value) => Reply::Done(value),
            Attempt::Wait => Reply::Wait((timeout > 0.0).then(|| nanoseconds(timeout))),
        })
    }

    /// Event of the bytes exchanged with a line; `None` without bytes.
    pub(super) fn exchange(&self, number: Option<u32>, dir: &'static str, bytes: &[u8]) -> Option<EventKind> {
        let link = number.and_then(|number| self.link(number)).unwrap_or_default().to_owned();
        (!bytes.is_empty()).then(|| EventKind::Sio { link, dir, bytes: bytes.to_vec() })
    }

    /// Notes that a program has closed the line.
    pub(super) fn end_use(&mut self, number: Option<u32>) {
        if let Some(known) = number.and_then(|number| self.lines.get_mut(number as usize)) {
            known.in_use = false;
        }
    }

    /// Services the lines that programs use: accepts callers, and buffers received bytes.
    pub(crate) fn attend(&mut self) {
        for known in self.lines.iter_mut().filter(|known| known.in_use) {
            if let Some(RecordedChannel { channel, .. }) = &mut known.channel {
                channel.attend();
            }
        }
    }

    /// Whether a program uses a line. No time may be skipped then, because bytes can arrive at any time.
    #[must_use]
    pub fn are_in_use(&self) -> bool {
        self.lines.iter().any(|known| known.in_use)
    }

    /// Whether a line that a program uses has a peer, if that has changed since the last call. A replay returns the same.
    pub(super) fn take_peer_change(&mut self) -> Option<bool> {
        let has_peer = self.lines.iter().any(NamedLine::has_peer);
        (std::mem::replace(&mut self.had_peer, has_peer) != has_peer).then_some(has_peer)
    }

    /// Whether a program uses a line to the outside. A peer may connect, or is connected.
    #[must_use]
    pub fn reach_outside(&self) -> bool {
        self.lines.iter().any(|known| known.in_use && known.is_outside)
    }

    /// Whether a line to the outside has a peer, whose bytes arrive in wall-clock time.
    #[must_use]
    pub fn have_outside_peer(&self) -> bool {
        self.outside_peer().is_some()
    }

    /// Whether a line that a program uses has a peer, which may send in any cycle.
    #[must_use]
    pub fn have_peer(&self) -> bool {
        self.lines.iter().any(|known| known.in_use && known.has_peer())
    }

    /// The line to the outside that has a peer, and the task that has used it last.
    pub(crate) fn outside_peer(&self) -> Option<(&str, Option<TaskNumber>)> {
        let known = self.lines.iter().find(|known| known.is_outside && known.has_peer())?;
        Some((&known.link, known.user))
    }

    /// Lines whose received bytes contain no complete string, by link.
    pub fn unfinished_strings(&self) -> impl Iterator<Item = (&str, UnfinishedString)> {
        self.lines.iter().filter_map(|known| Some((&*known.link, known.channel.as_ref()?.channel.unfinished_string()?)))
    }

    /// Closes all lines at the end of the application (3.7.1).
    pub(crate) fn shut_down(&mut self) {
        self.sending.clear();
        for known in &mut self.lines {
            known.in_use = false;
            if let Some(RecordedChannel { channel, .. }) = &mut known.channel {
                channel.shut_down();
            }
        }
    }

    /// The links of variables and of configured lines.
    pub fn links(&self) -> impl Iterator<Item = &str> {
        self.lines.iter().filter(|known| known.is_known).map(|known| known.link.as_str())
    }

    /// Whether a variable or the configuration names a line.
    pub(crate) fn has(&self, link: &str) -> bool {
        self.links().any(|known| known.eq_ignore_ascii_case(link))
    }

    /// Kinds of the lines, by link.
    pub fn kinds(&self) -> impl Iterator<Item = (&str, LineKind)> {
        self.lines.iter().filter_map(|known| Some((known.link.as_str(), known.channel.as_ref()?.channel.kind())))
    }
}
