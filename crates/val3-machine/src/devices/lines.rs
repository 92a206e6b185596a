//! The serial lines and sockets of the controller, by the texts that variables link to (3.7).

use std::cell::RefCell;
use std::collections::BTreeMap;
use std::rc::Rc;

use val3_lang::ports::TaskNumber;

use crate::sio::{Channel, ChannelConfig, Entry, Line, LineKind, Reach, Recorder, Refused, Replay, Sending};

/// Every line that variables link to or that is configured.
#[derive(Default)]
pub struct Lines {
    lines: Vec<Known>,
    /// What tasks are sending.
    pub(super) sending: BTreeMap<TaskNumber, Sending>,
    /// What lines have answered since it was taken, if they are recorded.
    told: Option<Told>,
    /// Some line was in use when it was last asked.
    was_in_use: bool,
    /// What lines answer instead of those outside.
    replay: Option<BTreeMap<String, Vec<Entry>>>,
}

/// Answers with the links of the lines that gave them; each recorder holds it too.
type Told = Rc<RefCell<Vec<(String, Entry)>>>;

/// A line by the text of its link.
struct Known {
    link: String,
    /// `None` for a link that nothing is configured of.
    channel: Option<Channel>,
    /// A program has used it, and it was not closed since.
    in_use: bool,
    /// What comes in does so by the clock on the wall.
    is_outside: bool,
}

impl Lines {
    /// Opens the lines of a configuration that reach outside, within `reach`. A serial line stays without a device
    /// until one is [attached](Self::attach).
    ///
    /// # Errors
    /// The link of the first line that cannot do what is configured.
    pub fn configure(&mut self, configs: &[ChannelConfig], reach: Reach) -> Result<(), String> {
        for config in configs {
            if let Some(line) = self.line(config, reach) {
                let channel = config.channel(line).map_err(|_| config.link.clone())?;
                self.put(&config.link, channel, self.replay.is_none());
            }
        }
        Ok(())
    }

    /// Lets a link lead to a line. `config` may give its parameters.
    ///
    /// # Errors
    /// If the line cannot do what is configured.
    pub fn attach(&mut self, config: &ChannelConfig, line: Box<dyn Line>, is_outside: bool) -> Result<(), Refused> {
        let line = self.recorded(&config.link, line);
        let channel = config.channel(line)?;
        self.put(&config.link, channel, is_outside);
        Ok(())
    }

    /// Writes down what the lines answer that are configured from now on.
    pub fn record(&mut self) {
        self.told = Some(Rc::default());
    }

    /// Lets the lines that are configured from now on answer as recorded ones did, by their links; a line without
    /// entries stays silent.
    pub fn replay(&mut self, entries: BTreeMap<String, Vec<Entry>>) {
        self.replay = Some(entries);
    }

    /// What recorded lines have answered since this was asked before.
    pub(super) fn take_told(&mut self) -> Vec<(String, Entry)> {
        self.told.as_ref().map(|told| std::mem::take(&mut *told.borrow_mut())).unwrap_or_default()
    }

    fn line(&mut self, config: &ChannelConfig, reach: Reach) -> Option<Box<dyn Line>> {
        let line = match &mut self.replay {
            Some(entries) => {
                let entries = entries.remove(&config.link).unwrap_or_default();
                Box::new(Replay::new(config.kind, entries))
            }
            None => config.socket(reach)?,
        };
        Some(self.recorded(&config.link, line))
    }

    fn recorded(&self, link: &str, line: Box<dyn Line>) -> Box<dyn Line> {
        let Some(told) = &self.told else { return line };
        let (told, link) = (Rc::clone(told), link.to_owned());
        Box::new(Recorder::new(line, move |entry| told.borrow_mut().push((link.clone(), entry))))
    }

    fn put(&mut self, link: &str, channel: Channel, is_outside: bool) {
        let number = self.number(link) as usize;
        if let Some(known) = self.lines.get_mut(number) {
            (known.channel, known.is_outside, known.in_use) = (Some(channel), is_outside, false);
        }
    }

    /// The number of a link, which variables hold.
    pub(super) fn number(&mut self, link: &str) -> u32 {
        let at = self.lines.iter().position(|known| known.link.eq_ignore_ascii_case(link)).unwrap_or_else(|| {
            self.lines.push(Known { link: link.to_owned(), channel: None, in_use: false, is_outside: false });
            self.lines.len() - 1
        });
        u32::try_from(at).unwrap_or(u32::MAX)
    }

    /// Bytes that tasks have to send and wait with.
    pub(super) fn pending(&self) -> usize {
        self.sending.values().map(Sending::total).sum()
    }

    /// The text of a link.
    pub(super) fn link(&self, number: u32) -> Option<&str> {
        self.lines.get(number as usize).map(|known| known.link.as_str())
    }

    /// The channel of a number.
    pub(super) fn channel(&mut self, number: Option<u32>) -> Option<&mut Channel> {
        self.lines.get_mut(number? as usize)?.channel.as_mut()
    }

    /// A program has used the line, or has closed it.
    pub(super) fn set_in_use(&mut self, number: Option<u32>, in_use: bool) {
        if let Some(known) = number.and_then(|number| self.lines.get_mut(number as usize)) {
            known.in_use = in_use;
        }
    }

    /// Looks after the lines that programs use: accepts callers, and takes in what has come.
    pub(crate) fn attend(&mut self) {
        for known in self.lines.iter_mut().filter(|known| known.in_use) {
            if let Some(channel) = &mut known.channel {
                channel.attend();
            }
        }
    }

    /// A program uses a line: no time may be left out, as something can come in at any.
    #[must_use]
    pub fn are_in_use(&self) -> bool {
        self.lines.iter().any(|known| known.in_use)
    }

    /// Whether a program uses a line, if that is otherwise than when it was asked before. A replay gives the same.
    pub(super) fn take_use(&mut self) -> Option<bool> {
        let in_use = self.are_in_use();
        (std::mem::replace(&mut self.was_in_use, in_use) != in_use).then_some(in_use)
    }

    /// A program uses a line to the outside: an idle controller has to wait for the clock on the wall.
    #[must_use]
    pub fn reach_outside(&self) -> bool {
        self.lines.iter().any(|known| known.in_use && known.is_outside)
    }

    /// Closes all lines at the end of the application (3.7.1).
    pub(crate) fn shut_down(&mut self) {
        self.sending.clear();
        for known in &mut self.lines {
            known.in_use = false;
            if let Some(channel) = &mut known.channel {
                channel.shut_down();
            }
        }
    }

    /// The kinds of the lines, by their links.
    pub fn kinds(&self) -> impl Iterator<Item = (&str, LineKind)> {
        self.lines.iter().filter_map(|known| Some((known.link.as_str(), known.channel.as_ref()?.kind())))
    }
}
